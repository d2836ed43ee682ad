// The net's view. As long as the user has not moved the camera it keeps the whole net in sight.
#include "ui/net_view.h"

#include <array>
#include <cmath>

#include "assets/icons.h"
#include "ui/status.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr double kTooSmall = 0.55;  ///< a net that fills less of the view than this is framed again

/// While a search runs the net changes size at every move; following each would make the picture tremble.
bool needs_framing(const PanZoomCamera& camera, const Box2& box) {
  const Box2 seen = camera.visible();
  const bool is_outside =
      box.min.x < seen.min.x || box.min.y < seen.min.y || box.max.x > seen.max.x || box.max.y > seen.max.y;
  const glm::dvec2 share = box.size() / seen.size();
  return is_outside || std::max(share.x, share.y) < kTooSmall;
}

float legend_height(const UiState& ui) { return ui.look.px(40); }

struct LegendItem {
  const char* label;
  void (*draw)(ImDrawList&, const Palette&, ImVec2 min, ImVec2 max, float scale);
};

void draw_dashes(ImDrawList& draw, ImVec2 from, float to_x, ImU32 colour, float scale,
                 std::initializer_list<float> dash) {
  float x = from.x;
  bool is_ink = true;
  while (x < to_x) {
    for (const float length : dash) {
      const float end = std::min(x + length * scale, to_x);
      if (is_ink && end > x) draw.AddLine(ImVec2(x, from.y), ImVec2(end, from.y), colour, 1.5F * scale);
      is_ink = !is_ink;
      x = end;
    }
  }
}

void draw_swatch(ImDrawList& draw, const Palette& colours, ImVec2 min, ImVec2 max, float scale) {
  draw.AddRectFilled(min, max, to_u32(colours.paper), 2 * scale);
}

constexpr std::array<LegendItem, 6> kLegend{
    LegendItem{"cut",
               [](ImDrawList& draw, const Palette& p, ImVec2 min, ImVec2 max, float scale) {
                 const ImVec2 from(min.x + 4 * scale, (min.y + max.y) / 2);
                 draw_dashes(draw, from, max.x - 4 * scale, to_u32(p.cut), scale, {100, 0});
               }},
    LegendItem{"mountain",
               [](ImDrawList& draw, const Palette& p, ImVec2 min, ImVec2 max, float scale) {
                 const ImVec2 from(min.x + 4 * scale, (min.y + max.y) / 2);
                 draw_dashes(draw, from, max.x - 4 * scale, to_u32(p.mountain), scale, {6, 2, 2, 2});
               }},
    LegendItem{"valley",
               [](ImDrawList& draw, const Palette& p, ImVec2 min, ImVec2 max, float scale) {
                 const ImVec2 from(min.x + 4 * scale, (min.y + max.y) / 2);
                 draw_dashes(draw, from, max.x - 4 * scale, to_u32(p.valley), scale, {4, 3});
               }},
    LegendItem{"tree",
               [](ImDrawList& draw, const Palette& p, ImVec2 min, ImVec2 max, float scale) {
                 const ImVec2 from(min.x + 4 * scale, (min.y + max.y) / 2);
                 draw_dashes(draw, from, max.x - 4 * scale, to_u32(p.tree), scale, {100, 0});
               }},
    LegendItem{"root",
               [](ImDrawList& draw, const Palette& p, ImVec2 min, ImVec2 max, float scale) {
                 const ImVec2 middle((min.x + max.x) / 2, (min.y + max.y) / 2);
                 draw.AddCircleFilled(middle, 4.5F * scale, to_u32(p.root), 16);
                 draw.AddCircle(middle, 4.5F * scale, to_u32(p.root_rim), 16, 1.5F * scale);
               }},
    LegendItem{"overlap",
               [](ImDrawList& draw, const Palette& p, ImVec2 min, ImVec2 max, float scale) {
                 draw.AddRectFilled(min, max, to_u32(p.overlap), 2 * scale);
                 draw.PushClipRect(min, max, true);
                 const float height = max.y - min.y;
                 for (float x = min.x - height; x < max.x; x += 5 * scale) {
                   draw.AddLine(ImVec2(x, max.y), ImVec2(x + height, min.y), to_u32(p.overlap_hatch),
                                1.5F * scale);
                 }
                 draw.PopClipRect();
               }},
};

bool is_listed(const LegendItem& item, const UiState& ui, bool has_overlaps) {
  const std::string_view label = item.label;
  if (label == "tree") return ui.settings.show_tree;
  if (label == "root") return ui.settings.show_root;
  if (label == "overlap") return ui.settings.show_overlaps && has_overlaps;
  return true;
}

float swatch_width(const UiState& ui, const LegendItem& item) {
  const std::string_view label = item.label;
  return ui.look.px(label == "root" || label == "overlap" ? 16 : 32);
}

/// Between two entries: less where the view is narrow, so that all of them stay.
float legend_gap(const UiState& ui, bool has_overlaps, float width) {
  float used = ui.look.px(32);
  int entries = 0;
  ImFont* font = ui.look.fonts.small;
  for (const LegendItem& item : kLegend) {
    if (!is_listed(item, ui, has_overlaps)) continue;
    used += swatch_width(ui, item) + ui.look.px(6) +
            font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, item.label).x;
    ++entries;
  }
  const float each = (width - used) / static_cast<float>(std::max(entries - 1, 1));
  return std::clamp(each, ui.look.px(4), ui.look.px(16));
}

}  // namespace

void NetView::follow_net(UiContext& context, const Scene& scene) {
  UiState& ui = context.ui;
  const Net* net = scene.net();
  if (model_version_ != scene.model_version()) is_moved_by_user_ = false;
  const bool is_asked = ui.wants_frame_net;
  ui.wants_frame_net = false;
  if (is_asked) is_moved_by_user_ = false;
  if (net == nullptr) return;
  const bool is_laid_anew = was_on_pages_ != scene.is_on_pages() || model_version_ != scene.model_version();
  const bool is_new = version_ != scene.version();
  model_version_ = scene.model_version();
  version_ = scene.version();
  was_on_pages_ = scene.is_on_pages();
  const bool is_resting = context.session.state() == RunState::Idle;
  const bool is_due =
      is_asked || is_laid_anew || needs_framing(camera_, scene.net_box()) || (is_new && is_resting);
  if (is_due && !is_moved_by_user_) camera_.frame(scene.net_box(), ui.look.px(24));
  if (!ui.centre_now.is_valid()) return;
  camera_.centre_on(net->box(ui.centre_now).centre());
  is_moved_by_user_ = true;
}

void NetView::handle(UiContext& context, const Scene& scene, const Gesture& gesture) {
  UiState& ui = context.ui;
  if (scene.net() == nullptr) return;
  const glm::dvec2 pointer(gesture.pointer.x, gesture.pointer.y);
  const FaceId under = gesture.is_hovered ? scene.net_picker().pick(camera_.to_world(pointer)) : FaceId();
  if (gesture.is_pressed) is_panning_ = !under.is_valid();
  if (gesture.drag_button > 0 || (gesture.drag_button == 0 && is_panning_)) {
    camera_.pan({gesture.drag.x, gesture.drag.y});
    is_moved_by_user_ = true;
  }
  if (gesture.wheel != 0) {
    camera_.zoom(std::pow(1.15, gesture.wheel), pointer);
    is_moved_by_user_ = true;
  }
  if (!gesture.is_hovered || gesture.drag_button >= 0) return;
  ui.hovered = under;
  ui.hint = under.is_valid()
                ? face_text(under) + " · click selects · R makes it the root · double-click centres it"
                : "Drag moves · wheel zooms · F shows all";
  if (gesture.is_clicked) ui.selected = under;
  if (gesture.is_double_clicked && under.is_valid()) ui.wants_centre = under;
}

void NetView::paint(const UiContext& context, const Scene& scene, Renderers& renderers) {
  const UiState& ui = context.ui;
  const Palette& colours = palette_of(ui);
  Background::clear_desk(colours);
  if (scene.net() == nullptr) return;
  NetLook look;
  look.scale = ui.look.scale;
  renderers.net.draw(camera_, colours, scene.states(), look);
  TreeLook tree{ui.settings.show_tree, ui.settings.show_root, true, ui.look.scale};
  renderers.tree.draw_on_net(camera_, colours, tree);
}

void NetView::legend(const UiContext& context, const Scene& scene) {
  const UiState& ui = context.ui;
  const Look& look = ui.look;
  const Palette& colours = palette_of(ui);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, legend_height(ui));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 max(min.x + size.x, min.y + size.y);
  draw.AddRectFilled(min, max, to_u32(colours.desk));
  if (scene.net() == nullptr) return;
  ImFont* font = look.fonts.small;
  const bool has_overlaps = !scene.shown()->overlaps.empty();
  const float gap = legend_gap(ui, has_overlaps, size.x);
  float x = min.x + look.px(16);
  const float middle = min.y + size.y / 2;
  for (const LegendItem& item : kLegend) {
    if (!is_listed(item, ui, has_overlaps)) continue;
    const ImVec2 extent = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, item.label);
    const ImVec2 corner(x, std::floor(middle - look.px(8)));
    const ImVec2 end(x + swatch_width(ui, item), corner.y + look.px(16));
    draw_swatch(draw, colours, corner, end, look.scale);
    item.draw(draw, colours, corner, end, look.scale);
    x = end.x + look.px(6);
    draw.AddText(font, font->FontSize, ImVec2(x, std::floor(middle - extent.y / 2)), look.colours.text,
                 item.label);
    x += extent.x + gap;
  }
}

void NetView::draw(UiContext& context, const Scene& scene, Renderers& renderers) {
  UiState& ui = context.ui;
  const std::string state = scene.net() == nullptr ? "" : status_of(context.session).in_short;
  view_header(context, "net", "Net", state, to_u32(palette_of(ui).desk),
              {ActionId::ToggleTree, ActionId::ToggleOverlaps, ActionId::ToggleRoot, ActionId::TogglePages,
               ActionId::Frame});
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 size(room.x, room.y - legend_height(ui));
  if (size.x < 1 || size.y < 1) return;
  camera_.set_size({size.x, size.y});
  follow_net(context, scene);
  handle(context, scene, picture_gesture(ui, "net/picture", size));
  PictureKey key;
  key.add(camera_).add(scene.version()).add(ui.look.colours.is_dark).add(ui.look.scale);
  key.add(ui.settings.show_tree).add(ui.settings.show_root);
  key.add_bytes(scene.states().bits().data(), scene.states().size());
  renderers.net_picture.redraw({static_cast<int>(size.x), static_cast<int>(size.y)}, key,
                               [&] { paint(context, scene, renderers); });
  const auto texture = reinterpret_cast<ImTextureID>(renderers.net_picture.texture());
  ImGui::GetWindowDrawList()->AddImage(texture, corner, ImVec2(corner.x + size.x, corner.y + size.y),
                                       ImVec2(0, 1), ImVec2(1, 0));
  ImGui::SetCursorScreenPos(ImVec2(corner.x, corner.y + size.y));
  legend(context, scene);
}

}  // namespace netwright
