// Which sheets are printed, and what the printing system is told.
#include "core/project/print_job.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "core/base/atomic_file.h"
#include "core/base/error.h"

namespace netwright {
namespace {

namespace fs = std::filesystem;

TEST(ChosenSheets, ReadsNumbersAndSpans) {
  using Sheets = std::vector<std::size_t>;
  EXPECT_EQ(chosen_sheets("", 3), (Sheets{0, 1, 2}));
  EXPECT_EQ(chosen_sheets("  ", 2), (Sheets{0, 1}));
  EXPECT_EQ(chosen_sheets("1-3, 5", 6), (Sheets{0, 1, 2, 4}));
  EXPECT_EQ(chosen_sheets("5,1 - 2,2", 6), (Sheets{0, 1, 4}));
  for (const char* wrong : {"0", "7", "3-1", "two", "1-", "-2", "1,,2", "1 2"})
    EXPECT_THROW(static_cast<void>(chosen_sheets(wrong, 6)), Error) << wrong;
}

class PrintingSystem : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("netwright_lp_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path script(const std::string& name, const std::string& lines) {
    fs::path path = folder_ / name;
    std::ofstream(path) << "#!/bin/sh\n" << lines;
    fs::permissions(path, fs::perms::owner_all);
    return path;
  }
  fs::path folder_;
};

TEST_F(PrintingSystem, GetsTheSheetsAtTrueSize) {
  const fs::path said = folder_ / "said";
  const fs::path got = folder_ / "got";
  const fs::path lp = script("lp", "echo \"$@\" > '" + said.string() + "'\ncat > '" + got.string() + "'\n");
  const std::array<fs::path, 1> folders{folder_};
  EXPECT_EQ(printing_program("lp", folders), lp);
  EXPECT_EQ(printing_program("lpstat", folders), fs::path());
  const Progress progress;
  send_to_printer(lp, {"Laser 2", "", false}, "%PDF bytes", "Globe", progress);
  EXPECT_EQ(read_file(said, 1000), "-d Laser 2 -t Globe -o print-scaling=none\n");
  EXPECT_EQ(read_file(got, 1000), "%PDF bytes");
}

TEST_F(PrintingSystem, ThatRefusesIsToldOf) {
  const Progress progress;
  const fs::path lp = script("lp", "cat > /dev/null\nexit 1\n");
  EXPECT_THROW(send_to_printer(lp, {}, "%PDF", "Globe", progress), Error);
  EXPECT_THROW(send_to_printer({}, {}, "%PDF", "Globe", progress), Error);
}

TEST_F(PrintingSystem, SaysWhichPrintersThereAre) {
  EXPECT_EQ(find_printers(script("lpstat", "echo Laser_2\necho Ink\n")),
            (std::vector<std::string>{"Laser_2", "Ink"}));
  EXPECT_TRUE(find_printers(script("lpstat", "exit 1\n")).empty());
  EXPECT_TRUE(find_printers({}).empty());
}

}  // namespace
}  // namespace netwright
