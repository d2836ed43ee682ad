// A face's number stands in its middle, a cut's number inside each of its two sides, a fold's number on the
// fold. Numbers count from 1, as the status bar does.
#include "ui/net_numbers.h"

#include <cmath>
#include <string>

#include "render/tree_renderer.h"
#include "ui/view_parts.h"

namespace netwright {
namespace {

constexpr double kRoomyFace = 24;  ///< radius of a face's inner circle from which it has room, design pixels
constexpr float kInset = 9;        ///< from a cut to the middle of its number

struct Target {
  const UiState& ui;
  const Net& net;
  const IdVector<EdgeId, EdgeKind>& kinds;
  const PanZoomCamera& camera;
  ImVec2 corner;
  int n_drawn = 0;
};

/// `at`: its middle, a pixel of the picture.
void number(Target& to, std::int32_t value, glm::dvec2 at, ImU32 colour, bool has_back) {
  const ImFont* font = to.ui.look.fonts.small;
  const std::string text = std::to_string(value + 1);
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str());
  const ImVec2 min(std::floor(to.corner.x + static_cast<float>(at.x) - size.x / 2),
                   std::floor(to.corner.y + static_cast<float>(at.y) - size.y / 2));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float rim = to.ui.look.px(2);
  if (has_back)
    draw.AddRectFilled(ImVec2(min.x - rim, min.y), ImVec2(min.x + size.x + rim, min.y + size.y),
                       to_u32(palette_of(to.ui).paper), rim);
  draw.AddText(font, font->FontSize, min, colour, text.c_str());
  ++to.n_drawn;
}

float text_width(const UiState& ui, std::int32_t value) {
  const ImFont* font = ui.look.fonts.small;
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, std::to_string(value + 1).c_str()).x;
}

void number_edge(Target& to, HalfedgeId h) {
  const Mesh& mesh = to.net.mesh();
  const EdgeId e = mesh.edge(h);
  const bool is_cut = to.kinds[e] == EdgeKind::Cut || to.kinds[e] == EdgeKind::Border;
  if (!is_cut && h != mesh.halfedge(e)) return;
  const glm::dvec2 a = to.camera.to_pixel(to.net.corner(h));
  const glm::dvec2 b = to.camera.to_pixel(to.net.corner(mesh.next(h)));
  const double length = glm::length(b - a);
  const Look& look = to.ui.look;
  if (length < static_cast<double>(text_width(to.ui, e.value) + look.px(24))) return;
  const glm::dvec2 along = (b - a) / length;
  const glm::dvec2 inward(along.y, -along.x);  // pixels have y down
  const double inset = is_cut ? static_cast<double>(look.px(kInset)) : 0;
  const Palette& p = palette_of(to.ui);
  const EdgeKind kind = to.kinds[e];
  const Colour colour = kind == EdgeKind::Mountain ? p.mountain : kind == EdgeKind::Valley ? p.valley : p.cut;
  number(to, e.value, (a + b) * 0.5 + inset * inward, to_u32(colour), !is_cut);
}

/// Radius of a circle inside the face, for faces that are about as wide as long.
double inner_radius_px(const Target& to, FaceId f) {
  const Mesh& mesh = to.net.mesh();
  double rim = 0;
  for (const HalfedgeId h : mesh.halfedges(f)) rim += mesh.length(mesh.edge(h));
  return 2 * mesh.area(f) / rim * to.camera.pixels_per_unit();
}

}  // namespace

int draw_numbers(const UiState& ui, const Net& net, const IdVector<EdgeId, EdgeKind>& kinds,
                 const PanZoomCamera& camera, ImVec2 corner) {
  Target to{ui, net, kinds, camera, corner};
  const double roomy = kRoomyFace * static_cast<double>(ui.look.scale);
  const glm::dvec2 size = camera.size_px();
  ImGui::GetWindowDrawList()->PushClipRect(
      corner, ImVec2(corner.x + static_cast<float>(size.x), corner.y + static_cast<float>(size.y)), true);
  const Box2 seen = camera.visible();
  for (const FaceId f : net.mesh().faces()) {
    if (inner_radius_px(to, f) < roomy) continue;
    const Box2 box = net.box(f);
    if (box.max.x < seen.min.x || box.min.x > seen.max.x || box.max.y < seen.min.y || box.min.y > seen.max.y)
      continue;
    for (const HalfedgeId h : net.mesh().halfedges(f)) number_edge(to, h);
    number(to, f.value, camera.to_pixel(face_anchor(net, f)),
           ui.look.colours.is_dark ? IM_COL32(0x4A, 0x50, 0x5A, 255) : IM_COL32(0x5C, 0x63, 0x6E, 255), true);
  }
  ImGui::GetWindowDrawList()->PopClipRect();
  return to.n_drawn;
}

}  // namespace netwright
