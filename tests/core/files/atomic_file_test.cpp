#include "core/files/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "tests/core/image/temporary_folder.h"

namespace plinian {
namespace {

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(AtomicFile, ReplacesWhatWasThereAndLeavesNothingElse) {
  const TemporaryFolder folder;
  write_file(folder / "a.txt", std::string_view("first"));
  write_file(folder / "a.txt", std::string_view("second"));
  EXPECT_EQ(contents(folder / "a.txt"), "second");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, AWriteThatFailsHalfwayKeepsTheOldFile) {
  const TemporaryFolder folder;
  write_file(folder / "a.txt", std::string_view("old"));
  // Files of this process may not grow beyond 100 bytes: the same error path as a full disk.
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old_limit, limit;
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old_limit), 0);
  limit = old_limit;
  limit.rlim_cur = 100;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  const std::string message =
      message_of<FileError>([&] { write_file(folder / "a.txt", std::string_view(std::string(1000, 'x'))); });
  setrlimit(RLIMIT_FSIZE, &old_limit);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_NE(message.find("a.txt: cannot be written: File too large"), std::string::npos) << message;
  EXPECT_EQ(contents(folder / "a.txt"), "old");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, KeepsABackupOfWhatCannotBeMadeAgain) {
  const TemporaryFolder folder;
  write_file_durably(folder / "a.txt", "first");
  EXPECT_EQ(folder.entries(), 1u);
  for (const char* text : {"second", "third"}) write_file_durably(folder / "a.txt", text);
  EXPECT_EQ(contents(folder / "a.txt"), "third");
  EXPECT_EQ(contents(folder / "a.txt.bak"), "second");
  EXPECT_EQ(folder.entries(), 2u);
  // A save that died after it had kept the backup.
  std::filesystem::remove(folder / "a.txt.bak");
  std::filesystem::create_hard_link(folder / "a.txt", folder / "a.txt.bak");
  write_file_durably(folder / "a.txt", "fourth");
  EXPECT_EQ(contents(folder / "a.txt.bak"), "third");
  EXPECT_EQ(folder.entries(), 2u);
}

TEST(AtomicFile, SaysThatTheFolderDoesNotExist) {
  const TemporaryFolder folder;
  const std::string path = folder / "nowhere/a.exr";
  const std::string message = message_of<FileError>([&] { check_writable(path); });
  EXPECT_EQ(message, path + ": cannot be written: the folder " + (folder / "nowhere") + " does not exist");
  EXPECT_EQ(message_of<FileError>([&] { write_file(path, std::string_view("x")); }), message);
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(AtomicFile, RefusesAFolderADeviceAndAFileUsedAsAFolder) {
  const TemporaryFolder folder;
  EXPECT_NE(message_of<FileError>([&] { check_writable(folder.path().string()); }).find("it is a folder"),
            std::string::npos);
  EXPECT_NE(message_of<FileError>([&] { check_writable("/dev/null"); }).find("not a plain file"),
            std::string::npos);
  write_file(folder / "file", std::string_view("x"));
  EXPECT_NE(message_of<FileError>([&] { check_writable(folder / "file/a.exr"); }).find("not a folder"),
            std::string::npos);
  EXPECT_NE(message_of<FileError>([&] { check_writable(""); }).find("empty"), std::string::npos);
}

TEST(AtomicFile, RefusesAFolderThatTakesNoFilesEvenForTheSuperuser) {
  if (!std::filesystem::is_directory("/proc/self")) GTEST_SKIP() << "no /proc here";
  EXPECT_NE(message_of<FileError>([&] { check_writable("/proc/self/a.exr"); }).find("no file can be made in"),
            std::string::npos);
}

// An ordinary user for the time of a test: the superuser may write any file.
struct OrdinaryUser {
  const uid_t before = ::geteuid();
  OrdinaryUser() {
    if (before == 0 && ::seteuid(65534) != 0) throw std::runtime_error("cannot become an ordinary user");
  }
  ~OrdinaryUser() {
    if (before == 0 && ::seteuid(0) != 0) std::abort();
  }
};

TEST(AtomicFile, RefusesAWriteProtectedFileAndFolder) {
  const TemporaryFolder folder;
  ::chmod(folder.path().c_str(), 0777);
  write_file(folder / "a.exr", std::string_view("precious"));
  ::chmod((folder / "a.exr").c_str(), 0444);
  {
    const OrdinaryUser user;
    EXPECT_NE(message_of<FileError>([&] { check_writable(folder / "a.exr"); }).find("Permission denied"),
              std::string::npos);
    EXPECT_THROW(write_file(folder / "a.exr", std::string_view("x")), FileError);
    check_writable(folder / "b.exr");
  }
  EXPECT_EQ(contents(folder / "a.exr"), "precious");
  ::chmod(folder.path().c_str(), 0555);
  {
    const OrdinaryUser user;
    EXPECT_NE(message_of<FileError>([&] { check_writable(folder / "b.exr"); }).find("Permission denied"),
              std::string::npos);
  }
  ::chmod(folder.path().c_str(), 0777);
}

TEST(AtomicFile, CheckingChangesNothing) {
  const TemporaryFolder folder;
  check_writable(folder / "a.exr");
  EXPECT_EQ(folder.entries(), 0u);
  write_file(folder / "a.exr", std::string_view("old"));
  check_writable(folder / "a.exr");
  EXPECT_EQ(contents(folder / "a.exr"), "old");
}

TEST(AtomicFile, FollowsALinkAndKeepsPermissions) {
  const TemporaryFolder folder;
  write_file(folder / "real.txt", std::string_view("old"));
  ::chmod((folder / "real.txt").c_str(), 0640);
  std::filesystem::create_symlink("real.txt", folder / "link.txt");
  write_file(folder / "link.txt", std::string_view("new"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
  EXPECT_EQ(contents(folder / "real.txt"), "new");
  struct stat status;
  ASSERT_EQ(::stat((folder / "real.txt").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0640u);
}

TEST(AtomicFile, LetsSomebodyElseWriteAndForgetsWhatFailed) {
  const TemporaryFolder folder;
  write_file(folder / "a.vdb", [](const std::string& temporary) { std::ofstream(temporary) << "first"; });
  EXPECT_EQ(contents(folder / "a.vdb"), "first");
  EXPECT_THROW(write_file(folder / "a.vdb",
                          [](const std::string& temporary) {
                            std::ofstream(temporary) << "half";
                            throw std::runtime_error("stopped");
                          }),
               std::runtime_error);
  EXPECT_EQ(contents(folder / "a.vdb"), "first");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, WritesIntoTheCurrentFolderByABareName) {
  const TemporaryFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  write_file("bare.txt", std::string_view("x"));
  std::filesystem::current_path(before);
  EXPECT_EQ(contents(folder / "bare.txt"), "x");
}

}  // namespace
}  // namespace plinian
