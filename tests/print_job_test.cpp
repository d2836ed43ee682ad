// Which sheets are printed, and what the printing system is told.
#include "core/project/print_job.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/project/derived.h"
#include "tests/project_support.h"

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

TEST(PrintedSheets, AreThoseChosenAndTheInstructionsWhereTheyAreWanted) {
  Project project = testing::solved(testing::project_of(shapes::icosphere(1)));
  project.size = {PrintSize::Kind::Height, 150};
  Progress progress;
  const auto derived = derive(project, nullptr, 1, progress);
  ASSERT_TRUE(derived->sheets);
  const std::size_t n = derived->sheets->size();
  ASSERT_GE(n, 2U);
  EXPECT_EQ(derived->instructions, nullptr);
  EXPECT_EQ(printed_sheets({}, project, *derived).size(), n);
  const auto second = printed_sheets({"", "2", false}, project, *derived);
  ASSERT_EQ(second.size(), 1U);
  const auto n_fills = [](const Sheet& sheet) { return sheet.fills.size(); };
  const std::size_t n_shaded = project.dual->mesh().n_faces();  // six pictures have more than that
  EXPECT_LT(n_fills(second.front()), n_shaded);
  project.exports.instructions = InstructionPage::Last;
  const auto with = printed_sheets({"", "2", false}, project, *derived);
  ASSERT_EQ(with.size(), 2U);
  EXPECT_GT(n_fills(with.back()), n_shaded);
  project.exports.instructions = InstructionPage::First;
  EXPECT_GT(n_fills(printed_sheets({}, project, *derived).front()), n_shaded);
  const auto again = derive(project, derived, 2, progress);
  ASSERT_TRUE(again->instructions);
  EXPECT_EQ(again->sheets, derived->sheets) << "nothing else is drawn anew";
  EXPECT_EQ(derive(project, again, 3, progress)->instructions, again->instructions);
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
