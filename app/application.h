// The editor as a loop: wait, take events, poll the session, draw when something changed. Knows the window
// only as an interface, so that tests and screenshots run the same loop without a screen.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>

#include "app/teller.h"
#include "app/window.h"
#include "core/project/session.h"
#include "ui/workspace.h"

namespace netwright {

class Application {
 public:
  /// `settings_file` may be empty: then nothing is remembered. The window must outlive the application.
  Application(Window& window, Session::Clock clock, std::filesystem::path settings_file);
  ~Application();
  Application(const Application&) = delete;
  Application& operator=(const Application&) = delete;

  /// Until the user quits.
  void run();
  /// One turn of the loop; waits for events at most this long, and draws when something changed.
  void turn(double longest_wait_s);
  /// Draws a frame whether or not anything changed.
  void draw();
  /// From now on a file says where everything is on screen, see Teller. Throws Error(Write).
  void tell_widgets(const std::filesystem::path& file);
  [[nodiscard]] bool is_over() const { return ui_.wants_quit; }

  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] UiState& ui() { return ui_; }
  [[nodiscard]] const Workspace& workspace() const { return workspace_; }

 private:
  [[nodiscard]] double wait_seconds() const;
  /// Waits for events; one that is in no queue, a mouse move, still wants a frame.
  void wait(double seconds);
  void handle(const WindowEvent& event);
  void open_dropped(const std::vector<std::filesystem::path>& paths);
  void update_title();
  void remember_model();
  /// Writes the settings when they have changed.
  void keep_settings();

  Window& window_;
  Session::Clock clock_;
  std::filesystem::path settings_file_;
  Settings saved_settings_;
  Session session_;
  std::atomic<bool> is_woken_ = false;  ///< by another thread, which wants a frame
  UiState ui_;
  Workspace workspace_;
  std::string title_;
  std::filesystem::path known_model_;
  WidgetLog widgets_;
  std::optional<Teller> teller_;
  bool needs_draw_ = true;
  double settings_kept_at_ = 0;
};

/// Where the window lies, to and from the settings. A maximized window keeps the size it had before.
void remember_placement(Settings& settings, const WindowPlacement& placement);
WindowPlacement placement_of(const Settings& settings);

/// What the window is called: the model, and how its search stands.
std::string window_title(const Session& session);

}  // namespace netwright
