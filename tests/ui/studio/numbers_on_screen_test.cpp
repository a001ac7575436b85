// The numbers on the screen, of all files of the program: none with a sign without a value, or digits without a
// meaning.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "script_lines.h"

namespace taxel::test {
namespace {

/// Returns the texts that no user should see: a zero with a sign, a power of ten below rounding errors, a plural of
/// one.
std::vector<std::string> bad_texts(const std::vector<std::string>& texts) {
  static const std::regex kBad(R"([+-]0(\.0*)?|.*\de-(0[6-9]|[1-9]\d)|nan|-?inf)");
  static const std::regex kPlural("samples|taxels|polygons|steps|problems|layouts|triangles|bodies|rows|holes");
  std::vector<std::string> bad;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (std::regex_match(texts[i], kBad)) bad.push_back(texts[i]);
    const bool is_single =
        i > 0 && texts[i - 1] == "1" && (i < 2 || !std::regex_match(texts[i - 2], std::regex("\\d+")));
    if (is_single && std::regex_match(texts[i], kPlural)) bad.push_back("1 " + texts[i]);
  }
  return bad;
}

std::vector<std::string> files() {
  std::vector<std::string> files;
  for (const char* folder : {"/assets/layouts", "/assets/scenes"})
    for (const auto& entry : std::filesystem::directory_iterator(std::string(TAXEL_SOURCE_DIR) + folder)) {
      const std::string file = entry.path().string();
      if (file.ends_with(".taxels.json") || file.ends_with(".xml")) files.push_back(file);
    }
  return files;
}

TEST(NumbersOnScreen, HaveNoEmptySignAndNoRoundingError) {
  ASSERT_EQ(bad_texts({"-0.000", "1.54e-14", "+0", "1", "samples", "21", "taxels", "-0.4", "3e-05"}).size(), 4U);
  ASSERT_GE(files().size(), 3U);
  for (const std::string& file : files()) {
    const StudioProgram studio;
    const Json shown = [&] {
      studio.play({kIdle, wait_time(0.2), key("Space"), key("a"), kIdle, kIdle, dump("run.json"), kLayoutMode, kIdle,
                   kIdle, dump("layout.json")},
                  {"--size", "1600x1200", file});
      return Json{studio.state("run.json"), studio.state("layout.json")};
    }();
    for (const Json& state : shown) {
      const auto texts = state["amount"]["texts"].get<std::vector<std::string>>();
      EXPECT_GT(texts.size(), 50U) << file;
      EXPECT_EQ(bad_texts(texts), std::vector<std::string>{}) << file;
    }
  }
}

}  // namespace
}  // namespace taxel::test
