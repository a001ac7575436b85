// When unsaved edits are written, at made-up times.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "app/studio/autosave.h"
#include "core/project/project_json.h"
#include "fixtures/run_program.h"

namespace taxel::test {
namespace {

using studio::Autosave;

class AutosaveInterval : public testing::TestWithParam<double> {};

/// Edits without end: each revision is written at the latest one interval after it was made, and not at every edit.
TEST_P(AutosaveInterval, IsNeitherLongerNorShorter) {
  const double every = GetParam();
  const auto folder = fresh_folder(std::filesystem::path(TAXEL_BINARY_DIR) / "studio_tests", "AutosaveInterval");
  Autosave autosave(every);
  autosave.start(folder);
  const auto project = std::make_shared<const Project>();
  double now = 1e5;  // [s]; the clock began at some time
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

}  // namespace
}  // namespace taxel::test
