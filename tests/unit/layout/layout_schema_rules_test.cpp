// The program enforces the JSON schema: each rule of assets/schema/layout.schema.json is broken by a document of its
// own, which reading or checking refuses at its place, and values at the limits of the rules are accepted.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/layout/check/layout_check.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/file/layout_keys.h"

namespace taxel {
namespace {

using Json = nlohmann::json;
using Pointer = Json::json_pointer;

/// A document that has each key of the schema.
const char* const kFull = R"({
  "format": "taxel-layout", "version": 1, "name": "full",
  "mesh": {"file": "m.obj", "scale": [1, 1, 1], "sha256": "", "repair": {"level": "wrap", "join": 0.1, "fill": 0.1,
           "edge": 0.1, "tolerance": 0.1, "refine": 2}},
  "frame": {"distal": [0, 0, 1], "pad": [0, -1, 0]},
  "sampling": {"density": 1e6, "seed": 1, "weights": "equal", "shells": "outer", "region": [[0, 5]]},
  "receptive_field": {"metric": "euclidean", "max_angle_deg": 45, "angle_falloff_deg": 0, "normals": "face"},
  "readout": {"aggregate": "mean", "method": "samples", "misses": "zero", "ray": "surface_normal", "max_depth": 0.004,
              "shear": true},
  "material": {"field": "pad", "modulus": 5e4, "thickness": 0.002, "dissipation": 5, "friction": 0.5, "faces": "all",
               "tangential_stiffness": 0, "bristles": 500},
  "taxels": [{"id": 5, "name": "a", "center": [0, 0, 1], "normal": [0, 0, 1], "radius": 0.5,
              "subtaxels": [{"center": [0, 0, 1], "normal": [0, 0, 1], "radius": 0.25}], "density": 2e6},
             {"id": 6, "name": "b", "center": [9, 0, 1], "normal": [0, 0, 1], "radius": 0.5}],
  "calibration": {"seed": 1, "unit": "V", "response": {"polynomial": [1, 0, 0, 0], "up_to": 1},
    "relaxation": [{"amplitude": 0.5, "time": 1}], "hysteresis": {"width": 1, "fraction": 0.5}, "low_pass": {"time": 1},
    "crosstalk": {"fraction": 0.5, "reach": 1}, "quantisation": {"step": 0.5}, "dead": {"fraction": 0.5, "value": 0},
    "tare": 1, "tare_deviation": 1, "gain": 2, "gain_deviation": 1, "noise": 1, "range": [0, 1], "rate": 1, "latency": 1,
    "taxels": [{"id": 5, "tare": 1, "gain": 2, "dead": 1}]}
})";

/// Values that are written in place of others in kFull, because the two exclude each other.
struct Instead {
  std::string_view place, removed, json;
};
constexpr Instead kInstead[] = {
    {"/calibration/response", "/calibration/response", R"({"points": [[0, 0], [1, 1]]})"},
    {"/calibration/hysteresis", "/calibration/hysteresis",
     R"({"width": 1, "fraction": 0, "plays": [{"width": 2, "fraction": 0}]})"},
    {"/calibration/low_pass/cutoff", "/calibration/low_pass/time", "1"},
    {"/calibration/crosstalk_matrix", "/calibration/crosstalk", "[[1, 0], [0, 1]]"},
    {"/calibration/curve", "/calibration/gain", "[[0, 0], [1, 1]]"},
    {"/calibration/quantisation/bits", "/calibration/quantisation/step", "8"},
    {"/calibration/taxels/0/curve", "/calibration/taxels/0/gain", "[[0, 0], [1, 1]]"},
};

/// Returns the pointer of the error that a document gives, or "accepted".
std::string error_place(const Json& document) {
  try {
    const Layout layout = parse_layout(document.dump());
    for (const Problem& p : check_layout_values(layout, ""))
      if (p.severity == Severity::error) return p.pointer;
  } catch (const Error& e) {
    return e.where();
  }
  return "accepted";
}

/// Walks the schema together with a document that fulfils it.
class Rules {
 public:
  Rules()
      : schema_(Json::parse(read_file(std::filesystem::path(TAXEL_SOURCE_DIR) / "assets/schema/layout.schema.json"))) {}

  void walk() {
    walk(schema_, Json::parse(kFull), Pointer());
    for (const Instead& instead : kInstead) {
      Json document = Json::parse(kFull);
      const Pointer removed{std::string(instead.removed)}, place{std::string(instead.place)};
      document[removed.parent_pointer()].erase(removed.back());
      document[place] = Json::parse(instead.json);
      ASSERT_EQ(error_place(document), "accepted") << place.to_string();
      walk(described(place), document, place);
    }
  }
  [[nodiscard]] int broken() const { return broken_; }
  [[nodiscard]] int kept() const { return kept_; }

 private:
  /// Returns the schema of a place.
  [[nodiscard]] Json described(const Pointer& place) const {
    if (place.empty()) return schema_;
    const Json parent = described(place.parent_pointer());
    return resolved(parent.contains("items") ? parent["items"] : parent["properties"][place.back()]);
  }
  /// Returns a schema with the keywords of the definition that it refers to.
  [[nodiscard]] Json resolved(Json rule) const {
    if (!rule.contains("$ref")) return rule;
    Json base = resolved(schema_[Pointer(rule["$ref"].get<std::string>().substr(1))]);
    rule.erase("$ref");
    base.update(rule);
    return base;
  }

  /// Expects that the document with another value at a place is refused there.
  void refuse(const Json& document, const Pointer& place, const Json& value, const std::string& rule) {
    Json changed = document;
    changed[place] = value;
    const std::string at = error_place(changed), here = place.to_string();
    EXPECT_TRUE(at != "accepted" && (at.starts_with(here) || here.starts_with(at)))
        << here << " = " << value << " breaks " << rule << ", and the error is at: " << at;
    ++broken_;
  }
  void accept(const Json& document, const Pointer& place, const Json& value, const std::string& rule) {
    Json changed = document;
    changed[place] = value;
    EXPECT_EQ(error_place(changed), "accepted") << place.to_string() << " = " << value << " fulfils " << rule;
    ++kept_;
  }

  void break_type(const Json& document, const Pointer& place, const std::string& type) {
    const std::vector<std::pair<std::string, Json>> values = {{"number", 0.5},          {"string", "word"},
                                                              {"array", Json::array()}, {"object", Json::object()},
                                                              {"boolean", true},        {"null", nullptr}};
    for (const auto& [name, value] : values)
      if (name != type) refuse(document, place, value, "type " + type);
  }

  void break_value(const Json& rule, const Json& document, const Pointer& place) {
    const Json value = document[place];
    for (const auto& [keyword, limit] : rule.items()) {
      const auto refuse_it = [&](const Json& other) { refuse(document, place, other, keyword + " " + limit.dump()); };
      const auto accept_it = [&](const Json& other) { accept(document, place, other, keyword + " " + limit.dump()); };
      if (keyword == "type") {
        break_type(document, place, limit);
      } else if (keyword == "const") {
        refuse_it(limit.is_number() ? Json(limit.get<int>() + 1) : Json(limit.get<std::string>() + "x"));
      } else if (keyword == "enum") {
        refuse_it("no such word");
        for (const Json& word : limit) accept_it(word);
      } else if (keyword == "minimum") {
        refuse_it(limit.get<double>() - 1);
        accept_it(limit);
      } else if (keyword == "maximum") {
        refuse_it(limit.get<double>() * 2 + 1);
        accept_it(limit);
      } else if (keyword == "exclusiveMinimum") {
        refuse_it(limit);
        refuse_it(limit.get<double>() - 1);
      } else if (keyword == "minItems" || keyword == "maxItems") {
        Json other = value;
        if (keyword == "minItems")
          other.erase(other.size() - 1);
        else
          other.push_back(value[0]);
        while (keyword == "minItems" && other.size() >= limit.get<std::size_t>()) other.erase(other.size() - 1);
        refuse_it(other);
      } else if (keyword == "minLength") {
        refuse_it("");
      } else if (keyword == "pattern") {
        refuse_it("not a hash");
        accept_it(std::string(64, 'a'));
      } else if (keyword == "not") {
        refuse_it(limit["const"]);
      } else if (keyword == "contains") {
        refuse_it({0, 0, 0});
      } else if (keyword == "anyOf") {
        refuse_it(Json::array());
        refuse_it("another text");
        accept_it(limit[1]["const"]);
      } else if (keyword == "required") {
        for (const Json& key : limit) {
          Json without = value;
          without.erase(key.get<std::string>());
          refuse(document, place, without, "required " + key.dump());
        }
      } else if (keyword == "default") {
        accept_it(limit);
      } else if (keyword != "properties" && keyword != "items" && keyword != "title" && keyword != "description" &&
                 keyword != "$schema" && keyword != "$defs") {
        ADD_FAILURE() << "the keyword " << keyword << " of the schema at " << place.to_string() << " is not tested";
      }
    }
  }

  void walk(const Json& unresolved, const Json& document, const Pointer& place) {
    const Json rule = resolved(unresolved);
    break_value(rule, document, place);
    const Json value = document[place];
    if (rule.contains("properties")) {
      EXPECT_EQ(known_layout_keys(place.to_string()).size(), rule["properties"].size()) << place.to_string();
      for (const auto& [key, property] : rule["properties"].items()) {
        const auto keys = known_layout_keys(place.to_string());
        EXPECT_TRUE(std::find(keys.begin(), keys.end(), key) != keys.end()) << place.to_string() << "/" << key;
        if (value.contains(key)) walk(property, document, place / key);
      }
    }
    if (rule.contains("items"))
      for (std::size_t i = 0; i < value.size(); ++i) walk(rule["items"], document, place / i);
  }

  Json schema_;
  int broken_ = 0, kept_ = 0;
};

TEST(LayoutSchema, IsEnforcedRuleByRule) {
  ASSERT_EQ(error_place(Json::parse(kFull)), "accepted");
  Rules rules;
  rules.walk();
  EXPECT_GT(rules.broken(), 500);
  EXPECT_GT(rules.kept(), 50);
}

TEST(LayoutSchema, AllowsFurtherKeysEverywhere) {
  Json document = Json::parse(kFull);
  const Json flat = document.flatten();
  for (const auto& [place, value] : flat.items()) {
    const Pointer parent = Pointer(place).parent_pointer();
    if (document[parent].is_object()) document[parent]["x_lab"] = 1;
  }
  EXPECT_EQ(error_place(document), "accepted");
  EXPECT_EQ(Json::parse(layout_to_json(parse_layout(document.dump())))["calibration"]["dead"]["x_lab"], 1);
}

}  // namespace
}  // namespace taxel
