// A person at the editor: the real interface on a headless window, with a clock the test turns and widgets
// found by name.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "app/application.h"
#include "app/window_headless.h"

namespace netwright::testing {

/// An empty folder that goes away with the test.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path write(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path path_;
};

class Gui {
 public:
  explicit Gui(glm::ivec2 size = {1440, 900}, double content_scale = 1,
               const std::filesystem::path& settings_file = {});

  HeadlessWindow window;
  double now = 0;
  Application app;
  WidgetLog widgets;

  [[nodiscard]] Session& session() { return app.session(); }
  [[nodiscard]] UiState& ui() { return app.ui(); }

  /// Draws frames; the clock goes on by a sixtieth of a second each.
  void frames(int n = 1);
  /// Draws until it holds; false when it still does not after many frames.
  bool until(const std::function<bool()>& holds);
  /// Where a widget is; a test failure when it is not drawn.
  WidgetRect rect(const std::string& name);
  void click(const std::string& name);
  void double_click(glm::dvec2 at);
  void point(glm::dvec2 at);
  void drag(glm::dvec2 from, glm::dvec2 to, int button = 0);
  void key(int key, int modifiers = 0);
  /// Replaces what stands in a text field and confirms it.
  void enter(const std::string& field, const std::string& text);

  void open_sample(const std::string& title);
  /// Searches to the end, the replay skipped; true when the net is proved.
  bool unfold();
  /// Pixel of the window in which a face's middle is seen in the net's view.
  glm::dvec2 net_pixel(FaceId face);
};

glm::dvec2 centre(const WidgetRect& rect);
/// Mean brightness, 0…255, of a small square of the window.
double brightness(const Image& image, glm::ivec2 at);

}  // namespace netwright::testing
