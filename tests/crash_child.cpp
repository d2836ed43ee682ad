// An editor without a window that changes, saves and autosaves a project until it is killed. It tells what it
// is about to do and what it knows to be on the disk, one line each, so that the test can hold it to that.
//   crash_child FOLDER FIRST      FOLDER/work.netwright is there; FIRST is the first number to use
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

#include "core/project/autosave.h"
#include "core/project/project_file.h"
#include "core/project/session.h"

namespace {

using namespace netwright;
namespace fs = std::filesystem;

void tell(const std::string& word, double number) {
  const std::string line = word + " " + std::to_string(static_cast<long>(number)) + "\n";
  if (::write(STDOUT_FILENO, line.data(), line.size()) != static_cast<ssize_t>(line.size())) std::_Exit(1);
}

class Editor {
 public:
  explicit Editor(fs::path folder) : folder_(std::move(folder)) {
    session_.keep_changes_in(folder_ / "state");
  }

  void open() {
    // The session looks for them on its worker, at the same time as we do; a person takes longer than that
    // to choose.
    const bool is_left = !find_leftovers(folder_ / "state").empty();
    while (is_left && session_.leftovers().empty()) turn();
    const fs::path work = folder_ / "work.netwright";
    session_.leftovers().empty() ? session_.open(work) : session_.recover(session_.leftovers().front().file);
    while (!session_.has_model()) turn();
    tell("opened", session_.project().size.height_mm);
  }

  /// The project's height is its number.
  void change(int number) {
    tell("changed", number);
    session_.set_size({PrintSize::Kind::Height, static_cast<double>(number)});
  }

  void save() {
    const double number = session_.project().size.height_mm;
    session_.save(folder_ / "work.netwright");
    while (session_.is_saving()) turn();
    if (!session_.is_modified()) tell("saved", number);
  }

  void autosave() {
    const double number = session_.project().size.height_mm;
    turn();
    now_ += 100;
    turn();
    while (session_.wait_seconds() < 1) turn();
    for (int i = 0; i < 20 && kept() != number; ++i) turn();
    if (kept() == number) tell("kept", number);
  }

 private:
  void turn() {
    session_.poll();
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  [[nodiscard]] double kept() const {
    const fs::path file = folder_ / "state" / "1.netwright";
    return fs::exists(file) ? load_project(file).project.size.height_mm : -1;
  }

  fs::path folder_;
  double now_ = 0;
  Session session_{[this] { return now_; }};
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 1;
  Editor editor(argv[1]);
  editor.open();
  for (int number = std::atoi(argv[2]);; ++number) {
    editor.change(number);
    if (number % 3 == 0) {
      editor.save();
    } else {
      editor.autosave();
    }
  }
}
