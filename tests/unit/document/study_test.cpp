// The runs of a study, and the errors for invalid studies.
#include "core/document/scenario/study.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace taxel {
namespace {

std::string document(const std::string& scenario, const std::string& parameters) {
  return R"({"format": "taxel-study", "version": 1, "scenario": )" + scenario + R"(, "parameters": )" + parameters +
         "}";
}
std::string why_not(const std::string& scenario, const std::string& parameters) {
  try {
    parse_study(document(scenario, parameters), "s.json");
  } catch (const Error& e) {
    return e.what();
  }
  return "accepted";
}

TEST(Study, VariesTheSecondParameterFastest) {
  const Study study = parse_study(document(
      R"({"kind": "press"})",
      R"([{"parameter": "depth", "from": 0.001, "to": 0.002, "count": 3}, {"parameter": "seed", "values": [7, 8]}])"));
  const std::vector<StudyRun> runs = runs_of(study);
  ASSERT_EQ(runs.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(runs[i].scenario.kind(), kKind<scenarios::Press>);
    EXPECT_DOUBLE_EQ(runs[i].scenario.as<scenarios::Press>().depth, 0.001 + 0.0005 * static_cast<double>(i / 2));
    EXPECT_EQ(runs[i].seed, 7 + i % 2);
    EXPECT_FALSE(runs[i].density);
    EXPECT_EQ(runs[i].values,
              (std::vector<double>{runs[i].scenario.as<scenarios::Press>().depth, 7.0 + static_cast<double>(i % 2)}));
  }
  EXPECT_EQ(runs.back().scenario.as<scenarios::Press>().depth, 0.002) << "the end exactly";
  EXPECT_EQ(parse_study(study_to_json(study)), study);
}

TEST(Study, NamesTheWrongField) {
  EXPECT_EQ(why_not("{}", "[]"), "s.json: /parameters: must be one or two, are 0");
  EXPECT_EQ(
      why_not("{}", R"([{"parameter": "hold", "values": [1]}])"),
      "s.json: /parameters/0/parameter: \"hold\" is neither density nor seed, nor a number of the kind \"sweep\"");
  EXPECT_EQ(why_not("{}", R"([{"parameter": "depth", "values": [0.001, -1]}])"),
            "s.json: /parameters/0/values/1: must be greater than 0, is -1");
  EXPECT_EQ(why_not("{}", R"([{"parameter": "depth", "values": []}])"),
            "s.json: /parameters/0/values: must be at least one");
  EXPECT_EQ(why_not("{}", R"([{"parameter": "seed", "values": [0.5]}])"),
            "s.json: /parameters/0/values/0: must be a whole number from 0, is 0.5");
  EXPECT_EQ(why_not("{}", R"([{"parameter": "density", "values": [0]}])"),
            "s.json: /parameters/0/values/0: must be greater than 0, is 0");
  EXPECT_EQ(why_not("{}", R"([{"parameter": "depth", "values": [1]}, {"parameter": "depth", "values": [1]}])"),
            "s.json: /parameters/1/parameter: \"depth\" is varied already");
  EXPECT_EQ(why_not("{}", R"([{"parameter": "depth", "values": [1], "count": 2}])"),
            "s.json: /parameters/0/count: is not used together with values");
  EXPECT_EQ(why_not("{}", R"([{"parameter": "depth", "from": 1, "to": 2, "count": 1}])"),
            "s.json: /parameters/0/count: must be a whole number from 2 to 1000, is 1");
  EXPECT_EQ(why_not("{}", R"([{"parameter": "depth", "from": 1, "to": 2, "count": 40},
                              {"parameter": "speed", "from": 1, "to": 2, "count": 40}])"),
            "s.json: /parameters: make more than 1000 runs");
  EXPECT_EQ(why_not(R"({"speed": 0})", R"([{"parameter": "depth", "values": [1]}])"),
            "s.json: /scenario/speed: must be greater than 0, is 0");
}

}  // namespace
}  // namespace taxel
