// What is drawn around chosen pieces: their outlines, the handle that turns them, guides where something
// snaps, and the new sheet that a piece is about to get.
#include <algorithm>

#include "core/sheet/outline.h"
#include "ui/arranging.h"
#include "ui/desk.h"

namespace netwright {
namespace {

ImVec2 to_screen(const PanZoomCamera& camera, ImVec2 corner, glm::dvec2 world) {
  const glm::dvec2 pixel = camera.to_pixel(world);
  return {corner.x + static_cast<float>(pixel.x), corner.y + static_cast<float>(pixel.y)};
}

void draw_box(const Look& look, const PanZoomCamera& camera, ImVec2 corner, const Box2& box, ImU32 colour) {
  ImGui::GetWindowDrawList()->AddRect(to_screen(camera, corner, {box.min.x, box.max.y}),
                                      to_screen(camera, corner, {box.max.x, box.min.y}), colour, 0, 0,
                                      look.px(1));
}

/// Where the net may lie: title and legend keep the rest of the sheet.
void draw_rooms(const UiContext& c, const PageLayout& layout, const PanZoomCamera& camera, ImVec2 corner) {
  const ImU32 colour = to_u32(Colour(glm::vec3(palette_of(c.ui).hover_edge), 0.7F));
  for (int i = 0; i < static_cast<int>(layout.canvases.size()); ++i)
    draw_box(c.ui.look, camera, corner, room_on_desk(layout, i), colour);
}

void draw_new_sheet(const UiContext& c, const PanZoomCamera& camera, ImVec2 corner) {
  const Arranging& a = c.ui.arranging;
  const auto n = static_cast<int>(a.layout->canvases.size());
  const bool is_wanted = std::any_of(a.pieces.begin(), a.pieces.end(), [&](int piece) {
    const glm::dvec2 centre = a.motion(a.boxes[static_cast<std::size_t>(piece)].centre());
    return canvas_at(*a.layout, centre.x * a.layout->scale) == n;
  });
  if (!is_wanted) return;
  const ImU32 colour = to_u32(palette_of(c.ui).hover_edge);
  const Box2 sheet = sheet_on_desk(*a.layout, n);
  draw_box(c.ui.look, camera, corner, sheet, colour);
  draw_box(c.ui.look, camera, corner, room_on_desk(*a.layout, n), colour);
  const ImVec2 at = to_screen(camera, corner, {sheet.min.x, sheet.max.y});
  const ImFont* font = c.ui.look.fonts.small;
  ImGui::GetWindowDrawList()->AddText(font, font->FontSize,
                                      ImVec2(at.x + c.ui.look.px(6), at.y + c.ui.look.px(4)),
                                      c.ui.look.colours.text, "New sheet");
}

void draw_guides(const UiContext& c, const PanZoomCamera& camera, ImVec2 corner) {
  const Box2 seen = camera.visible();
  const ImU32 colour = to_u32(palette_of(c.ui).hover_edge);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto& guides = c.ui.arranging.guides;
  if (guides[0])
    draw.AddLine(to_screen(camera, corner, {*guides[0], seen.min.y}),
                 to_screen(camera, corner, {*guides[0], seen.max.y}), colour, c.ui.look.px(1));
  if (guides[1])
    draw.AddLine(to_screen(camera, corner, {seen.min.x, *guides[1]}),
                 to_screen(camera, corner, {seen.max.x, *guides[1]}), colour, c.ui.look.px(1));
}

void draw_handle(const UiContext& c, const Net& drawn, const PanZoomCamera& camera, ImVec2 corner) {
  const auto handle = turn_handle(c, drawn, camera);
  if (!handle) return;
  const Look& look = c.ui.look;
  const ImU32 line = to_u32(palette_of(c.ui).selection);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 at(corner.x + static_cast<float>(handle->x), corner.y + static_cast<float>(handle->y));
  draw.AddLine(ImVec2(at.x, at.y + look.px(9)), ImVec2(at.x, at.y + look.px(24)), line, look.px(1.5F));
  draw.AddCircleFilled(at, look.px(9), look.colours.field);
  draw.AddCircle(at, look.px(9), line, 0, look.px(2));
  // A bent arrow: what the handle does.
  draw.PathArcTo(at, look.px(4), -2.2F, 2.0F, 12);
  draw.PathStroke(look.colours.text, 0, look.px(1.3F));
  const ImVec2 tip(at.x - look.px(2.4F), at.y - look.px(3.2F));
  draw.AddTriangleFilled(ImVec2(tip.x - look.px(1.8F), tip.y + look.px(1.6F)),
                         ImVec2(tip.x + look.px(0.4F), tip.y - look.px(2.4F)),
                         ImVec2(tip.x + look.px(1.8F), tip.y + look.px(1.8F)), look.colours.text);
}

}  // namespace

void add_arranging(const UiContext& c, const Net& drawn, OverlayLines& lines) {
  if (!c.ui.arranging.is_on) return;
  const std::vector<int> chosen = chosen_pieces(c);
  if (chosen.empty()) return;
  for (const OutlineLoop& loop : outline_loops(drawn)) {
    if (!std::binary_search(chosen.begin(), chosen.end(), loop.piece)) continue;
    for (const HalfedgeId h : loop.sides)
      lines.add_in_plane(drawn.corner(h), drawn.corner(drawn.mesh().next(h)), OverlayStyle::Selected);
  }
}

void draw_arranging(const UiContext& c, const Scene& scene, const PanZoomCamera& camera, ImVec2 corner) {
  if (!is_arranging(c, scene)) return;
  const Arranging& a = c.ui.arranging;
  draw_rooms(c, *c.session.pages(), camera, corner);
  if (a.has_motion && a.grip == Arranging::Grip::Move) draw_new_sheet(c, camera, corner);
  draw_guides(c, camera, corner);
  if (a.grip != Arranging::Grip::Move) draw_handle(c, *scene.net(), camera, corner);
}

}  // namespace netwright
