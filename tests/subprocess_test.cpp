// Children: bytes in, bytes out, and limits that hold.
#include "core/base/subprocess.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace netwright {
namespace {

TEST(Subprocess, FeedsInputAndTakesOutputLargerThanAnyPipe) {
  const std::string input(3'000'000, 'x');
  const ChildResult result = run_child("/bin/cat", {}, input, {.seconds = 60});
  EXPECT_EQ(result.end, ChildResult::End::Exited);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.output, input);
}

TEST(Subprocess, PassesArgumentsWithoutAShell) {
  const ChildResult result = run_child("/bin/echo", {"a b", "$HOME", "*"}, "", {.seconds = 60});
  EXPECT_EQ(result.output, "a b $HOME *\n");
}

TEST(Subprocess, HandsOnTheExitCode) {
  EXPECT_EQ(run_child("/bin/sh", {"-c", "exit 7"}, "", {.seconds = 60}).exit_code, 7);
}

TEST(Subprocess, SurvivesAChildThatDoesNotRead) {
  EXPECT_EQ(run_child("/bin/true", {}, std::string(3'000'000, 'x'), {.seconds = 60}).end,
            ChildResult::End::Exited);
}

TEST(Subprocess, EndsAChildThatTakesTooLong) {
  EXPECT_EQ(run_child("/bin/sleep", {"1000"}, "", {.seconds = 0.1}).end, ChildResult::End::TimedOut);
}

TEST(Subprocess, EndsAChildThatWritesTooMuch) {
  const ChildResult result =
      run_child("/bin/cat", {"/dev/zero"}, "", {.seconds = 60, .output_bytes = 1 << 20});
  EXPECT_EQ(result.end, ChildResult::End::Flooded);
  EXPECT_LT(result.output.size(), std::size_t{2} << 20);
}

TEST(Subprocess, TellsACrashFromAnExit) {
  EXPECT_EQ(run_child("/bin/sh", {"-c", "kill -SEGV $$"}, "", {.seconds = 60}).end,
            ChildResult::End::Crashed);
}

TEST(Subprocess, SaysWhenThereIsNoSuchProgram) {
  EXPECT_THROW(run_child("/nowhere/at/all", {}, "", {}), Error);
}

TEST(Subprocess, FindsItsOwnFolder) { EXPECT_TRUE(std::filesystem::is_directory(program_folder())); }

TEST(Subprocess, EndsAChildWhoseWorkIsCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_EQ(run_child("/bin/sleep", {"1000"}, "", {.progress = &progress}).end, ChildResult::End::Cancelled);
}

}  // namespace
}  // namespace netwright
