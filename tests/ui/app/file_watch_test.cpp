// The watch over open files: each change is reported once, and only after the file has come to rest.
#include "app/studio/host/document/document_files.h"

#include <gtest/gtest.h>

#include <fstream>

#include "fixtures/temp_folder.h"

namespace taxel::studio {
namespace {

using Changes = std::vector<std::pair<std::string, FileChange>>;

struct Watched {
  test::TempFolder folder;
  std::string file = (folder.path() / "open.obj").string();
  FileWatch watch;
  double now = 100;  // time of the clock [s]

  Watched() {
    append("first");
    watch.watch({file});
  }
  void append(const std::string& text) const { std::ofstream(file, std::ios::app) << text; }
  /// Polls half a second later.
  Changes look() {
    now += 0.5;
    return watch.look(now);
  }
};

TEST(FileWatchUnit, ReportsNothingForAFileAtRest) {
  Watched w;
  for (int i = 0; i < 3; ++i) EXPECT_EQ(w.look(), Changes{});
}

TEST(FileWatchUnit, WaitsUntilAFileIsWritten) {
  Watched w;
  EXPECT_EQ(w.look(), Changes{});
  for (int i = 0; i < 4; ++i) {
    w.append("more");
    EXPECT_EQ(w.look(), Changes{}) << "the file is still being written";
  }
  EXPECT_EQ(w.look(), (Changes{{w.file, FileChange::changed}}));
  EXPECT_EQ(w.look(), Changes{}) << "reported once";
  w.append("again");
  EXPECT_EQ(w.look(), Changes{});
  EXPECT_EQ(w.look(), (Changes{{w.file, FileChange::changed}}));
}

TEST(FileWatchUnit, DetectsAnOverwriteOfTheSameSizeByItsTime) {
  Watched w;
  const auto time = std::filesystem::last_write_time(w.file);
  w.look();
  std::ofstream(w.file) << "FIRST";
  std::filesystem::last_write_time(w.file, time + std::chrono::seconds(1));
  EXPECT_EQ(w.look(), Changes{});
  EXPECT_EQ(w.look(), (Changes{{w.file, FileChange::changed}}));
}

TEST(FileWatchUnit, ReportsADeletionOnlyIfTheFileStaysAway) {
  Watched w;
  w.look();
  std::filesystem::remove(w.file);
  EXPECT_EQ(w.look(), Changes{}) << "it may be replaced";
  w.append("new");
  EXPECT_EQ(w.look(), Changes{});
  EXPECT_EQ(w.look(), (Changes{{w.file, FileChange::changed}})) << "it was replaced";
  std::filesystem::remove(w.file);
  EXPECT_EQ(w.look(), Changes{});
  EXPECT_EQ(w.look(), (Changes{{w.file, FileChange::deleted}}));
  EXPECT_EQ(w.look(), Changes{});
}

TEST(FileWatchUnit, IgnoresTheWritesOfTheProgram) {
  Watched w;
  w.look();
  w.append("saved");
  w.watch.accept(w.file);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(w.look(), Changes{});
}

TEST(FileWatchUnit, PollsEveryHalfSecond) {
  Watched w;
  w.look();
  w.append("more");
  EXPECT_EQ(w.watch.look(w.now + 0.5), Changes{});
  EXPECT_EQ(w.watch.look(w.now + 0.99), Changes{}) << "too early for the second look";
  EXPECT_EQ(w.watch.look(w.now + 1.0), (Changes{{w.file, FileChange::changed}}));
}

TEST(FileWatchUnit, ContinuesWithAFileThatWasWatchedBefore) {
  Watched w;
  w.look();
  w.append("more");
  w.look();
  const std::string other = (w.folder.path() / "other.obj").string();
  std::ofstream{other} << "other";
  w.watch.watch({other, w.file});
  EXPECT_EQ(w.look(), (Changes{{w.file, FileChange::changed}})) << "its change is not lost";
}

TEST(FileHash, DiffersByContentAndIsEmptyWithoutAFile) {
  const Watched w;
  const std::string before = hash_of(w.file);
  EXPECT_EQ(before.size(), 64U);
  w.append("x");
  EXPECT_NE(hash_of(w.file), before);
  EXPECT_EQ(hash_of(""), "");
  EXPECT_EQ(hash_of(w.file + ".none"), "");
}

}  // namespace
}  // namespace taxel::studio
