// The loop and what connects window, session and interface. A frame costs little, but not nothing: at rest
// none is drawn.
#include "app/application.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/mesh/read.h"
#include "core/project/project_file.h"
#include "ui/actions.h"
#include "ui/leave.h"
#include "ui/preferences.h"
#include "ui/status.h"

namespace netwright {
namespace {

/// Dear ImGui settles over a few frames after each event: popups measure themselves, hovering takes effect.
constexpr int kFramesAfterEvent = 3;
constexpr double kFrame_s = 1.0 / 60;
constexpr double kLongestWait_s = 1;
constexpr double kSettingsEvery_s = 5;

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

void remember_placement(Settings& settings, const WindowPlacement& placement) {
  settings.is_maximized = placement.is_maximized;
  if (placement.is_maximized || placement.size.x <= 0) return;  // the size to come back to stays
  settings.window_width = placement.size.x;
  settings.window_height = placement.size.y;
  settings.window_x = placement.position.x;
  settings.window_y = placement.position.y;
}

WindowPlacement placement_of(const Settings& settings) {
  return {{settings.window_x, settings.window_y},
          {settings.window_width, settings.window_height},
          settings.is_maximized};
}

std::string window_title(const Session& session) {
  if (!session.has_model()) return "Netwright";
  return (session.is_modified() ? "• " : "") + project_name(session) + " – " + status_of(session).in_short +
         " – Netwright";
}

Application::Application(Window& window, Session::Clock clock, std::filesystem::path settings_file)
    : window_(window), clock_(std::move(clock)), settings_file_(std::move(settings_file)), session_(clock_) {
  if (!settings_file_.empty()) ui_.settings = load_settings(settings_file_);
  saved_settings_ = ui_.settings;
  if (settings_file_.empty()) {
    ui_.settings.hints_done.fill(true);  // tests and pictures are of nobody who is new here
    session_.set_polish(polish_of(ui_.settings));
  } else {
    apply_preferences(session_, ui_.settings);
  }
  ui_.wake = [this] {
    is_woken_ = true;
    window_.wake();
  };
  ui_.is_desktop_dark = desktop_prefers_dark();
  ui_.is_motion_reduced = desktop_reduces_motion();
  session_.set_wake([this] { window_.wake(); });
  window_.set_title(window_title(session_));
}

Application::~Application() {
  session_.set_wake({});
  // Only who quits in order has been asked about unsaved changes; after anything else they can be recovered.
  if (ui_.wants_quit) session_.give_up_changes();
  keep_settings();
}

void Application::keep_settings() {
  if (settings_file_.empty()) return;
  remember_placement(ui_.settings, window_.placement());
  if (ui_.settings == saved_settings_) return;
  save_settings(ui_.settings, settings_file_);
  saved_settings_ = ui_.settings;
}

double Application::wait_seconds() const {
  if (needs_draw_ || ui_.frames_wanted > 0) return 0;
  double wait = std::min(kLongestWait_s, session_.wait_seconds());
  for (const Toast& toast : ui_.toasts) wait = std::min(wait, std::max(toast.until - ui_.now, kFrame_s));
  return wait;
}

void Application::open_dropped(const std::vector<std::filesystem::path>& paths) {
  if (paths.empty()) return;
  const auto is_known = [](const auto& path) { return is_model_path(path) || has_project_name(path); };
  const auto known = std::find_if(paths.begin(), paths.end(), is_known);
  UiContext context{session_, ui_};
  open_file(context, known == paths.end() ? paths.front() : *known);
}

void Application::handle(const WindowEvent& event) {
  ui_.frames_wanted = std::max(ui_.frames_wanted, kFramesAfterEvent);
  switch (event.kind) {
    case WindowEvent::Kind::Key:
      if (!event.is_repeat || event.key == keys::kLeft || event.key == keys::kRight)
        workspace_.key(session_, ui_, event.key, event.modifiers);
      break;
    case WindowEvent::Kind::Text:
      workspace_.character(session_, ui_, event.code_point);
      break;
    case WindowEvent::Kind::Drop:
      open_dropped(event.paths);
      break;
    case WindowEvent::Kind::Close: {
      UiContext context{session_, ui_};
      ask_to_quit(context);
      break;
    }
    case WindowEvent::Kind::MouseButton:
    case WindowEvent::Kind::MouseMove:
    case WindowEvent::Kind::Scroll:
    case WindowEvent::Kind::Resize:
      break;
  }
}

void Application::update_title() {
  std::string title = window_title(session_);
  if (title == title_) return;
  title_ = std::move(title);
  window_.set_title(title_);
}

void Application::remember_model() {
  const auto& path = session_.file().empty() ? session_.project().path : session_.file();
  if (path == known_model_) return;
  known_model_ = path;
  if (path.empty()) return;
  remember(ui_.settings, path);
  // At once, since what ends the editor may leave no time for it.
  if (!settings_file_.empty() && save_settings(ui_.settings, settings_file_)) saved_settings_ = ui_.settings;
}

void Application::draw() {
  ui_.now = clock_();
  session_.set_autosave_minutes(ui_.settings.autosave_minutes);
  needs_draw_ = false;
  if (ui_.frames_wanted > 0) --ui_.frames_wanted;
  if (workspace_.update_look(ui_, window_.content_scale())) window_.refresh_fonts();
  window_.begin_frame();
  ImGui::NewFrame();
  workspace_.draw(session_, ui_);
  ImGui::Render();
  window_.present();
  update_title();
  remember_model();
  if (teller_) teller_->tell(told_of(session_, ui_, workspace_, title_));
}

void Application::tell_widgets(const std::filesystem::path& file) {
  teller_.emplace(file);
  ui_.widgets = &widgets_;
}

void Application::wait(double seconds) {
  const double before = steady_seconds();
  window_.wait_events(seconds);
  const bool is_early = steady_seconds() - before < seconds * 0.95;
  if (is_early) ui_.frames_wanted = std::max(ui_.frames_wanted, 1);
}

void Application::turn(double longest_wait_s) {
  wait(std::min(wait_seconds(), longest_wait_s));
  for (const WindowEvent& event : window_.take_events()) handle(event);
  if (is_woken_.exchange(false)) ui_.frames_wanted = std::max(ui_.frames_wanted, 1);
  const bool has_changed = session_.poll();
  const bool has_old_toast = std::any_of(ui_.toasts.begin(), ui_.toasts.end(),
                                         [this](const Toast& toast) { return toast.until <= clock_(); });
  // Now and then, so that a crash costs nobody the window's layout; not while something is being dragged.
  if (clock_() - settings_kept_at_ > kSettingsEvery_s && !ImGui::IsAnyMouseDown()) {
    settings_kept_at_ = clock_();
    keep_settings();
  }
  if (has_changed || needs_draw_ || has_old_toast || ui_.frames_wanted > 0) draw();
}

void Application::run() {
  double last_frame = steady_seconds();
  while (!is_over()) {
    turn(kLongestWait_s);
    // Snapshots come faster than any screen shows them; the processor is the solver's.
    for (double left = 1; left > 0;) {
      left = kFrame_s - (steady_seconds() - last_frame);
      if (left > 0) wait(left);
    }
    last_frame = steady_seconds();
  }
}

}  // namespace netwright
