// Whole files: round trips, atomic writing, and the error for each kind of failure.
#include "core/base/files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "core/base/error.h"
#include "core/base/output.h"
#include "fixtures/ended_process.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;
using test::TempFolder;

template <class Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::size_t file_count(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(Files, ReadsRegularFilesOnly) {
  const TempFolder folder;
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(message_of([&] { read_file(pipe); }), pipe.string() + ": is not a regular file");
  EXPECT_EQ(message_of([&] { read_file("/dev/zero"); }), "/dev/zero: is not a regular file");
  EXPECT_EQ(message_of([&] { read_file(folder.path()); }), folder.path().string() + ": is a folder, not a file");
}

TEST(Files, RefusesFilesAboveTheLimit) {
  const TempFolder folder;
  write_file_atomically(folder / "five", "12345");
  EXPECT_EQ(read_file(folder / "five", 5), "12345");
  EXPECT_EQ(message_of([&] { read_file(folder / "five", 4); }),
            (folder / "five").string() + ": is larger than 4 bytes, the most that is read");
  fs::resize_file(folder / "five", kMaxFileBytes + 1);  // a sparse file uses no space on the disk
  EXPECT_EQ(message_of([&] { read_file(folder / "five"); }),
            (folder / "five").string() + ": is larger than 1073741824 bytes, the most that is read");
}

TEST(Files, KeepsAllBytesInARoundTrip) {
  const TempFolder folder;
  std::string bytes("line\r\n\0more\n", 12);
  for (int i = 0; i < 100000; ++i) bytes += static_cast<char>(i * i);
  write_file_atomically(folder / "a", bytes);
  EXPECT_TRUE(read_file(folder / "a") == bytes);
  write_file_atomically(folder / "a", "");
  EXPECT_EQ(read_file(folder / "a"), "");
  EXPECT_EQ(file_count(folder.path()), 1U) << "nothing is left next to the file";
}

TEST(Files, ShowsReadersTheOldFileOrTheNewOne) {
  const TempFolder folder;
  write_file_atomically(folder / "a", "old");
  // A reader that has the file open keeps the old bytes, because the new bytes are in another file that is renamed over
  // the old one.
  FILE* open = std::fopen((folder / "a").c_str(), "rb");
  ASSERT_NE(open, nullptr);
  write_file_atomically(folder / "a", "newer");
  char seen[8] = {};
  EXPECT_EQ(std::fread(seen, 1, sizeof seen, open), 3U);
  EXPECT_STREQ(seen, "old");
  std::fclose(open);
  EXPECT_EQ(read_file(folder / "a"), "newer");
}

TEST(Files, ErrorNamesTheUnreadableFile) {
  const TempFolder folder;
  EXPECT_NE(message_of([&] { read_file(folder / "none"); }).find("none: no such file"), std::string::npos);
  EXPECT_NE(message_of([&] { read_file(folder.path()); }).find("is a folder"), std::string::npos);
}

TEST(Files, ErrorNamesTheUnwritableFileAndLeavesNothing) {
  const TempFolder folder;
  EXPECT_NE(message_of([&] { write_file_atomically(folder / "none/a", "x"); }).find("none/a"), std::string::npos);
  fs::create_directory(folder / "taken");
  EXPECT_NE(message_of([&] { write_file_atomically(folder / "taken", "x"); }).find("taken"), std::string::npos);
  EXPECT_TRUE(fs::is_directory(folder / "taken"));
  EXPECT_EQ(file_count(folder.path()), 1U);
}

TEST(Files, KeepsTheOldFileIfAWriteFails) {
  const TempFolder folder;
  const fs::path file = folder / std::string(250, 'a');  // too long with the suffix of a temporary name
  std::ofstream(file) << "old";
  EXPECT_NE(message_of([&] { write_file_atomically(file, "new"); }).find("cannot be written"), std::string::npos);
  EXPECT_EQ(read_file(file), "old");
}

TEST(Files, RemovesTemporaryPathsOfEndedProcesses) {
  const TempFolder folder;
  const std::string number = "-0123abcd", ended = std::to_string(test::ended_process()) + number,
                    running = std::to_string(::getppid()) + number;
  for (const std::string& name :
       {"a." + ended + ".part", "a." + running + ".part", "b." + ended + ".part", std::string("a.notes.part"),
        std::string("a.1.part"), ".taxel-" + ended + ".part/x"}) {
    fs::create_directories((folder / name).parent_path());
    std::ofstream(folder / name) << "half";
  }
  write_file_atomically(folder / "a", "whole");
  EXPECT_FALSE(fs::exists(folder / ("a." + ended + ".part")));
  EXPECT_TRUE(fs::exists(folder / ("a." + running + ".part"))) << "its process runs";
  EXPECT_TRUE(fs::exists(folder / ("b." + ended + ".part"))) << "belongs to another file";
  for (const char* name : {"a.notes.part", "a.1.part"}) EXPECT_TRUE(fs::exists(folder / name)) << "is a user's file";
  OutputFolder output(folder.path());
  EXPECT_FALSE(fs::exists(folder / (".taxel-" + ended + ".part")));
}

TEST(Files, KeepsTemporaryPathsThatAreLocked) {
  // The process id of another machine or container is meaningless here, so the lock decides.
  const TempFolder folder;
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  const fs::path other = folder / ("a." + std::to_string(child) + "-00000000.part");
  const int descriptor = ::open(other.c_str(), O_WRONLY | O_CREAT, 0666);
  ASSERT_EQ(::flock(descriptor, LOCK_EX), 0);
  write_file_atomically(folder / "a", "whole");
  EXPECT_TRUE(fs::exists(other));
  ::close(descriptor);
  write_file_atomically(folder / "a", "whole");
  EXPECT_FALSE(fs::exists(other));
}

TEST(OutputFolders, CheckAllTargetsBeforeAnyIsWritten) {
  const TempFolder folder;
  fs::create_directories(folder / "out/b");
  std::ofstream(folder / "out/a") << "old";
  OutputFolder output(folder / "out");
  output.write("a", "new");
  output.write("b", "new");
  EXPECT_NE(message_of([&] { output.commit(); }).find("out/b: is a folder, a file is needed"), std::string::npos);
  EXPECT_EQ(read_file(folder / "out/a"), "old");
}

TEST(OutputFolders, NameTheFinalFileInErrors) {
  const TempFolder folder;
  OutputFolder output(folder / "out");
  const std::string name(250, 'a');
  EXPECT_EQ(message_of([&] { output.write(name, ""); }),
            (folder / "out" / name).string() + ": cannot be written: File name too long");
}

TEST(OutputFolders, CommitSeveralTimes) {
  const TempFolder folder;
  {
    OutputFolder output(folder / "deep/out");
    output.write("a", "1");
    EXPECT_EQ(output.commit(), std::vector<std::string>{"a"});
    output.write("b", "2");
  }
  EXPECT_EQ(read_file(folder / "deep/out/a"), "1");
  EXPECT_EQ(file_count(folder / "deep/out"), 1U) << "the second file was not committed";
  { const OutputFolder nothing(folder / "other/out"); }
  EXPECT_FALSE(fs::exists(folder / "other"));
}

TEST(Files, NamesTheFileOnAFullDisk) {
  const TempFolder folder;
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message = message_of([&] { write_file_atomically(folder / "a", std::string(100000, 'x')); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(message, (folder / "a").string() + ": writing failed: File too large");
  EXPECT_EQ(file_count(folder.path()), 0U);
}

TEST(Files, CreatesFoldersWithTheirParents) {
  const TempFolder folder;
  make_folder(folder / "a/b/c");
  make_folder(folder / "a/b/c");
  EXPECT_TRUE(fs::is_directory(folder / "a/b/c"));
  write_file_atomically(folder / "file", "x");
  EXPECT_NE(message_of([&] { make_folder(folder / "file"); }).find("file"), std::string::npos);
  EXPECT_NE(message_of([&] { make_folder(folder / "file/sub"); }).find("file/sub"), std::string::npos);
}

}  // namespace
}  // namespace taxel
