// The child runs on a worker of its own, so that neither the window nor the session's chores wait for a
// person who is looking for a file.
#include "ui/desktop_picker.h"

#include <array>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/mailbox.h"
#include "core/base/subprocess.h"
#include "core/base/worker.h"

namespace netwright {
namespace {

namespace fs = std::filesystem;

fs::path on_path(const char* name) {
  const char* all = std::getenv("PATH");
  std::string_view rest = all == nullptr ? "" : all;
  while (!rest.empty()) {
    const auto colon = rest.find(':');
    fs::path candidate = fs::path(rest.substr(0, colon)) / name;
    std::error_code error;
    if (fs::is_regular_file(candidate, error)) return candidate;
    rest = colon == std::string_view::npos ? "" : rest.substr(colon + 1);
  }
  return {};
}

std::string patterns(const std::vector<std::string>& extensions) {
  std::string text;
  for (const std::string& extension : extensions) text += (text.empty() ? "*." : " *.") + extension;
  return text.empty() ? "*" : text;
}

DesktopPicker::Answer ask(const fs::path& program, const PickRequest& request, const Progress& progress) {
  try {
    ChildLimits limits;
    limits.output_bytes = 65536;
    limits.progress = &progress;
    const ChildResult result = run_child(program, picker_arguments(program, request), {}, limits);
    std::string path = result.output;
    while (!path.empty() && path.back() == '\n') path.pop_back();
    // Both programs end with 1 when the user cancelled.
    if (result.end == ChildResult::End::Exited && result.exit_code == 0 && !path.empty())
      return {path, false};
    return {{}, result.end != ChildResult::End::Exited || result.exit_code > 1};
  } catch (const Error&) {
    return {{}, true};
  }
}

}  // namespace

fs::path desktop_picker_program() {
  for (const char* name : {"zenity", "kdialog"})
    if (fs::path found = on_path(name); !found.empty()) return found;
  return {};
}

std::vector<std::string> picker_arguments(const fs::path& program, const PickRequest& request) {
  if (program.filename() == "kdialog")
    return {"--title", request.title, request.is_saving ? "--getsavefilename" : "--getopenfilename",
            request.start.string(), patterns(request.extensions)};
  std::vector<std::string> words{"--file-selection", "--title=" + request.title,
                                 "--filename=" + request.start.string() + (request.is_saving ? "" : "/"),
                                 "--file-filter=" + patterns(request.extensions)};
  if (request.is_saving) words.insert(words.end(), {"--save", "--confirm-overwrite"});
  return words;
}

struct DesktopPicker::Impl {
  explicit Impl(std::function<void()> on_answer) : answer(std::move(on_answer)) {}
  Mailbox<Answer> answer;
  Worker worker;  ///< last: its job ends before the mailbox goes
};

DesktopPicker::DesktopPicker() = default;
DesktopPicker::~DesktopPicker() = default;

void DesktopPicker::begin(const fs::path& program, const PickRequest& request,
                          std::function<void()> on_answer) {
  impl_ = std::make_unique<Impl>(std::move(on_answer));
  impl_->worker.submit(Worker::Lane::Chores, [box = &impl_->answer, program, request](Progress& progress) {
    box->post(std::make_shared<const Answer>(ask(program, request, progress)));
  });
}

void DesktopPicker::cancel() { impl_.reset(); }

bool DesktopPicker::is_up() const { return impl_ != nullptr; }

std::optional<DesktopPicker::Answer> DesktopPicker::take() {
  const std::shared_ptr<const Answer> answer = impl_ ? impl_->answer.take() : nullptr;
  if (!answer) return std::nullopt;
  impl_.reset();
  return *answer;
}

}  // namespace netwright
