// A window without a screen, for screenshots, thumbnails and tests of the interface: draws into a framebuffer
// on an EGL context that needs neither display nor window system, and takes its events from the program.
#pragma once

#include <memory>
#include <string>

#include "app/window.h"

namespace netwright {

class HeadlessWindow : public Window {
 public:
  /// Throws Error(Usage) when EGL has no surfaceless platform or no OpenGL 3.3.
  explicit HeadlessWindow(const WindowOptions& options, double content_scale = 1);
  ~HeadlessWindow() override;

  // What a person would do; it reaches the interface with the next begin_frame. Give ImGui one frame between
  // moving and pressing, and one between pressing and releasing.
  void move_mouse(glm::dvec2 position_px);
  void press_mouse(int button = 0, int modifiers = 0);
  void release_mouse(int button = 0);
  void scroll(glm::dvec2 amount);
  /// Presses and releases a key: one event in the queue, and down for one frame in ImGui's arrays.
  void press_key(int key, int modifiers = 0);
  void type_text(const std::string& utf8);
  void drop(std::vector<std::filesystem::path> paths);
  void request_close();
  void resize(glm::ivec2 size_px);
  /// Modifiers held from now on, for drags with Shift and the like.
  void hold_modifiers(int modifiers);

  [[nodiscard]] glm::ivec2 size_px() const override;
  [[nodiscard]] double content_scale() const override;
  void wait_events(double timeout_s) override;
  void wake() override;
  void begin_frame() override;
  void present() override;
  void refresh_fonts() override;
  [[nodiscard]] Image read_pixels() const override;
  [[nodiscard]] WindowPlacement placement() const override;
  void set_title(const std::string& title) override;
  [[nodiscard]] bool is_software() const override;
  [[nodiscard]] const std::string& title() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace netwright
