// The accordion: which sections there are, what their headers summarize, and the lines between them.
#include <array>
#include <string>

#include "ui/panels.h"
#include "ui/status.h"
#include "ui/tab_tool.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

std::string model_summary(const UiContext& c) {
  if (!c.session.has_model()) return "none";
  return counted(static_cast<std::int64_t>(c.session.project().dual->mesh().n_faces()), "face", "faces");
}

std::string solve_summary(const UiContext& c) {
  return c.session.has_model() ? "seed " + std::to_string(c.session.project().seed) : "";
}

std::string paper_summary(const UiContext& c) {
  const auto sheets = c.session.sheets();
  const std::string& format = c.session.project().paper.format;
  return sheets == nullptr ? format : std::to_string(sheets->size()) + " × " + format;
}

std::string tabs_summary(const UiContext& c) {
  if (!c.session.has_model()) return "";
  const TabSettings& tabs = c.session.project().tabs;
  if (!tabs.is_on) return "none";
  const auto pages = c.session.pages();
  if (pages == nullptr) return length_text(tabs.width_mm, c.ui.settings.unit);
  const std::string made = grouped(static_cast<std::int64_t>(pages->tabs.tabs.size()));
  const auto missing = static_cast<std::int64_t>(pages->tabs.missing.size());
  return missing == 0 ? made : made + ", " + grouped(missing) + " missing";
}

std::string print_summary(const UiContext& c) {
  if (!c.session.has_model()) return "";
  const SheetSettings& sheet = c.session.project().sheet;
  return sheet.is_grey ? "grey" : sheet.printed_side == PrintedSide::Both ? "both sides" : "";
}

std::string export_summary(const UiContext& c) {
  if (!c.session.has_model()) return "";
  const bool has_instructions = c.session.project().exports.instructions != InstructionPage::None;
  return has_instructions ? "with instructions" : "";
}

/// How many things are wrong, the worst grade first.
std::string check_summary(const UiContext& c) {
  const auto judged = c.session.buildability();
  const auto shown = c.session.shown();
  if (judged == nullptr || shown == nullptr) return "";
  std::int64_t n_warnings = 0;
  std::int64_t n_troubles = 0;
  for (const BuildLine& line : lines_of(*judged, shown->net)) {
    n_warnings += line.grade == BuildLine::Grade::Warning ? 1 : 0;
    n_troubles += line.grade == BuildLine::Grade::Trouble ? 1 : 0;
  }
  if (n_troubles > 0) return counted(n_troubles, "problem", "problems");
  return n_warnings > 0 ? counted(n_warnings, "warning", "warnings") : "fine";
}

std::string assembly_summary(const UiContext& c) {
  const std::size_t n = c.session.has_model() ? c.session.project().glued.size() : 0;
  return n == 0 ? "" : grouped(static_cast<std::int64_t>(n)) + " glued";
}

std::string overlaps_summary(const UiContext& c) {
  const auto shown = c.session.shown();
  return shown == nullptr ? "" : grouped(static_cast<std::int64_t>(shown->overlaps.size()));
}

std::string no_summary(const UiContext& /*c*/) { return {}; }

/// A net without overlaps needs no list of them; the section is the last, so that it may come and go.
bool has_overlaps(const UiContext& c) {
  const auto shown = c.session.shown();
  return shown != nullptr && !shown->overlaps.empty();
}

std::string runs_summary(const UiContext& c) {
  const auto runs = c.session.runs();
  return runs.empty() ? "none yet" : counted(static_cast<std::int64_t>(runs.size()), "run", "runs");
}

std::string history_summary(const UiContext& c) {
  const auto n = static_cast<std::int64_t>(c.session.history().size()) - 1;
  return n == 0 ? "no changes" : counted(n, "step", "steps");
}

struct SectionLine {
  Section section;
  const char* title;
  std::string (*summary)(const UiContext&);
  void (*body)(UiContext&);
};

constexpr std::array<SectionLine, kSections> kSectionLines{
    SectionLine{Section::Why, "Why not one piece?", no_summary, panel_why},
    SectionLine{Section::Model, "Model", model_summary, panel_model},
    SectionLine{Section::Solve, "Solve", solve_summary, panel_solve},
    SectionLine{Section::Runs, "Runs", runs_summary, panel_runs},
    SectionLine{Section::Tabs, "Tabs", tabs_summary, panel_tabs},
    SectionLine{Section::Paper, "Paper", paper_summary, panel_paper},
    SectionLine{Section::Print, "Print", print_summary, panel_print},
    SectionLine{Section::Export, "Export", export_summary, panel_export},
    SectionLine{Section::Check, "Check", check_summary, panel_check},
    SectionLine{Section::Assembly, "Assembly", assembly_summary, panel_assembly},
    SectionLine{Section::History, "History", history_summary, panel_history},
    SectionLine{Section::Overlaps, "Overlaps", overlaps_summary, panel_overlaps}};

void line_below(const UiState& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x;
  ImGui::GetWindowDrawList()->AddLine(at, ImVec2(right, at.y), ui.look.colours.border);
  ImGui::Dummy(ImVec2(0, 1));
}

}  // namespace

void side_panel(UiContext& context) {
  UiState& ui = context.ui;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.look.px(8), 0));
  for (const SectionLine& line : kSectionLines) {
    if (line.section == Section::Overlaps && !has_overlaps(context)) continue;
    if (line.section == Section::Why && context.session.trouble() == nullptr) continue;
    bool& is_open = ui.settings.is_open(line.section);
    if (section_header(ui, line.title, line.summary(context), is_open)) is_open = !is_open;
    if (is_open) {
      ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.look.px(8), ui.look.px(8)));
      ImGui::Indent(ui.look.px(16));
      ImGui::PushItemWidth(-ui.look.px(16));
      line.body(context);
      ImGui::PopItemWidth();
      ImGui::Unindent(ui.look.px(16));
      ImGui::PopStyleVar();
      ImGui::Dummy(ImVec2(0, ui.look.px(12)));
    }
    line_below(ui);
  }
  ImGui::PopStyleVar();
}

}  // namespace netwright
