// Problems in the sensing of a layout: `taxel check` and `taxel samples` report each one with the taxel's id, also a
// taxel that can only read 0. Nothing crashes.
#include <algorithm>
#include <cmath>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

constexpr double kHalf = 0.01, kCavity = 0.006, kIsland = 0.003;  // half sizes of nested boxes [m]

Json operation(const char* op, const std::string& path, const Json& value) {
  return {{"op", op}, {"path", path}, {"value", value}};
}
Json replaced(const std::string& path, const Json& value) {
  return Json::array({operation("replace", path, value)});
}

/// Returns the problem with this code of a file, or null if it is not listed exactly once.
Json problem(const fs::path& file, const std::string& code) {
  const Outcome outcome = taxel({"check", file.string(), "--json"});
  const Json report = Json::parse(outcome.out);
  Json found;
  int count = 0;
  for (const Json& p : report["problems"])
    if (p["code"] == code) found = p, ++count;
  EXPECT_EQ(count, 1) << code << " in " << outcome.out;
  return count == 1 ? found : Json();
}

/// Expects `taxel check` to list an error with this code, place and message, and `taxel samples` to stop with it.
void expect_error(const fs::path& layout, const std::string& code, const std::string& pointer,
                  const std::string& message) {
  const Json p = problem(layout, code);
  EXPECT_EQ(p, Json({{"file", layout.string()},
                     {"pointer", pointer},
                     {"severity", "error"},
                     {"code", code},
                     {"message", message},
                     {"fix", p["fix"]}}));
  expect_refusal(taxel({"samples", layout.string()}), "taxel: " + layout.string() + ": " + pointer + ": " + message);
}

/// Expects `taxel check` to list a warning with this code, place and message, and `taxel samples` to print it and
/// continue.
void expect_warning(const fs::path& layout, const std::string& code, const std::string& pointer,
                    const std::string& message) {
  const Json p = problem(layout, code);
  EXPECT_EQ(p["pointer"], pointer);
  EXPECT_EQ(p["severity"], "warning");
  EXPECT_EQ(p["message"], message);
  const Outcome samples = taxel({"samples", layout.string(), "--density", "1e5"});
  EXPECT_EQ(samples.status, 0);
  EXPECT_NE(samples.err.find(pointer + ": " + message), std::string::npos) << samples.err;
}

TEST(BadSensing, IsRefusedForValuesOutOfRange) {
  const fs::path folder = test_folder();
  const auto error = [&](const std::string& pointer, const Json& value, const char* code, const std::string& message) {
    expect_error(changed_layout(folder, replaced(pointer, value)), code, pointer, message);
  };
  error("/taxels/3/radius", 0, "radius_not_positive", "must be greater than 0, is 0 (taxel 3)");
  error("/taxels/3/normal", {0, 0, 0}, "zero_normal", "must be a direction, is [0, 0, 0] (taxel 3)");
  error("/receptive_field/max_angle_deg", 0, "angle_out_of_range",
        "must be greater than 0 and at most 180 degrees, is 0");
  error("/sampling/density", 0, "density_not_positive", "must be greater than 0, is 0");
}

// JSON has no NaN. The word is refused with its line, and so is a number that is too large for a double.
TEST(BadSensing, IsRefusedForNumbersThatAreNotFinite) {
  const fs::path folder = test_folder();
  const std::string text = file_text(changed_layout(folder, replaced("/taxels/3/radius", 12345)));
  for (const char* nonsense : {"NaN", "nan", "1e999", "Infinity"}) {
    std::string broken = text;
    broken.replace(broken.find("12345"), 5, nonsense);
    write_text(folder / "nan.taxels.json", broken);
    for (const char* command : {"check", "samples"}) {
      const Outcome outcome = taxel({command, "nan.taxels.json"}, folder);
      EXPECT_EQ(outcome.status, 2) << nonsense;
      EXPECT_EQ(outcome.err.rfind("taxel: nan.taxels.json: ", 0), 0U) << outcome.err;
      EXPECT_NE(outcome.err.find("is not JSON"), std::string::npos) << outcome.err;
    }
  }
  write_text(folder / "null.taxels.json", std::string(text).replace(text.find("12345"), 5, "null"));
  expect_refusal(taxel({"samples", "null.taxels.json"}, folder),
                 "taxel: null.taxels.json: /taxels/3/radius: must be a number, is null");
}

TEST(BadSensing, IsReportedForPlacesAndSizes) {
  const fs::path folder = test_folder();
  expect_error(changed_layout(folder, replaced("/taxels/5/center", {0, 0, 0.1305})), "center_off_surface",
               "/taxels/5/center", "is 100 mm from the surface, the radius is 6 mm (taxel 5)");
  expect_warning(changed_layout(folder, replaced("/taxels/5/radius", 0.5)), "radius_exceeds_body", "/taxels/5/radius",
                 "0.5 m is larger than the whole mesh, 0.0386 m (taxel 5)");
  const Json taxels = Json::parse(file_text(fingertip_layout()))["taxels"];
  const Json twins = Json::array({operation("replace", "/taxels/7/center", taxels[2]["center"]),
                                  operation("replace", "/taxels/7/normal", taxels[2]["normal"]),
                                  operation("replace", "/taxels/7/id", 70)});
  expect_warning(changed_layout(folder, twins), "duplicate_place", "/taxels/7/center",
                 "is the same place as /taxels/2 (taxel 70)");
}

TEST(BadSensing, IsRefusedForMoreThanTenMillionSamples) {
  const fs::path folder = test_folder();
  const fs::path layout = changed_layout(folder, replaced("/sampling/density", 1e11));
  const Json p = problem(layout, "density_too_high");
  EXPECT_EQ(p["pointer"], "/sampling/density");
  EXPECT_EQ(p["severity"], "error");
  const std::string message = p["message"];
  EXPECT_NE(message.find("samples, the limit is 10000000"), std::string::npos) << message;
  expect_refusal(taxel({"samples", layout.string()}), "taxel: " + layout.string() + ": /sampling/density: " + message);
  expect_refusal(taxel({"samples", fingertip_layout().string(), "--density", "1e11"}),
                 "taxel: " + fingertip_layout().string() + ": /sampling/density: " + message);
}

/// Returns the reading of the layout in a contact.
Json reading_of(const fs::path& folder, std::vector<std::string> options = {}) {
  fs::copy(fs::path(TAXEL_SOURCE_DIR) / "tests" / "golden" / "finger_on_box.json", folder,
           fs::copy_options::overwrite_existing);
  std::vector<std::string> arguments{"read", "changed.taxels.json", "finger_on_box.json"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return taxel_json(arguments, folder);
}

// Too few samples for a small field, or a normal that no face has: the taxel reads 0, with a warning.
TEST(BadSensing, ReadsZeroWithAWarningIfAFieldHasNoSamples) {
  const fs::path folder = test_folder();
  const auto expect_zero = [&](const Json& patch, const char* code, const std::string& message) {
    const fs::path layout = changed_layout(folder, patch);
    expect_warning(layout, code, "/taxels/9", message);
    const Json counts = taxel_json({"samples", layout.string(), "--density", "1e5", "--out", "s.csv"}, folder);
    EXPECT_EQ(counts["taxels"][9]["id"], 90);
    EXPECT_EQ(counts["taxels"][9]["samples"], 0);
    const Json read = reading_of(folder, {"--density", "1e5"});
    for (const auto& [how, values] : read["readings"].items()) EXPECT_EQ(values[9], 0.0) << how;
    EXPECT_EQ(read["taxels"][9]["covered"], 0);
    EXPECT_EQ(read["taxels"][9]["samples"], Json::array());
  };
  const Json id = operation("replace", "/taxels/9/id", 90);
  expect_zero(
      Json::array({id, operation("replace", "/taxels/9/radius", 2e-5), operation("replace", "/sampling/density", 1e5)}),
      "field_without_samples", "no sample lies in the receptive field: it will read 0 (taxel 90)");
  const Json normal = Json::parse(file_text(fingertip_layout()))["taxels"][9]["normal"];
  const Json inward = {-normal[0].get<double>(), -normal[1].get<double>(), -normal[2].get<double>()};
  expect_zero(Json::array({id, operation("replace", "/taxels/9/normal", inward),
                           operation("replace", "/taxels/9/radius", 0.002)}),
              "field_empty",
              "no surface within 2 mm has a normal within 45 degrees of the taxel's: it will read 0 "
              "(taxel 90)");
}

/// A box with a cavity, and an island in the cavity; a taxel on top of the box and one on top of the island.
fs::path nested_layout(const fs::path& folder, const Json& sampling) {
  write_text(folder / "nested.obj", box_obj(kHalf, 1) + box_obj(kCavity, 9, false) + box_obj(kIsland, 17));
  Json layout = Json::parse(file_text(fingertip_layout()));
  Json taxel = layout["taxels"][0], inner = taxel;
  for (Json* t : {&taxel, &inner}) (*t)["normal"] = {0, 0, 1}, (*t)["radius"] = 0.002;
  taxel["center"] = {0, 0, kHalf};
  inner["center"] = {0, 0, kIsland};
  inner["id"] = 1;
  layout["mesh"] = {{"file", "nested.obj"}};
  layout["material"]["thickness"] = 0.001;
  layout["taxels"] = Json::array({taxel, inner});
  layout["sampling"] = sampling;
  write_text(folder / "nested.taxels.json", layout.dump());
  return folder / "nested.taxels.json";
}

// Inner shells are sensed only on request; a note says so.
TEST(BadSensing, OmitsCavitiesAndIslandsUnlessRequested) {
  const fs::path folder = test_folder();
  const auto samples = [&](const fs::path& layout, double area) {
    const Json counts = taxel_json({"samples", layout.string(), "--quiet", "--out", "f.csv"}, folder);
    EXPECT_NEAR(counts["area"].get<double>(), area, 1e-12);
    EXPECT_EQ(counts["samples"], std::round(2e6 * area));
    EXPECT_GT(counts["taxels"][0]["samples"], 10);
    return counts["taxels"][1]["samples"].get<int>();
  };
  const auto faces = [&] {
    const std::vector<double> all = read_csv(folder / "f.csv").at("face");
    return *std::max_element(all.begin(), all.end());
  };
  const double outer = 24 * kHalf * kHalf, all = outer + 24 * (kCavity * kCavity + kIsland * kIsland);

  // The taxel on the island is farther from the skin than its radius, which is an error unless the island is sensed.
  const fs::path left_out = nested_layout(folder, {{"density", 2e6}});
  const Json said = problem(left_out, "mesh_has_cavity");
  EXPECT_EQ(said["severity"], "note");
  EXPECT_EQ(said["message"], "has enclosed shells (24 of 36 faces): no sample lies on them");
  EXPECT_EQ(problem(left_out, "center_off_surface")["message"],
            "is 7 mm from the surface, the radius is 2 mm (taxel 1)");
  Json without = Json::parse(file_text(left_out));
  without["taxels"].erase(1);
  write_text(folder / "without.taxels.json", without.dump());
  const Json counts = taxel_json({"samples", "without.taxels.json", "--quiet", "--out", "f.csv"}, folder);
  EXPECT_NEAR(counts["area"].get<double>(), outer, 1e-12);
  EXPECT_LT(faces(), 12);

  const fs::path asked = nested_layout(folder, {{"density", 2e6}, {"shells", "all"}});
  EXPECT_EQ(problem(asked, "mesh_has_cavity")["message"],
            "has enclosed shells (24 of 36 faces): they are sampled as well, but only the outer ones can be touched");
  EXPECT_GT(samples(asked, all), 10);
  EXPECT_GE(faces(), 24) << "the island's faces";
  const fs::path unknown = nested_layout(folder, {{"density", 2e6}, {"shells", "inner"}});
  expect_refusal(taxel({"samples", unknown.string()}),
                 "taxel: " + unknown.string() + R"(: /sampling/shells: must be one of "outer", "all", is "inner")");
}

TEST(BadSensing, IsNamedByASweepWithMissingTaxels) {
  const fs::path layout =
      changed_layout(test_folder(), Json::parse(R"([{"op": "replace", "path": "/taxels", "value": []},
                                                    {"op": "replace", "path": "/sampling/density", "value": 1e5}])"));
  const Outcome swept = taxel({"sweep", "--layout", layout.string()});
  EXPECT_EQ(swept.status, 2);
  EXPECT_NE(swept.err.find("taxel: " + layout.string() + ": /taxels: has none: a scenario has nothing to read. Place "),
            std::string::npos)
      << swept.err;
  for (const char* help : {"taxelstudio", "taxel presets NAME --out FILE", "--layout SENSOR.yaml --mesh MESH"})
    EXPECT_NE(swept.err.find(help), std::string::npos) << swept.err;
}

}  // namespace
}  // namespace taxel::test
