// Layout files: reading returns the written values, and every error names its place.
#include "core/layout/file/layout_json.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "fixtures/complaint.h"

namespace taxel {
namespace {

constexpr const char* kMinimal = R"({
  "format": "taxel-layout", "version": 1, "mesh": {"file": "m.obj"},
  "taxels": [{"center": [0, 0, 0], "normal": [0, 0, 1], "radius": 0.006}]
})";

Layout full_layout() {
  Layout layout;
  layout.name = "tip \"A\" \xC3\xA9\n";
  layout.mesh = {"a/b.stl", dvec3(0.001, -0.001, 1.0 / 3.0), "abc", {RepairLevel::wrap, 0.0, 0.1, 1.0 / 3.0, 1e-9, 3}};
  layout.frame = {dvec3(0, 1, 0), dvec3(-0.0, 0, 0.1 + 0.2)};
  layout.sampling = {1.5e6, 0xffffffffffffffffULL, SampleWeights::voronoi, Shells::all, std::vector{1, 2, 5}};
  layout.receptive_field = {Metric::geodesic, 37.5, 12.25, FieldNormals::interpolated};
  layout.readout = {Aggregate::force, ReadingMethod::exact, Misses::omit, RayDirection::taxel_normal, 1e-300, true};
  layout.material = {FieldKind::star,        5e4,           0.0021, 4.9406564584124654e-324,
                     1.7976931348623157e308, FaceRule::all, 1.5e8,  500};
  layout.taxels = {{7, "left 1", dvec3(1e-9, 2, -3.25), dvec3(0, 1, 0), 0.006, {}},
                   {-2, "", dvec3(0.1), dvec3(1e20, 0, 0), -1.0, {{dvec3(1, 2, 3), dvec3(0, 0, 1), 0.5}, {}}}};
  Calibration& c = layout.calibration.emplace();
  c.seed = 0x8000000000000001ULL;
  c.unit = "V";
  c.response = {{1, 1e-6}, 5e4, {}};
  c.relaxation = {{0.1, 0.8}, {0.2, 1.0 / 3.0}};
  c.low_pass = {{}, 30};
  c.crosstalk_matrix = {{1, 0.1 + 0.2}, {0, 1}};
  c.latency = 0.004;
  c.hysteresis = {150.5, 0.25, {{300, 0.5}, {450, 0.25}}};
  c.crosstalk = {0.1, 0.006};
  c.tare = {true, 0};
  c.tare_deviation = 1.0 / 3.0;
  c.curve = {{-1, 0}, {1e5, 4.5}};
  c.gain_deviation = 0.05;
  c.noise = 1e-3;
  c.range = {-0.5, 5};
  c.quantisation = {{}, 12};
  c.rate = 100;
  c.dead = {0.02, -1};
  c.taxels = {{.id = 7, .tare = 1.5, .gain = -2, .curve = {}, .dead = {}},
              {.id = 3, .tare = {}, .gain = {}, .curve = {{0, 1}, {0.1 + 0.2, 2}}, .dead = 0}};
  layout.unknown = {{"/calibration/crosstalk/of", "\"skin\""},
                    {"/calibration/date", "\"today\""},
                    {"/calibration/taxels/1/note", "7"},
                    {"/mesh/made by", "\"hand\""},
                    {"/mesh/repair/by", "\"us\""},
                    {"/taxels/1/subtaxels/0/a~1b", "[]"},
                    {"/taxels/0/note", "null"}};
  return layout;
}

/// Returns the error that parsing throws, as "pointer|message".
std::string error_of(const std::string& text) {
  try {
    parse_layout(text, "f.json");
  } catch (const Error& e) {
    EXPECT_EQ(e.file(), "f.json");
    return fmt::format("{}|{}", e.where(), e.message());
  }
  return "no error";
}

std::string with(const std::string& what, const std::string& instead) {
  const std::string text = kMinimal;
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return fmt::format("{}{}{}", text.substr(0, at), instead, text.substr(at + what.size()));
}

TEST(LayoutJson, KeepsTheDefaultsOfKeysThatAPartLacks) {
  const Layout usual;
  const Layout layout = parse_layout(R"({"format": "taxel-layout", "version": 1, "mesh": {"file": "m"}, "taxels": [],
    "material": {"friction": 0.3}, "sampling": {"seed": 7}})");
  Material material = usual.material;
  material.friction = 0.3;
  EXPECT_EQ(layout.material, material);
  EXPECT_EQ(layout.sampling.density, usual.sampling.density);
  EXPECT_EQ(layout.sampling.seed, 7U);
}

TEST(LayoutJson, WritesAndReadsBackEveryValue) {
  const Layout layout = full_layout();
  const std::string text = layout_to_json(layout);
  const Layout back = parse_layout(text);
  EXPECT_EQ(back, layout);
  EXPECT_TRUE(std::signbit(back.frame.pad.x));
  EXPECT_EQ(layout_to_json(back), text);
  EXPECT_EQ(text.back(), '\n');
}

TEST(LayoutJson, WritesKeysInTheOrderOfTheFormat) {
  const std::string text = layout_to_json(full_layout());
  std::size_t at = 0;
  for (const char* key : {"format",
                          "version",
                          "name",
                          "mesh",
                          "file",
                          "scale",
                          "sha256",
                          "repair",
                          "level",
                          "join",
                          "fill",
                          "edge",
                          "tolerance",
                          "refine",
                          "by",
                          "made by",
                          "frame",
                          "distal",
                          "pad",
                          "sampling",
                          "density",
                          "seed",
                          "weights",
                          "shells",
                          "region",
                          "receptive_field",
                          "metric",
                          "max_angle_deg",
                          "angle_falloff_deg",
                          "normals",
                          "readout",
                          "aggregate",
                          "method",
                          "misses",
                          "ray",
                          "max_depth",
                          "material",
                          "field",
                          "modulus",
                          "thickness",
                          "dissipation",
                          "friction",
                          "tangential_stiffness",
                          "bristles",
                          "taxels",
                          "id",
                          "name",
                          "center",
                          "normal",
                          "radius",
                          "subtaxels",
                          "note",
                          "calibration",
                          "seed",
                          "unit",
                          "response",
                          "polynomial",
                          "up_to",
                          "relaxation",
                          "amplitude",
                          "time",
                          "hysteresis",
                          "width",
                          "fraction",
                          "plays",
                          "width",
                          "fraction",
                          "low_pass",
                          "cutoff",
                          "crosstalk",
                          "fraction",
                          "reach",
                          "crosstalk_matrix",
                          "quantisation",
                          "bits",
                          "dead",
                          "fraction",
                          "value",
                          "tare",
                          "tare_deviation",
                          "curve",
                          "gain_deviation",
                          "noise",
                          "range",
                          "rate",
                          "latency",
                          "taxels",
                          "id",
                          "tare",
                          "gain",
                          "curve",
                          "dead",
                          "date"}) {
    const std::size_t next = text.find(fmt::format("\"{}\":", key), at);
    ASSERT_NE(next, std::string::npos) << key;
    at = next;
  }
}

TEST(LayoutJson, WritesShellsOnlyIfAllAreSampled) {
  Layout layout = parse_layout(kMinimal);
  EXPECT_EQ(layout.sampling.shells, Shells::outer);
  EXPECT_EQ(layout_to_json(layout).find("shells"), std::string::npos);
  layout.sampling.shells = Shells::all;
  EXPECT_EQ(parse_layout(layout_to_json(layout)), layout);
}

TEST(LayoutJson, WritesOnlyTheSetValuesOfARepair) {
  Layout layout = parse_layout(kMinimal);
  EXPECT_EQ(layout.mesh.repair, RepairRecipe{});
  EXPECT_EQ(layout_to_json(layout).find("repair"), std::string::npos);
  layout.mesh.repair.edge = 3e-4;
  const std::string text = layout_to_json(layout);
  EXPECT_NE(text.find("\"edge\": 0.0003"), std::string::npos);
  EXPECT_EQ(text.find("\"level\""), std::string::npos);
  EXPECT_EQ(parse_layout(text), layout);
  for (const RepairLevel level : {RepairLevel::automatic, RepairLevel::exact, RepairLevel::wrap, RepairLevel::keep}) {
    layout.mesh.repair = {level, {}, {}, {}, {}, {}};
    EXPECT_EQ(parse_layout(layout_to_json(layout)), layout);
  }
}

TEST(LayoutJson, KeepsUnknownKeysOfADefaultRepair) {
  const Layout layout = parse_layout(with("\"m.obj\"", R"("m.obj", "repair": {"level": "auto", "seen": true})"));
  EXPECT_EQ(layout.mesh.repair, RepairRecipe{});
  EXPECT_EQ(layout.unknown.at("/mesh/repair/seen"), "true");
  EXPECT_EQ(parse_layout(layout_to_json(layout)), layout);
}

TEST(LayoutJson, NamesTheMistakeInARepair) {
  const auto complaint = [](const std::string& repair) {
    return error_of(with("\"m.obj\"", "\"m.obj\", \"repair\": " + repair));
  };
  EXPECT_EQ(complaint("3"), "/mesh/repair|must be an object, is 3");
  EXPECT_EQ(complaint(R"({"level": "automatic"})"),
            R"(/mesh/repair/level|must be one of "auto", "exact", "wrap", "keep", is "automatic")");
  EXPECT_EQ(complaint(R"({"edge": "0.3 mm"})"), R"(/mesh/repair/edge|must be a number, is "0.3 mm")");
  EXPECT_EQ(complaint(R"({"join": null})"), "/mesh/repair/join|must be a number, is null");
}

TEST(LayoutJson, WritesARegionInRunsAndOnlyIfThereIsOne) {
  Layout layout = parse_layout(kMinimal);
  EXPECT_TRUE(layout.sampling.region->empty());
  EXPECT_EQ(layout_to_json(layout).find("region"), std::string::npos);
  layout.sampling.region = std::vector{0, 1, 2, 9, 20, 21};
  const std::string text = layout_to_json(layout);
  EXPECT_EQ(parse_layout(text), layout);
  const std::string runs = text.substr(text.find("\"region\""));
  std::string packed;
  for (const char c : runs.substr(0, runs.find('}')))
    if (c != ' ' && c != '\n') packed += c;
  EXPECT_EQ(packed, "\"region\":[[0,2],[9,9],[20,21]]");
}

TEST(LayoutJson, NamesTheMistakeInARegion) {
  const auto complaint = [](const std::string& region) {
    std::string text = kMinimal;
    text.insert(text.find('{') + 1, "\"sampling\": {\"region\": " + region + "},");
    return test::complaint_of([&] { parse_layout(text, "l"); });
  };
  EXPECT_EQ(complaint("[[0, 3]]"), "accepted");
  EXPECT_EQ(complaint("3"), "l: /sampling/region: must be an array, is 3");
  EXPECT_EQ(complaint("[[0, 3], [5]]"),
            "l: /sampling/region/1: must be an array of 2 faces, the first and the last of a run, is [5]");
  EXPECT_EQ(
      complaint("[[3, 0]]"),
      "l: /sampling/region/0: must be the first and the last of a run of faces, 0 or more and ascending, is [3,0]");
  EXPECT_EQ(
      complaint("[[-1, 0]]"),
      "l: /sampling/region/0: must be the first and the last of a run of faces, 0 or more and ascending, is [-1,0]");
  EXPECT_EQ(complaint("[[0, 3], [3, 4]]"), "l: /sampling/region/1: must be a run behind face 3, is [3,4]");
  EXPECT_EQ(complaint("[[0, 2000000000]]"),
            "l: /sampling/region/0: must be at most 100000000 faces in all, is [0,2000000000]");
}

TEST(LayoutJson, WritesTheShortestNumbers) {
  Layout layout = parse_layout(kMinimal);
  layout.sampling.density = 1e7;
  const std::string text = layout_to_json(layout);
  EXPECT_NE(text.find("\"radius\": 0.006,"), std::string::npos) << text;
  EXPECT_NE(text.find("\"density\": 10000000,"), std::string::npos) << text;
  EXPECT_NE(text.find("\"normal\": [0, 0, 1],"), std::string::npos) << text;
}

TEST(LayoutJson, UsesDefaultsForOptionalKeys) {
  const Layout layout = parse_layout(kMinimal);
  Layout expected;
  expected.mesh.file = "m.obj";
  expected.taxels = {{0, "", dvec3(0), dvec3(0, 0, 1), 0.006, {}}};
  EXPECT_EQ(layout, expected);
  EXPECT_EQ(layout.sampling.density, 1e7);
  EXPECT_EQ(layout.receptive_field.max_angle_deg, 45.0);
  EXPECT_EQ(layout.readout.aggregate, Aggregate::weighted_mean);
}

TEST(LayoutJson, WritesTheDensityOfATaxelOnlyWhereItIsSet) {
  Layout layout = parse_layout(kMinimal);
  EXPECT_EQ(layout.taxels[0].density, 0);
  EXPECT_EQ(layout_to_json(layout).find("density", layout_to_json(layout).find("taxels")), std::string::npos);
  layout.taxels[0].density = 2.5e7;
  const std::string text = layout_to_json(layout);
  EXPECT_NE(text.find("\"density\": 25000000"), std::string::npos) << text;
  EXPECT_EQ(parse_layout(text), layout);
}

TEST(LayoutJson, WritesRollOffNormalsAndMethodOnlyWhereTheyAreSet) {
  Layout layout = parse_layout(kMinimal);
  EXPECT_EQ(layout.receptive_field.angle_falloff_deg, 0.0);
  EXPECT_EQ(layout.receptive_field.normals, FieldNormals::face);
  EXPECT_EQ(layout.readout.method, ReadingMethod::samples);
  const std::string plain = layout_to_json(layout);
  for (const char* key : {"angle_falloff_deg", "\"normals\"", "\"method\""})
    EXPECT_EQ(plain.find(key), std::string::npos) << key;
  layout.receptive_field.angle_falloff_deg = 10;
  layout.receptive_field.normals = FieldNormals::interpolated;
  layout.readout.method = ReadingMethod::exact;
  const std::string text = layout_to_json(layout);
  EXPECT_NE(text.find("\"angle_falloff_deg\": 10"), std::string::npos) << text;
  EXPECT_NE(text.find("\"normals\": \"interpolated\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"method\": \"exact\""), std::string::npos) << text;
  EXPECT_EQ(parse_layout(text), layout);
}

TEST(LayoutJson, WritesFrictionThatSticksOnlyWhereItIsSet) {
  Layout layout = parse_layout(kMinimal);
  EXPECT_EQ(layout.material.tangential_stiffness, 0.0);
  EXPECT_EQ(layout.material.bristles, 1000);
  const std::string plain = layout_to_json(layout);
  for (const char* key : {"tangential_stiffness", "bristles"}) EXPECT_EQ(plain.find(key), std::string::npos) << key;
  layout.material.tangential_stiffness = 1.5e8;
  layout.material.bristles = 2000;
  const std::string text = layout_to_json(layout);
  EXPECT_NE(text.find("\"bristles\": 2000"), std::string::npos) << text;
  EXPECT_EQ(parse_layout(text), layout);
}

TEST(LayoutJson, KeepsUnknownKeysOnAnyLevel) {
  const std::string text = R"({"format": "taxel-layout", "version": 1, "x": {"deep": [1, {"er": 1.50}]},
    "mesh": {"file": "m", "y/z": true}, "frame": {"u": 1}, "sampling": {"u": 2}, "receptive_field": {"u": 3},
    "readout": {"u": 4}, "material": {"u": 5}, "taxels": [{"center": [0, 0, 0], "normal": [0, 0, 1], "radius": 1, "z": "t",
    "subtaxels": [{"center": [0, 0, 0], "normal": [0, 0, 1], "radius": 1, "w~": null}]}]})";
  const Layout layout = parse_layout(text);
  const std::map<std::string, std::string> expected = {
      {"/x", R"({"deep":[1,{"er":1.5}]})"}, {"/mesh/y~1z", "true"}, {"/frame/u", "1"},    {"/sampling/u", "2"},
      {"/receptive_field/u", "3"},          {"/readout/u", "4"},    {"/material/u", "5"}, {"/taxels/0/z", "\"t\""},
      {"/taxels/0/subtaxels/0/w~0", "null"}};
  EXPECT_EQ(layout.unknown, expected);
  const std::string once = layout_to_json(layout);
  EXPECT_EQ(parse_layout(once), layout);
  EXPECT_EQ(layout_to_json(parse_layout(once)), once);
}

TEST(LayoutJson, DropsUnknownKeysOfADeletedTaxel) {
  Layout layout = full_layout();
  layout.taxels.clear();
  const Layout back = parse_layout(layout_to_json(layout));
  EXPECT_EQ(back.unknown.size(), 5U);
}

TEST(LayoutJson, NamesTheKeyOfAWrongType) {
  EXPECT_EQ(error_of(with("0.006", "\"abc\"")), "/taxels/0/radius|must be a number, is \"abc\"");
  EXPECT_EQ(error_of(with("0.006", "null")), "/taxels/0/radius|must be a number, is null");
  EXPECT_EQ(error_of(with("[0, 0, 0]", "[0, true, 0]")), "/taxels/0/center/1|must be a number, is true");
  EXPECT_EQ(error_of(with("[0, 0, 0]", "[0, 0]")), "/taxels/0/center|must be an array of 3 numbers, is [0,0]");
  EXPECT_EQ(error_of(with("{\"file\": \"m.obj\"}", "7")), "/mesh|must be an object, is 7");
  EXPECT_EQ(error_of(with("\"m.obj\"", "[]")), "/mesh/file|must be a text, is []");
  EXPECT_EQ(error_of(with("\"radius\": 0.006", "\"radius\": 1, \"id\": 1.5")),
            "/taxels/0/id|must be a whole number of at most 31 bits, is 1.5");
  EXPECT_EQ(error_of(with("\"radius\": 0.006", "\"radius\": 1, \"subtaxels\": [3]")),
            "/taxels/0/subtaxels/0|must be an object, is 3");
  EXPECT_EQ(error_of(with("\"taxels\": [", "\"sampling\": {\"seed\": -1}, \"taxels\": [")),
            "/sampling/seed|must be a whole number, 0 or more, is -1");
  EXPECT_EQ(error_of("[1]"), "|must be an object, is [1]");
}

TEST(LayoutJson, WritesACalibrationOnlyIfThereIsOne) {
  Layout layout = parse_layout(kMinimal);
  const std::string text = layout_to_json(layout);
  EXPECT_FALSE(layout.calibration.has_value());
  EXPECT_EQ(text.find("calibration"), std::string::npos);
  layout = parse_layout(with("\"taxels\": [", "\"calibration\": {}, \"taxels\": ["));
  EXPECT_EQ(layout.calibration, Calibration{});
  EXPECT_EQ(parse_layout(layout_to_json(layout)), layout);
  layout.calibration->tare = Tare{false, -30.25};
  layout.calibration->quantisation = Quantisation{0.5, {}};
  layout.calibration->gain = 1;
  EXPECT_EQ(parse_layout(layout_to_json(layout)), layout);
  layout.calibration.reset();
  EXPECT_EQ(layout_to_json(layout), text);
}

TEST(LayoutJson, NamesKeyAndTaxelOfAWrongCalibration) {
  const auto error = [](const std::string& calibration) {
    return error_of(with("\"taxels\": [", "\"calibration\": " + calibration + ", \"taxels\": ["));
  };
  EXPECT_EQ(error("[1]"), "/calibration|must be an object, is [1]");
  EXPECT_EQ(error(R"({"tare": "first"})"), "/calibration/tare|must be a number or \"first_reading\", is \"first\"");
  EXPECT_EQ(error(R"({"range": [1]})"), "/calibration/range|must be an array of 2 numbers, is [1]");
  EXPECT_EQ(error(R"({"curve": []})"), "/calibration/curve|must be an array of 2 points or more, is []");
  EXPECT_EQ(error(R"({"curve": [[0, 0], [1, 2, 3]]})"),
            "/calibration/curve/1|must be an array of 2 numbers, is [1,2,3]");
  EXPECT_EQ(error(R"({"hysteresis": {}})"), "/calibration/hysteresis/width|is missing");
  EXPECT_EQ(error(R"({"crosstalk": {"fraction": 0.1}})"), "/calibration/crosstalk/reach|is missing");
  EXPECT_EQ(error(R"({"quantisation": {"bits": 1.5}})"),
            "/calibration/quantisation/bits|must be a whole number of at most 31 bits, is 1.5");
  EXPECT_EQ(error(R"({"taxels": [{"gain": 1}]})"), "/calibration/taxels/0/id|is missing");
  EXPECT_EQ(error(R"({"taxels": [{"id": 3}, {"id": 9, "gain": "2"}]})"),
            "/calibration/taxels/1/gain|must be a number, is \"2\" (taxel 9)");
  EXPECT_EQ(error(R"({"taxels": [{"id": 9, "curve": [[0, 0], [1, null]]}]})"),
            "/calibration/taxels/0/curve/1/1|must be a number, is null (taxel 9)");
}

TEST(LayoutJson, NamesTheChoicesForAnUnknownWord) {
  EXPECT_EQ(error_of(with("\"taxels\": [", "\"sampling\": {\"weights\": \"even\"}, \"taxels\": [")),
            "/sampling/weights|must be one of \"equal\", \"voronoi\", is \"even\"");
  EXPECT_EQ(error_of(with("\"taxels\": [", "\"readout\": {\"misses\": 0}, \"taxels\": [")),
            "/readout/misses|must be a text, is 0");
}

TEST(LayoutJson, ShowsTheKeysOfJsonOfAnotherProgram) {
  const std::string error =
      error_of(R"({"name": "tip", "units": "mm", "taxels": [{"id": "t0", "position": [37, -17, 60]}]})");
  EXPECT_EQ(error,
            "/format|is missing: this is JSON of another program with the keys \"name\": \"tip\", \"units\": \"mm\", "
            "\"taxels\". Taxels of other programs are read from a table: columns x, y, z, nx, ny, nz with their unit, "
            "\"x [mm]\"");
  EXPECT_EQ(error_of("{}"), "/format|is missing");
}

TEST(LayoutJson, NamesAMissingKey) {
  EXPECT_EQ(error_of(with("\"format\"", "\"_\"")), "/format|is missing");
  EXPECT_EQ(error_of(with("\"version\"", "\"_\"")), "/version|is missing");
  EXPECT_EQ(error_of(with("\"mesh\"", "\"_\"")), "/mesh/file|is missing");
  EXPECT_EQ(error_of(with("\"file\"", "\"_\"")), "/mesh/file|is missing");
  EXPECT_EQ(error_of(with("\"taxels\"", "\"_\"")), "/taxels|is missing");
  EXPECT_EQ(error_of(with("\"center\"", "\"_\"")), "/taxels/0/center|is missing");
  EXPECT_EQ(error_of(with("\"normal\"", "\"_\"")), "/taxels/0/normal|is missing");
  EXPECT_EQ(error_of(with("\"radius\"", "\"_\"")), "/taxels/0/radius|is missing");
}

TEST(LayoutJson, NamesTheKeyThatAMissingOneResembles) {
  EXPECT_EQ(error_of(with("\"center\"", "\"centre\"")),
            "/taxels/0/center|is missing; there is \"centre\"; did you mean \"center\"?");
  EXPECT_EQ(error_of(with("\"taxels\"", "\"Taxels\"")),
            "/taxels|is missing; there is \"Taxels\"; did you mean \"taxels\"?");
}

TEST(LayoutJson, NamesAnUnknownVersionOrFormat) {
  EXPECT_EQ(error_of(with("\"version\": 1", "\"version\": 7")),
            "/version|7 is unknown, this program reads version 1 and older ones");
  EXPECT_EQ(error_of(with("\"version\": 1", "\"version\": 1.5")),
            "/version|1.5 is unknown, this program reads version 1 and older ones");
  EXPECT_EQ(error_of(with("taxel-layout", "urdf")), "/format|must be \"taxel-layout\", is \"urdf\"");
}

TEST(LayoutJson, NamesLineAndColumnOfBrokenText) {
  EXPECT_EQ(error_of("{\n  \"format\": \"\xC3\xA9\xC3\xA9\" oops}"),
            "line 2, column 18|is not JSON: unexpected \"oops\"");
  EXPECT_EQ(error_of(""), "line 1, column 1|is not JSON: ends too early");
  EXPECT_EQ(error_of("{\"a\": nan}"), "line 1, column 8|is not JSON: unexpected \"nan\"");
  EXPECT_EQ(error_of("[\"1e999\", 1e-999,\n -12.5E+400]"),
            "line 2, column 2|is not JSON: the number -12.5E+400 is too large");
  EXPECT_EQ(error_of("[\"\xFF\"]"), "line 1, column 3|is not JSON: must be encoded as UTF-8");
  EXPECT_EQ(error_of(with("0.006", "1e999")), "line 3, column 67|is not JSON: the number 1e999 is too large");
  EXPECT_EQ(error_of(with("0.006", "1, \"radius\": 2")), "|has the key \"radius\" twice in one object");
  EXPECT_EQ(error_of(std::string(100000, '[')), "|is nested deeper than 64 levels");
}

TEST(LayoutJson, RefusesValuesThatJsonCannotHold) {
  Layout layout = full_layout();
  layout.taxels[1].subtaxels[0].center.y = std::numeric_limits<double>::quiet_NaN();
  try {
    layout_to_json(layout);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.where(), "/taxels/1/subtaxels/0/center/1");
  }
}

TEST(LayoutJson, SurvivesEveryCutAndEveryChangedByte) {
  const std::string text = layout_to_json(full_layout());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool whole = i + 1 == text.size();  // only the newline is cut
    if (!whole) {
      EXPECT_THROW(parse_layout(text.substr(0, i)), Error) << i;
    }
    std::string changed = text;
    changed[i] = static_cast<char>(changed[i] ^ 0x15);
    try {
      layout_to_json(parse_layout(changed));
    } catch (const Error&) {
      continue;
    }
  }
}

TEST(LayoutJson, ReadsWrittenFilesAndFindsTheirMeshes) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "written.taxels.json";
  write_layout(path, full_layout());
  EXPECT_EQ(read_layout(path), full_layout());
  std::filesystem::remove(path);
  EXPECT_THROW(read_layout(path), Error);

  Layout layout;
  layout.mesh.file = "../meshes/m.obj";
  EXPECT_EQ(mesh_path(layout, "/a/layouts/l.json"), "/a/meshes/m.obj");
  layout.mesh.file = "/b/m.obj";
  EXPECT_EQ(mesh_path(layout, "/a/layouts/l.json"), "/b/m.obj");
}

TEST(LayoutJson, ReadsTheRealLayout) {
  const std::filesystem::path file = std::filesystem::path(TAXEL_REAL_DATA) / "shadow_fingertip.taxels.json";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "absent: " << file;
  const Layout layout = read_layout(file);
  ASSERT_EQ(layout.taxels.size(), 12U);
  EXPECT_EQ(layout.taxels[3].name, "right pad mid");
  EXPECT_EQ(layout.taxels[3].center, dvec3(0.0035417, 0.0248569, 0.0055062));
  EXPECT_EQ(layout.mesh.scale, dvec3(0.001));
  EXPECT_TRUE(layout.unknown.empty());
  const std::string once = layout_to_json(layout);
  EXPECT_EQ(layout_to_json(parse_layout(once)), once);
}

}  // namespace
}  // namespace taxel
