// The net's own lines on a page: outlines joined and clipped, folds with dashes that fit their whole edge, so
// that a fold that runs over two tiles meets its other half in phase.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/sheet/dash.h"
#include "core/sheet/draw.h"
#include "core/sheet/outline.h"
#include "core/sheet/print_style.h"

namespace netwright {

namespace {

using namespace print_style;

}  // namespace

IdVector<EdgeId, EdgeKind> drawn_kinds(const Net& net, const SheetSettings& settings) {
  IdVector<EdgeId, EdgeKind> kinds = edge_kinds(net);
  for (const EdgeId e : net.mesh().edges()) {
    if (kinds[e] == EdgeKind::Cut || kinds[e] == EdgeKind::Border) continue;
    const double bend = net.dual->bend(e);
    const bool is_asked = std::ranges::binary_search(settings.shown_folds, e);
    const bool is_bent = kinds[e] != EdgeKind::Hidden && std::abs(bend) >= settings.lines.flat_below_rad;
    if ((is_bent || is_asked) && !std::ranges::binary_search(settings.hidden_folds, e)) {
      kinds[e] = bend >= 0 ? EdgeKind::Mountain : EdgeKind::Valley;
    } else {
      kinds[e] = EdgeKind::Flat;
    }
  }
  return kinds;
}

NetLines net_lines(const Net& net, const PageLayout& layout, const SheetSettings& settings) {
  const Mesh& mesh = net.mesh();
  const auto point = [&](HalfedgeId h) { return layout.on_canvas(net.piece[mesh.face(h)], net.corner(h)); };
  const auto canvas = [&](int piece) { return layout.pieces[static_cast<std::size_t>(piece)].canvas; };
  const IdVector<HalfedgeId, const GlueTab*> tabs = tabs_by_side(mesh, layout.tabs);
  NetLines lines;
  for (const OutlineLoop& loop : outline_loops(net)) {
    NetLines::Outline outline{canvas(loop.piece), {}};
    for (const HalfedgeId h : loop.sides) {
      outline.points.push_back(point(h));
      if (tabs[h] == nullptr) continue;
      // A tab lists the side's two ends first; its rim leads on from where the side begins.
      for (std::size_t i = 2; i < tabs[h]->points.size(); ++i)
        outline.points.push_back(layout.on_canvas_mm(loop.piece, tabs[h]->points[i]));
      lines.folds.push_back({outline.canvas, point(h), point(mesh.next(h)), Layer::TabFold});
    }
    lines.outlines.push_back(std::move(outline));
  }
  const IdVector<EdgeId, EdgeKind> kinds = drawn_kinds(net, settings);
  for (const FaceId f : mesh.faces()) {
    if (net.tree.is_root(f)) continue;
    const HalfedgeId h = net.tree.to_parent(f);
    const EdgeKind kind = kinds[mesh.edge(h)];
    if (kind != EdgeKind::Mountain && kind != EdgeKind::Valley) continue;
    lines.folds.push_back({canvas(net.piece[f]), point(h), point(mesh.next(h)),
                           kind == EdgeKind::Mountain ? Layer::Mountain : Layer::Valley});
  }
  return lines;
}

Stroke net_stroke(const LineStyles& styles, Layer layer, glm::dvec2 from, glm::dvec2 to) {
  const auto style = [&]() -> const PrintedLine& {
    switch (layer) {
      case Layer::Mountain:
        return styles.mountain;
      case Layer::Valley:
        return styles.valley;
      case Layer::TabFold:
        return styles.tab_fold;
      default:
        return styles.cut;
    }
  };
  const PrintedLine& line = style();
  return {
      layer, {from, to}, false, line.width_mm, line.colour, fit_dash(line.dash_mm, glm::length(to - from)),
      0};
}

namespace {

Layer seen_from_behind(Layer layer) {
  return layer == Layer::Mountain ? Layer::Valley : layer == Layer::Valley ? Layer::Mountain : layer;
}

/// What is printed of a fold: all of it, or a mark at either end.
std::vector<NetLines::Fold> inked_parts(const NetLines::Fold& fold, const LineStyles& styles) {
  const double length = glm::length(fold.to - fold.from);
  if (!styles.only_ends || length <= 2 * styles.end_mark_mm) return {fold};
  const glm::dvec2 mark = (fold.to - fold.from) * (styles.end_mark_mm / length);
  NetLines::Fold first = fold;
  NetLines::Fold last = fold;
  first.to = fold.from + mark;
  // Seen from its end, so that both marks begin at the corner.
  last.from = fold.to;
  last.to = fold.to - mark;
  return {first, last};
}

/// A fold on a dark picture is drawn in a light shade of its colour.
void show_on_ground(Stroke& stroke, const Sheet& sheet) {
  constexpr int kSamples = 8;
  constexpr double kWhite = 0.65;
  const glm::dvec2 along = stroke.points[1] - stroke.points[0];
  double sum = 0;
  for (int i = 0; i < kSamples; ++i)
    sum += brightness(sheet, stroke.points[0] + along * ((i + 0.5) / kSamples));
  if (sum < kDarkGround * kSamples) stroke.colour = glm::mix(stroke.colour, glm::dvec3(1), kWhite);
}

void draw_fold(Sheet& sheet, const NetLines::Fold& fold, const PageView& view, const LineStyles& styles) {
  const auto part = clip_segment(view.window(), fold.from, fold.to);
  if (!part) return;
  Stroke stroke = net_stroke(styles, fold.layer, fold.from, fold.to);
  const glm::dvec2 along = fold.to - fold.from;
  stroke.points = {view.at(fold.from + along * part->first), view.at(fold.from + along * part->second)};
  stroke.dash_phase_mm = part->first * glm::length(along);
  if (!sheet.pictures.empty()) show_on_ground(stroke, sheet);
  sheet.strokes.push_back(std::move(stroke));
}

/// Where a cut runs over a dark picture it gets a light line on top, which machines pass over.
void show_cut_on_ground(Sheet& sheet, const Stroke& cut) {
  constexpr double kStep = 1;
  constexpr double kDark = 0.3;
  constexpr double kLight = 0.85;
  std::vector<glm::dvec2> run;
  const auto end_run = [&] {
    if (run.size() > 1)
      sheet.strokes.push_back({Layer::Print, run, false, cut.width_mm, glm::dvec3(kLight), {}, 0});
    run.clear();
  };
  const std::size_t n = cut.points.size();
  for (std::size_t i = 0; i + (cut.is_closed ? 0 : 1) < n; ++i) {
    const glm::dvec2 from = cut.points[i];
    const glm::dvec2 along = cut.points[(i + 1) % n] - from;
    const double steps = std::max(1.0, std::ceil(glm::length(along) / kStep));
    for (double k = 0; k < steps; ++k) {
      if (brightness(sheet, from + along * ((k + 0.5) / steps)) >= kDark) {
        end_run();
        continue;
      }
      if (run.empty()) run.push_back(from + along * (k / steps));
      run.push_back(from + along * ((k + 1) / steps));
    }
  }
  end_run();
}

}  // namespace

void draw_folds(Sheet& sheet, const NetLines& lines, const PageView& view, const LineStyles& styles) {
  for (NetLines::Fold fold : lines.folds) {
    if (fold.canvas != view.page.canvas) continue;
    if (view.is_mirrored) fold.layer = seen_from_behind(fold.layer);
    for (const NetLines::Fold& part : inked_parts(fold, styles)) draw_fold(sheet, part, view, styles);
  }
}

void draw_cuts(Sheet& sheet, const NetLines& lines, const PageView& view, const LineStyles& styles) {
  for (const NetLines::Outline& outline : lines.outlines) {
    if (outline.canvas != view.page.canvas) continue;
    ClippedLine clipped = clip_polyline(view.window(), outline.points, true);
    for (std::vector<glm::dvec2>& run : clipped.runs) {
      for (glm::dvec2& p : run) p = view.at(p);
      const Stroke cut{
          Layer::Cut, std::move(run), clipped.is_whole, styles.cut.width_mm, styles.cut.colour, {}, 0};
      sheet.strokes.push_back(cut);
      if (!sheet.pictures.empty()) show_cut_on_ground(sheet, cut);
    }
  }
}

}  // namespace netwright
