// Looks at the disk only when a file is chosen or a dialog opens: a menu that is drawn sixty times a second
// must not wait for a network drive.
#include "ui/recent_files.h"

#include <algorithm>

#include "ui/actions.h"
#include "ui/file_browser.h"
#include "ui/leave.h"

namespace netwright {

namespace fs = std::filesystem;

void open_recent(UiContext& context, const fs::path& file) {
  std::error_code error;
  if (fs::exists(file, error)) {
    open_file(context, file);
    return;
  }
  add_toast(context.ui, file.filename().string() + " is no longer in " + folder_text(file) + ".", false);
  // `file` may stand in the list itself: the last use of it.
  std::erase_if(context.ui.settings.recent,
                [name = file.string()](const fs::path& one) { return one == name; });
}

std::string folder_text(const fs::path& file) {
  constexpr std::size_t kLongest = 40;
  std::string text = file.parent_path().string();
  const std::string home = home_folder().string();
  if (home.size() > 1 && text.starts_with(home) && (text.size() == home.size() || text[home.size()] == '/'))
    text = "~" + text.substr(home.size());
  if (text.size() <= kLongest) return text;
  const std::string end = fs::path(text).filename().string();
  const std::size_t first = text.find('/', 1);
  const std::string begin = first == std::string::npos ? "" : text.substr(0, first);
  return begin + "/…/" + end;
}

fs::path latest_folder(const Settings& settings) {
  const auto found = std::ranges::find_if(settings.recent, [](const fs::path& file) {
    std::error_code error;
    return fs::is_directory(file.parent_path(), error);
  });
  return found == settings.recent.end() ? home_folder() : found->parent_path();
}

}  // namespace netwright
