// Our own file browser: places at the left, a folder's content at the right, a name below when saving. Always
// there, whatever the desktop offers; tests drive it by name.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ui/ui_state.h"

namespace netwright {

class FileBrowser {
 public:
  enum class Mode { Open, Save };
  struct Request {
    Mode mode = Mode::Open;
    std::filesystem::path folder;         ///< where to begin; the home folder when it does not exist
    std::string name;                     ///< proposed file name, for Save
    std::vector<std::string> extensions;  ///< lower case without dot; files with others are not listed
  };

  void begin(const Request& request);
  /// Draws into the present window down to `height` pixels. The file that was chosen (once), else nothing.
  /// When saving over an existing file it has been confirmed.
  std::optional<std::filesystem::path> draw(UiState& ui, float height);
  /// Changes the extension of the proposed name, and what is listed.
  void set_extension(const std::string& extension);
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] bool is_asking_to_overwrite() const { return wants_overwrite_; }
  /// The button at the bottom of the dialog, or Enter.
  std::optional<std::filesystem::path> accept();
  [[nodiscard]] bool can_accept() const;

 private:
  struct Entry {
    std::string name;
    bool is_folder = false;
    std::uintmax_t bytes = 0;
  };
  void enter(const std::filesystem::path& folder);
  void read_folder();
  [[nodiscard]] bool is_listed(const Entry& entry) const;
  void draw_path(UiState& ui);
  void draw_places(UiState& ui);
  std::optional<std::filesystem::path> draw_entries(UiState& ui);
  std::optional<std::filesystem::path> choose(const Entry& entry, bool is_double);

  Request request_;
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  std::string trouble_;  ///< why the folder cannot be listed
  std::string name_;     ///< selected or typed
  bool wants_overwrite_ = false;
  bool scroll_to_top_ = false;
};

std::filesystem::path home_folder();

}  // namespace netwright
