// A recording of a real sensor in the window: the meaning of its columns is set, and it is aligned, fitted and used as
// the calibration.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "script_lines.h"

namespace taxel::test {
namespace {

std::string simulated_until(double time) {
  return R"({"do": "wait_time", "time": )" + std::to_string(time) + "}";
}

/// Returns taxel 3 of the sweep as a device would record it: counts over the device's own clock, made from the readings
/// that the window exported.
std::string counts_of(const std::string& readings_csv, double clock) {
  std::istringstream lines(readings_csv);
  std::string line;
  std::getline(lines, line);
  std::vector<std::string> heads;
  std::istringstream head(line);
  for (std::string name; std::getline(head, name, ',');) heads.push_back(name);
  const auto column = static_cast<std::size_t>(std::find(heads.begin(), heads.end(), "taxel_3") - heads.begin());
  std::ostringstream table;
  table.precision(12);
  table << "clock,other,t3\n";
  for (int row = 0; std::getline(lines, line); ++row) {
    std::vector<double> values;
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) values.push_back(std::stod(field));
    if (row % 10 == 0) table << 1e3 * (values[0] + clock) << ",7," << 50 + 0.02 * values[column] << "\n";
  }
  return table.str();
}

/// Returns our fingertip with few samples.
std::vector<std::string> sparse_samples(const StudioProgram& studio) {
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = kMeshFile;
  layout["sampling"]["density"] = 1e6;
  write_text(studio.folder() / "few.taxels.json", layout.dump());
  return {"few.taxels.json"};
}

/// Returns lines that choose File > Import real recording, type the file and press Enter.
Lines imported(const std::string& file) {
  return {
      press("File"), kIdle, press("Import real recording..."), kIdle, key("a", kCtrl), type(file), kIdle, key("Enter"),
      kIdle,         kIdle};
}

/// Returns lines that choose an entry of File > Export, type the file and press Enter.
Lines lines_of_export(const std::string& entry, const std::filesystem::path& file) {
  return {press("File"),       kIdle, press("Export"), kIdle, press(entry), kIdle, key("a", kCtrl),
          type(file.string()), kIdle, key("Enter"),    kIdle};
}

bool has_message_with(const Json& state, const std::string& text) {
  for (const Json& message : state["messages"])
    if (message["text"].get<std::string>().find(text) != std::string::npos) return true;
  return false;
}

std::size_t times_in(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

bool has_labelled(const Json& state, const std::string& label) {
  for (const Json& widget : state["widgets"])
    if (widget["label"] == label) return true;
  return false;
}

const Lines kTouching{key("="), key("="), simulated_until(1.3), key("Space"), kIdle};

TEST(Real, OverlaysFitsAndCalibratesWithARecording) {
  const StudioProgram studio;
  const std::string file = (studio.folder() / "real.csv").string();
  studio.play(joined({kTouching,
                      {key("e", kCtrlShift), kIdle, key("a", kCtrl), type((studio.folder() / "run.csv").string()),
                       kIdle, key("Enter"), kIdle}}),
              sparse_samples(studio));
  write_text(file, counts_of(file_text(studio.folder() / "run.csv"), 12.5));
  studio.play(joined({kTouching,
                      imported(file),
                      {dump("asks.json"),
                       R"({"do": "screenshot", "file": "asks.png"})",
                       press("Meaning of clock"),
                       kIdle,
                       press("time"),
                       kIdle,
                       press("Unit of time"),
                       kIdle,
                       press("ms"),
                       kIdle,
                       press("Save mapping"),
                       kIdle,
                       press("Overlay"),
                       kIdle,
                       kIdle,
                       press("Taxels over travel tab"),
                       kIdle,
                       dump("shown.json"),
                       press("Fit gains"),
                       kIdle,
                       dump("fitted.json"),
                       R"({"do": "screenshot", "file": "fitted.png"})",
                       press("Apply as calibration"),
                       kIdle,
                       dump("applied.json"),
                       key("z", kCtrl),
                       kIdle,
                       dump("undone.json"),
                       key("3", kCtrl),
                       kIdle,
                       press("Real tab"),
                       kIdle,
                       dump("analysed.json"),
                       press("Remove"),
                       kIdle,
                       dump("removed.json")}}),
              sparse_samples(studio));
  const Json asks = studio.state("asks.json")["real"], shown = studio.state("shown.json")["real"]["shown"],
             fitted = studio.state("fitted.json")["real"], applied = studio.state("applied.json");
  EXPECT_TRUE(asks["asks"]);
  EXPECT_EQ(asks["columns"], Json({"clock", "other", "t3"}));
  EXPECT_EQ(asks["mapping"]["taxels"], Json::parse(R"([{"taxel": 3, "column": "t3"}])")) << "guessed";
  EXPECT_TRUE(std::filesystem::exists(studio.folder() / "real.recmap.json"));
  EXPECT_NEAR(shown["shift"].get<double>(), -12.5, 0.002);
  EXPECT_GT(shown["correlation"].get<double>(), 0.99);
  ASSERT_EQ(fitted["shown"]["fits"].size(), 1U);
  const Json& fit = fitted["shown"]["fits"][0];
  EXPECT_NEAR(fit["gain"].get<double>(), 0.02, 0.0005);
  EXPECT_NEAR(fit["offset"].get<double>(), 50, 1);
  EXPECT_NE(studio.state("fitted.json")["widgets"].dump().find("gain in units of the recording per kPa"),
            std::string::npos)
      << "its unit";
  EXPECT_GT(fitted["curves"][0]["points"].get<int>(), 50);
  EXPECT_EQ(studio.state("analysed.json")["mode"], "analyse");
  EXPECT_GT(studio.state("analysed.json")["real"]["points"].get<int>(), 20) << "rings over the curves";
  const Json& calibration = applied["document"]["layout"]["calibration"]["taxels"][0];
  EXPECT_EQ(calibration["gain"], fit["gain"]);
  EXPECT_NEAR(calibration["tare"].get<double>(), -fit["offset"].get<double>() / fit["gain"].get<double>(), 1e-6);
  EXPECT_FALSE(studio.state("undone.json")["document"]["layout"].contains("calibration"));
  EXPECT_EQ(studio.state("removed.json")["real"]["shown"], nullptr);
}

/// Returns readings that a run exported, with times 2 s later.
std::string two_seconds_later(const std::string& readings_csv) {
  std::istringstream lines(readings_csv);
  std::string line;
  std::getline(lines, line);
  std::ostringstream table;
  table.precision(12);
  table << line << "\n";
  while (std::getline(lines, line)) {
    const std::size_t comma = line.find(',');
    table << std::stod(line.substr(0, comma)) + 2 << line.substr(comma) << "\n";
  }
  return table.str();
}

/// Expects a row for each fit, in the units of the recording per pascal.
void expect_table_of(const Json& fits, const std::string& csv) {
  std::istringstream table(csv);
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line, "taxel,column,gain,gain_unit,offset,r2,rms,unit,shift_s,points,refused");
  int fitted = 0;
  for (const Json& fit : fits) {
    ASSERT_TRUE(std::getline(table, line));
    const std::string begin = fit["taxel"].dump() + ",taxel_" + fit["taxel"].dump() + ",";
    EXPECT_TRUE(line.starts_with(begin)) << line;
    if (fit["refused"] != "") continue;
    EXPECT_NEAR(std::stod(line.substr(begin.size())), fit["gain"].get<double>(), 1e-9);
    EXPECT_NE(line.find(",1/Pa,"), std::string::npos) << line;
    ++fitted;
  }
  EXPECT_GT(fitted, 2);
}

TEST(Real, IsAlignedWhenTheRunEndsAndExportedWithThePlotAndTheFit) {
  const StudioProgram studio;
  const std::filesystem::path folder = studio.folder();
  const std::string file = (folder / "real.csv").string();
  std::vector<std::string> arguments = sparse_samples(studio);
  arguments.insert(arguments.end(), {"--scenario", TAXEL_SOURCE_DIR "/tests/fixtures/edge_sweep.json"});
  const std::string ended = R"({"do": "wait_for", "pointer": "/simulation/playing", "equals": false})";
  const Lines whole{simulated_until(4.5), ended, kIdle, kIdle, kIdle}, fast{key("="), key("=")};
  studio.play(joined({fast, whole, lines_of_export("Export recording...", folder / "run.csv")}), arguments);
  write_text(file, two_seconds_later(file_text(folder / "run.csv")));
  studio.play(joined({{key("Right"), kIdle, dump("before.json"), press("Panels"), kIdle, press("Real"), kIdle, kIdle,
                       dump("opened.json")},
                      imported(file),
                      {press("Overlay"), kIdle, kIdle, dump("waits.json"), press("Align"), kIdle, kIdle,
                       dump("refused.json"), R"({"do": "screenshot", "file": "refused.png"})"},
                      fast,
                      {key("Space"), R"({"do": "wait_for", "pointer": "/simulation/playing", "equals": true})"},
                      whole,
                      {dump("aligned.json"), press("Fit gains"), kIdle, kIdle, dump("fitted.json"),
                       R"({"do": "screenshot", "file": "fits.png"})"},
                      lines_of_export("Export plot (SVG, PDF)...", folder / "plot.svg"),
                      lines_of_export("Export fit of real recording (CSV)...", folder / "fit.csv"),
                      {press("Remove"), kIdle, kIdle},
                      lines_of_export("Export plot (SVG, PDF)...", folder / "without.svg")}),
              arguments);
  const Json waits = studio.state("waits.json"), refused = studio.state("refused.json"),
             aligned = studio.state("aligned.json"), fitted = studio.state("fitted.json");
  EXPECT_FALSE(has_labelled(studio.state("before.json"), "Real tab"));
  EXPECT_TRUE(has_labelled(studio.state("opened.json"), "Read a recording...")) << "by the menu Panels";
  EXPECT_TRUE(waits["real"]["shown"]["awaits_end"]);
  EXPECT_TRUE(
      has_message_with(waits, "real.csv: not aligned: it does not overlap with enough of the run; it is aligned "))
      << waits["messages"].dump(1);
  EXPECT_NE(refused["real"]["refused"].get<std::string>().find("cannot be aligned"), std::string::npos);
  EXPECT_EQ(aligned["real"]["refused"], "") << "the reason is over";
  EXPECT_FALSE(aligned["real"]["shown"]["awaits_end"]);
  EXPECT_NEAR(aligned["real"]["shown"]["shift"].get<double>(), -2, 0.001);
  EXPECT_TRUE(has_message_with(aligned, "real.csv: aligned with the run: shift -")) << aligned["messages"].dump(1);
  EXPECT_LE(aligned["real"]["shown"]["overlap"].get<double>(), 5 + 1e-9) << "the run lasts 5 s";
  EXPECT_FALSE(fitted["real"]["shown"]["fits"].empty());

  const std::string plot = file_text(folder / "plot.svg"), without = file_text(folder / "without.svg");
  EXPECT_NE(plot.find(">real recording<"), std::string::npos);
  EXPECT_GT(times_in(plot, "<path"), times_in(without, "<path") + 20) << "rings";
  EXPECT_EQ(without.find("real recording"), std::string::npos);
  expect_table_of(fitted["real"]["shown"]["fits"], file_text(folder / "fit.csv"));
}

TEST(Real, ReportsABadTableInTheDialogThatStaysOpen) {
  const StudioProgram studio;
  const std::string file = (studio.folder() / "bad.csv").string();
  write_text(file, "time,taxel_3\n0,1\n1,x\n2,3\n");
  studio.play(joined({{key("Right"), kIdle},
                      imported((studio.folder() / "gone.csv").string()),
                      {dump("gone.json")},
                      imported(file),
                      {press("Overlay"), kIdle, dump("bad.json"), key("Escape"), kIdle, dump("left.json")}}),
              sparse_samples(studio));
  EXPECT_NE(studio.state("gone.json")["messages"].dump().find("gone.csv: no such file"), std::string::npos);
  const Json bad = studio.state("bad.json")["real"];
  EXPECT_TRUE(bad["asks"]);
  EXPECT_NE(bad["problem"].get<std::string>().find("line 3, column \"taxel_3\": is no number: \"x\""),
            std::string::npos)
      << bad["problem"];
  EXPECT_FALSE(studio.state("left.json")["real"]["asks"]);
  EXPECT_EQ(studio.state("left.json")["real"]["shown"], nullptr);
}

}  // namespace
}  // namespace taxel::test
