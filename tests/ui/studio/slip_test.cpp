// Slip and shear of the taxels in the window: the plot, the table of taxels, and layouts that have neither.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "csv_row.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

/// Returns the arguments that open our fingertip in a window in which the plot is in front.
std::vector<std::string> plotted_fingertip(const StudioProgram& studio) {
  std::vector<std::string> arguments = sparse_fingertip(studio, 5e5, "1280x800");
  std::filesystem::create_directories(studio.folder() / "state");
  write_text(studio.folder() / "state/settings.json", R"({"panel_bars": false, "panel_heat": false})");
  arguments.insert(arguments.begin(), {"--state-dir", "state"});
  return arguments;
}

/// Returns the arguments that open our fingertip with friction that sticks and with shear.
std::vector<std::string> sticking_fingertip(const StudioProgram& studio) {
  std::vector<std::string> arguments = plotted_fingertip(studio);
  const std::filesystem::path file = studio.folder() / "first.taxels.json";
  Json layout = Json::parse(file_text(file));
  layout["material"]["tangential_stiffness"] = 2e7;  // slides 0.5 mm before it slips
  layout["readout"]["shear"] = true;
  write_text(file, layout.dump());
  return arguments;
}

std::string rest_on(const std::string& label) {
  return R"({"event": "mouse_move", "at": {"widget": ")" + label + R"("}})";
}

/// Returns the value in the plot's read-out of the taxel with the largest one.
double largest_at_pointer(const Json& state) {
  double largest = 0;
  for (const Json& line : state["plot"]["readout"]["lines"]) largest = std::max(largest, line["value"].get<double>());
  return largest;
}

/// Expects the values at the pointer to be those of a file that the command line wrote for the same run.
void expect_at_pointer(const Json& state, const std::filesystem::path& file) {
  const Json& readout = state["plot"]["readout"];
  std::map<std::string, double> row = csv_row(file, 1e-3 * readout["x"].get<double>(), "travel");
  EXPECT_NEAR(1e3 * row["travel"], readout["x"].get<double>(), 1e-6);
  for (const Json& line : readout["lines"])
    EXPECT_NEAR(row[fmt::format("taxel_{}", line["taxel"].get<int>())], line["value"].get<double>(), 1e-12);
}

const Lines kInSweep{kIdle, key("="), key("="), R"({"do": "wait_time", "time": 1.3})", key("Space"), kIdle};
const std::string kToPlot = rest_on("Plot");

TEST(SlipInTheWindow, IsPlottedAndListedWithShear) {
  const StudioProgram studio;
  studio.play(
      joined(
          {kInSweep,
           {press("Slip"), kIdle, kToPlot, kIdle, dump("slip.json"), R"({"do": "screenshot", "file": "slip.png"})"},
           {press("Shear"), kIdle, kToPlot, kIdle, dump("shear.json"), R"({"do": "screenshot", "file": "shear.png"})"},
           {press("Sort by Slip"), press("Sort by Slip"), kIdle, dump("sorted.json"),
            R"({"do": "screenshot", "file": "sorted.png"})"},
           {press("Sort by Shear"), kIdle, dump("by_shear.json")}}),
      sticking_fingertip(studio));
  const Json slip = studio.state("slip.json")["plot"], shear = studio.state("shear.json")["plot"];
  EXPECT_EQ(slip["quantity"], "slip");
  EXPECT_EQ(slip["unit"], "%");
  EXPECT_GT(slip["largest"].get<double>(), 0.5);
  EXPECT_LE(slip["largest"].get<double>(), 1);
  EXPECT_GE(slip["curves"].size(), 2U);
  EXPECT_GT(largest_at_pointer(studio.state("slip.json")), 0);
  EXPECT_EQ(shear["quantity"], "shear");
  EXPECT_EQ(shear["unit"], "kPa");
  EXPECT_GT(shear["largest"].get<double>(), 100);
#ifdef TAXEL_PROGRAM
  const Outcome swept = run_program(
      TAXEL_PROGRAM, {"sweep", "--layout", "first.taxels.json", "--object", "box", "--out", "run", "--quiet"},
      studio.folder());
  ASSERT_EQ(swept.status, 0) << swept.err;
  expect_at_pointer(studio.state("slip.json"), studio.folder() / "run/slip.csv");
#endif
  EXPECT_NE(studio.state("sorted.json")["table"]["rows"], studio.state("shear.json")["table"]["rows"]);
}

TEST(SlipInTheWindow, IsGreyedOutWhereFrictionHasNoMemory) {
  const StudioProgram studio;
  studio.play(joined({kInSweep,
                      {press("Slip"), kIdle, dump("slip.json"), rest_on("Slip"), R"({"do": "rest", "seconds": 1})",
                       R"({"do": "screenshot", "file": "reason.png"})"}}),
              plotted_fingertip(studio));
  EXPECT_EQ(studio.state("slip.json")["plot"]["quantity"], "reading");
  EXPECT_EQ(studio.state("slip.json")["plot"]["unit"], "kPa");
}

}  // namespace
}  // namespace taxel::test
