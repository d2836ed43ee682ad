// The separate parts of the model, the largest first: each gets a piece of paper of its own unless it is left
// out. Pointing at one lights it in both views.
#include <algorithm>
#include <unordered_set>

#include "core/base/counted.h"
#include "core/mesh/mesh_report.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr float kRowHeight = 44;
constexpr float kRowsShown = 6.5F;  ///< the half row says that there are more

bool is_left_out(const Recipe& recipe, const ModelPart& part) {
  return std::ranges::find(recipe.left_out, part.first_face) != recipe.left_out.end();
}

void set_left_out(Recipe& recipe, const ModelPart& part, bool is_out) {
  std::erase(recipe.left_out, part.first_face);
  if (is_out && part.first_face >= 0) recipe.left_out.push_back(part.first_face);
  std::ranges::sort(recipe.left_out);
}

/// The mesh's faces that belong to a part of the model it was made of: its components that hold one of the
/// part's faces, since faces that a repair made cannot be told by the file's numbers.
std::vector<FaceId> faces_of(const Project& project, const ModelPart& part) {
  const Mesh& whole = *project.made->stages->whole;
  const Mesh& mesh = project.dual->mesh();
  std::unordered_set<int> sources;
  for (const int f : part.faces) sources.insert(whole.face_source(FaceId(f)));
  sources.erase(-1);
  std::vector<bool> is_mine(mesh.n_components(), false);
  for (const FaceId f : mesh.faces()) {
    if (sources.contains(mesh.face_source(f))) is_mine[static_cast<std::size_t>(mesh.component(f))] = true;
  }
  std::vector<FaceId> faces;
  for (const FaceId f : mesh.faces())
    if (is_mine[static_cast<std::size_t>(mesh.component(f))]) faces.push_back(f);
  return faces;
}

std::string about(const ModelPart& part, double unit_mm, LengthUnit unit) {
  const glm::dvec3 size = part.size * (unit_mm / in_millimetres(unit));
  return size_text(size) + " " + sign_of(unit) + (part.is_inner ? ", inside" : "") +
         (part.is_small ? ", small" : "");
}

class PartList {
 public:
  PartList(UiContext& context, const std::vector<ModelPart>& parts)
      : context_(context), ui_(context.ui), parts_(parts), recipe_(context.session.wanted_recipe()) {
    for (const ModelPart& part : parts) n_kept_ += is_left_out(recipe_, part) ? 0 : 1;
    unit_mm_ = guess_unit(*context.session.project().source).in_mm;
  }

  void draw() {
    const Look& look = ui_.look;
    ImGui::Dummy(ImVec2(0, look.px(2)));
    ImGui::PushFont(look.fonts.bold);
    ImGui::TextUnformatted("Parts");
    ImGui::PopFont();
    text_small(ui_, n_kept_ == static_cast<int>(parts_.size())
                        ? "Each becomes a piece of its own."
                        : grouped(n_kept_) + " of " +
                              counted(static_cast<std::int64_t>(parts_.size()), "part", "parts") +
                              " become pieces.");
    note_widget(ui_, "parts/summary");
    const float rows = std::min(static_cast<float>(parts_.size()), kRowsShown);
    const float width = ImGui::GetContentRegionAvail().x - look.px(16);
    std::optional<std::size_t> hovered;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    ImGui::BeginChild("parts", ImVec2(width, std::floor(rows * look.px(kRowHeight))));
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(parts_.size()), look.px(kRowHeight));
    while (clipper.Step()) {
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
        if (row(static_cast<std::size_t>(i))) hovered = static_cast<std::size_t>(i);
      }
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
    light(hovered);
    buttons();
  }

 private:
  /// True while the pointer is on it.
  bool row(std::size_t index) {
    const ModelPart& part = parts_[index];
    const Look& look = ui_.look;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 end(at.x + ImGui::GetContentRegionAvail().x, at.y + look.px(kRowHeight));
    const bool is_hovered = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(at, end);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (is_hovered) draw.AddRectFilled(at, end, look.colours.hover, look.px(4));
    bool is_kept = !is_left_out(recipe_, part);
    const bool is_last = is_kept && n_kept_ == 1;
    const std::string number = std::to_string(index + 1);
    if (is_last) ImGui::BeginDisabled();
    const bool is_clicked = checkbox(
        ui_, "parts/" + number,
        "Part " + number + ", " + counted(static_cast<std::int64_t>(part.faces.size()), "face", "faces"),
        is_kept, is_last ? "One part has to stay" : "");
    if (is_last) ImGui::EndDisabled();
    if (is_clicked) {
      set_left_out(recipe_, part, !is_kept);
      context_.session.set_recipe(recipe_, is_kept ? "keep part " + number : "leave out part " + number);
    }
    draw.AddText(look.fonts.small, look.fonts.small->FontSize, ImVec2(at.x + look.px(26), at.y + look.px(24)),
                 look.colours.muted, about(part, unit_mm_, ui_.settings.unit).c_str());
    ImGui::SetCursorScreenPos(ImVec2(at.x, end.y));
    ImGui::Dummy(ImVec2(0, 0));
    return is_hovered;
  }

  void light(std::optional<std::size_t> hovered) {
    if (hovered == ui_.hovered_part) return;
    ui_.hovered_part = hovered;
    ui_.hovered_part_faces.clear();
    if (hovered) ui_.hovered_part_faces = faces_of(context_.session.project(), parts_[*hovered]);
    ui_.frames_wanted = std::max(ui_.frames_wanted, 2);
  }

  template <class IsMeant>
  void button_for(const char* name, const char* label, const char* undo, IsMeant is_meant) {
    const bool has_any = std::ranges::any_of(
        parts_, [&](const ModelPart& part) { return is_meant(part) && !is_left_out(recipe_, part); });
    if (!has_any) return;
    if (n_buttons_++ == 0) {
      ImGui::AlignTextToFramePadding();
      ImGui::TextUnformatted("Leave out");
    }
    ImGui::SameLine(0, ui_.look.px(8));
    ButtonSpec spec{name, label};
    spec.kind = ButtonKind::Outlined;
    spec.height = ui_.look.px(30);
    if (!button(ui_, spec)) return;
    Recipe recipe = recipe_;
    for (const ModelPart& part : parts_) {
      if (is_meant(part)) set_left_out(recipe, part, true);
    }
    context_.session.set_recipe(recipe, undo);
  }

  void buttons() {
    ImGui::Dummy(ImVec2(0, 0));
    button_for("parts/small", "Small", "leave out small parts",
               [](const ModelPart& part) { return part.is_small; });
    button_for("parts/inner", "Inner", "leave out inner parts",
               [](const ModelPart& part) { return part.is_inner; });
    if (recipe_.left_out.empty()) return;
    ButtonSpec all{"parts/all", "Keep all"};
    all.kind = ButtonKind::Outlined;
    all.height = ui_.look.px(30);
    if (!button(ui_, all)) return;
    Recipe recipe = recipe_;
    recipe.left_out.clear();
    context_.session.set_recipe(recipe, "keep all parts");
  }

  UiContext& context_;
  UiState& ui_;
  const std::vector<ModelPart>& parts_;
  Recipe recipe_;
  double unit_mm_ = 1;
  int n_kept_ = 0;
  int n_buttons_ = 0;
};

}  // namespace

void panel_parts(UiContext& context) {
  const auto survey = context.session.project().made->stages->survey;
  if (survey == nullptr || survey->parts.size() < 2) return;
  PartList(context, survey->parts).draw();
}

}  // namespace netwright
