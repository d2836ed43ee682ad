// Kills an editor two hundred times while it saves and autosaves. Whatever it had told to be on the disk must
// be found there, in a project that opens.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "core/base/random.h"
#include "core/project/autosave.h"
#include "core/project/project_file.h"
#include "tests/project_support.h"

extern char** environ;

namespace netwright {
namespace {

namespace fs = std::filesystem;

/// In memory where the machine has that: then flushing costs nothing and the kills fall closer.
fs::path new_folder() {
  const fs::path memory = "/dev/shm";
  const fs::path root = ::access(memory.c_str(), W_OK) == 0 ? memory : fs::temp_directory_path();
  std::string name = (root / "netwright_crash_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  return name;
}

pid_t start(const fs::path& folder, int first) {
  const std::string log = (folder / "log").string();
  std::vector<std::string> words{NETWRIGHT_CRASH_CHILD, folder.string(), std::to_string(first)};
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  pid_t child = -1;
  EXPECT_EQ(posix_spawn(&child, NETWRIGHT_CRASH_CHILD, &actions, nullptr, argv.data(), environ), 0);
  posix_spawn_file_actions_destroy(&actions);
  return child;
}

/// What a child has told: the last number of each kind, -1 for none.
struct Told {
  int opened = -1, changed = -1, saved = -1, kept = -1;
  explicit Told(const fs::path& log) {
    std::ifstream in(log);
    std::string word;
    for (int number = 0; in >> word >> number;) {
      if (word == "opened") opened = number;
      if (word == "changed") changed = number;
      if (word == "saved") saved = number;
      if (word == "kept") kept = number;
    }
  }
};

int number_in(const fs::path& file) { return static_cast<int>(load_project(file).project.size.height_mm); }

TEST(Crashes, TwoHundredKillsLoseNothingThatWasSavedOrKept) {
  const fs::path folder = new_folder();
  Project project = testing::project_of(shapes::icosphere(2));
  project.size = {PrintSize::Kind::Height, 1};
  save_project(project, folder / "work.netwright");
  Random random(11);
  int last_saved = 1;
  int last_kept = 1;  // what an autosave or save held for sure when the child before was killed
  int next = 2;
  int n_amid_work = 0;
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const pid_t child = start(folder, next);
    ASSERT_GT(child, 0);
    // Every tenth is killed while it starts and recovers, the others somewhere in their work.
    if (round % 10 != 0) {
      const int goal = next + random.below(5);  // counted in work done: a busy machine takes longer for it
      for (int i = 0; i < 40000 && Told(folder / "log").changed < goal; ++i)
        std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    std::this_thread::sleep_for(std::chrono::microseconds(random.below(20000)));
    kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the child ended by itself";

    const Told told(folder / "log");
    if (told.opened >= 0) {
      ASSERT_GE(told.opened, last_kept) << "it did not recover the newest";
    }
    last_saved = std::max(last_saved, told.saved);
    last_kept = std::max({last_kept, told.saved, told.kept});
    n_amid_work += told.changed >= 0 ? 1 : 0;
    const int newest = std::max(told.changed, next);
    const int in_file = number_in(folder / "work.netwright");
    ASSERT_GE(in_file, last_saved);
    ASSERT_LE(in_file, newest);
    int recovered = in_file;
    std::error_code no_folder_yet;
    for (const auto& entry : fs::directory_iterator(folder / "state", no_folder_yet))
      if (has_project_name(entry.path())) recovered = std::max(recovered, number_in(entry.path()));
    ASSERT_GE(recovered, last_kept);
    ASSERT_LE(recovered, newest);
    next = newest + 1;
  }
  EXPECT_GT(n_amid_work, 150);
  EXPECT_GT(last_saved, 20) << "hardly anything was saved meanwhile";
  std::error_code ignored;
  fs::remove_all(folder, ignored);
}

}  // namespace
}  // namespace netwright
