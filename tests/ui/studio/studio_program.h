// taxelstudio as a test runs it: a script of raw events in, states and pictures out.
#pragma once

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fixtures/run_program.h"

namespace taxel::test {

using Json = nlohmann::json;

/// A PNG in memory, RGB.
struct Picture {
  int width = 0, height = 0;
  std::vector<unsigned char> rgb;
  [[nodiscard]] std::array<int, 3> pixel(double x, double y) const;
};

/// Whether the tests run the program in a real window instead of offscreen: the environment says so
/// (STUDIO_TESTS_IN_A_WINDOW), and has a display.
bool in_a_window();

class StudioProgram {
 public:
  StudioProgram();  ///< works in a fresh folder of the running test
  /// Plays script lines, offscreen or in_a_window(), with more arguments after them. Fails the test when the exit
  /// status is not 0.
  Outcome play(const std::vector<std::string>& lines, const std::vector<std::string>& arguments = {}) const;
  /// The same, whatever the exit status.
  [[nodiscard]] Outcome run(const std::vector<std::string>& lines,
                            const std::vector<std::string>& arguments = {}) const;

  [[nodiscard]] Json state(const std::string& file) const;       ///< of a dump_state command
  [[nodiscard]] Picture picture(const std::string& file) const;  ///< of a screenshot command
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// Largest difference of the three channels.
int color_distance(const std::array<int, 3>& pixel, const Json& color);

}  // namespace taxel::test
