// The JSON text of reports: order of keys, kinds of values, and the three layouts.
#include "app/cli/report_writer.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace taxel::cli {
namespace {

TEST(ReportWriter, WritesValuesInTheOrderOfTheCalls) {
  ReportWriter w;
  w("text", "a \"b\"");
  w("whole", 12);
  w("large", std::numeric_limits<std::uint64_t>::max());
  w("number", 0.1);
  w("round", 2.0);
  w("flag", true);
  w("vector", dvec3(1, 0.5, -2));
  w("list", std::vector<int>{1, 2});
  EXPECT_EQ(w.text(JsonStyle::short_arrays),
            "{\n"
            "  \"text\": \"a \\\"b\\\"\",\n"
            "  \"whole\": 12,\n"
            "  \"large\": 18446744073709551615,\n"
            "  \"number\": 0.1,\n"
            "  \"round\": 2.0,\n"
            "  \"flag\": true,\n"
            "  \"vector\": [1.0, 0.5, -2.0],\n"
            "  \"list\": [1, 2]\n"
            "}\n");
}

TEST(ReportWriter, WritesNullWithoutAValue) {
  ReportWriter w;
  w("empty", std::optional<double>());
  w("full", std::optional<std::string>("x"));
  w("nan", std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(w.text(), "{\n  \"empty\": null,\n  \"full\": \"x\",\n  \"nan\": null\n}\n");
}

TEST(ReportWriter, NestsObjectsAndLists) {
  ReportWriter w;
  w.object("inner", [](ReportWriter& inner) { inner("a", 1); });
  w.list("items", std::vector<int>{7, 8}, [](ReportWriter& one, int item) { one("id", item); });
  w.list("none", std::vector<int>{}, [](ReportWriter&, int) {});
  w("last", 3);
  EXPECT_EQ(w.text(JsonStyle::narrow_indents),
            "{\n \"inner\": {\n  \"a\": 1\n },\n \"items\": [\n  {\n   \"id\": 7\n  },\n  {\n   \"id\": 8\n  }\n ],\n"
            " \"none\": [],\n \"last\": 3\n}\n");
}

TEST(ReportWriter, CopiesTheKeysOfAJsonText) {
  ReportWriter w;
  w.keys_of(R"({"z": [1, {"y": 2.50}], "a": null})");
  w("b", 1);
  EXPECT_EQ(w.text(), "{\n  \"z\": [\n    1,\n    {\n      \"y\": 2.5\n    }\n  ],\n  \"a\": null,\n  \"b\": 1\n}\n");
}

TEST(ReportWriter, ReplacesBytesThatAreNotText) {
  ReportWriter w;
  w("file", std::string("\xff.obj"));
  EXPECT_EQ(w.text(), "{\n  \"file\": \"\xef\xbf\xbd.obj\"\n}\n");
}

}  // namespace
}  // namespace taxel::cli
