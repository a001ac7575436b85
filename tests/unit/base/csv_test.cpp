// Tables of RFC 4180, tables of spreadsheets, and invalid tables.
#include "core/base/text/table.h"

#include <gtest/gtest.h>

#include "fixtures/complaint.h"

namespace taxel {
namespace {

using Fields = std::vector<std::string>;

TEST(Csv, SplitsFields) {
  const std::vector<CsvRow> rows = parse_csv("a, b ,\"c, \"\"d\"\"\"\r\n\n# note, \"\n1,,\n\"two\nlines\" ,x");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].fields, (Fields{"a", "b", "c, \"d\""}));
  EXPECT_EQ(rows[1].fields, (Fields{"1", "", ""}));
  EXPECT_EQ(rows[1].line, 4);
  EXPECT_EQ(rows[2].fields, (Fields{"two\nlines", "x"}));
  EXPECT_TRUE(parse_csv("").empty());
}

TEST(Csv, FindsTheSeparator) {
  EXPECT_EQ(parse_csv("a;b,c\n1;2,5")[1].fields, (Fields{"1", "2,5"}));
  EXPECT_EQ(parse_csv("a\tb\n1\t\t3\n")[1].fields, (Fields{"1", "", "3"}));
  EXPECT_EQ(parse_csv("\"a;b\",c\n")[0].fields, (Fields{"a;b", "c"}));
  EXPECT_EQ(parse_csv("\xEF\xBB\xBFx,y\n")[0].fields, (Fields{"x", "y"}));
}

TEST(Csv, KeepsQuotedFieldsInARoundTrip) {
  for (const std::string field : {"", "a", " a", "a\t", "#1", "a,b", "a;b", "\"", "\"\"", "a\nb", "a\r\nb,\"c\""}) {
    for (const std::string& text : {"x," + csv_field(field) + "\n", csv_field(field) + ",x\n"}) {
      const std::vector<CsvRow> rows = parse_csv("a,b\n" + text);
      ASSERT_EQ(rows.size(), 2U) << text;
      EXPECT_EQ(rows[1].fields[text.starts_with("x,") ? 1 : 0], field);
    }
  }
}

TEST(Csv, NamesTheLine) {
  const auto complaint = [](const std::string& text) { return test::complaint_of([&] { parse_csv(text, "t.csv"); }); };
  EXPECT_EQ(complaint("a\n\"b\nc"), "t.csv: line 2: a quote is not closed");
  EXPECT_EQ(complaint("a\nb\"c"), "t.csv: line 2: a quote is inside of a field");
  EXPECT_EQ(complaint("\"a\"b"), "t.csv: line 1: a quoted field goes on behind its quote");
}

}  // namespace
}  // namespace taxel
