// The times at which unsaved edits are written, with a simulated clock.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "app/studio/host/document/document_files.h"
#include "app/studio/host/jobs/job_executor.h"
#include "core/document/project.h"
#include "fixtures/run_program.h"

namespace taxel::test {
namespace {

using studio::Autosave;

class AutosaveInterval : public testing::TestWithParam<double> {};

/// With continuous edits, each revision is written at the latest one interval after it was made, and not at every edit.
TEST_P(AutosaveInterval, IsNeitherLongerNorShorter) {
  const double every = GetParam();
  const auto folder = fresh_folder(std::filesystem::path(TAXEL_BINARY_DIR) / "studio_tests", "AutosaveInterval");
  studio::JobPool pool;
  Autosave autosave(pool, every);
  autosave.start(folder);
  const auto project = std::make_shared<const Project>();
  double now = 1e5;  // time of the clock, which began at an arbitrary time [s]
  EXPECT_FALSE(autosave.seconds_until_due(now));
  autosave.update(project, 1, "finger", "", now);
  for (const double part : {0.0, 0.3, 0.9, 0.999}) {
    const double wait = every * (1 - part);
    autosave.update(project, 2, "finger", "", now + every * part);
    ASSERT_TRUE(autosave.seconds_until_due(now + every * part)) << "written too early, at " << part;
    EXPECT_NEAR(*autosave.seconds_until_due(now + every * part), wait, 1e-6 * every);
  }
  now += every;
  EXPECT_NEAR(*autosave.seconds_until_due(now), 0, 1e-6 * every);
  autosave.update(project, 2, "finger", "", now + 1e-6 * every);
  EXPECT_FALSE(autosave.seconds_until_due(now)) << "it was written";
  autosave.update(project, 2, "finger", "", now + 5 * every);
  EXPECT_FALSE(autosave.seconds_until_due(now)) << "nothing is unwritten";
  autosave.update(nullptr, 0, "finger", "", now + 6 * every);
  EXPECT_FALSE(autosave.seconds_until_due(now)) << "saved";
  autosave.end();
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

INSTANTIATE_TEST_SUITE_P(Seconds, AutosaveInterval, testing::Values(0.01, 2.0, 30.0));

/// Waits for the result of the attempt, at most ten seconds.
std::string answer(Autosave& autosave, const ProjectPtr& project, std::uint64_t revision, double now) {
  for (int i = 0; i < 1000; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (std::string failure = autosave.update(project, revision, "finger", "", now); !failure.empty()) return failure;
  }
  return "";
}

// The folder may be on a full disk that has room again later.
TEST(AutosaveFailure, IsReportedOnceAndWritingIsRetried) {
  const auto folder = fresh_folder(std::filesystem::path(TAXEL_BINARY_DIR) / "studio_tests", "AutosaveFailure");
  const auto file = folder / (std::to_string(::getpid()) + "-1.taxelproj");
  studio::JobPool pool;
  Autosave autosave(pool, 2);
  autosave.start(folder);
  std::filesystem::create_directories(file / "in the way");
  const auto project = std::make_shared<const Project>();
  autosave.update(project, 1, "finger", "", 100);
  autosave.update(project, 1, "finger", "", 102);
  EXPECT_NE(answer(autosave, project, 1, 103).find(file.string()), std::string::npos);
  ASSERT_TRUE(autosave.seconds_until_due(103)) << "it is tried again";
  EXPECT_NEAR(*autosave.seconds_until_due(103), 2, 1e-9);
  autosave.update(project, 1, "finger", "", 105);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_EQ(autosave.update(project, 1, "finger", "", 106), "") << "reported once";
  std::filesystem::remove_all(file);
  autosave.update(project, 1, "finger", "", 108);
  for (int i = 0; i < 1000 && !std::filesystem::exists(file); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(std::filesystem::is_regular_file(file));
  autosave.end();
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST(AutosaveFolder, OffersOnlyRegularFiles) {
  const auto folder = fresh_folder(std::filesystem::path(TAXEL_BINARY_DIR) / "studio_tests", "AutosaveFolder");
  ASSERT_EQ(::mkfifo((folder / "1-1.taxelproj").c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", folder / "1-2.taxelproj");
  write_text(folder / "1-3.taxelproj", "{}");
  studio::JobPool pool;
  Autosave autosave(pool, 2);
  autosave.start(folder);
  const auto lost = autosave.lost();
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_EQ(lost.front().file.filename(), "1-3.taxelproj");
}

}  // namespace
}  // namespace taxel::test
