// Files are complete or not there, and every refusal of the file system is one clear sentence.
#include "parapet/records/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "program_runner.hpp"

namespace parapet::test {
namespace {

using ::testing::IsSubstring;

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const records::FileError& error) {
    return error.what();
  }
  return "nothing was refused";
}

std::size_t entries(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(AtomicFile, ReplacesTheContentAndLeavesNothingBeside) {
  const TemporaryFolder folder;
  records::write_file_atomically(folder / "a", "first");
  records::write_file_atomically(folder / "a", "second");
  EXPECT_EQ(file_text(folder / "a"), "second");
  EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(AtomicFile, RefusedTargetKeepsItsContentAndLeavesNothingBeside) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "a");  // a file cannot be renamed over a folder
  EXPECT_PRED_FORMAT2(IsSubstring, "/a: Is a directory",
                      refusal([&] { records::write_file_atomically(folder / "a", "text"); }));
  EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(AtomicFile, MissingFolderIsNamed) {
  const TemporaryFolder folder;
  EXPECT_PRED_FORMAT2(IsSubstring, "No such file or directory", refusal([&] {
                        records::write_file_atomically(folder / "no/where", "text");
                      }));
}

TEST(AtomicFile, LinkIsNeitherFollowedNorReplaced) {
  const TemporaryFolder folder;
  folder.write("victim", "text");
  std::filesystem::create_symlink("victim", folder / "a");
  EXPECT_PRED_FORMAT2(IsSubstring, "is a link",
                      refusal([&] { records::write_file_atomically(folder / "a", "new"); }));
  EXPECT_PRED_FORMAT2(IsSubstring, "is a link",
                      refusal([&] { records::read_own_file(folder / "a"); }));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "a"));
  EXPECT_EQ(file_text(folder / "victim"), "text");
}

TEST(AtomicFile, PipeIsNoFileOfOurs) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_PRED_FORMAT2(IsSubstring, "not a regular file",
                      refusal([&] { records::read_own_file(folder / "pipe"); }));
}

TEST(AtomicFile, FolderWhereAFileStandsIsRefused) {
  const TemporaryFolder folder;
  folder.write("a", "text");
  EXPECT_PRED_FORMAT2(IsSubstring, "cannot create the folder",
                      refusal([&] { records::make_folder(folder / "a"); }));
  EXPECT_PRED_FORMAT2(IsSubstring, "cannot create the folder",
                      refusal([&] { records::make_folder(folder / "a/b"); }));
  EXPECT_NO_THROW(records::make_folder(folder / "b/c"));
  EXPECT_NO_THROW(records::make_folder(folder / "b/c"));
}

TEST(AtomicFile, ReadingAFolderOrNothingIsRefused) {
  const TemporaryFolder folder;
  EXPECT_PRED_FORMAT2(IsSubstring, "Is a directory",
                      refusal([&] { records::read_file(folder.path()); }));
  EXPECT_PRED_FORMAT2(IsSubstring, "No such file",
                      refusal([&] { records::read_file(folder / "a"); }));
}

}  // namespace
}  // namespace parapet::test
