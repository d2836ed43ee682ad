// The way from "take this project away" to the deed. What waits stands in UiState::leaving until the question
// is answered (dialog_project.cpp) and, where the answer was to save, until that is done.
#include "ui/leave.h"

#include <utility>

namespace netwright {

void leave(UiContext& context, std::function<void(UiContext&)> next) {
  if (context.session.is_modified()) {
    context.ui.leaving = std::move(next);
  } else {
    next(context);
  }
}

void open_file(UiContext& context, const std::filesystem::path& file) {
  leave(context, [file](UiContext& c) { c.session.open(file); });
}

void ask_to_quit(UiContext& context) {
  leave(context, [](UiContext& c) { c.ui.wants_quit = true; });
}

void save_project_of(UiContext& context) {
  if (context.session.file().empty()) {
    context.ui.dialog = Dialog::Save;
  } else {
    context.session.save(context.session.file());
  }
}

void watch_leaving(UiContext& context) {
  if (!context.ui.leaves_when_saved || context.session.is_saving()) return;
  context.ui.leaves_when_saved = false;
  const std::function<void(UiContext&)> next = std::exchange(context.ui.leaving, nullptr);
  // A save that failed has told why: then everything stays as it is.
  if (next && !context.session.is_modified()) next(context);
}

std::string project_name(const Session& session) {
  if (!session.has_model()) return "";
  if (!session.file().empty()) return session.file().filename().string();
  return session.project().dual->mesh().name();
}

}  // namespace netwright
