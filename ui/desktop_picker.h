// The desktop's own file dialog, shown by zenity or kdialog as a child process beside ours. Our own browser
// stays for desktops that have neither.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace netwright {

/// Where zenity or kdialog lies on PATH; empty when there is neither.
std::filesystem::path desktop_picker_program();

struct PickRequest {
  bool is_saving = false;
  std::string title;
  std::filesystem::path start;          ///< a folder, or the proposed file when saving
  std::vector<std::string> extensions;  ///< lower case without dot
};

/// What the program is started with.
std::vector<std::string> picker_arguments(const std::filesystem::path& program, const PickRequest& request);

class DesktopPicker {
 public:
  DesktopPicker();
  ~DesktopPicker();  ///< closes a dialog that is still up
  DesktopPicker(const DesktopPicker&) = delete;
  DesktopPicker& operator=(const DesktopPicker&) = delete;

  /// Shows the dialog; returns at once. `on_answer` is called on another thread when it was closed.
  void begin(const std::filesystem::path& program, const PickRequest& request,
             std::function<void()> on_answer);
  [[nodiscard]] bool is_up() const;
  void cancel();  ///< closes the dialog; there will be no answer

  struct Answer {
    std::filesystem::path path;  ///< empty when the user cancelled
    bool has_failed = false;     ///< the program could not be started or crashed
  };
  /// Once, when the dialog was closed.
  std::optional<Answer> take();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace netwright
