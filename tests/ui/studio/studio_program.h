// The program taxelstudio in a test: a script of raw events in, states and images out. Offscreen, the program runs
// inside of the test's process.
#pragma once

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fixtures/run_program.h"

namespace taxel::test {

using Json = nlohmann::json;

/// An RGB image from a PNG.
struct Picture {
  int width = 0, height = 0;
  std::vector<unsigned char> rgb;
  [[nodiscard]] std::array<int, 3> pixel(double x, double y) const;
};

/// Returns whether the tests run the program in a real window instead of offscreen: the environment variable
/// STUDIO_TESTS_IN_A_WINDOW is set and there is a display.
bool in_a_window();

/// Which frames are drawn offscreen: those that a script saves as pictures, which is many times as fast, or all.
enum class DrawnFrames { saved, all };

/// Which compiled parts of sensors a program finds offscreen: those of all earlier tests of the process, or none, for
/// tests of how a sensor is compiled.
enum class CompiledParts { shared, own };

class StudioProgram {
 public:
  /// Uses an empty folder of the running test.
  explicit StudioProgram(DrawnFrames drawn = DrawnFrames::saved, CompiledParts parts = CompiledParts::shared);
  /// Plays script lines, offscreen or in_a_window(), with more arguments after them. The test fails if the exit status
  /// is not 0.
  Outcome play(const std::vector<std::string>& lines, const std::vector<std::string>& arguments = {}) const;
  /// Plays script lines and accepts any exit status.
  [[nodiscard]] Outcome run(const std::vector<std::string>& lines,
                            const std::vector<std::string>& arguments = {}) const;

  [[nodiscard]] Json state(const std::string& file) const;       ///< state written by a dump_state command
  [[nodiscard]] Picture picture(const std::string& file) const;  ///< image written by a screenshot command
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  DrawnFrames drawn_;
  CompiledParts parts_;
  std::filesystem::path folder_;
};

/// Returns the largest difference of the three channels.
int color_distance(const std::array<int, 3>& pixel, const Json& color);

}  // namespace taxel::test
