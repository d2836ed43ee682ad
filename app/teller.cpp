// Asks the very functions that answer the pointer, so that what is told is what a click would mean. The file
// is written under another name and renamed: who reads it never sees half a frame.
#include "app/teller.h"

#include <cmath>
#include <fstream>
#include <utility>

#include "core/base/error.h"
#include "render/edge_picker.h"
#include "render/tree_renderer.h"
#include "ui/pointing.h"

namespace netwright {
namespace {

constexpr double kInsideEdge = 2;  ///< pixels from the middle of an edge into the face that it is told from

/// One of the two views: how it points, and where its corners are.
struct View {
  const char* name;
  WidgetRect picture;
  std::function<Pointed(glm::dvec2)> point;
  std::function<glm::dvec2(HalfedgeId)> pixel;  ///< of a corner, in the picture
  std::function<glm::dvec2(FaceId)> anchor;     ///< of a face
};

std::string line(const std::initializer_list<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : "\t") + word;
  return text + "\n";
}

std::string whole(double pixels) { return std::to_string(std::llround(pixels)); }

std::string number(std::int32_t index) { return std::to_string(index + 1); }

bool is_inside(const View& view, glm::dvec2 at) {
  return at.x > 0 && at.y > 0 && at.x < static_cast<double>(view.picture.max.x - view.picture.min.x) &&
         at.y < static_cast<double>(view.picture.max.y - view.picture.min.y);
}

std::string place(const View& view, glm::dvec2 at) {
  return whole(static_cast<double>(view.picture.min.x) + at.x) + "\t" +
         whole(static_cast<double>(view.picture.min.y) + at.y);
}

const char* word_of(EdgePin pin) {
  return pin == EdgePin::MustFold ? "fold" : pin == EdgePin::MustCut ? "cut" : "none";
}

std::string told_edge(const View& view, const Mesh& mesh, const ShownNet* shown, const Constraints& pins,
                      HalfedgeId h) {
  const EdgeId e = mesh.edge(h);
  const glm::dvec2 a = view.pixel(h);
  const glm::dvec2 b = view.pixel(mesh.next(h));
  const glm::dvec2 inward = view.anchor(mesh.face(h)) - (a + b) * 0.5;
  const glm::dvec2 at = glm::round((a + b) * 0.5 + kInsideEdge * inward / std::max(1.0, glm::length(inward)));
  if (!is_inside(view, at)) return {};
  const Pointed pointed = view.point(at);
  if (!pointed.side.is_valid() || mesh.edge(pointed.side) != e) return {};
  const bool is_fold = shown != nullptr && shown->net.tree.is_fold(mesh, e);
  const char* kind = mesh.is_border(e) ? "border" : is_fold ? "fold" : "cut";
  const FaceId other = mesh.neighbour(h);
  return line({std::string(view.name) + "-edge", number(e.value), place(view, at), kind,
               word_of(pin_of(pins, e)), number(mesh.face(h).value),
               other.is_valid() ? number(other.value) : "0"});
}

std::string told_view(const View& view, const Mesh& mesh, const ShownNet* shown, const Constraints& pins) {
  std::string text;
  for (const FaceId f : mesh.faces()) {
    const glm::dvec2 at = glm::round(view.anchor(f));
    if (!is_inside(view, at)) continue;
    const Pointed pointed = view.point(at);
    if (pointed.face == f && !pointed.side.is_valid())
      text += line({std::string(view.name) + "-face", number(f.value), place(view, at)});
  }
  for (const HalfedgeId h : mesh.halfedges()) text += told_edge(view, mesh, shown, pins, h);
  return text;
}

std::string told_model(const WidgetRect& picture, const Session& session, const UiState& ui,
                       const Workspace& workspace, const ShownNet* shown) {
  const Scene& scene = workspace.scene();
  const ModelPose pose = scene.pose();
  const OrbitCamera& camera = workspace.model_view().camera();
  const View view{
      "model", picture,
      [&](glm::dvec2 at) { return point_at(scene.model_picker(), pose, camera, at, edge_reach(ui)); },
      [&](HalfedgeId h) { return glm::dvec2(camera.project(pose.position(h))); },
      [&](FaceId f) {
        return glm::dvec2(camera.project(pose.is_model() ? face_anchor(*scene.dual(), f) : pose.centre(f)));
      }};
  return told_view(view, pose.mesh(), shown, session.project().pins);
}

std::string told_net(const WidgetRect& picture, const Session& session, const UiState& ui,
                     const Workspace& workspace, const ShownNet& shown) {
  const Scene& scene = workspace.scene();
  const Net& net = *scene.net();
  const PanZoomCamera& camera = workspace.net_view().camera();
  const View view{
      "net", picture,
      [&](glm::dvec2 at) { return point_at(scene.net_picker(), net, camera, at, edge_reach(ui)); },
      [&](HalfedgeId h) { return camera.to_pixel(net.corner(h)); },
      [&](FaceId f) { return camera.to_pixel(face_anchor(net, f)); }};
  return told_view(view, net.mesh(), &shown, session.project().pins);
}

std::string told_widgets(const UiState& ui) {
  std::string text;
  for (const auto& [name, rect] : ui.widgets->all()) {
    const auto pixels = [](float value) { return whole(static_cast<double>(value)); };
    text += line({"widget", name, pixels(rect.min.x), pixels(rect.min.y), pixels(rect.max.x - rect.min.x),
                  pixels(rect.max.y - rect.min.y), rect.is_enabled ? "on" : "off"});
  }
  return text;
}

std::string told_pointer(const UiState& ui, const Mesh& mesh) {
  std::string text;
  if (ui.hovered.is_valid()) text += line({"hovered-face", number(ui.hovered.value)});
  if (ui.hovered_side.is_valid()) text += line({"hovered-edge", number(mesh.edge(ui.hovered_side).value)});
  return text;
}

}  // namespace

std::string told_of(const Session& session, const UiState& ui, const Workspace& workspace,
                    const std::string& title) {
  std::string text = line({"title", title});
  if (ui.widgets == nullptr) return text;
  text += told_widgets(ui);
  const Scene& scene = workspace.scene();
  if (!session.has_model() || scene.dual() != session.project().dual) return text;
  text += line(
      {"step", std::to_string(session.history_position()), std::to_string(session.history().size() - 1)});
  text += line({"laying-out", session.is_laying_out() ? "yes" : "no"});
  text += told_pointer(ui, scene.dual()->mesh());
  if (ui.dialog != Dialog::None) return text;
  const auto& shown = scene.shown();
  const bool is_own_net = shown != nullptr && shown->net.dual == scene.dual();
  if (const auto picture = ui.widgets->find("model/picture"))
    text += told_model(*picture, session, ui, workspace, is_own_net ? shown.get() : nullptr);
  if (const auto picture = ui.widgets->find("net/picture"); picture && is_own_net)
    text += told_net(*picture, session, ui, workspace, *shown);
  return text;
}

Teller::Teller(std::filesystem::path file) : file_(std::move(file)) { tell("title\t\n"); }

void Teller::tell(const std::string& text) {
  if (text == told_) return;
  std::filesystem::path beside = file_;
  beside += ".new";
  std::ofstream out(beside, std::ios::binary);
  out << text;
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(beside, file_, error);
  if (!out || error)
    throw Error(ErrorKind::Write, "What is on screen cannot be written to " + file_.string() +
                                      "; name a file in a folder you may write to after --tell-widgets.");
  told_ = text;
}

}  // namespace netwright
