// The cache on disk: values come back whole or not at all, the bound holds, and processes share a folder.
#include "core/base/disk_cache.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <vector>

#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kRoom = 1'000'000;

/// Returns the files of a folder, ascending.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

void age(const DiskCache& cache, const std::string& key, int hours) {
  ASSERT_TRUE(cache.find(key)) << key;  // it is the newest file now
  const std::vector<fs::path> files = files_in(cache.folder());
  const auto newest = std::max_element(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return fs::last_write_time(a) < fs::last_write_time(b);
  });
  fs::last_write_time(*newest, fs::file_time_type::clock::now() - std::chrono::hours(hours));
}

TEST(DiskCache, FindsTheValueOfItsKeyOnly) {
  const test::TempFolder folder;
  const DiskCache cache(folder / "new" / "cache", kRoom);
  EXPECT_FALSE(cache.find("a"));
  const std::string value("bytes\0\n and more", 16);
  cache.keep("a", value);
  cache.keep("b", "");
  EXPECT_EQ(cache.find("a"), value);
  EXPECT_EQ(cache.find("b"), "");
  EXPECT_FALSE(cache.find("c"));
  cache.keep("a", "another");
  EXPECT_EQ(cache.find("a"), "another");
  EXPECT_EQ(cache.content().values, 2U);
}

TEST(DiskCache, RemovesDamagedFiles) {
  const test::TempFolder folder;
  const DiskCache cache(folder.path(), kRoom);
  const std::string value(500, 'x');
  cache.keep("key", value);
  const fs::path file = files_in(folder.path()).at(0);
  const std::string whole = read_file(file);
  std::vector<std::string> damaged{"", whole.substr(0, 20), whole.substr(0, whole.size() - 1), whole + "x"};
  for (const std::size_t place : {std::size_t{3}, std::size_t{40}, std::size_t{100}, whole.size() - 1}) {
    damaged.push_back(whole);
    damaged.back()[place] ^= 1;
  }
  for (const std::string& bytes : damaged) {
    write_file_atomically(file, bytes);
    EXPECT_FALSE(cache.find("key")) << bytes.size();
    EXPECT_FALSE(fs::exists(file)) << bytes.size();
  }
  write_file_atomically(file, whole);
  EXPECT_EQ(cache.find("key"), value);
}

TEST(DiskCache, RefusesTheFileOfAnotherKey) {
  const test::TempFolder folder;
  const DiskCache cache(folder.path(), kRoom);
  cache.keep("first", "one");
  const fs::path first = files_in(folder.path()).at(0);
  const std::string bytes = read_file(first);
  fs::remove(first);
  cache.keep("second", "two");
  write_file_atomically(files_in(folder.path()).at(0), bytes);
  EXPECT_FALSE(cache.find("second"));
}

TEST(DiskCache, RemovesValuesThatWereNotUsedForTheLongestTime) {
  const test::TempFolder folder;
  const DiskCache cache(folder.path(), 4000);
  for (const char* key : {"a", "b", "c"}) cache.keep(key, std::string(1000, 'x'));
  age(cache, "a", 3), age(cache, "b", 2), age(cache, "c", 1);
  ASSERT_TRUE(cache.find("a"));
  cache.keep("d", std::string(1000, 'x'));
  EXPECT_TRUE(cache.find("a"));
  EXPECT_FALSE(cache.find("b"));
  EXPECT_TRUE(cache.find("c"));
  EXPECT_TRUE(cache.find("d"));
  EXPECT_LE(cache.content().bytes, cache.max_bytes());
  cache.keep("large", std::string(5000, 'x'));
  EXPECT_FALSE(cache.find("large"));
  EXPECT_TRUE(cache.find("a")) << "a value larger than the bound replaces nothing";
}

TEST(DiskCache, ClearsValuesAndNothingElse) {
  const test::TempFolder folder;
  const DiskCache cache(folder.path(), kRoom);
  cache.keep("a", "one");
  cache.keep("b", "two");
  const fs::path own = folder.write("notes.txt", "of the user"),
                 alike = folder.write("0123.cached", "too short a name");
  const DiskCache::Content before = cache.content(), removed = cache.clear();
  EXPECT_EQ(removed.values, 2U);
  EXPECT_EQ(removed.bytes, before.bytes);
  EXPECT_EQ(cache.content().values, 0U);
  EXPECT_EQ(files_in(folder.path()), (std::vector<fs::path>{alike, own}));
}

TEST(DiskCache, DoesWithoutAFolder) {
  const test::TempFolder folder;
  const DiskCache cache(folder.write("file", "") / "below", kRoom);
  cache.keep("a", "one");
  EXPECT_FALSE(cache.find("a"));
  EXPECT_EQ(cache.content().values, 0U);
  EXPECT_EQ(cache.clear().values, 0U);
}

/// Keeps and finds values of a few keys many times. Returns false if a found value is not that of its key.
bool keeps_and_finds(const DiskCache& cache, unsigned seed) {
  for (unsigned i = 0; i < 200; ++i) {
    const unsigned k = (i * 7 + seed) % 10;
    const std::string key = std::to_string(k), value(1000 + 100 * k, static_cast<char>('a' + k));
    if (const auto found = cache.find(key); found && *found != value) return false;
    cache.keep(key, value);
  }
  return true;
}

TEST(DiskCache, IsSharedByProcesses) {
  const test::TempFolder folder;
  const DiskCache cache(folder.path(), 8000);  // about half of the values
  std::vector<pid_t> children;
  for (unsigned seed = 0; seed < 3; ++seed) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(keeps_and_finds(cache, seed) ? 0 : 1);
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = -1;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_GT(cache.content().values, 3U);
  EXPECT_LE(cache.content().bytes, cache.max_bytes());
  EXPECT_EQ(files_in(folder.path()).size(), cache.content().values) << "temporary files are left";
}

}  // namespace
}  // namespace taxel
