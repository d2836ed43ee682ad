// The real netwright-cli as a child process, and a folder for each test to work in. The tests of the command
// line share this.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/json.h"
#include "core/mesh/shapes.h"
#include "tests/support.h"

extern char** environ;

namespace netwright {

inline std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

struct Ended {
  int status = -1;  ///< exit status; -1 when a signal ended it
  std::string out;
  std::string err;
};

/// A running netwright-cli; its two outputs go to files beside the test's own. A net is not polished unless a
/// test says so: that would take a second of each.
class Child {
 public:
  Child(const std::filesystem::path& folder, const std::vector<std::string>& arguments)
      : out_(folder / "stdout.txt"), err_(folder / "stderr.txt") {
    std::vector<std::string> words{NETWRIGHT_CLI};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const bool is_search = !arguments.empty() && arguments.front() == "unfold" && arguments.size() > 1 &&
                           arguments[1].front() != '-';
    if (is_search && std::ranges::find(words, "--polish") == words.end())
      words.insert(words.end(), {"--polish", "0"});
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    constexpr int kNew = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&actions, 1, out_.c_str(), kNew, 0644);
    posix_spawn_file_actions_addopen(&actions, 2, err_.c_str(), kNew, 0644);
    is_running_ = posix_spawn(&pid_, NETWRIGHT_CLI, &actions, nullptr, argv.data(), environ) == 0;
    posix_spawn_file_actions_destroy(&actions);
  }
  ~Child() {
    if (!is_running_) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  void interrupt() const { kill(pid_, SIGINT); }

  Ended wait() {
    Ended ended;
    int status = 0;
    if (is_running_ && waitpid(pid_, &status, 0) == pid_ && WIFEXITED(status))
      ended.status = WEXITSTATUS(status);
    is_running_ = false;
    ended.out = content(out_);
    ended.err = content(err_);
    return ended;
  }

 private:
  std::filesystem::path out_;
  std::filesystem::path err_;
  pid_t pid_ = 0;
  bool is_running_ = false;
};

class CommandLine : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              ("netwright_cli_" + std::to_string(getpid()) + "_" + info->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  [[nodiscard]] std::string at(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return at(name);
  }
  std::string write(const std::string& name, const PolygonSoup& soup) const {
    return write(name, shapes::to_obj(soup));
  }
  /// Far too large to be unfolded while a test waits.
  [[nodiscard]] std::string endless_model() const { return write("endless.obj", testing::endless_search()); }
  [[nodiscard]] Ended run(const std::vector<std::string>& arguments) const {
    return Child(folder_, arguments).wait();
  }
  [[nodiscard]] Json run_json(const std::vector<std::string>& arguments, int expected_status) const {
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.status, expected_status) << ended.err;
    return parse_json(ended.out, "standard output");
  }
  /// What the commands added to the folder.
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      const std::string name = entry.path().filename().string();
      if (name != "stdout.txt" && name != "stderr.txt") names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  std::filesystem::path folder_;
};

/// Status 1, nothing on standard output, and one line on standard error that holds `words`.
inline void expect_refusal(const Ended& ended, const std::string& words) {
  EXPECT_EQ(ended.status, 1);
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  EXPECT_NE(ended.err.find(words), std::string::npos) << ended.err;
  EXPECT_TRUE(ended.err.ends_with(".\n")) << ended.err;
}

using Strings = std::vector<std::string>;

}  // namespace netwright
