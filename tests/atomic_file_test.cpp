// Files appear whole or not at all.
#include "core/base/atomic_file.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

namespace fs = std::filesystem;
using testing::TemporaryFolder;

std::string write_refusal(const fs::path& path) {
  try {
    write_file(path, "new");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Write);
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return "";
}

TEST(WriteFile, WritesAllBytesAndLeavesNoTemporaryFile) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\n\xff", 5);
  write_file(folder / "file", bytes);
  EXPECT_EQ(read_file(folder / "file", 100), bytes);
  EXPECT_EQ(folder.files().size(), 1U);
}

TEST(WriteFile, ReplacesAnOldFileAndKeepsItsRights) {
  const TemporaryFolder folder;
  write_file(folder / "file", "a longer old text");
  fs::permissions(folder / "file", fs::perms::owner_read | fs::perms::owner_write);
  write_file(folder / "file", "new");
  EXPECT_EQ(read_file(folder / "file", 100), "new");
  EXPECT_EQ(fs::status(folder / "file").permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(WriteFile, WritesThroughALink) {
  const TemporaryFolder folder;
  write_file(folder / "real", "old");
  fs::create_symlink(folder / "real", folder / "link");
  write_file(folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(read_file(folder / "real", 100), "new");
}

TEST(WriteFile, RefusesMissingFoldersAndFoldersInPlaceOfFiles) {
  const TemporaryFolder folder;
  EXPECT_NE(write_refusal(folder / "no" / "file").find("folder does not exist"), std::string::npos);
  fs::create_directory(folder / "folder");
  EXPECT_NE(write_refusal(folder / "folder").find("it is a folder"), std::string::npos);
  EXPECT_EQ(folder.files().size(), 1U);
}

TEST(WriteFile, LetsWhatWasWrittenBeCheckedBeforeTheOldFileGoes) {
  const TemporaryFolder folder;
  write_file(folder / "file", "old");
  std::string seen;
  write_file(folder / "file", "new", [&](std::string_view written) {
    seen = written;
    EXPECT_EQ(read_file(folder / "file", 100), "old");
  });
  EXPECT_EQ(seen, "new");
  const auto refuse = [](std::string_view) { throw Error(ErrorKind::Write, "That was not it."); };
  EXPECT_THROW(write_file(folder / "file", "newer", refuse), Error);
  EXPECT_EQ(read_file(folder / "file", 100), "new");
  EXPECT_EQ(folder.files().size(), 1U);
}

TEST(ReadFile, RefusesWhatIsMissingTooLargeOrNoFile) {
  const TemporaryFolder folder;
  write_file(folder / "file", std::string(1000, 'x'));
  EXPECT_EQ(read_file(folder / "file", 1000).size(), 1000U);
  EXPECT_THROW(read_file(folder / "file", 999), Error);
  EXPECT_THROW(read_file(folder / "missing", 999), Error);
  EXPECT_THROW(read_file(folder / "", 999), Error);
}

}  // namespace
}  // namespace netwright
