// Fonts of the system, as fontconfig finds them in a folder of the test.
#include "core/base/os/fonts.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "fixtures/tiny_font.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

TEST(SystemFonts, AreFoundIfTheyHaveTheCharacter) {
  const fs::path folder = fs::path(testing::TempDir()) / "taxel_fonts";
  fs::create_directories(folder);
  const fs::path font = folder / "tiny.ttf", config = folder / "fonts.conf";
  std::ofstream(font, std::ios::binary) << test::tiny_font(U'\u4E2D');
  std::ofstream(config) << "<?xml version=\"1.0\"?><!DOCTYPE fontconfig SYSTEM \"fonts.dtd\"><fontconfig><dir>"
                        << folder.string() << "</dir><cachedir>" << (folder / "cache").string()
                        << "</cachedir></fontconfig>";
  ::setenv("FONTCONFIG_FILE", config.c_str(), 1);
  const std::optional<os::FontFile> found = os::find_font("zh-cn", U'\u4E2D');
  if (!found) GTEST_SKIP() << "the library of fontconfig is not installed";
  EXPECT_EQ(fs::weakly_canonical(found->file), fs::weakly_canonical(font));
  EXPECT_EQ(found->index, 0);
  EXPECT_FALSE(os::find_font("ko", U'\uAC00')) << "the font does not have this character";
  ::unsetenv("FONTCONFIG_FILE");
}

}  // namespace
}  // namespace taxel
