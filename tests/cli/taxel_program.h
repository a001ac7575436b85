// The program `taxel` for the tests of this folder, files for it, and sweeps that several tests share.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fixtures/read_npz.h"
#include "fixtures/run_program.h"

namespace taxel::test {

using Json = nlohmann::json;

/// Returns an empty folder for the running test.
std::filesystem::path test_folder();

/// Runs taxel in the given folder.
Outcome taxel(const std::vector<std::string>& arguments, const std::filesystem::path& folder = TAXEL_BINARY_DIR);

/// Runs taxel, expects exit status 0, and parses its stdout.
Json taxel_json(std::vector<std::string> arguments, const std::filesystem::path& folder = TAXEL_BINARY_DIR);

/// Expects exit status 2, nothing on stdout, and exactly this line on stderr.
void expect_refusal(const Outcome& outcome, const std::string& line);

/// Return the layout of our fingertip, and a copy of it with one change (a JSON patch).
std::filesystem::path fingertip_layout();
std::filesystem::path changed_layout(const std::filesystem::path& folder, const Json& patch);

/// Returns the OBJ text of a box of half size `half` whose first corner is the file's vertex `first` (from 1): two
/// triangles on each side, in the order -z, +z, -y, +y, -x, +x, facing outward, or inward as the wall of a cavity.
/// Corner 1 + 2 bits: the corner at +x has bit 0 set, at +y bit 1, at +z bit 2.
std::string box_obj(double half, int first = 1, bool outward = true);

/// The columns of a CSV file by name.
using Table = std::map<std::string, std::vector<double>>;
Table read_csv(const std::filesystem::path& path);

/// The largest change of a taxel from a row of a recording to the next.
struct RecordedJump {
  int taxel = 0;        ///< id of the taxel
  double time = 0;      ///< time of the later row [s]
  std::size_t row = 0;  ///< index of the later row
  double before = 0, after = 0;
};
RecordedJump largest_jump(const std::filesystem::path& run);

/// Returns the output folder of `taxel sweep` with these options. The first test that needs it makes it; a changed
/// program makes it again.
std::filesystem::path shared_sweep(const std::vector<std::string>& options = {});

/// Returns the output folder of a short sweep over a box, which ends in contact.
std::filesystem::path shared_box_sweep(std::vector<std::string> options = {});

/// Returns the layout of the real fingertip, or an empty path if it is absent.
std::filesystem::path real_layout();
#define SKIP_WITHOUT_REAL_DATA()            \
  if (::taxel::test::real_layout().empty()) \
  GTEST_SKIP() << "shadow_fingertip.taxels.json is absent from " TAXEL_REAL_DATA

}  // namespace taxel::test
