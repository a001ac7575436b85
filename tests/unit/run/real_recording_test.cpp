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
  EXPECT_EQ(
      complaint(R"("taxels": [{"taxel": 1, "column": "a"}])"),
      "m.json: /rate: must be greater than 0 where no column is the time: name that column in \"time\", or give the "
      "rows per second");
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

TEST(GuessMapping, InventsNoRateWithoutAColumnOfTimes) {
  for (const char* text : {"frame,taxel_1,taxel_2\n0,5,6\n1,5,6\n2,5,6\n", "taxel_1,taxel_2\n5,6\n4,6\n5,6\n"}) {
    const ColumnMapping m = guess_mapping(text, {1, 2});
    EXPECT_EQ(m.time, "");
    EXPECT_EQ(m.rate, 0);
    EXPECT_NE(refusal(text, m).find("/rate: must be greater than 0 where no column is the time"), std::string::npos);
  }
}

/// Reads a table with its guessed mapping.
RealRecording read_guessed(const std::string& text, const std::vector<int>& ids) {
  return parse_real_recording(text, guess_mapping(text, ids), "real.csv");
}

TEST(GuessMapping, JoinsStampsInTwoColumnsOfAnyOrder) {
  for (const char* head : {"header.stamp.nanosec,p0,header.stamp.sec", "nsecs,p0,secs", "stamp_nsec,p0,stamp_sec"}) {
    const RealRecording read =
        read_guessed(std::string(head) + "\n999000000,5,1700000000\n1000000,6,1700000001\n", {0});
    ASSERT_EQ(read.series.time.size(), 2U) << head;
    EXPECT_EQ(read.series.time[0], 0) << head;
    EXPECT_NEAR(read.series.time[1], 0.002, 1e-9) << head << ": a double of the stamp has steps of 2.4e-7 s";
    EXPECT_EQ(read.series.values, (std::vector<std::vector<double>>{{5, 6}})) << head;
  }
}

TEST(GuessMapping, ReadsTimesOfIso8601) {
  const RealRecording read = read_guessed(
      "when_timestamp,p0\n2026-11-29T07:00:00.5Z,1\n2026-11-29 08:00:01+01:00,2\n2026-11-29T07:00:01.25,3\n", {0});
  EXPECT_EQ(read.series.time, (std::vector<double>{0, 0.5, 0.75}));
}

TEST(GuessMapping, ReadsOneValueInEachRowAndListsInACell) {
  const RealRecording rows =
      read_guessed("time [s],taxel,value [kPa],note\n0,1,10,a\n0,2,20,b\n0.1,2,21,c\n0.1,1,11,d\n0.2,1,12,e\n", {1, 2});
  EXPECT_EQ(rows.series.taxel_ids, (std::vector<int>{1, 2}));
  EXPECT_EQ(rows.series.values[0], (std::vector<double>{10, 11, 12}));
  EXPECT_EQ(rows.series.values[1][1], 21);
  EXPECT_TRUE(std::isnan(rows.series.values[1][2]));
  EXPECT_EQ(rows.series.unit, "kPa");
  ASSERT_EQ(rows.notes.size(), 3U);
  EXPECT_EQ(rows.notes[1], "column \"note\" is not read");
  const std::string cells = "time,values\n0,\"[1, 2, 3]\"\n0.1,\"[4 5 6]\"\n";
  const RealRecording lists = read_guessed(cells, {0, 1, 2});
  EXPECT_EQ(lists.series.taxel_ids, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(lists.series.values[2], (std::vector<double>{3, 6}));
  EXPECT_EQ(refusal(cells + "0.2,\"[7 8]\"\n", guess_mapping(cells, {0, 1, 2})),
            "real.csv: line 4, column \"values\": must be a list of 3 numbers as in the first row, is \"[7 8]\"");
}

TEST(GuessMapping, CountsColumnsFromOneWhereAllIdsCountFromZero) {
  const auto ids_of = [](const std::string& head, const std::vector<int>& ids) {
    std::vector<std::pair<int, std::string>> found;
    for (const TaxelColumn& one : guess_mapping(head + "\n0,1,2,3\n0.1,1,2,3\n", ids).taxels)
      found.emplace_back(one.taxel, one.column);
    return found;
  };
  using Found = std::vector<std::pair<int, std::string>>;
  EXPECT_EQ(ids_of("t,p1,p2,p3", {0, 1, 2}), (Found{{0, "p1"}, {1, "p2"}, {2, "p3"}}));
  EXPECT_EQ(ids_of("t,p0,p1,p2", {1, 2, 3}), (Found{{1, "p0"}, {2, "p1"}, {3, "p2"}}));
  EXPECT_EQ(ids_of("t,p1,p2,p3", {1, 2, 7}), (Found{{1, "p1"}, {2, "p2"}})) << "only all ids show a shift";
  EXPECT_EQ(ids_of("t,temperature,humidity,light", {0, 1}), Found{}) << "no column is a taxel";
}

TEST(GuessMapping, ReadsRowsAndColumnsAsAGridOfAllTaxels) {
  const ColumnMapping m =
      guess_mapping("t,r0c0,r1c0,r0c1,r1c1,r0c2,r1c2\n0,1,2,3,4,5,6\n0.1,1,2,3,4,5,6\n", {10, 11, 12, 20, 21, 22});
  ASSERT_EQ(m.taxels.size(), 6U);
  for (const auto& [k, column] : {std::pair{1U, "r0c1"}, {3U, "r1c0"}, {5U, "r1c2"}})
    EXPECT_EQ(m.taxels[k].column, column);
  EXPECT_EQ(m.taxels[3].taxel, 20);
}

TEST(GuessMapping, ReadsUtf16AndNamesColumnsAndTaxelsThatAreLeft) {
  std::string wide = "\xFF\xFE";
  for (const char c : std::string("time;taxel_3 [kPa];temp\n0,0;1,5;20\n0,1;1,7;20\n")) wide += c, wide += '\0';
  const ColumnMapping m = guess_mapping(wide, {3, 4});
  EXPECT_EQ(m.decimal, ",");
  EXPECT_EQ(m.unit, "kPa");
  EXPECT_EQ(taxels_without_column(m, {3, 4}), (std::vector<int>{4}));
  const RealRecording read = parse_real_recording(wide, m, "real.csv");
  EXPECT_EQ(read.series.values[0], (std::vector<double>{1.5, 1.7}));
  EXPECT_EQ(read.notes, (std::vector<std::string>{"columns that are not read: temp"}));
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
