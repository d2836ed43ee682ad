// A drawn sheet parted into what is printed and what is cut, and the registration marks of the presets.
#include <algorithm>
#include <cctype>

#include "core/sheet/cutter_package.h"

namespace netwright {

namespace {

constexpr double kMarkInset = 10;  // mm from the paper's edges
constexpr double kMarkSquare = 5;  // the full square at the upper left
constexpr double kMarkArm = 20;    // of the angles at two other corners
constexpr double kMarkWidth = 0.5;
constexpr double kCrossArm = 3;  // of the crosses for the other machines
constexpr double kCrossInset = 7;
constexpr double kCutWidth = 0.1;
constexpr double kHairline = 0.025;  // a thousandth of an inch: what lasers take for a line to follow
constexpr glm::dvec3 kBlack{0, 0, 0};

Stroke mark_line(std::vector<glm::dvec2> points, double width_mm) {
  return {Layer::Regmarks, std::move(points), false, width_mm, kBlack, {}, 0};
}

/// A square at the upper left, angles at the upper right and the lower left.
void add_silhouette_marks(Sheet& sheet) {
  const glm::dvec2 low(kMarkInset);
  const glm::dvec2 high = glm::dvec2(sheet.width_mm, sheet.height_mm) - kMarkInset;
  const double s = kMarkSquare;
  sheet.fills.push_back({Layer::Regmarks,
                         {low, low + glm::dvec2(s, 0), low + glm::dvec2(s, s), low + glm::dvec2(0, s)},
                         kBlack});
  sheet.strokes.push_back(
      mark_line({{high.x - kMarkArm, low.y}, {high.x, low.y}, {high.x, low.y + kMarkArm}}, kMarkWidth));
  sheet.strokes.push_back(
      mark_line({{low.x, high.y - kMarkArm}, {low.x, high.y}, {low.x + kMarkArm, high.y}}, kMarkWidth));
}

void add_crosses(Sheet& sheet) {
  for (const double x : {kCrossInset, sheet.width_mm - kCrossInset})
    for (const double y : {kCrossInset, sheet.height_mm - kCrossInset}) {
      sheet.strokes.push_back(mark_line({{x - kCrossArm, y}, {x + kCrossArm, y}}, kCutWidth));
      sheet.strokes.push_back(mark_line({{x, y - kCrossArm}, {x, y + kCrossArm}}, kCutWidth));
    }
}

bool is_fold(Layer layer) {
  return layer == Layer::Mountain || layer == Layer::Valley || layer == Layer::TabFold;
}

glm::dvec3 pure_colour(Layer layer) {
  switch (layer) {
    case Layer::Cut:
      return {1, 0, 0};
    case Layer::Mountain:
      return {0, 0, 1};
    case Layer::Valley:
      return {0, 1, 0};
    case Layer::TabFold:
      return {1, 0, 1};
    default:
      return kBlack;
  }
}

/// Cuts and folds as a machine wants them; only perforation keeps its dashes.
void add_machine_lines(Sheet& target, const Sheet& sheet, CutterPreset preset) {
  for (Stroke stroke : sheet.strokes) {
    if (stroke.layer != Layer::Cut && !is_fold(stroke.layer)) continue;
    stroke.colour = pure_colour(stroke.layer);
    stroke.width_mm = preset == CutterPreset::Laser ? kHairline : kCutWidth;
    if (preset != CutterPreset::Silhouette || stroke.layer == Layer::Cut) stroke.dash_mm.clear();
    target.strokes.push_back(std::move(stroke));
  }
}

void add_labels(Sheet& target, const Sheet& sheet) {
  for (const Text& text : sheet.texts)
    if (text.layer == Layer::Labels) target.texts.push_back(text);
}

bool is_inside(const Box2& box, glm::dvec2 p) {
  return p.x >= box.min.x && p.y >= box.min.y && p.x <= box.max.x && p.y <= box.max.y;
}

/// Fills, pictures and numbers of the net, without what stands around it.
void add_prints(Sheet& target, const Sheet& sheet, const Box2& net) {
  constexpr double kBleed = 3;
  const Box2 reach{net.min - kBleed, net.max + kBleed};
  for (const Fill& fill : sheet.fills)
    if (std::ranges::all_of(fill.points, [&](glm::dvec2 p) { return is_inside(reach, p); }))
      target.fills.push_back(fill);
  for (const Picture& picture : sheet.pictures)
    if (is_inside(reach, picture.at + picture.size_mm / 2.0)) target.pictures.push_back(picture);
  for (const Stroke& stroke : sheet.strokes)
    if (stroke.layer == Layer::Labels) target.strokes.push_back(stroke);
  add_labels(target, sheet);
}

}  // namespace

std::optional<CutterPreset> cutter_named(std::string_view name) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  for (std::size_t i = 0; i < kCutterNames.size(); ++i)
    if (std::ranges::equal(name, kCutterNames[i], {}, lower, lower)) return static_cast<CutterPreset>(i);
  return std::nullopt;
}

PaperSetup cutter_paper(PaperSetup paper, CutterPreset preset) {
  const double least =
      preset == CutterPreset::Silhouette ? kMarkInset + kMarkSquare + 1 : kCrossInset + kCrossArm + 1;
  paper.margin_mm = std::max(paper.margin_mm, least);
  return paper;
}

CutterSheets cutter_sheets(const Sheet& sheet, const PageLayout& layout, CutterPreset preset) {
  CutterSheets sheets;
  for (Sheet* part : {&sheets.print, &sheets.cut}) {
    part->width_mm = sheet.width_mm;
    part->height_mm = sheet.height_mm;
    part->number = sheet.number;
    part->count = sheet.count;
    if (preset == CutterPreset::Silhouette) {
      add_silhouette_marks(*part);
    } else {
      add_crosses(*part);
    }
  }
  add_prints(sheets.print, sheet, layout.frame.net);
  add_machine_lines(sheets.cut, sheet, preset);
  if (preset == CutterPreset::Laser) {
    add_machine_lines(sheets.print, sheet, preset);
    add_labels(sheets.cut, sheet);
    for (Text& text : sheets.cut.texts) text.colour = kBlack;
  }
  return sheets;
}

}  // namespace netwright
