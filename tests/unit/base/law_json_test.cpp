// Pressure laws in JSON: read as written, and refused with the place of the value that breaks a rule.
#include "core/base/text/law_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace taxel {
namespace {

using LawJson = nlohmann::ordered_json;

PressureLaw law_in(const std::string& text) {
  const LawJson json = LawJson::parse(text);
  return read_law(JsonNode<LawJson>(json, "f.json", nullptr, "/law"));
}
std::string refusal_of(const std::string& text) {
  try {
    law_in(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(LawJson, IsReadAsWritten) {
  for (const PressureLaw& law : {PressureLaw{}, PressureLaw{LawKind::stiffening, 0.78, {}},
                                 PressureLaw{LawKind::table, 0, {{0.2, 0.1}, {0.5, 0.5}}}}) {
    EXPECT_EQ(law_in(law_json<LawJson>(law).dump()), law);
    EXPECT_EQ(law_of(numbers_of(law)), law);
  }
  EXPECT_THROW(law_of({1, 0.5, 0.3}), Error);
  EXPECT_THROW(law_of({3, 0.5}), Error);
}

TEST(LawJson, IsRefusedWithThePlace) {
  EXPECT_NE(refusal_of(R"("stiff")").find("/law: must be \"linear\""), std::string::npos);
  EXPECT_NE(refusal_of("{}").find("/law: must have"), std::string::npos);
  EXPECT_NE(refusal_of(R"({"stiffening": 0.5, "table": []})").find("one of the two"), std::string::npos);
  EXPECT_NE(refusal_of(R"({"stiffening": 1})").find("/law/stiffening: must be at least 0"), std::string::npos);
  EXPECT_NE(refusal_of(R"({"stiffening": "x"})").find("/law/stiffening: must be a number"), std::string::npos);
  EXPECT_NE(refusal_of(R"({"table": [[1, 1]]})").find("/law/table: must have 2 rows"), std::string::npos);
  EXPECT_NE(refusal_of(R"({"table": [[1, 1], [2]]})").find("/law/table/1: must be an array of 2"), std::string::npos);
  EXPECT_NE(refusal_of(R"({"table": [[0.5, 1], [1, 0.9]]})").find("/law/table/1/1: must be greater"),
            std::string::npos);
  EXPECT_NE(refusal_of(R"({"stifening": 0.5})").find("did you mean \"stiffening\""), std::string::npos);
}

}  // namespace
}  // namespace taxel
