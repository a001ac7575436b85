// `taxel plot` and the recordings of `taxel convert`: plots of real runs, and inputs that are refused.
#include <regex>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

fs::path plotted_sweep() {
  return shared_sweep({"--density", "1e6"});
}

/// Returns the texts of an SVG file, without its title. Fails if its tags are not closed in their order.
std::vector<std::string> texts_of_svg(const std::string& svg) {
  std::vector<std::string> texts, open;
  const std::regex tag(R"(<(/?)([a-z?]+)((?:\s+[\w:-]+="[^"<>]*")*)\s*([/?]?)>([^<]*))");
  std::size_t length = 0;
  for (std::sregex_iterator at(svg.begin(), svg.end(), tag), end; at != end; ++at) {
    const std::smatch& found = *at;
    length += static_cast<std::size_t>(found.length());
    if (found[1].length() > 0) {
      EXPECT_FALSE(open.empty());
      EXPECT_EQ(open.empty() ? "" : open.back(), found[2]);
      if (!open.empty()) open.pop_back();
    } else if (found[4].length() == 0) {
      open.push_back(found[2]);
      if (found[2] == "text") texts.push_back(found[5]);
    }
  }
  EXPECT_TRUE(open.empty());
  EXPECT_EQ(length, svg.size()) << "a part of the file is no tag";
  return texts;
}

bool has_text(const std::vector<std::string>& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

TEST(Plot, NamesTheRespondingTaxelsOfASweep) {
  const fs::path folder = test_folder();
  const Json made = taxel_json({"plot", plotted_sweep().string(), "--out", "p.svg", "--out", "p.pdf"}, folder);
  std::vector<int> ids;
  for (const Json& taxel : made["taxels"]) ids.push_back(taxel["id"]);
  EXPECT_EQ(ids, (std::vector<int>{3, 4, 9, 10}));
  EXPECT_EQ(made["over"], "travel");
  EXPECT_EQ(made["files"], (std::vector<std::string>{"p.svg", "p.pdf"}));
  const std::vector<std::string> texts = texts_of_svg(file_text(folder / "p.svg"));
  for (const char* text :
       {"3 right pad mid", "4 right tip", "9 left pad mid", "10 left tip", "travel (mm)", "reading (kPa)"})
    EXPECT_TRUE(has_text(texts, text)) << text;
  const std::string pdf = file_text(folder / "p.pdf");
  EXPECT_TRUE(pdf.starts_with("%PDF-1.4"));
  EXPECT_NE(pdf.find("(10 left tip) Tj"), std::string::npos);
  EXPECT_NE(pdf.find("/BaseFont /Helvetica"), std::string::npos);
}

TEST(Plot, DrawsATableAsItsArchive) {
  const fs::path folder = test_folder();
  const std::string title = "--title=x";
  const Outcome archive = taxel({"plot", (plotted_sweep() / "readings.npz").string(), "--taxels", "4", title}, folder);
  const Outcome table = taxel({"plot", (plotted_sweep() / "readings.csv").string(), "--taxels", "4", title}, folder);
  EXPECT_EQ(archive.status, 0) << archive.err;
  EXPECT_NE(table.err.find("a table has no units: its readings are taken as Pa"), std::string::npos) << table.err;
  const auto path_of = [](const std::string& svg) { return svg.substr(svg.find("stroke=\"#0072b2\"") - 600, 600); };
  EXPECT_EQ(path_of(archive.out), path_of(table.out));
}

TEST(Plot, HasPanelsOfTheSizeThatIsGiven) {
  const fs::path folder = test_folder();
  const Json made = taxel_json({"plot", plotted_sweep().string(), "--normalised", "--heat-map", "--forces", "--size",
                                "120x200", "--title", "a < b & \"c\"", "--out", "p.svg"},
                               folder);
  EXPECT_EQ(made["panels"], 3);
  EXPECT_NEAR(made["width"].get<double>(), 0.12, 1e-9);
  EXPECT_NEAR(made["height"].get<double>(), 0.2, 1e-9);
  const std::string svg = file_text(folder / "p.svg");
  const std::vector<std::string> texts = texts_of_svg(svg);
  for (const char* text :
       {"a &lt; b &amp; \"c\"", "0 right pad low", "force z", "magnitude", "reading / largest reading", "1.0"})
    EXPECT_TRUE(has_text(texts, text)) << text;
  EXPECT_LT(svg.size(), 300'000U);
}

TEST(Plot, DrawsTheRunsOfAStudy) {
  const fs::path folder = test_folder();
  write_text(folder / "study.json", R"({"format": "taxel-study", "version": 1, "scenario": {"kind": "press", "hold": 0},
    "parameters": [{"parameter": "depth", "values": [0.0005, 0.001, 0.0015]}]})");
  const Outcome study = taxel({"study", "study.json", "--density", "2e5", "--out", "s"}, folder);
  ASSERT_EQ(study.status, 0) << study.err;
  const Json made = taxel_json({"plot", "s", "--out", "p.svg"}, folder);
  EXPECT_EQ(made["panels"], 3);
  const std::vector<std::string> texts = texts_of_svg(file_text(folder / "p.svg"));
  for (const char* text : {"depth 0.0005", "depth 0.001", "depth 0.0015", "time (s)"})
    EXPECT_TRUE(has_text(texts, text)) << text;
  EXPECT_EQ(taxel({"plot", "s", "--forces"}, folder).status, 2);
  write_text(folder / "s/runs.csv", "file,depth\n../s/run_000.csv,1\n");
  EXPECT_EQ(taxel({"plot", "s"}, folder).err,
            "taxel: s/runs.csv: line 2: must name a file of this folder, names \"../s/run_000.csv\"\n");
  write_text(folder / "s/runs.csv", "file,depth\nrun_000.csv\n");
  EXPECT_EQ(taxel({"plot", "s"}, folder).err, "taxel: s/runs.csv: line 2: has 1 fields, the header has 2 columns\n");
  write_text(folder / "s/runs.csv", "file,depth\n");
  EXPECT_EQ(taxel({"plot", "s"}, folder).err, "taxel: s/runs.csv: lists no run\n");
}

TEST(Plot, NamesBrokenInputAndWritesNothing) {
  const fs::path folder = test_folder();
  fs::create_directories(folder / "empty");
  write_text(folder / "bad.csv", "time,travel,taxel_0\n0,0,1\n1,0,?\n");
  const std::string run = plotted_sweep().string();
  const std::pair<std::vector<std::string>, const char*> cases[] = {
      {{"plot", "nowhere"}, "taxel: nowhere: "},
      {{"plot", "empty"}, "taxel: empty: is no run: it has neither readings.npz nor readings.csv"},
      {{"plot", "bad.csv"}, "taxel: bad.csv: line 3, column \"taxel_0\": must be a number up to 1e100, is \"?\""},
      {{"plot", run, "--out", "p.png"}, "taxel: p.png: must end in .svg or .pdf"},
      {{"plot", run, "--taxels", "3,99"}, "has no taxel \"99\"; its taxels are 0, 1, 2, "},
      {{"plot", run, "--taxels", "3,,4"}, "taxel: plot: --taxels: must be ids or names with commas between them"},
      {{"plot", run, "--sensor", "thumb"}, "has no sensor \"thumb\", but finger"},
      {{"plot", run, "--size", "12"},
       "taxel: plot: --size: must be a width and a height up to 2000 mm such as 160x90, is \"12\""},
      {{"plot", run, "--size", "20x20"}, "taxel: plot: --size: the height of the page leaves "},
      {{"plot", run, "--size", "50x90"}, "taxel: plot: --size: the width of the page leaves "},
      {{"plot", run, "--calibrated"}, "has no calibrated values: no layout of the run has a calibration"}};
  for (const auto& [arguments, message] : cases) {
    std::vector<std::string> all = arguments;
    if (arguments.size() < 4 || arguments[2] != "--out") all.insert(all.end(), {"--out", "p.svg"});
    const Outcome outcome = taxel(all, folder);
    EXPECT_EQ(outcome.status, 2) << message;
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err << "\nexpected " << message;
  }
  EXPECT_FALSE(fs::exists(folder / "p.svg"));
}

TEST(ConvertRecording, WritesTheMessagesThatTheSweepWrites) {
  const fs::path folder = test_folder();
  const Outcome sweep = taxel({"sweep", "--density", "2e5", "--tactile-state", "--out", "run"}, folder);
  ASSERT_EQ(sweep.status, 0) << sweep.err;
  const Json made = taxel_json({"convert", "run", "out.jsonl"}, folder);
  EXPECT_EQ(made["rows"], 501);
  EXPECT_EQ(made["sensors"][0]["taxels"], 12);
  EXPECT_TRUE(file_text(folder / "out.jsonl") == file_text(folder / "run/tactile_state.jsonl"));
  EXPECT_EQ(taxel({"convert", "run/readings.npz", "again.jsonl"}, folder).status, 0);
  EXPECT_TRUE(file_text(folder / "again.jsonl") == file_text(folder / "run/tactile_state.jsonl"));
}

TEST(ConvertRecording, RefusesALayout) {
  const fs::path folder = test_folder();
  fs::create_directories(folder / "empty");
  write_text(folder / "taxels.csv", "x,y,z\n0,0,0\n");
  EXPECT_EQ(taxel({"convert", "empty", "o.jsonl"}, folder).err,
            "taxel: empty: is no recorded run: it has no readings.npz\n");
  EXPECT_EQ(taxel({"convert", "taxels.csv", "o.jsonl"}, folder).err,
            "taxel: taxels.csv: is no recorded run: name the folder of a run, or its readings.npz\n");
  EXPECT_EQ(taxel({"convert", plotted_sweep().string(), "o.jsonl", "--radius", "1"}, folder).err,
            "taxel: convert: --radius: goes with layouts; the output is a recording by its name\n");
  EXPECT_FALSE(fs::exists(folder / "o.jsonl"));
}

TEST(ConvertRecording, NamesThePythonModuleForMcap) {
  const fs::path folder = test_folder();
  const Outcome outcome = taxel({"convert", plotted_sweep().string(), "o.mcap"}, folder);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("a recorded run becomes .jsonl, or .mcap by python -m taxel.mcap\n"), std::string::npos)
      << outcome.err;
  EXPECT_FALSE(fs::exists(folder / "o.mcap"));
}

}  // namespace
}  // namespace taxel::test
