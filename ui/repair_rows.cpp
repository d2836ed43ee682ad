// One table says how each step is called; the two steps that can go further or less far, welding and closing
// holes, have a field under their switch, and faces that are not flat have two cures to choose from.
#include "ui/repair_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "assets/icons.h"
#include "core/base/counted.h"
#include "core/project/open_model.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr float kIndent = 26;  ///< of what belongs to a switch: its box and a gap
constexpr float kFieldWidth = 116;
constexpr int kUsualHole = 32;  ///< edges around; larger ones are rather meant to be there

struct StepWords {
  RepairStep step;
  const char* name;  ///< of the widget
  const char* label;
  const char* on;   ///< what undo calls it
  const char* off;  ///< and taking it back
  const char* tip;
};

constexpr std::array<StepWords, 8> kWords{
    StepWords{RepairStep::Weld, "repair/weld", "Weld points", "weld points", "keep points apart",
              "Joins open edges whose ends lie this close together"},
    StepWords{RepairStep::DegenerateFaces, "repair/degenerate", "Clear empty faces", "clear empty faces",
              "keep empty faces", "Faces without area or with a corner named twice"},
    StepWords{RepairStep::DoubledFaces, "repair/doubled", "Drop doubled faces", "drop doubled faces",
              "keep doubled faces", "Of faces with the same corners one stays"},
    StepWords{
        RepairStep::NonManifold, "repair/split", "Part shared edges", "part shared edges",
        "keep shared edges",
        "Edges with more than two faces and points where parts touch become several: paper has two sides"},
    StepWords{RepairStep::Turn, "repair/turn", "Turn faces outward", "", "",
              "Always done: without it nothing tells inside from outside"},
    StepWords{RepairStep::Holes, "repair/holes", "Close holes", "close holes", "keep holes open",
              "Fills borders with faces; masks and shells want theirs open"},
    StepWords{RepairStep::IsolatedPoints, "repair/isolated", "Drop loose points", "drop loose points",
              "keep loose points", "Points that no face uses"},
    StepWords{RepairStep::UnevenFaces, "repair/uneven", "Faces not flat", "", "",
              "Paper does not bend in two ways at once"}};

const StepWords& words_of(RepairStep step) { return *std::ranges::find(kWords, step, &StepWords::step); }

/// The switch of a step; null where there is none.
bool* switch_of(Repairs& repairs, RepairStep step) {
  switch (step) {
    case RepairStep::Weld:
      return &repairs.welds;
    case RepairStep::DegenerateFaces:
      return &repairs.drops_degenerate_faces;
    case RepairStep::DoubledFaces:
      return &repairs.drops_doubled_faces;
    case RepairStep::NonManifold:
      return &repairs.splits_non_manifold;
    case RepairStep::IsolatedPoints:
      return &repairs.drops_isolated_points;
    case RepairStep::Turn:
    case RepairStep::Holes:
    case RepairStep::UnevenFaces:
      break;
  }
  return nullptr;
}

bool has_row(const RepairSurvey& survey, RepairStep step) {
  return survey.find(step) != nullptr || (step == RepairStep::Weld && survey.can_weld);
}

/// The largest of the holes that are probably none of the model's own; the smallest when all are large.
int usual_hole(const std::vector<int>& sizes) {
  int usual = sizes.front();
  for (const int size : sizes) usual = size <= kUsualHole ? size : usual;
  return usual;
}

class Rows {
 public:
  Rows(UiState& ui, const Recipe& wanted, const RepairSurvey& survey, double unit_mm, float width)
      : ui_(ui), recipe_(wanted), survey_(survey), unit_mm_(unit_mm), width_(width) {}

  std::optional<RecipeChange> draw() {
    for (const StepWords& words : kWords) {
      if (has_row(survey_, words.step)) row(words);
    }
    if (label_.empty()) return std::nullopt;
    return RecipeChange{recipe_, label_};
  }

 private:
  void row(const StepWords& words) {
    const float left = ImGui::GetCursorPosX();
    bool is_on = head(words);
    const RepairCount* const count = survey_.find(words.step);
    counts(words, left, count == nullptr ? 0 : count->found, count == nullptr ? 0 : count->left, is_on);
    if (words.step == RepairStep::Weld) tolerance_row(left);
    if (words.step == RepairStep::Holes) holes_row(left);
    if (words.step == RepairStep::UnevenFaces) uneven_row(left);
  }

  /// The switch, or a tick where there is no choice. True when the step is wanted.
  bool head(const StepWords& words) {
    bool* const flag = switch_of(recipe_.repairs, words.step);
    const bool is_holes = words.step == RepairStep::Holes;
    const RepairCount* const count = survey_.find(words.step);
    const bool is_done = count != nullptr && count->left < count->found;
    const std::string tip = is_done && !count->sentence.empty() ? count->sentence : words.tip;
    if (flag == nullptr && !is_holes) {
      tick(words, tip);
      return true;
    }
    bool is_on = is_holes ? recipe_.repairs.max_hole_edges > 0 : *flag;
    if (!checkbox(ui_, words.name, words.label, is_on, tip)) return is_on;
    if (is_holes) {
      recipe_.repairs.max_hole_edges = is_on ? usual_hole(survey_.hole_sizes) : 0;
    } else {
      *flag = is_on;
    }
    label_ = is_on ? words.on : words.off;
    return is_on;
  }

  void tick(const StepWords& words, const std::string& tip) {
    const Look& look = ui_.look;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size(look.px(kIndent) + ImGui::CalcTextSize(words.label).x, look.px(28));
    const float y = std::floor(at.y + (size.y - ImGui::GetTextLineHeight()) / 2);
    ImGui::Dummy(size);
    note_widget(ui_, words.name);
    tooltip(ui_, tip);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddText(ImVec2(at.x + look.px(1), y), look.colours.good, icon::kDone);
    draw.AddText(ImVec2(at.x + look.px(kIndent), y), look.colours.text, words.label);
  }

  void counts(const StepWords& words, float left, int found, int rest, bool is_on) {
    const std::string text = repair_count_text(found, rest);
    const float height = ImGui::GetItemRectSize().y;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    ImGui::SameLine(left + width_ - size.x);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::Dummy(ImVec2(size.x, height));
    note_widget(ui_, std::string(words.name) + "/count");
    const bool is_cured = is_on && found > 0 && rest == 0;
    ImGui::GetWindowDrawList()->AddText(ImVec2(at.x, std::floor(at.y + (height - size.y) / 2)),
                                        is_cured ? ui_.look.colours.good : ui_.look.colours.muted,
                                        text.c_str());
  }

  void field_label(float left, const char* text) const {
    ImGui::SetCursorPosX(left + ui_.look.px(kIndent));
    ImGui::AlignTextToFramePadding();
    text_muted(ui_, text);
    ImGui::SameLine(left + width_ - ui_.look.px(kFieldWidth));
    ImGui::SetNextItemWidth(ui_.look.px(kFieldWidth));
  }

  void tolerance_row(float left) {
    const LengthUnit unit = ui_.settings.unit;
    const double scale = unit_mm_ / in_millimetres(unit);
    field_label(left, "within");
    double length = survey_.weld_tolerance * scale;
    if (recipe_.repairs.weld_tolerance >= 0) length = recipe_.repairs.weld_tolerance * scale;
    const bool is_new =
        number_field(ui_, "repair/tolerance", length, fine_length_format(length, unit).c_str());
    tooltip(ui_, "The largest gap that is closed, at the model's own size");
    if (!is_new) return;
    recipe_.repairs.weld_tolerance = std::max(length, 0.0) / scale;
    recipe_.repairs.welds = true;
    label_ = words_of(RepairStep::Weld).on;
  }

  void holes_row(float left) {
    field_label(left, "edges, up to");
    const int now = recipe_.repairs.max_hole_edges;
    auto edges = static_cast<std::uint64_t>(now > 0 ? now : usual_hole(survey_.hole_sizes));
    const bool is_new = number_field(ui_, "repair/hole-edges", edges);
    tooltip(ui_, sizes_text());
    if (!is_new) return;
    recipe_.repairs.max_hole_edges = static_cast<int>(std::min<std::uint64_t>(edges, 2'000'000'000));
    label_ = words_of(RepairStep::Holes).on;
  }

  /// "There are holes with 3, 12 and 4 000 edges around."
  [[nodiscard]] std::string sizes_text() const {
    constexpr std::size_t kShown = 6;
    std::vector<int> sizes = survey_.hole_sizes;
    sizes.erase(std::ranges::unique(sizes).begin(), sizes.end());
    std::string text = "The holes have ";
    for (std::size_t i = 0; i < std::min(sizes.size(), kShown); ++i)
      text += (i == 0 ? "" : (i + 1 == sizes.size() ? " or " : ", ")) + grouped(sizes[i]);
    if (sizes.size() > kShown) text += " … " + grouped(sizes.back());
    return text + " edges around";
  }

  void uneven_row(float left) {
    ImGui::SetCursorPosX(left + ui_.look.px(kIndent));
    int chosen = recipe_.uneven == UnevenFaces::Flatten ? 1 : 0;
    const float width = width_ - ui_.look.px(kIndent);
    if (!segments(ui_, "repair/uneven", width, {"Split", "Flatten"}, chosen)) return;
    recipe_.uneven = chosen == 1 ? UnevenFaces::Flatten : UnevenFaces::Split;
    label_ = chosen == 1 ? "flatten faces" : "split faces";
  }

  UiState& ui_;
  Recipe recipe_;
  const RepairSurvey& survey_;
  double unit_mm_;
  float width_;
  std::string label_;
};

}  // namespace

std::optional<RecipeChange> repair_rows(UiState& ui, const Recipe& wanted, const RepairSurvey& survey,
                                        double unit_mm, float width) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.look.px(8), ui.look.px(2)));
  auto change = Rows(ui, wanted, survey, unit_mm, width).draw();
  ImGui::PopStyleVar();
  return change;
}

bool has_repair_rows(const RepairSurvey& survey) {
  return std::ranges::any_of(kWords, [&](const StepWords& words) { return has_row(survey, words.step); });
}

std::vector<std::string> beyond_rows(const ModelStages& stages) {
  std::vector<std::string> sentences;
  const std::vector<RepairCount>& counts = stages.survey->repairs.counts;
  for (const std::string& done : stages.repaired) {
    if (std::ranges::find(counts, done, &RepairCount::sentence) == counts.end()) sentences.push_back(done);
  }
  return sentences;
}

bool can_repair_more(const Recipe& wanted, const RepairSurvey& survey) {
  Repairs now = wanted.repairs;
  return std::ranges::any_of(survey.counts, [&](const RepairCount& count) {
    const bool* const flag = switch_of(now, count.step);
    return flag != nullptr && !*flag && count.left > 0;
  });
}

Recipe with_all_repairs(Recipe recipe) {
  const Recipe usual = usual_repair();
  const Repairs before = recipe.repairs;
  recipe.repairs = usual.repairs;
  recipe.repairs.weld_tolerance = before.weld_tolerance;
  recipe.repairs.max_hole_edges = before.max_hole_edges;
  if (recipe.uneven == UnevenFaces::Refuse) recipe.uneven = usual.uneven;
  return recipe;
}

std::string repair_count_text(int found, int left) {
  if (found == 0) return "none";
  return left == found ? grouped(found) : grouped(found) + " → " + grouped(left);
}

std::string fine_length_format(double length, LengthUnit unit) {
  constexpr double kMostDecimals = 9;
  const double decimals = length > 0 ? std::clamp(1 - std::floor(std::log10(length)), 0.0, kMostDecimals) : 1;
  return "%." + std::to_string(static_cast<int>(decimals)) + "f " + sign_of(unit);
}

}  // namespace netwright
