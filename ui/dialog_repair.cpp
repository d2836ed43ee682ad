// What to do with a file that cannot be unfolded as it is: what is wrong, what repairing would do, and the
// three ways on. Nothing is repaired without this question.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "assets/icons.h"
#include "ui/actions.h"
#include "ui/dialogs.h"
#include "ui/repair_rows.h"
#include "ui/status.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr float kWidth = 600;
constexpr float kFrameHeight = 138;  ///< title, footer and margins
constexpr float kLeastHeight = 220;

void heading(const UiState& ui, const char* text) {
  ImGui::Dummy(ImVec2(0, ui.look.px(4)));
  ImGui::PushFont(ui.look.fonts.bold);
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
}

void sentence(const UiState& ui, const char* sign, ImU32 colour, const std::string& text) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddText(at, colour, sign);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.look.px(24));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

/// A sentence as said beside a button that cures it: without the advice behind its semicolon.
std::string without_advice(std::string text) {
  const auto advice = text.rfind("; ");
  if (advice != std::string::npos) text.replace(advice, std::string::npos, ".");
  return text;
}

/// A refusal without the file's name, which is in the title.
std::string reason_alone(const Session::Pending& pending, const std::string& refusal) {
  std::string text = without_advice(refusal);
  if (text.starts_with(pending.name + ": ")) text.erase(0, pending.name.size() + 2);
  if (!text.empty()) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

/// However long the file's name is, what is the matter with it stays to be read.
std::string title_of(const UiState& ui, const std::string& name) {
  constexpr const char* kRest = " needs repair";
  ImGui::PushFont(ui.look.fonts.title);
  const float dialog = std::min(ui.look.px(kWidth), ImGui::GetIO().DisplaySize.x - ui.look.px(32));
  const float room = dialog - ui.look.px(40) - ImGui::CalcTextSize(kRest).x;
  std::string title = shortened(name, room) + kRest;
  ImGui::PopFont();
  return title;
}

std::string before_and_after(int before, int after) {
  return before == after ? "It stays at " + counted(after, "face", "faces") + "."
                         : counted(before, "face", "faces") + " before, " + grouped(after) + " after.";
}

void describe(const UiState& ui, const Session::Pending& pending) {
  const Colours& colours = ui.look.colours;
  if (!ui.error.empty()) sentence(ui, icon::kError, colours.bad, ui.error);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(reason_alone(pending, pending.refusal).c_str());
  ImGui::PopTextWrapPos();
  note_widget(ui, "repair/refusal");
  heading(ui, "What is wrong");
  for (const MeshReport::Line& line : pending.report.lines) {
    if (line.kind != MeshReport::Line::Kind::Problem || line.text == pending.refusal) continue;
    sentence(ui, icon::kError, colours.bad, without_advice(line.text));
    note_widget(ui, "repair/" + std::string(topic_name(line.topic)));
  }
}

/// What comes of the repairs that are wanted.
void outcome(const UiState& ui, const Session::Pending& pending) {
  heading(ui, "Result");
  if (!pending.is_fit()) {
    sentence(ui, icon::kError, ui.look.colours.bad,
             "That is not enough: " + reason_alone(pending, pending.made->refusal));
    note_widget(ui, "repair/not-enough");
    return;
  }
  for (const std::string& done : beyond_rows(*pending.made->stages))
    sentence(ui, icon::kDone, ui.look.colours.good, done);
  const auto n_after = static_cast<int>(pending.made->dual->mesh().n_faces());
  text_muted(ui, before_and_after(pending.report.n_faces, n_after));
  note_widget(ui, "repair/faces");
}

/// The steps, each with its switch; a change is tried at once.
void choose(UiContext& context, const Session::Pending& pending) {
  UiState& ui = context.ui;
  heading(ui, "Repairs");
  const double unit_mm = guess_unit(*pending.made->stages->source).in_mm;
  const float width = ImGui::GetContentRegionAvail().x - ui.look.px(4);
  const auto change = repair_rows(ui, pending.recipe, pending.made->stages->survey->repairs, unit_mm, width);
  if (change) {
    ui.error.clear();
    context.session.try_pending(change->recipe);
  }
}

}  // namespace

void Dialogs::draw_trying(UiContext& context) {
  const UiState& ui = context.ui;
  const auto chore = context.session.chore();
  const double fraction = chore == nullptr ? 0 : chore->fraction();
  const float bottom = ImGui::GetWindowHeight() - ui.look.px(48);
  ImGui::SetCursorPos(ImVec2(ui.look.px(20), bottom));
  text_small(ui, (chore == nullptr ? "" : chore->phase()) + "… " +
                     std::to_string(std::lround(fraction * 100)) + " %");
  ImGui::SetCursorPos(ImVec2(ui.look.px(20), bottom + ui.look.px(22)));
  progress_line(ui, ui.look.px(200), fraction);
  note_widget(ui, "repair/progress");
  // Giving up the work is not giving up the file: Esc leads back to the question.
  const bool is_escaped = std::exchange(is_cancelled_, false);
  is_accepted_ = false;
  if (footer(context, {"Stop", true, false}) || is_escaped) context.session.cancel_opening();
}

void Dialogs::draw_choices(UiContext& context, const Session::Pending& pending) {
  UiState& ui = context.ui;
  Session& session = context.session;
  const bool is_all = with_all_repairs(pending.recipe) == pending.recipe;
  if (!is_all) {
    ButtonSpec all{"repair/all", "All repairs"};
    all.kind = ButtonKind::Outlined;
    all.tip = "Switches on everything that changes nothing but faults";
    ImGui::SetCursorPos(ImVec2(ui.look.px(20), ImGui::GetWindowHeight() - ui.look.px(48)));
    if (button(ui, all)) session.try_pending(with_all_repairs(pending.recipe));
  }
  Footer what{is_all ? "Repair all" : "Repair"};
  what.is_enabled = pending.is_fit() && !session.is_making();
  what.why_not = session.is_making() ? "Still trying these repairs." : "These repairs are not enough.";
  const bool is_accepted = footer(context, what);
  const bool is_cancelled = present_ == Dialog::None;
  if (is_cancelled) {
    session.drop_pending();
    ui.error.clear();
  } else if (is_accepted) {
    session.repair_pending();
  }
}

void Dialogs::draw_repair(UiContext& context) {
  UiState& ui = context.ui;
  const Session::Pending* pending = context.session.pending();
  const std::string title = pending == nullptr ? " " : title_of(ui, pending->name);
  const float height = std::max(repair_height_ / ui.look.scale + kFrameHeight, kLeastHeight);
  if (!begin_window(ui, kWidth, height, title)) return;
  if (pending != nullptr) {
    ImGui::BeginChild("about", ImVec2(0, ImGui::GetContentRegionAvail().y - ui.look.px(44)));
    const float top = ImGui::GetCursorPosY();
    describe(ui, *pending);
    choose(context, *pending);
    outcome(ui, *pending);
    const float drawn = ImGui::GetCursorPosY() - top;
    if (drawn != repair_height_) ui.frames_wanted = std::max(ui.frames_wanted, 2);
    repair_height_ = drawn;
    ImGui::EndChild();
    // What takes only a moment would but flicker.
    constexpr double kNoticeable_s = 0.3;
    if (context.session.is_making() && ui.now - ui.chore_since > kNoticeable_s) {
      draw_trying(context);
    } else {
      draw_choices(context, *pending);
    }
  }
  if (present_ == Dialog::Repair && context.session.pending() == nullptr) {
    ui.settings.is_open(Section::Model) = true;  // where one reads what was done
    finish(context);
  }
  ImGui::EndPopup();
}

}  // namespace netwright
