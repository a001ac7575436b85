// Targets that exist stay as they are: rights, owner, links, devices and pipes.
#include "core/base/output.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <thread>

#include "core/base/files.h"
#include "fixtures/complaint.h"
#include "fixtures/temp_folder.h"

namespace {
/// Called in the place of another process with the path of each folder that this program is about to make.
std::function<void(const std::filesystem::path&)> act_as_another_process;
}  // namespace

/// Takes the place of the C library's function in this program.
extern "C" int mkdir(const char* path, mode_t mode) noexcept {
  if (act_as_another_process) act_as_another_process(path);
  return static_cast<int>(::syscall(SYS_mkdirat, AT_FDCWD, path, mode));
}

namespace taxel::test {
namespace {

namespace fs = std::filesystem;

struct stat status_of(const fs::path& path) {
  struct stat status {};
  EXPECT_EQ(::lstat(path.c_str(), &status), 0) << path;
  return status;
}

unsigned mode_of(const fs::path& path) {
  return status_of(path).st_mode & 07777U;
}

/// The ways in which every file is written.
void write_both_ways(const fs::path& target, const std::string& bytes, int way) {
  if (way == 0) return write_file_atomically(target, bytes);
  OutputFolder folder(target.parent_path());
  folder.write(target.filename().string(), bytes);
  folder.commit();
}

class EachWay : public testing::TestWithParam<int> {
 protected:
  void write(const std::string& name, const std::string& bytes) const {
    write_both_ways(folder_ / name, bytes, GetParam());
  }
  /// Expects that only these files are in the folder.
  void expect_only(const std::set<std::string>& names) const {
    std::set<std::string> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_.path()))
      found.insert(entry.path().filename().string());
    EXPECT_EQ(found, names);
  }
  TempFolder folder_;
};

TEST_P(EachWay, KeepsTheRightsOfAFile) {
  for (const unsigned mode : {0600U, 0664U, 0640U}) {
    std::ofstream(folder_ / "a") << "old";
    ASSERT_EQ(::chmod((folder_ / "a").c_str(), mode), 0);
    write("a", "new");
    EXPECT_EQ(mode_of(folder_ / "a"), mode);
    EXPECT_EQ(read_file(folder_ / "a"), "new");
  }
}

TEST_P(EachWay, GivesNewFilesTheRightsOfTheUmask) {
  const mode_t before = ::umask(027);
  write("a", "new");
  ::umask(before);
  EXPECT_EQ(mode_of(folder_ / "a"), 0640U);
}

TEST_P(EachWay, KeepsTheOwnerOfAFile) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give files away";
  std::ofstream(folder_ / "a") << "old";
  ASSERT_EQ(::chown((folder_ / "a").c_str(), 1234, 5678), 0);
  write("a", "new");
  EXPECT_EQ(status_of(folder_ / "a").st_uid, 1234U);
  EXPECT_EQ(status_of(folder_ / "a").st_gid, 5678U);
}

TEST_P(EachWay, FollowsLinks) {
  fs::create_directory(folder_ / "real");
  std::ofstream(folder_ / "real/a") << "old";
  fs::create_symlink("real/a", folder_ / "link");
  fs::create_symlink("link", folder_ / "second");
  fs::create_symlink("real/new", folder_ / "to_nothing");
  write("second", "new");
  write("to_nothing", "first");
  EXPECT_EQ(read_file(folder_ / "real/a"), "new");
  EXPECT_EQ(read_file(folder_ / "real/new"), "first");
  for (const char* link : {"link", "second", "to_nothing"}) EXPECT_TRUE(fs::is_symlink(folder_ / link)) << link;
  expect_only({"real", "link", "second", "to_nothing"});
}

TEST_P(EachWay, KeepsTheOtherNamesOfAFile) {
  std::ofstream(folder_ / "a") << "an old and longer text";
  fs::create_hard_link(folder_ / "a", folder_ / "b");
  write("a", "new");
  EXPECT_EQ(read_file(folder_ / "b"), "new");
  EXPECT_EQ(status_of(folder_ / "a").st_ino, status_of(folder_ / "b").st_ino);
  expect_only({"a", "b"});
}

TEST_P(EachWay, WritesIntoAPipe) {
  ASSERT_EQ(::mkfifo((folder_ / "a").c_str(), 0600), 0);
  const std::string bytes(300000, 'x');  // more than a pipe holds
  const int reader = ::open((folder_ / "a").c_str(), O_RDONLY | O_NONBLOCK);
  std::string read;
  std::thread writing([&] { write("a", bytes); });
  char block[4096];
  while (read.size() < bytes.size())
    if (const ssize_t n = ::read(reader, block, sizeof block); n > 0) read.append(block, static_cast<std::size_t>(n));
  writing.join();
  ::close(reader);
  EXPECT_TRUE(read == bytes);
  EXPECT_TRUE(S_ISFIFO(status_of(folder_ / "a").st_mode));
  expect_only({"a"});
}

TEST_P(EachWay, RefusesAPipeThatNobodyReads) {
  ASSERT_EQ(::mkfifo((folder_ / "a").c_str(), 0600), 0);
  EXPECT_EQ(complaint_of([&] { write("a", "new"); }),
            (folder_ / "a").string() + ": cannot be written: no program reads it");
  expect_only({"a"});
}

TEST_P(EachWay, WritesIntoADevice) {
  for (const char* device : {"/dev/null", "/dev/full"}) {
    if (!fs::exists(device)) GTEST_SKIP() << "no " << device;
    fs::remove(folder_ / "a");
    fs::create_symlink(device, folder_ / "a");
    const std::string complaint = complaint_of([&] { write("a", "new"); });
    EXPECT_EQ(complaint, device == std::string("/dev/null")
                             ? "accepted"
                             : (folder_ / "a").string() + ": writing failed: No space left on device");
    EXPECT_TRUE(fs::is_symlink(folder_ / "a"));
    EXPECT_TRUE(S_ISCHR(status_of(device).st_mode));
  }
  expect_only({"a"});
}

INSTANTIATE_TEST_SUITE_P(Files, EachWay, testing::Values(0, 1));

TEST(TemporaryPaths, AreNewAndPrivateAndCannotBeForeseen) {
  const TempFolder folder;
  std::set<std::string> names;
  for (int i = 0; i < 20; ++i) {
    const TemporaryPath file(folder.path(), "a.", os::Open::create_private);
    names.insert(file.path().filename().string());
    EXPECT_EQ(mode_of(file.path()), 0600U);
  }
  EXPECT_EQ(names.size(), 20U);
  const TemporaryPath staging(folder.path(), ".taxel-", os::Open::create_folder);
  EXPECT_EQ(mode_of(staging.path()), 0700U);
}

TEST(TemporaryPaths, AreNeverLinksThatExist) {
  const TempFolder folder;
  std::ofstream(folder / "victim") << "mine";
  fs::create_symlink("victim", folder / "link");
  for (const os::Open how :
       {os::Open::create, os::Open::create_private, os::Open::append, os::Open::hold, os::Open::create_folder})
    EXPECT_FALSE(os::File(folder / "link", how).is_open()) << static_cast<int>(how);
  EXPECT_EQ(read_file(folder / "victim"), "mine");
}

TEST(OutputFolders, RemoveOnlyTheirOwnFolders) {
  const TempFolder folder;
  {
    const OutputFolder first(folder / "results/1");
    OutputFolder second(folder / "results/2");
    std::ofstream(folder / "results/1/notes") << "mine";
  }
  EXPECT_FALSE(fs::exists(folder / "results/2"));
  EXPECT_EQ(read_file(folder / "results/1/notes"), "mine");
}

TEST(OutputFolders, KeepOtherFilesInTheirSubfolders) {
  const TempFolder folder;
  fs::create_directories(folder / "out/meshes");
  std::ofstream(folder / "out/meshes/mine.obj") << "mine";
  OutputFolder output(folder / "out");
  fs::create_directory(output.staging() / "meshes");
  output.write("meshes/new.obj", "new");
  EXPECT_EQ(output.commit(), std::vector<std::string>{"meshes"});
  EXPECT_EQ(read_file(folder / "out/meshes/mine.obj"), "mine");
  EXPECT_EQ(read_file(folder / "out/meshes/new.obj"), "new");
}

TEST(OutputFolders, MakeParentsThatAnotherProcessRemoves) {
  const TempFolder folder;
  const std::filesystem::path results = folder / "results", out = results / "1";
  int most = 50;  // of each
  std::map<std::filesystem::path, int> removed;
  act_as_another_process = [&](const std::filesystem::path& made) {
    const std::filesystem::path parent = made.parent_path();
    if ((parent == results || parent == out) && removed[parent] < most && ::rmdir(parent.c_str()) == 0)
      ++removed[parent];
  };
  EXPECT_EQ(complaint_of([&] { const OutputFolder one(out); }), "accepted");
  EXPECT_EQ(removed[results], most);
  EXPECT_EQ(removed[out], most);
  most = 1'000'000;
  EXPECT_EQ(complaint_of([&] { const OutputFolder one(out); }),
            out.string() + ": folder cannot be made: No such file or directory");
  act_as_another_process = nullptr;
}

}  // namespace
}  // namespace taxel::test
