// How the tests move mouse and keys: one frame between moving, pressing and releasing, as Dear ImGui wants
// it.
#include "tests/gui_support.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "render/tree_renderer.h"
#include "ui/preferences.h"

namespace netwright::testing {

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "netwright-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder could be made");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}

std::filesystem::path TemporaryFolder::write(const std::string& name, const std::string& content) const {
  std::ofstream(path_ / name, std::ios::binary) << content;
  return path_ / name;
}

Gui::Gui(glm::ivec2 size, double content_scale, const std::filesystem::path& settings_file)
    : window({"Netwright", size}, content_scale),
      app(
          window, [this] { return now; }, settings_file) {
  ui().widgets = &widgets;
  ui().settings.theme = ThemeChoice::Light;
  ui().settings.polish_s = 0;  // a second for each net would be long
  session().set_polish(polish_of(ui().settings));
  frames(3);
}

void Gui::frames(int n) {
  for (int i = 0; i < n; ++i) {
    now += 1.0 / 60;
    app.turn(0);
    app.draw();
  }
}

bool Gui::until(const std::function<bool()>& holds) {
  constexpr int kMostTurns = 4000;
  for (int i = 0; i < kMostTurns; ++i) {
    if (holds()) return true;
    now += 1.0 / 60;
    window.wait_events(0.005);
    app.turn(0);
  }
  return holds();
}

WidgetRect Gui::rect(const std::string& name) {
  const auto found = widgets.find(name);
  if (!found) {
    ADD_FAILURE() << "no widget is called " << name;
    return {};
  }
  return *found;
}

glm::dvec2 centre(const WidgetRect& rect) { return {rect.centre().x, rect.centre().y}; }

void Gui::point(glm::dvec2 at) {
  window.move_mouse(at);
  frames(2);
}

void Gui::click(const std::string& name) {
  point(centre(rect(name)));
  window.press_mouse();
  frames();
  window.release_mouse();
  frames(4);
}

void Gui::double_click(glm::dvec2 at) {
  point(at);
  for (int i = 0; i < 2; ++i) {
    window.press_mouse();
    frames();
    window.release_mouse();
    frames();
  }
  frames(2);
}

void Gui::drag(glm::dvec2 from, glm::dvec2 to, int button) {
  point(from);
  window.press_mouse(button);
  frames();
  constexpr int kSteps = 4;
  for (int i = 1; i <= kSteps; ++i) point(from + (to - from) * (static_cast<double>(i) / kSteps));
  window.release_mouse(button);
  frames(2);
}

void Gui::key(int key, int modifiers) {
  window.press_key(key, modifiers);
  frames(3);
}

void Gui::enter(const std::string& field, const std::string& text) {
  click(field);
  key('A', kControl);
  window.type_text(text);
  frames(2);
  key(keys::kEnter);
}

void Gui::open_sample(const std::string& title) {
  click("sample/" + title);
  EXPECT_TRUE(until([&] { return session().state() == RunState::Idle; })) << ui().error;
  frames(4);
}

bool Gui::unfold() {
  session().unfold();
  const bool is_over = until([&] {
    if (session().state() == RunState::Replaying) session().skip_replay();
    return session().state() == RunState::Idle;
  });
  const auto shown = session().shown();
  if (!is_over || shown == nullptr || !shown->is_proved) return false;
  const bool has_sheets = until([&] { return session().sheets() != nullptr; });
  frames(4);
  return has_sheets;
}

glm::dvec2 Gui::net_pixel(FaceId face) {
  const Net& net = *app.workspace().scene().net();
  const glm::dvec2 inside = app.workspace().net_view().camera().to_pixel(face_anchor(net, face));
  const WidgetRect picture = rect("net/picture");
  return glm::dvec2(picture.min.x, picture.min.y) + inside;
}

double brightness(const Image& image, glm::ivec2 at) {
  constexpr int kHalf = 2;
  double sum = 0;
  for (int y = at.y - kHalf; y <= at.y + kHalf; ++y) {
    for (int x = at.x - kHalf; x <= at.x + kHalf; ++x) {
      const auto i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                          static_cast<std::size_t>(x));
      sum += (image.rgba[i] + image.rgba[i + 1] + image.rgba[i + 2]) / 3.0;
    }
  }
  return sum / ((2 * kHalf + 1) * (2 * kHalf + 1));
}

}  // namespace netwright::testing
