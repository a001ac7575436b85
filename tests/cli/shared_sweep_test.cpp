// The cache of sweeps that the tests share. With a wrong entry the tests would not test the program.
#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

TEST(SharedSweep, IsMadeAgainIfTheFilesOfItsOptionsChange) {
  const fs::path folder = test_folder();
  const auto sweep_of = [&](double radius) {
    const fs::path layout =
        changed_layout(folder, Json::array({{{"op", "replace"}, {"path", "/taxels/4/radius"}, {"value", radius}},
                                            {{"op", "replace"}, {"path", "/sampling/density"}, {"value", 1e5}}}));
    return shared_box_sweep({"--layout", layout.string()});
  };
  const fs::path small = sweep_of(0.004), large = sweep_of(0.006);
  EXPECT_NE(small, large) << "the same options, but another layout";
  EXPECT_NE(file_text(small / "readings.csv"), file_text(large / "readings.csv"));
  EXPECT_EQ(sweep_of(0.004), small);
}

TEST(SharedSweep, IsMadeAgainIfOrderOrTextOfOptionsChanges) {
  const fs::path plain = shared_box_sweep({"--density", "1e5"});
  EXPECT_NE(shared_box_sweep({"--density", "2e5"}), plain);
  EXPECT_EQ(shared_box_sweep({"--density", "1e5"}), plain);
}

}  // namespace
}  // namespace taxel::test
