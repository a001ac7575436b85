// Tables of real sensors: read with a mapping, guessed from their column names, refused with line and column.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/run/real/real_recording.h"
#include "fixtures/complaint.h"

namespace taxel {
namespace {

ColumnMapping two_taxels() {
  ColumnMapping mapping;
  mapping.time = "t";
  mapping.time_unit = TimeUnit::ms;
  mapping.gain = 2;
  mapping.offset = -1;
  mapping.taxels = {{7, "a", {}, {}}, {3, "#3", 10.0, 0.5}};
  return mapping;
}

std::string refusal(const std::string& text, const ColumnMapping& mapping = two_taxels()) {
  return test::complaint_of([&] { parse_real_recording(text, mapping, "real.csv"); });
}

TEST(RealRecording, ReadsColumnsAsTaxelsOverSeconds) {
  const RealRecording read =
      parse_real_recording("# made by hand\nt,a,b\n0,1,2\n10,3,4\n\n25,+5,-6e1\n", two_taxels(), "real.csv");
  EXPECT_EQ(read.series.taxel_ids, (std::vector<int>{7, 3}));
  EXPECT_EQ(read.series.time, (std::vector<double>{0, 0.01, 0.025}));
  EXPECT_EQ(read.series.values[0], (std::vector<double>{1, 5, 9}));
  EXPECT_EQ(read.series.values[1], (std::vector<double>{20.5, 40.5, -599.5}));
  EXPECT_TRUE(read.notes.empty());
}

TEST(RealRecording, SpacesRowsUniformlyWithoutATimeColumn) {
  ColumnMapping mapping = two_taxels();
  mapping.time.clear();
  mapping.rate = 50;
  EXPECT_EQ(parse_real_recording("t,a,b\n9,1,2\n9,3,4\n9,5,6\n", mapping, "").series.time,
            (std::vector<double>{0, 0.02, 0.04}));
}

TEST(RealRecording, ReadsSemicolonsDecimalCommasAndBlanks) {
  ColumnMapping mapping = two_taxels();
  mapping.separator = ";", mapping.decimal = ",";
  EXPECT_EQ(parse_real_recording("t;a;b\n0;0,5;1\n1,5;1;1\n", mapping, "").series.time,
            (std::vector<double>{0, 0.0015}));
  mapping.separator = " ", mapping.decimal = ".";
  const RealRecording read = parse_real_recording("  t   a\tb\r\n 0  1 2 \r\n1 3   4\r\n", mapping, "");
  EXPECT_EQ(read.series.values[0], (std::vector<double>{1, 5}));
}

TEST(RealRecording, ReportsMissingValuesAndGaps) {
  const RealRecording read =
      parse_real_recording("t,a,b\n0,1,2\n1,NaN,2\n1,9,9\n2,,2\n3,4,-\n90,4,2\n91,4,2\n", two_taxels(), "real.csv");
  EXPECT_EQ(read.series.time.size(), 6U);
  EXPECT_TRUE(std::isnan(read.series.values[0][1]) && std::isnan(read.series.values[1][3]));
  EXPECT_EQ(read.notes,
            (std::vector<std::string>{"1 rows have the time of the row before and are left out",
                                      "taxel 7: 2 of 6 values are missing", "taxel 3: 1 of 6 values are missing",
                                      "nothing was recorded from 0.003 s to 0.09 s"}));
  const Interpolated taxel(read.series, 0);
  EXPECT_DOUBLE_EQ(taxel.at(0.0015), 4) << "over missing values, between 1 at 0 and 7 at 3 ms";
  EXPECT_EQ(taxel.at(0.003), 7);
  EXPECT_TRUE(std::isnan(taxel.at(0.05))) << "in the gap";
  EXPECT_TRUE(std::isnan(taxel.at(-1e-9)) && std::isnan(taxel.at(0.0911)));
}

TEST(RealRecording, NamesMistakesByLineAndColumn) {
  EXPECT_EQ(refusal(""), "real.csv: has 0 lines, of which 1 are header: no row");
  EXPECT_EQ(refusal("t,a,b\n"), "real.csv: has 1 lines, of which 1 are header: no row");
  EXPECT_EQ(refusal("t,a,b\n0,1,2\n"), "real.csv: has 1 rows of numbers, at least 2 are needed");
  EXPECT_EQ(refusal("t,c,b\n0,1,2\n1,1,2\n"), "real.csv: taxel 7: there is no column \"a\"; there are t, c, b");
  EXPECT_EQ(refusal("t,a\n0,1\n1,1\n"), "real.csv: taxel 3: there is no column \"#3\"; there are t, a");
  EXPECT_EQ(refusal("t,a,a\n0,1,2\n1,1,2\n"),
            "real.csv: taxel 7: several columns are named \"a\": give its number, as #2");
  EXPECT_EQ(refusal("t,a,b\n0,1,2\n1,x1,2\n"), "real.csv: line 3, column \"a\": is no number: \"x1\"");
  EXPECT_EQ(refusal("t,a,b\n0,1,inf\n1,1,2\n"), "real.csv: line 2, column \"b\": is no number: \"inf\"");
  EXPECT_EQ(refusal("t,a,b\n0,1,2\n1,1\n"), "real.csv: line 3: has 2 columns, not 3");
  EXPECT_EQ(refusal("t,a,b\n0,1,2\n,1,2\n"), "real.csv: line 3, column \"t\": the time is missing");
  EXPECT_EQ(refusal("t,a,b\n5,1,2\n4,1,2\n"),
            "real.csv: line 3, column \"t\": time runs backwards: 0.004 s after 0.005 s");
}

TEST(ColumnMapping, IsUnchangedAfterARoundTrip) {
  ColumnMapping mapping = two_taxels();
  mapping.unit = "kPa";
  EXPECT_EQ(mapping_from_json(mapping_to_json(mapping), "m.json"), mapping);
  const ColumnMapping least = mapping_from_json(
      R"({"format": "column-mapping", "version": 1, "time": "t", "taxels": [{"taxel": 1, "column": "a"}]})", "");
  EXPECT_EQ(least.separator, ",");
  EXPECT_EQ(least.header_lines, 1);
}

TEST(ColumnMapping, NamesImpossibleMappings) {
  const auto complaint = [](const std::string& rest) {
    return test::complaint_of(
        [&] { mapping_from_json(R"({"format": "column-mapping", "version": 1, )" + rest + "}", "m.json"); });
  };
  EXPECT_EQ(complaint(R"("taxels": [])"), "m.json: /rate: must be greater than 0 where no column is the time");
  EXPECT_EQ(complaint(R"("time": "t", "taxels": [])"), "m.json: /taxels: no column is a taxel");
  EXPECT_EQ(complaint(R"("time": "t")"), "m.json: /taxels: is missing");
  EXPECT_EQ(complaint(R"("time": "t", "taxels": [{"taxel": 1, "column": "t"}])"),
            "m.json: /taxels/0/column: column \"t\" is used already");
  EXPECT_EQ(complaint(R"("time": "t", "taxels": [{"taxel": 1, "column": "a"}, {"taxel": 1, "column": "b"}])"),
            "m.json: /taxels/1/taxel: taxel 1 has a column already");
  EXPECT_EQ(complaint(R"("time": "t", "gain": 0, "taxels": [{"taxel": 1, "column": "a"}])"),
            "m.json: /gain: must not be 0, is 0");
  EXPECT_EQ(complaint(R"("time": "t", "time_unit": "h", "taxels": [])"),
            "m.json: /time_unit: must be one of s, ms, us, ns, is \"h\"");
  EXPECT_EQ(complaint(R"("separator": "ab", "time": "t", "taxels": [])"),
            "m.json: /separator: must be a comma, a semicolon, a tab or a blank");
  EXPECT_EQ(complaint(R"("tme": "t")"), "m.json: /tme: unknown key; did you mean \"time\"?");
}

TEST(GuessMapping, FindsTimeUnitAndTaxelsByColumnNames) {
  const ColumnMapping m =
      guess_mapping("# log\nTimestamp [us],temp,taxel_3,taxel_7\n10,20,1,2\n20,20,3,4\n", {1, 3, 7});
  EXPECT_EQ(m.separator, ",");
  EXPECT_EQ(m.header_lines, 1);
  EXPECT_EQ(m.time, "Timestamp [us]");
  EXPECT_EQ(m.time_unit, TimeUnit::us);
  EXPECT_EQ(m.taxels, (std::vector<TaxelColumn>{{3, "taxel_3", {}, {}}, {7, "taxel_7", {}, {}}}));
}

TEST(GuessMapping, AssignsNumbersAloneInOrder) {
  const ColumnMapping m = guess_mapping("0 11 21\n10 12 22\n20 13 23\n", {5, 4, 3});
  EXPECT_EQ(m.separator, " ");
  EXPECT_EQ(m.header_lines, 0);
  EXPECT_EQ(m.time, "#1");
  EXPECT_EQ(m.time_unit, TimeUnit::ms);
  EXPECT_EQ(m.taxels, (std::vector<TaxelColumn>{{5, "#2", {}, {}}, {4, "#3", {}, {}}}));
}

/// Returns a table of two taxels whose first column is `name` and increases from 0 by `interval`.
std::string table_with_times(const std::string& name, double interval) {
  std::string text = name + ",taxel_1,taxel_2\n";
  for (int row = 0; row < 5; ++row) text += fmt::format("{:.12g},{},2\n", row * interval, row);
  return text;
}

TEST(GuessMapping, ReadsTheSameTimesFromEachUnit) {
  struct Unit {
    const char* word;
    TimeUnit unit;
    double per_second;
  };
  for (const Unit& unit :
       {Unit{"s", TimeUnit::s, 1}, {"ms", TimeUnit::ms, 1e3}, {"us", TimeUnit::us, 1e6}, {"ns", TimeUnit::ns, 1e9}}) {
    // 100 rows per second: the unit is in the column's name, or follows from the numbers alone.
    for (const std::string& name : {std::string("time"), fmt::format("t [{}]", unit.word)}) {
      const std::string text = table_with_times(name, 0.01 * unit.per_second);
      const ColumnMapping mapping = guess_mapping(text, {1, 2});
      EXPECT_EQ(mapping.time_unit, unit.unit) << name << " in " << unit.word;
      const std::vector<double> times = parse_real_recording(text, mapping, "real.csv").series.time;
      ASSERT_EQ(times.size(), 5U);
      for (int row = 0; row < 5; ++row)
        EXPECT_NEAR(times[static_cast<std::size_t>(row)], 0.01 * row, 1e-15) << name << " in " << unit.word;
    }
  }
}

TEST(GuessMapping, ChangesTheUnitOfTimeAtItsLimits) {
  const auto unit = [](double interval) { return guess_mapping(table_with_times("time", interval), {1, 2}).time_unit; };
  EXPECT_EQ(unit(0.999), TimeUnit::s);
  EXPECT_EQ(unit(1), TimeUnit::ms);
  EXPECT_EQ(unit(499), TimeUnit::ms);
  EXPECT_EQ(unit(500), TimeUnit::us);
  EXPECT_EQ(unit(99999), TimeUnit::us);
  EXPECT_EQ(unit(100000), TimeUnit::ns);
}

TEST(GuessMapping, ReadsDecimalCommasAndSeveralHeaderLines) {
  const ColumnMapping m = guess_mapping("Sensor 12\nzeit;p1;p2\ns;kPa;kPa\n0,1;1,5;2\n0,2;1,6;2\n0,3;1,6;2\n", {1, 2});
  EXPECT_EQ(m.separator, ";");
  EXPECT_EQ(m.decimal, ",");
  EXPECT_EQ(m.header_lines, 3);
  EXPECT_EQ(m.time, "s") << "by its numbers: the last header line has units";
  EXPECT_EQ(m.taxels, (std::vector<TaxelColumn>{{1, "#2", {}, {}}, {2, "#3", {}, {}}}));
  EXPECT_EQ(guess_mapping("", {1}).taxels.size(), 0U);
  EXPECT_EQ(guess_mapping("nonsense \"", {1}).taxels.size(), 0U);
}

}  // namespace
}  // namespace taxel
