// While a piece is dragged the scene draws it with the motion on top of its pages. When the button is
// released the motion stays until the new pages are there, so that nothing jumps in between.
#include "ui/arranging.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/base/counted.h"
#include "ui/desk.h"
#include "ui/editing.h"
#include "ui/measure.h"
#include "ui/selection.h"
#include "ui/tab_tool.h"

namespace netwright {
namespace {

constexpr float kSnapReach = 8;             ///< design pixels
constexpr std::size_t kMostChecked = 4000;  ///< faces that are checked at every move of the mouse

const ShownNet& shown_of(const UiContext& c) { return *c.session.shown(); }

Rigid2 shift(glm::dvec2 way) { return {1, 0, way.x, way.y}; }

bool holds(const std::vector<int>& pieces, int piece) {
  return std::find(pieces.begin(), pieces.end(), piece) != pieces.end();
}

std::vector<Box2> piece_boxes(const Net& drawn) {
  std::vector<Box2> boxes(static_cast<std::size_t>(drawn.n_pieces));
  for (const FaceId f : drawn.mesh().faces())
    boxes[static_cast<std::size_t>(drawn.piece[f])].add(drawn.box(f));
  return boxes;
}

std::vector<FaceId> faces_of(const Net& net, int piece) {
  std::vector<FaceId> faces;
  for (const FaceId f : net.mesh().faces())
    if (net.piece[f] == piece) faces.push_back(f);
  return faces;
}

void select_piece(UiContext& c, int piece, bool adds) {
  const std::vector<int> chosen = chosen_pieces(c);
  const std::vector<FaceId> faces = faces_of(shown_of(c).net, piece);
  std::vector<FaceId> before = adds ? c.ui.selected_faces : std::vector<FaceId>();
  const bool lets_go = adds && holds(chosen, piece);
  if (lets_go)
    std::erase_if(before, [&](FaceId f) { return std::binary_search(faces.begin(), faces.end(), f); });
  clear_selection(c.ui);
  select_faces(c.ui, lets_go ? std::vector<FaceId>() : faces, before);
}

/// The motion of the net's view as one of each piece's canvas, in mm.
std::vector<PieceMotion> motions_of(const Arranging& a) {
  const PageLayout& layout = *a.layout;
  std::vector<PieceMotion> motions;
  for (const int piece : a.pieces) {
    const int canvas = layout.pieces[static_cast<std::size_t>(piece)].canvas;
    const glm::dvec2 centre = a.motion(a.boxes[static_cast<std::size_t>(piece)].centre()) * layout.scale;
    const int goal = canvas_at(layout, centre.x);
    Rigid2 motion = a.motion;
    motion.x *= layout.scale;
    motion.y *= layout.scale;
    motion = shift({-canvas_left(layout, goal), 0}) * motion * shift({canvas_left(layout, canvas), 0});
    motions.push_back({piece, goal, motion});
  }
  return motions;
}

void set_motion(UiContext& c, const Rigid2& motion) {
  Arranging& a = c.ui.arranging;
  if (a.has_motion && a.motion == motion) return;
  a.motion = motion;
  a.has_motion = true;
  ++a.version;
  const Net& net = a.shown->net;
  a.goal = move_pieces(net, *a.layout, motions_of(a));
  a.misplaced.clear();
  if (net.mesh().n_faces() > kMostChecked) return;
  const auto layout = lay_out(net, c.session.project().paper, a.goal, a.layout->tabs);
  if (layout) a.misplaced = find_misplaced(net, *layout).faces;
}

/// What snaps to the edge of the sheet is the paper to be cut out, tabs and all.
void add_tabs(const Net& net, const PageLayout& layout, std::vector<Box2>& boxes) {
  for (const GlueTab& tab : layout.tabs.tabs) {
    const int piece = net.piece[net.mesh().face(tab.side)];
    const double left = canvas_left(layout, layout.pieces[static_cast<std::size_t>(piece)].canvas);
    for (const glm::dvec2 p : tab.points) {
      const glm::dvec2 at = layout.on_canvas_mm(piece, p);
      boxes[static_cast<std::size_t>(piece)].add(glm::dvec2(left + at.x, -at.y) / layout.scale);
    }
  }
}

void take_hold(UiContext& c, const Scene& scene, Arranging::Grip grip, glm::dvec2 at) {
  Arranging& a = c.ui.arranging;
  a.grip = grip;
  a.pieces = chosen_pieces(c);
  a.from = at;
  a.shown = c.session.shown();
  a.layout = c.session.pages();
  a.boxes = piece_boxes(*scene.net());
  add_tabs(a.shown->net, *a.layout, a.boxes);
  a.box = Box2();
  for (const int piece : a.pieces) a.box.add(a.boxes[static_cast<std::size_t>(piece)]);
  a.levels = level_turns(a.shown->net, *a.layout, a.pieces);
}

void let_go(Arranging& a) {
  const std::uint64_t version = a.version + 1;
  a = Arranging{.is_on = a.is_on};
  a.version = version;
}

/// The least way from one of `mine` to one of `theirs`, if it is within reach.
struct Snap {
  double way = 0;
  std::optional<double> at;

  void offer(double mine, double theirs, double reach) {
    const double offered = theirs - mine;
    if (std::abs(offered) > reach || (at && std::abs(way) <= std::abs(offered))) return;
    way = offered;
    at = theirs;
  }
};

/// Brings sides and middles in line with those of the sheet and of the other pieces.
glm::dvec2 snapped_way(Arranging& a, glm::dvec2 way, double reach) {
  const Box2 box{a.box.min + way, a.box.max + way};
  const int canvas = canvas_at(*a.layout, box.centre().x * a.layout->scale);
  std::vector<Box2> goals{room_on_desk(*a.layout, canvas)};
  for (std::size_t i = 0; i < a.boxes.size(); ++i)
    if (!holds(a.pieces, static_cast<int>(i))) goals.push_back(a.boxes[i]);
  glm::dvec2 snapped = way;
  for (const int axis : {0, 1}) {
    Snap snap;
    for (const Box2& goal : goals) {
      snap.offer(box.min[axis], goal.min[axis], reach);
      snap.offer(box.max[axis], goal.max[axis], reach);
      snap.offer(box.centre()[axis], goal.centre()[axis], reach);
    }
    snapped[axis] += snap.way;
    a.guides[static_cast<std::size_t>(axis)] = snap.at;
  }
  return snapped;
}

std::string count_text(std::size_t n) {
  return n == 1 ? std::string("piece") : counted(static_cast<std::int64_t>(n), "piece", "pieces");
}

std::string trouble_text(const Arranging& a) {
  return a.misplaced.empty() ? "" : " · red: covers another piece or reaches over the edge of the page";
}

void drag_move(UiContext& c, const Gesture& gesture, glm::dvec2 at, double reach) {
  Arranging& a = c.ui.arranging;
  a.guides = {};
  const glm::dvec2 way = at - a.from;
  const glm::dvec2 snapped = gesture.is_free ? way : snapped_way(a, way, reach);
  set_motion(c, shift(snapped));
  const double scale = a.layout->scale;
  c.ui.hint = "Moved " + exact_length_text(std::abs(snapped.x) * scale, c.ui.settings.unit) +
              (snapped.x < 0 ? " left, " : " right, ") +
              exact_length_text(std::abs(snapped.y) * scale, c.ui.settings.unit) +
              (snapped.y < 0 ? " down" : " up") + " · Ctrl switches snapping off" + trouble_text(a);
}

void drag_turn(UiContext& c, const Gesture& gesture, glm::dvec2 at) {
  Arranging& a = c.ui.arranging;
  const glm::dvec2 centre = a.box.centre();
  const glm::dvec2 u = a.from - centre;
  const glm::dvec2 v = at - centre;
  const double angle = std::atan2(cross(u, v), glm::dot(u, v));
  const double turn = gesture.is_free ? angle : snapped_turn(angle, a.levels);
  set_motion(c, shift(centre) * Rigid2::rotation(turn) * shift(-centre));
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "Turned %.1f° %s · ", std::abs(turn) * 180 / std::numbers::pi,
                turn < 0 ? "clockwise" : "the other way round");
  c.ui.hint = text.data() + std::string("snaps to 15° and to edges, Ctrl turns freely") + trouble_text(a);
}

void release(UiContext& c) {
  Arranging& a = c.ui.arranging;
  const bool is_turn = a.grip == Arranging::Grip::Turn;
  a.grip = Arranging::Grip::None;
  a.guides = {};
  if (!a.has_motion || a.motion == Rigid2()) {
    let_go(a);
    return;
  }
  const HandLayout goal = a.goal;
  c.session.place_pieces(goal, (is_turn ? "turn " : "move ") + count_text(a.pieces.size()));
}

bool is_at_handle(const UiContext& c, const Net& drawn, const PanZoomCamera& camera, glm::dvec2 pointer) {
  const auto handle = turn_handle(c, drawn, camera);
  return handle && glm::distance(*handle, pointer) <= static_cast<double>(c.ui.look.px(13));
}

int piece_under(const Net& net, const Pointed& pointed) {
  const FaceId face = pointed.face.is_valid()   ? pointed.face
                      : pointed.side.is_valid() ? net.mesh().face(pointed.side)
                                                : FaceId();
  return face.is_valid() ? net.piece[face] : -1;
}

void hover_hint(UiContext& c, bool is_on_handle) {
  const Arranging& a = c.ui.arranging;
  if (is_on_handle) {
    c.ui.hint = "Drag turns: snaps to 15° and to edges, Ctrl turns freely";
  } else if (a.hovered >= 0) {
    c.ui.hint = shown_of(c).net.n_pieces == 1
                    ? arranging_hint(c)
                    : (chosen_pieces(c).size() > 1 ? pieces_hint(c) + " · " : "") + "Piece " +
                          std::to_string(a.hovered + 1) + " of " + std::to_string(shown_of(c).net.n_pieces) +
                          " · drag moves it · Shift+click adds it";
  } else {
    c.ui.hint = arranging_hint(c);
  }
}

}  // namespace

bool is_arranging(const UiContext& c, const Scene& scene) {
  return c.ui.arranging.is_on && scene.is_on_pages() && c.session.pages() != nullptr;
}

std::optional<glm::dvec2> turn_handle(const UiContext& c, const Net& drawn, const PanZoomCamera& camera) {
  const std::vector<int> chosen = chosen_pieces(c);
  if (chosen.empty()) return std::nullopt;
  const Arranging& a = c.ui.arranging;
  if (a.grip == Arranging::Grip::Turn) return camera.to_pixel(a.motion(a.from));  // it is held
  Box2 box;
  for (const FaceId f : drawn.mesh().faces())
    if (holds(chosen, drawn.piece[f])) box.add(drawn.box(f));
  const double rim = c.ui.look.px(16);
  const glm::dvec2 at = camera.to_pixel({box.centre().x, box.max.y}) - glm::dvec2(0, c.ui.look.px(28));
  return glm::clamp(at, glm::dvec2(rim), glm::max(camera.size_px() - rim, glm::dvec2(rim)));
}

std::vector<int> chosen_pieces(const UiContext& c) {
  std::vector<int> pieces;
  const auto shown = c.session.shown();
  if (shown == nullptr || shown->net.dual != c.session.project().dual) return pieces;
  for (const FaceId f : c.ui.selected_faces)
    if (!holds(pieces, shown->net.piece[f])) pieces.push_back(shown->net.piece[f]);
  std::sort(pieces.begin(), pieces.end());
  return pieces;
}

void select_whole_pieces(UiContext& c) {
  std::vector<FaceId> faces;
  const std::vector<int> chosen = chosen_pieces(c);
  const Net& net = shown_of(c).net;
  for (const FaceId f : net.mesh().faces())
    if (holds(chosen, net.piece[f])) faces.push_back(f);
  select_faces(c.ui, std::move(faces), {});
}

std::string pieces_hint(const UiContext& c) {
  return counted(static_cast<std::int64_t>(chosen_pieces(c).size()), "piece", "pieces") + " selected";
}

std::string arranging_hint(const UiContext& c) {
  if (chosen_pieces(c).empty())
    return "Drag a piece to move it · click it and drag its handle to turn it · drag around several · Esc "
           "ends";
  return pieces_hint(c) + " · drag the handle to turn · Q turns by a quarter · Esc lets go";
}

void take_arrange(UiContext& c, const Scene& scene, const Pointed& pointed, const Gesture& gesture,
                  const PanZoomCamera& camera) {
  Arranging& a = c.ui.arranging;
  const glm::dvec2 pointer(gesture.pointer.x, gesture.pointer.y);
  const glm::dvec2 at = camera.to_world(pointer);
  if (a.grip != Arranging::Grip::None) {
    if (gesture.drag_button == 0 && a.grip == Arranging::Grip::Move) {
      drag_move(c, gesture, at, c.ui.look.px(kSnapReach) / camera.pixels_per_unit());
    } else if (gesture.drag_button == 0) {
      drag_turn(c, gesture, at);
    } else if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
      const bool is_click = gesture.is_clicked && a.grip == Arranging::Grip::Move;
      const int clicked = piece_under(*scene.net(), pointed);
      release(c);
      if (is_click && clicked >= 0) select_piece(c, clicked, false);
    }
    return;
  }
  if (a.has_motion || !gesture.is_hovered) return;  // its pages are still being laid out
  // Shift is about selecting: what lies under the handle can be reached, too.
  const bool is_on_handle = !gesture.is_adding && is_at_handle(c, *scene.net(), camera, pointer);
  a.hovered = is_on_handle ? -1 : piece_under(*scene.net(), pointed);
  c.ui.hovered = pointed.face;
  if (gesture.is_pressed && is_on_handle) {
    take_hold(c, scene, Arranging::Grip::Turn, at);
  } else if (gesture.is_pressed && a.hovered >= 0 && !gesture.is_adding) {
    if (!holds(chosen_pieces(c), a.hovered)) select_piece(c, a.hovered, false);
    select_whole_pieces(c);
    take_hold(c, scene, Arranging::Grip::Move, at);
  } else if (gesture.is_clicked && a.hovered >= 0 && gesture.is_adding) {
    select_piece(c, a.hovered, true);
  }
  if (is_on_handle || a.hovered >= 0)
    ImGui::SetMouseCursor(is_on_handle ? ImGuiMouseCursor_Hand : ImGuiMouseCursor_ResizeAll);
  hover_hint(c, is_on_handle);
}

Gesture with_band(UiContext& c, const Scene& scene, const Pointed& pointed, Gesture gesture,
                  const PanZoomCamera& camera) {
  const glm::dvec2 pointer(gesture.pointer.x, gesture.pointer.y);
  const bool is_on_ground = gesture.is_pressed && !pointed.face.is_valid() && !pointed.side.is_valid() &&
                            !is_at_handle(c, *scene.net(), camera, pointer);
  if (!is_on_ground || c.ui.arranging.grip != Arranging::Grip::None) return gesture;
  if (!gesture.is_adding) clear_selection(c.ui);
  gesture.is_adding = true;
  return gesture;
}

void follow_pages(UiContext& c) {
  Arranging& a = c.ui.arranging;
  const bool holds_something = a.has_motion || a.grip != Arranging::Grip::None;
  if (holds_something && (c.session.pages() != a.layout || c.session.shown() != a.shown)) let_go(a);
  if (a.has_motion) c.ui.frames_wanted = std::max(c.ui.frames_wanted, 1);
}

void end_arranging(UiState& ui) {
  let_go(ui.arranging);
  ui.arranging.is_on = false;
}

void escape_arranging(UiContext& c) {
  if (c.ui.arranging.grip != Arranging::Grip::None) {
    let_go(c.ui.arranging);
  } else if (has_selection(c.ui)) {
    clear_selection(c.ui);
  } else {
    end_arranging(c.ui);
  }
}

void toggle_arranging(UiContext& c) {
  const bool was_on = c.ui.arranging.is_on;
  end_editing(c.ui);
  end_tab_tool(c.ui);
  c.ui.measuring = Measuring();
  end_arranging(c.ui);
  c.ui.arranging.is_on = !was_on;
  if (!was_on) c.ui.settings.show_pages = true;
}

void align_chosen(UiContext& c, Align where) {
  c.session.place_pieces(align_pieces(shown_of(c).net, *c.session.pages(), chosen_pieces(c), where),
                         "align " + count_text(chosen_pieces(c).size()));
}

void turn_chosen_by_a_quarter(UiContext& c) {
  const Net& net = shown_of(c).net;
  const PageLayout& layout = *c.session.pages();
  std::vector<PieceMotion> motions;
  for (const int piece : chosen_pieces(c)) {
    const glm::dvec2 middle = box_on_canvas(net, layout, piece).centre();
    const glm::dvec2 centre(middle.x, -middle.y);
    const Rigid2 turn = shift(centre) * Rigid2{0, -1, 0, 0} * shift(-centre);
    motions.push_back({piece, layout.pieces[static_cast<std::size_t>(piece)].canvas, turn});
  }
  c.session.place_pieces(move_pieces(net, layout, motions), "turn " + count_text(motions.size()));
}

void rearrange(UiContext& c) { c.session.rearrange_pieces(); }

std::string why_not_arrange(const UiContext& c) {
  if (!c.session.has_model()) return "Open a model first.";
  if (c.ui.arranging.is_on) return "";
  if (c.session.state() != RunState::Idle) return "A search is running: wait for it or stop it (Esc).";
  if (c.session.shown() == nullptr || c.session.project().tree == nullptr)
    return "Unfold the model first (Space).";
  return c.session.pages() == nullptr ? "There are no pages for this net yet: it overlaps, or they are still "
                                        "being laid out."
                                      : "";
}

std::string why_not_align(const UiContext& c) {
  if (!c.session.has_model()) return "Open a model first.";
  if (c.session.pages() == nullptr) return "There is no net on its pages.";
  return chosen_pieces(c).empty() ? "Select one or more pieces first: press A and click them." : "";
}

void split_to_fit(UiContext& c) { c.session.split_to_fit(); }

std::string why_not_split(const UiContext& c) {
  if (!c.session.has_model()) return "Open a model first.";
  const auto pages = c.session.pages();
  if (pages == nullptr) return "Unfold the model first (Space).";
  return std::ranges::any_of(pages->canvases, &PageLayout::Canvas::is_tiled) ? ""
                                                                             : "Every piece fits a page.";
}

std::string why_not_rearrange(const UiContext& c) {
  return c.session.has_placed_pieces() ? "" : "Nothing was moved by hand: the pieces are arranged already.";
}

}  // namespace netwright
