// The JSON schema agrees with the reader: the same keys, words and defaults.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/words.h"

namespace taxel {
namespace {

using Json = nlohmann::json;

const std::filesystem::path kAssets = std::filesystem::path(TAXEL_SOURCE_DIR) / "assets";

Json schema() {
  return Json::parse(read_file(kAssets / "schema/layout.schema.json"));
}

template <class E>
Json words() {
  Json list = Json::array();
  for (const auto& w : words_of(E{})) list.push_back(std::string(w.text));
  return list;
}

TEST(LayoutSchema, HasTheReadersWords) {
  const Json p = schema()["properties"];
  EXPECT_EQ(p["mesh"]["properties"]["repair"]["properties"]["level"]["enum"], words<RepairLevel>());
  EXPECT_EQ(p["sampling"]["properties"]["weights"]["enum"], words<SampleWeights>());
  EXPECT_EQ(p["sampling"]["properties"]["shells"]["enum"], words<Shells>());
  EXPECT_EQ(p["receptive_field"]["properties"]["metric"]["enum"], words<Metric>());
  EXPECT_EQ(p["receptive_field"]["properties"]["normals"]["enum"], words<FieldNormals>());
  EXPECT_EQ(p["readout"]["properties"]["method"]["enum"], words<ReadingMethod>());
  EXPECT_EQ(p["readout"]["properties"]["aggregate"]["enum"], words<Aggregate>());
  EXPECT_EQ(p["readout"]["properties"]["misses"]["enum"], words<Misses>());
  EXPECT_EQ(p["readout"]["properties"]["ray"]["enum"], words<RayDirection>());
  EXPECT_EQ(p["material"]["properties"]["faces"]["enum"], words<FaceRule>());
  EXPECT_EQ(p["material"]["properties"]["field"]["enum"], Json::parse(R"(["pad", "star"])"));  // those of a skin
}

/// Expects every key of `value` to be a property of `described`. A default in the schema must equal the value.
void expect_described(const Json& value, const Json& described, const std::string& where) {
  for (const auto& [key, item] : value.items()) {
    ASSERT_TRUE(described["properties"].contains(key)) << where << "/" << key;
    const Json& property = described["properties"][key];
    if (property.contains("default")) {
      EXPECT_EQ(property["default"], item) << where << "/" << key;
    }
    if (item.is_object()) expect_described(item, property, where + "/" + key);
  }
  for (const auto& [key, property] : described["properties"].items())
    EXPECT_TRUE(value.contains(key)) << where << " lacks " << key;
}

TEST(LayoutSchema, HasTheReadersKeysAndDefaults) {
  Layout layout = parse_layout(R"({"format": "taxel-layout", "version": 1, "mesh": {"file": "m"}, "taxels": []})");
  Json written = Json::parse(layout_to_json(layout));
  written.erase("taxels");
  Json described = schema();
  described["properties"].erase("taxels");
  described["properties"].erase("calibration");
  Json& sampling = described["properties"]["sampling"]["properties"];
  EXPECT_EQ(sampling["shells"]["default"], std::string(to_word(layout.sampling.shells)));
  sampling.erase("shells");  // written only if it differs from the default
  sampling.erase("region");  // written only if it differs from the default
  Json& mesh = described["properties"]["mesh"]["properties"];
  const Json repair = mesh["repair"];
  mesh.erase("repair");  // written only if it differs from the default
  Json& readout = described["properties"]["readout"]["properties"];
  EXPECT_EQ(readout["shear"]["default"], layout.readout.shear);  // written if it differs from the default
  EXPECT_EQ(readout["method"]["default"], std::string(to_word(layout.readout.method)));  // as shear
  readout.erase("method");
  Json& field = described["properties"]["receptive_field"]["properties"];
  EXPECT_EQ(field["angle_falloff_deg"]["default"], layout.receptive_field.angle_falloff_deg);  // as shear
  EXPECT_EQ(field["normals"]["default"], std::string(to_word(layout.receptive_field.normals)));
  field.erase("angle_falloff_deg");
  field.erase("normals");
  Json& material = described["properties"]["material"]["properties"];
  EXPECT_EQ(material["faces"]["default"], std::string(to_word(layout.material.faces)));  // as shear
  material.erase("faces");
  EXPECT_EQ(material["law"]["default"], "linear");  // as shear
  material.erase("law");
  for (const char* key : {"tangential_stiffness", "bristles"}) {  // as shear
    EXPECT_EQ(material[key]["default"], Json(std::string_view(key) == "bristles" ? 1000 : 0)) << key;
    material.erase(key);
  }
  const Json shear = readout["shear"];
  readout.erase("shear");
  expect_described(written, described, "");
  layout.readout.shear = true;
  EXPECT_EQ(Json::parse(layout_to_json(layout))["readout"]["shear"], true);
  EXPECT_EQ(shear["type"], "boolean");
  EXPECT_EQ(repair["properties"]["level"]["default"], std::string(to_word(RepairRecipe{}.level)));
  layout.mesh.repair = {RepairLevel::exact, 1.0, 1.0, 1.0, 1.0, 1.0};
  const Json recipe = Json::parse(layout_to_json(layout))["mesh"]["repair"];
  for (const auto& [key, value] : recipe.items()) EXPECT_TRUE(repair["properties"].contains(key)) << key;
  EXPECT_EQ(recipe.size(), repair["properties"].size());

  layout.taxels = {{0, "", dvec3(0), dvec3(0, 0, 1), 1.0, {}}};
  Json taxel = schema()["$defs"]["taxel"];
  EXPECT_EQ(taxel["properties"]["density"]["default"], 0);  // as shear
  taxel["properties"].erase("density");
  expect_described(Json::parse(layout_to_json(layout))["taxels"][0], taxel, "/taxels/0");
}

TEST(LayoutSchema, HasEveryPartOfACalibration) {
  Layout layout = parse_layout(R"({"format": "taxel-layout", "version": 1, "mesh": {"file": "m"}, "taxels": []})");
  Calibration& c = layout.calibration.emplace();
  c.response = {{1}, 1, {{0, 0}, {1, 1}}};
  c.relaxation = {{0.1, 2}};
  c.hysteresis = {1, 1, {{2, 0.25}}};
  c.low_pass = {1, 2};
  c.crosstalk_matrix = {{1}};
  c.latency = 0.1;
  c.crosstalk.emplace();
  c.quantisation = {0.5, 12};
  c.dead.emplace();
  c.unit = "V";
  c.tare_deviation = c.gain_deviation = c.noise = 1;
  c.tare.emplace(), c.gain = 1, c.curve = {{0, 0}, {1, 1}}, c.range.emplace(), c.rate = 1;
  c.taxels = {{.id = 0, .tare = 1, .gain = 1, .curve = c.curve, .dead = 0}};
  const Json written = Json::parse(layout_to_json(layout))["calibration"];
  const Json described = schema()["properties"]["calibration"];
  expect_described(written, described, "/calibration");
  expect_described(written["relaxation"][0], described["properties"]["relaxation"]["items"],
                   "/calibration/relaxation/0");
  expect_described(written["hysteresis"]["plays"][0],
                   described["properties"]["hysteresis"]["properties"]["plays"]["items"],
                   "/calibration/hysteresis/plays/0");
  expect_described(written["taxels"][0], described["properties"]["taxels"]["items"], "/calibration/taxels/0");
}

TEST(LayoutSchema, RequiresTheSameKeysAsTheReader) {
  const Json s = schema();
  EXPECT_EQ(s["required"], Json::parse(R"(["format", "version", "mesh", "taxels"])"));
  EXPECT_EQ(s["properties"]["mesh"]["required"], Json::parse(R"(["file"])"));
  for (const char* kind : {"taxel", "subtaxel"})
    EXPECT_EQ(s["$defs"][kind]["required"], Json::parse(R"(["center", "normal", "radius"])"));
}

}  // namespace
}  // namespace taxel
