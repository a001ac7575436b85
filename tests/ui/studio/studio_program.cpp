#include "studio_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/studio/shell/program.h"
#include "core/sensor/sensor_cache.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace taxel::test {
namespace {

/// Runs the program with the compiled parts of sensors that all tests of this process share. Compiling them takes most
/// of a short run.
int run_with_shared_parts(int argc, char** argv) {
  static SensorCache cache(32);  // the tests of a program open about as many meshes in turn
  return studio::run_program(argc, argv, cache);
}

int run_with_own_parts(int argc, char** argv) {
  SensorCache cache;
  return studio::run_program(argc, argv, cache);
}

}  // namespace

std::array<int, 3> Picture::pixel(double x, double y) const {
  const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
  if (column < 0 || row < 0 || column >= width || row >= height)
    throw std::out_of_range("pixel outside of the picture");
  const unsigned char* p =
      &rgb[3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column))];
  return {p[0], p[1], p[2]};
}

bool in_a_window() {
  return std::getenv("STUDIO_TESTS_IN_A_WINDOW") != nullptr;
}

StudioProgram::StudioProgram(DrawnFrames drawn, CompiledParts parts) : drawn_(drawn), parts_(parts) {
  const testing::TestInfo& info = *testing::UnitTest::GetInstance()->current_test_info();
  // Some tests run twice, perhaps at the same time.
  folder_ = fresh_folder(std::filesystem::path(TAXEL_BINARY_DIR) / (in_a_window() ? "window_tests" : "studio_tests"),
                         std::string(info.test_suite_name()) + "." + info.name());
}

Outcome StudioProgram::run(const std::vector<std::string>& lines, const std::vector<std::string>& arguments) const {
  std::string script;
  for (const std::string& line : lines) script += line + "\n";
  if (in_a_window()) script += "{\"do\": \"quit\"}\n";  // a window would stay open
  write_text(folder_ / "script.jsonl", script);
  std::vector<std::string> all{"--script", "script.jsonl"};
  if (!in_a_window()) all.emplace_back("--headless");
  if (!in_a_window() && drawn_ == DrawnFrames::saved) all.emplace_back("--draw-saved");
  // The sweep over a box stays in contact until its end, which these tests need. The demo has a sweep of its own.
  const auto is_given = [&](const char* option) {
    return std::find(arguments.begin(), arguments.end(), option) != arguments.end();
  };
  if (!is_given("--scenario") && !is_given("--demo"))
    all.insert(all.end(), {"--scenario", TAXEL_SOURCE_DIR "/tests/fixtures/box_sweep.json"});
  all.insert(all.end(), arguments.begin(), arguments.end());
  if (in_a_window()) return run_program(STUDIO_PROGRAM, all, folder_);
  const auto run = parts_ == CompiledParts::shared ? run_with_shared_parts : run_with_own_parts;
  return run_main(run, STUDIO_PROGRAM, all, folder_);
}

Outcome StudioProgram::play(const std::vector<std::string>& lines, const std::vector<std::string>& arguments) const {
  Outcome outcome = run(lines, arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return outcome;
}

Json StudioProgram::state(const std::string& file) const {
  return Json::parse(file_text(folder_ / file));
}

Picture StudioProgram::picture(const std::string& file) const {
  Picture picture;
  int channels = 0;
  unsigned char* pixels = stbi_load((folder_ / file).c_str(), &picture.width, &picture.height, &channels, 3);
  if (pixels == nullptr) throw std::runtime_error("no picture " + file);
  picture.rgb.assign(pixels, pixels + 3 * picture.width * picture.height);
  stbi_image_free(pixels);
  return picture;
}

int color_distance(const std::array<int, 3>& pixel, const Json& color) {
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::abs(pixel[i] - 255.0 * color[i].get<double>()));
  return static_cast<int>(std::ceil(largest));
}

}  // namespace taxel::test
