// Labels: the same number on both sides of a cut, and none that covers another, a fold or a cut, or leaves
// its face or tab.
#include "core/sheet/labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/base/polygon2.h"
#include "core/base/predicates.h"
#include "core/sheet/font.h"
#include "core/sheet/outline.h"
#include "core/unfold/overlap.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

using testing::net_of;

using Quad = std::array<glm::dvec2, 4>;

/// A net and how it lies on paper, with tabs or without.
struct Laid {
  Net net;
  PageLayout layout;
};

Laid laid(const PolygonSoup& soup, double tab_mm) {
  Net net = net_of(soup);
  PageLayout layout = arrange(net, {}, {});
  if (tab_mm > 0) layout.tabs = testing::tabs_everywhere(net, layout.scale, tab_mm);
  return {std::move(net), std::move(layout)};
}

SheetSettings everything() {
  SheetSettings settings;
  settings.labels = {true, false, false, true, true, true, 2.47};
  return settings;
}

std::vector<glm::dvec2> face_on_canvas(const Laid& l, FaceId f) {
  std::vector<glm::dvec2> polygon;
  for (const HalfedgeId h : l.net.mesh().halfedges(f))
    polygon.push_back(l.layout.on_canvas(l.net.piece[f], l.net.corner(h)));
  return polygon;
}

std::vector<glm::dvec2> tab_on_canvas(const Laid& l, HalfedgeId side) {
  std::vector<glm::dvec2> polygon;
  for (const GlueTab& tab : l.layout.tabs.tabs)
    if (tab.side == side)
      for (const glm::dvec2 p : tab.points)
        polygon.push_back(l.layout.on_canvas_mm(l.net.piece[l.net.mesh().face(side)], p));
  return polygon;
}

bool crosses(const Quad& quad, const std::vector<glm::dvec2>& polygon) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < polygon.size(); ++j)
      if (segments_meet(quad[i], quad[(i + 1) % 4], polygon[j], polygon[(j + 1) % polygon.size()]))
        return true;
  return false;
}

bool meet(const Quad& a, const Quad& b) {
  return crosses(a, {b.begin(), b.end()}) || contains(a, b[0]) || contains(b, a[0]);
}

/// Every label lies in its face or tab, and no two of those meet. A face's sides are all folds and cuts there
/// are, so a label inside covers none.
void expect_free(const Laid& l, const PlacedLabels& placed) {
  for (const Label& label : placed.labels) {
    const std::vector<glm::dvec2> plot =
        label.is_on_tab ? tab_on_canvas(l, label.side) : face_on_canvas(l, label.face);
    ASSERT_GE(plot.size(), 3U);
    const Quad quad = label.corners();
    EXPECT_FALSE(crosses(quad, plot)) << label.words;
    for (const glm::dvec2 p : quad) EXPECT_TRUE(contains(plot, p)) << label.words;
    EXPECT_GE(label.size_mm, kLeastLabelSize * 0.999);
    EXPECT_LE(std::abs(label.angle_rad), 1.5708);
  }
  for (std::size_t i = 0; i < placed.labels.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Label& a = placed.labels[i];
      const Label& b = placed.labels[j];
      if (a.face != b.face) continue;
      EXPECT_FALSE(meet(a.corners(), b.corners())) << a.words << " and " << b.words;
    }
}

TEST(PlaceLabels, CoversNoLineAndNoOtherLabelOnAnyShapeOfTheZoo) {
  std::size_t n_labels = 0;
  for (const testing::ZooShape& shape : testing::zoo()) {
    SCOPED_TRACE(shape.soup.name);
    for (const double tab_mm : {0.0, 2.0, 5.0}) {
      const Laid l = laid(shape.soup, tab_mm);
      const PlacedLabels placed = place_labels(l.net, l.layout, everything());
      expect_free(l, placed);
      n_labels += placed.labels.size();
    }
  }
  EXPECT_GT(n_labels, 1000U);
}

TEST(PlaceLabels, CoversNothingThatIsDrawnOnTheWholePage) {
  int n_nets = 0;
  std::size_t n_labels = 0;
  for (const testing::ZooShape& shape : testing::zoo()) {
    SCOPED_TRACE(shape.soup.name);
    const Net net = net_of(shape.soup);
    if (!find_overlaps(net, kShownDepth).empty()) continue;
    ++n_nets;
    PageLayout layout = arrange(net, {}, {});
    layout.tabs = place_tabs(net, layout.scale, {});
    testing::widen(layout, 10);
    const SheetSettings settings = everything();
    const PlacedLabels placed = place_labels(net, layout, settings);
    const std::vector<Sheet> sheets = draw_sheets(net, layout, {}, settings);
    n_labels += placed.labels.size();
    std::vector<Quad> quads;
    for (const Label& label : placed.labels) {
      quads.push_back(label.corners());
      for (glm::dvec2& p : quads.back()) p = layout.on_page(layout.pages.front(), p);
    }
    for (std::size_t i = 0; i < quads.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        // Pieces may lie closer than their tabs reach where the layout knows nothing of tabs.
        if (net.n_pieces > 1 && net.piece[placed.labels[i].face] != net.piece[placed.labels[j].face])
          continue;
        EXPECT_FALSE(meet(quads[i], quads[j])) << placed.labels[i].words << " and " << placed.labels[j].words;
      }
      for (const Stroke& stroke : sheets.front().strokes) {
        if (!testing::is_of_net(stroke) || net.n_pieces > 1) continue;
        for (std::size_t k = 0; k + 1 < stroke.points.size(); ++k)
          for (std::size_t side = 0; side < 4; ++side)
            EXPECT_FALSE(segments_meet(quads[i][side], quads[i][(side + 1) % 4], stroke.points[k],
                                       stroke.points[k + 1]))
                << placed.labels[i].words;
      }
    }
  }
  EXPECT_GT(n_nets, 20);
  EXPECT_GT(n_labels, 500U);
}

TEST(PlaceLabels, NoLabelsBoxIsSmallerThanItsWords) {
  const Font regular(FontWeight::Regular);
  const Font semi_bold(FontWeight::SemiBold);
  const Laid l = laid(shapes::combined(shapes::cube(), shapes::icosphere(2), {5, 0, 0}), 3);
  const PlacedLabels placed = place_labels(l.net, l.layout, everything());
  for (const Label& label : placed.labels) {
    Box2 ink;
    const Font& font = weight_of(label.kind) == FontWeight::Regular ? regular : semi_bold;
    for (const Font::Step& step : font.outline(label.words, label.size_mm, {0, 0}))
      if (step.kind != 'Z') ink.add(step.points[step.kind == 'C' ? 2 : 0]);
    EXPECT_LE(ink.max.x, label.box_mm.x + 1e-9) << label.words;
    EXPECT_GE(ink.min.y, -label.box_mm.y - 0.02 * label.size_mm) << label.words;
    EXPECT_LE(ink.max.y, 0.02 * label.size_mm) << label.words << " goes below its line";
  }
}

TEST(PlaceLabels, WritesTheSameNumberOnBothSidesOfEveryCut) {
  for (const double tab_mm : {0.0, 3.0}) {
    const Laid l = laid(shapes::icosphere(2), tab_mm);
    SheetSettings settings;
    settings.labels.skips_obvious = false;
    const PlacedLabels placed = place_labels(l.net, l.layout, settings);
    EXPECT_TRUE(placed.left_out.empty());
    std::map<std::string, std::vector<HalfedgeId>> sides;
    for (const Label& label : placed.labels) sides[label.words].push_back(label.side);
    EXPECT_EQ(sides.size(), l.net.mesh().n_edges() - (l.net.mesh().n_faces() - 1));
    for (const auto& [words, pair] : sides) {
      ASSERT_EQ(pair.size(), 2U) << words;
      EXPECT_EQ(l.net.mesh().twin(pair[0]), pair[1]) << words;
    }
  }
}

TEST(PlaceLabels, PutsNumbersOnTabsAndElseIntoTheFaceBesideTheSide) {
  Laid l = laid(shapes::cube(), 5);
  std::erase_if(l.layout.tabs.tabs,
                [&](const GlueTab& tab) { return l.net.mesh().twin(tab.side) < tab.side; });
  SheetSettings settings;
  settings.labels.skips_obvious = false;
  const PlacedLabels placed = place_labels(l.net, l.layout, settings);
  for (const Label& label : placed.labels) {
    EXPECT_EQ(label.is_on_tab, label.side < l.net.mesh().twin(label.side));
    const glm::dvec2 a = l.layout.on_canvas(0, l.net.corner(label.side));
    const glm::dvec2 b = l.layout.on_canvas(0, l.net.corner(l.net.mesh().next(label.side)));
    EXPECT_NEAR(
        cross(glm::normalize(b - a), glm::dvec2(std::cos(label.angle_rad), std::sin(label.angle_rad))), 0,
        1e-9);
    EXPECT_LT(std::abs(cross(glm::normalize(b - a), label.centre - a)), 5) << "beside its side";
    EXPECT_NEAR(label.size_mm, 2.47, 1e-9) << "nothing is in the way of seven points";
  }
}

TEST(PlaceLabels, GivesNeighboursOnTheOutlineNeighbouringNumbers) {
  const Net net = net_of(shapes::icosphere(2));
  const IdVector<EdgeId, int> numbers = cut_numbers(net, false);
  int last = 0;
  const std::vector<OutlineLoop> loops = outline_loops(net);
  for (const HalfedgeId h : loops.front().sides) {
    const int number = numbers[net.mesh().edge(h)];
    EXPECT_LE(number, last + 1);
    last = std::max(last, number);
  }
  EXPECT_EQ(last, static_cast<int>(net.mesh().n_edges() - net.mesh().n_faces() + 1));
}

TEST(PlaceLabels, LeavesOutNumbersWhereTwoSidesCanOnlyMeetEachOther) {
  const Net net = net_of(shapes::icosphere(2));
  const IdVector<EdgeId, int> all = cut_numbers(net, false);
  const IdVector<EdgeId, int> fewer = cut_numbers(net, true);
  const std::vector<HalfedgeId> sides = outline_loops(net).front().sides;
  int n_skipped = 0;
  for (const EdgeId e : net.mesh().edges()) {
    if (all[e] == 0) {
      EXPECT_EQ(fewer[e], 0);
    } else if (fewer[e] == 0) {
      ++n_skipped;
      const auto place = std::ranges::find_if(sides, [&](HalfedgeId h) { return net.mesh().edge(h) == e; });
      const auto next = place + 1 == sides.end() ? sides.begin() : place + 1;
      EXPECT_TRUE(net.mesh().edge(*next) == e || net.mesh().edge(sides.back()) == e) << "neighbours meet";
    }
  }
  EXPECT_GT(n_skipped, 0);
}

TEST(PlaceLabels, TellsTheCutsThatAreTooShortForANumber) {
  Net net = net_of(shapes::icosphere(3));
  PageLayout layout = arrange(net, {}, {PrintSize::Kind::Height, 12});
  SheetSettings settings;
  settings.labels.skips_obvious = false;
  const PlacedLabels placed = place_labels(net, layout, settings);
  EXPECT_GT(placed.left_out.size(), 0U);
  EXPECT_EQ(placed.labels.size() / 2 + placed.left_out.size(),
            net.mesh().n_edges() - net.mesh().n_faces() + 1);
  for (const Label& label : placed.labels)
    EXPECT_FALSE(std::ranges::binary_search(placed.left_out, net.mesh().edge(label.side)));
}

TEST(PlaceLabels, WritesOnlyWhatIsAskedFor) {
  const Laid l = laid(shapes::combined(shapes::cube(), shapes::tetrahedron(), {5, 0, 0}), 3);
  const auto kinds_with = [&](auto change) {
    SheetSettings settings;
    settings.labels.edge_numbers = false;
    change(settings.labels);
    std::set<Label::Kind> kinds;
    const PlacedLabels placed = place_labels(l.net, l.layout, settings);
    for (const Label& label : placed.labels) kinds.insert(label.kind);
    return kinds;
  };
  using Kinds = std::set<Label::Kind>;
  EXPECT_EQ(kinds_with([](LabelSettings&) {}), Kinds{});
  EXPECT_EQ(kinds_with([](LabelSettings& s) { s.edge_numbers = true; }), Kinds{Label::Kind::EdgeNumber});
  EXPECT_EQ(kinds_with([](LabelSettings& s) { s.piece_names = true; }), Kinds{Label::Kind::PieceName});
  EXPECT_EQ(kinds_with([](LabelSettings& s) { s.fold_angles = true; }), Kinds{Label::Kind::FoldAngle});
  EXPECT_EQ(kinds_with([](LabelSettings& s) { s.face_numbers = true; }), Kinds{Label::Kind::FaceNumber});
}

TEST(PlaceLabels, MeasuresFoldsInDegrees) {
  const Laid l = laid(shapes::cube(), 0);
  SheetSettings settings;
  settings.labels.edge_numbers = false;
  settings.labels.fold_angles = true;
  const PlacedLabels placed = place_labels(l.net, l.layout, settings);
  EXPECT_EQ(placed.labels.size(), 5U);
  for (const Label& label : placed.labels) EXPECT_EQ(label.words, "90°");
}

TEST(NumberWords, MarkWhatReadsAsAnotherNumberUpsideDown) {
  for (const int number : {6, 9, 66, 68, 86, 89, 99, 608})
    EXPECT_EQ(number_words(number).back(), '.') << number;
  for (const int number : {1, 8, 10, 16, 69, 88, 96, 60, 90, 123})
    EXPECT_EQ(number_words(number), std::to_string(number));
}

TEST(PieceName, GoesOnWithTwoLettersAfterZ) {
  EXPECT_EQ(piece_name(0), "A");
  EXPECT_EQ(piece_name(25), "Z");
  EXPECT_EQ(piece_name(26), "AA");
}

}  // namespace
}  // namespace netwright
