// `taxel align`: a shifted, scaled and disturbed copy of a run is aligned with the run; bad tables are refused.
#include <cmath>
#include <sstream>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

fs::path short_sweep() {
  return shared_box_sweep({"--density", "5e5", "--past", "0.002"});
}

/// Returns a table like that of a real sensor: taxel k in `100 + 10 k` counts per kPa above 200, in milliseconds of
/// another clock.
std::string real_table(const fs::path& run, double clock) {
  const Table table = read_csv(run / "readings.csv");
  std::ostringstream text;
  text.precision(12);
  text << "Time [ms];s_3;s_4;s_0;s_9\n";
  const std::vector<double>& time = table.at("time");
  for (std::size_t i = 0; i < time.size(); ++i) {
    text << 1e3 * (time[i] + clock);
    for (const int id : {3, 4, 0, 9}) {
      const double reading = table.at("taxel_" + std::to_string(id))[i];
      text << ";" << (id == 9 ? 7.0 : 200 + (100 + 10 * id) * 1e-3 * reading + (id == 0 ? i % 3 : 0));
    }
    text << "\n";
  }
  return text.str();
}

TEST(Align, RecoversTheShiftAndTheGainsOfADistortedRecording) {
  const fs::path run = short_sweep(), folder = test_folder();
  write_text(folder / "real.csv", real_table(run, 41.2345));
  const std::string before = file_text(run / "readings.csv");
  const Json found =
      taxel_json({"align", run.string(), "real.csv", "--save-map", "real.recmap.json", "--out", "a.csv"}, folder);
  EXPECT_NEAR(found["shift"].get<double>(), -41.2345, 0.001) << "a tenth of the run's interval";
  EXPECT_GT(found["correlation"].get<double>(), 0.999) << "of the taxels that respond";
  std::map<int, Json> taxels;
  for (const Json& taxel : found["taxels"]) taxels[taxel["id"]] = taxel;
  ASSERT_EQ(taxels.size(), 4U);
  EXPECT_NEAR(taxels[3]["gain"].get<double>(), 0.130, 0.002);
  EXPECT_NEAR(taxels[4]["gain"].get<double>(), 0.140, 0.002);
  EXPECT_NEAR(taxels[4]["offset"].get<double>(), 200, 2);
  EXPECT_GT(taxels[3]["r2"].get<double>(), 0.99);
  EXPECT_EQ(taxels[9]["refused"], "is constant in the recording");
  EXPECT_EQ(taxels[0]["refused"], "does not respond in the run");
  const std::string aligned = file_text(folder / "a.csv"), head = aligned.substr(0, aligned.find('\n'));
  EXPECT_EQ(head,
            "time,taxel_0,real_0,fitted_0,taxel_3,real_3,fitted_3,taxel_4,real_4,fitted_4,taxel_9,real_9,fitted_9");
  EXPECT_EQ(std::count(aligned.begin(), aligned.end(), '\n'), std::count(before.begin(), before.end(), '\n'));
  EXPECT_EQ(file_text(run / "readings.csv"), before);
  // Align again with the written mapping and with a given shift.
  const Json again = taxel_json({"align", run.string(), "real.csv", "--map", "real.recmap.json"}, folder);
  EXPECT_EQ(again["taxels"], found["taxels"]);
  const Json given =
      taxel_json({"align", run.string(), "real.csv", "--shift", "-41.2345", "--common", "--no-offset"}, folder);
  EXPECT_EQ(given["correlation"], nullptr);
  EXPECT_FALSE(given["with_offset"].get<bool>());
  const Outcome text = taxel({"align", run.string(), "real.csv", "--quiet"}, folder);
  EXPECT_EQ(text.err, "");
  EXPECT_NE(text.out.find("if -41.23"), std::string::npos);
}

TEST(Align, NamesTheTableOrMappingThatItRefuses) {
  const fs::path run = short_sweep(), folder = test_folder();
  const std::string good = real_table(run, 0);
  write_text(folder / "m.json", R"({"format": "column-mapping", "version": 1, "separator": ";", "time": "Time [ms]",
    "time_unit": "ms", "taxels": [{"taxel": 3, "column": "s_3"}, {"taxel": 77, "column": "s_4"}]})");
  const auto refused = [&](const std::string& table, const std::string& line, bool mapped = true) {
    write_text(folder / "real.csv", table);
    std::vector<std::string> arguments{"align", run.string(), "real.csv", "--quiet"};
    if (mapped) arguments.insert(arguments.end(), {"--map", "m.json"});
    expect_refusal(taxel(arguments, folder), line);
  };
  refused(good, "taxel: m.json: /taxels/1/taxel: the run has no taxel 77");
  refused("", "taxel: real.csv: has 0 lines, of which 1 are header: no row");
  refused("", "taxel: real.csv: /taxels: no column is a taxel", false);
  refused("a;b\n1;2\n2;3\n", "taxel: real.csv: time: there is no column \"Time [ms]\"; there are a, b");
  refused("Time [ms];s_3;s_4\n0;1;2\n1;oops;2\n", "taxel: real.csv: line 3, column \"s_3\": is no number: \"oops\"");
  refused("Time [ms];s_3;s_4\n5;1;2\n4;1;2\n",
          "taxel: real.csv: line 3, column \"Time [ms]\": time runs backwards: 0.004 s after 0.005 s");
  expect_refusal(taxel({"align", run.string(), "gone.csv"}, folder), "taxel: gone.csv: no such file");
  write_text(folder / "m.json", R"({"format": "column-mapping", "version": 1, "separator": ";", "time": "Time [ms]",
    "time_unit": "ms", "taxels": [{"taxel": 3, "column": "s_3"}]})");
  refused("Time [ms];s_3;s_4\n0;1;2\n1;1;2\n2;1;3\n",
          "taxel: real.csv: cannot be aligned: no shift gives an overlap of half of the shorter signal with changing "
          "readings; give it by --shift");
}

}  // namespace
}  // namespace taxel::test
