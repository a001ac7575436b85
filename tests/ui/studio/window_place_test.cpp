// The place of the window on the screen, kept from one start to the next.
#include <gtest/gtest.h>

#include "script_lines.h"

namespace taxel::test {
namespace {

TEST(WindowPlace, IsKeptFromOneStartToTheNext) {
  const StudioProgram studio;
  std::filesystem::create_directories(studio.folder() / "state");
  write_text(studio.folder() / "state/settings.json", R"({"window_place": [60, 40, 900, 640]})");
  const std::vector<std::string> arguments{"--state-dir", "state", "--empty"};
  studio.play({kIdle, R"({"do": "screenshot", "file": "kept.png"})"}, arguments);
  const Json written = Json::parse(file_text(studio.folder() / "state/settings.json"));
  EXPECT_EQ(written["window_place"], Json({60, 40, 900, 640}));
  const Picture kept = studio.picture("kept.png");
  if (in_a_window()) {
    EXPECT_EQ(kept.width, 900);
    EXPECT_EQ(kept.height, 640);
    studio.play({kIdle, R"({"do": "screenshot", "file": "given.png"})"},
                {"--state-dir", "state", "--empty", "--size", "800x600"});
    EXPECT_EQ(studio.picture("given.png").width, 800) << "--size is stronger";
  } else {
    EXPECT_EQ(kept.width, 1280) << "offscreen, only --size counts";
  }
}

}  // namespace
}  // namespace taxel::test
