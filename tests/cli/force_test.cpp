// Forces and shear of taxels add up to the contact's force and follow Coulomb's law.
#include <algorithm>
#include <cmath>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;
using Vector = std::vector<double>;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Json read(const fs::path& folder) {
  return taxel_json({"read", "fingertip.taxels.json", "case.json"}, folder);
}

TEST(Read, AddsForcesAndTheUncoveredRestUpToTheContact) {
  for (const char* metric : {"euclidean", "geodesic"}) {
    const fs::path folder =
        finger_on_box(R"([{"op": "add", "path": "/receptive_field/metric", "value": ")" + std::string(metric) + "\"}]");
    const Json result = read(folder);
    const Vector force = result["force"].get<Vector>(), readings = result["readings"]["force"].get<Vector>();
    Vector sum = result["uncovered"]["normal_force"].get<Vector>();
    double shares = result["uncovered"]["force"], largest = 0;
    for (std::size_t k = 0; k < readings.size(); ++k) {
      const Vector normal = result["taxels"][k]["normal_force"].get<Vector>();
      for (std::size_t i = 0; i < 3; ++i) sum[i] += normal[i];
      EXPECT_LE(std::sqrt(dot(normal, normal)), readings[k] * (1 + 1e-12) + 1e-15);
      shares += readings[k], largest = std::max(largest, readings[k]);
    }
    const double size = std::sqrt(dot(force, force));
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(sum[i], force[i], 1e-10 * size);
    EXPECT_GE(shares, size);  // pressures push in more than one direction
    EXPECT_GT(largest, 0.1 * size);
    EXPECT_EQ(result["shear"], Json(std::vector<Vector>(12, Vector{0, 0})));
    const Outcome text = taxel({"read", "fingertip.taxels.json", "case.json"}, folder);
    EXPECT_NE(text.out.find("force that no taxel reaches: "), std::string::npos) << text.out;
  }
}

TEST(Read, GivesForcesThatDoNotDependOnTheTaxelOrder) {
  const fs::path folder = finger_on_box();
  const Json before = read(folder)["readings"]["force"];
  Json layout = Json::parse(file_text(folder / "fingertip.taxels.json"));
  std::reverse(layout["taxels"].begin(), layout["taxels"].end());
  write_text(folder / "fingertip.taxels.json", layout.dump());
  Json after = read(folder)["readings"]["force"];
  std::reverse(after.begin(), after.end());
  EXPECT_EQ(before, after);
}

// On a plane all polygons have the same normal, so friction is one vector times the pressure for every aggregate.
TEST(Read, GivesTheFrictionCoefficientAsShearOverReading) {
  for (const char* aggregate : {"weighted_mean", "max", "force"}) {
    const fs::path folder =
        finger_on_box(R"([{"op": "add", "path": "/readout/aggregate", "value": ")" + std::string(aggregate) + "\"}]");
    Json contact = Json::parse(file_text(folder / "case.json"));
    contact["a"]["linear_velocity"] = {0.003, -0.004, 0};
    contact["b"] = {{"shape", {{"type", "plane"}}}, {"pos", {0, 0, 0.0505}}, {"material", {{"friction", 0.5}}}};
    write_text(folder / "case.json", contact.dump());
    const Json result = read(folder);
    const Vector readings = result["readings"][aggregate].get<Vector>();
    const double friction = 0.5 * 2 / std::acos(-1.0) * std::atan(0.005 / 1e-4);
    double largest = 0;
    for (std::size_t k = 0; k < readings.size(); ++k) {
      const Vector against{-0.6, 0.8, 0};
      for (std::size_t i = 0; i < 2; ++i) {
        const double expected = friction * readings[k] * dot(against, result["taxels"][k]["tangents"][i].get<Vector>());
        EXPECT_NEAR(result["shear"][k][i].get<double>(), expected, 1e-9 * (std::abs(expected) + readings[k]))
            << aggregate;
      }
      largest = std::max(largest, readings[k]);
    }
    EXPECT_GT(largest, 0);
  }
}

const std::vector<std::string> kShort{"--object", "box", "--before", "0.002", "--past", "0.004"};

fs::path sweep_of(const fs::path& folder, const std::string& patch) {
  Json changes = Json::parse(R"([{"op": "replace", "path": "/sampling/density", "value": 1e6}])");
  for (const Json& change : Json::parse(patch)) changes.push_back(change);
  const fs::path layout = changed_layout(folder, changes);
  std::vector<std::string> arguments{"sweep", "--quiet", "--layout", layout.string(), "--out", "out"};
  arguments.insert(arguments.end(), kShort.begin(), kShort.end());
  const Outcome outcome = taxel(arguments, folder);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return folder / "out";
}

TEST(Sweep, WritesShearToItsOwnFileAndKeepsTheReadings) {
  const fs::path folder = test_folder();
  fs::create_directory(folder / "with");
  fs::create_directory(folder / "without");
  const fs::path with = sweep_of(folder / "with", R"([{"op": "add", "path": "/readout/shear", "value": true}])");
  const fs::path without = sweep_of(folder / "without", "[]");
  EXPECT_EQ(file_text(with / "readings.csv"), file_text(without / "readings.csv"));
  EXPECT_FALSE(fs::exists(without / "shear.csv"));
  const Table readings = read_csv(with / "readings.csv"), shear = read_csv(with / "shear.csv");
  ASSERT_EQ(shear.size(), 2U + 24U);
  EXPECT_EQ(shear.at("travel"), readings.at("travel"));
  double largest = 0;
  for (int id = 0; id < 12; ++id) {
    const std::string name = "taxel_" + std::to_string(id);
    for (std::size_t row = 0; row < readings.at(name).size(); ++row) {
      const double s = std::hypot(shear.at(name + "_e1")[row], shear.at(name + "_e2")[row]);
      EXPECT_LE(s, 0.5 * readings.at(name)[row] * 1.1 + 1e-9) << "never more than friction holds, damping included";
      largest = std::max(largest, s);
    }
  }
  EXPECT_GT(largest, 100);  // Pa
  const auto arrays = parse_npz(file_text(with / "readings.npz"));
  const std::size_t rows = readings.at("travel").size();
  EXPECT_EQ(arrays.at("shear").shape, (std::vector<std::size_t>{rows, 12, 2}));
  EXPECT_EQ(arrays.at("tangents").shape, (std::vector<std::size_t>{12, 2, 3}));
  EXPECT_EQ(arrays.at("shear").doubles()[(30 * 12 + 10) * 2 + 1], shear.at("taxel_10_e2")[30]);
}

TEST(Sweep, RecordsForcesInNewtonsAndTheUncoveredForce) {
  const fs::path folder = test_folder();
  const fs::path out = sweep_of(folder, R"([{"op": "add", "path": "/readout/aggregate", "value": "force"}])");
  const Table table = read_csv(out / "readings.csv");
  const auto arrays = parse_npz(file_text(out / "readings.npz"));
  const std::vector<double> uncovered = arrays.at("uncovered").doubles();
  ASSERT_EQ(uncovered.size(), 3 * table.at("travel").size());
  double largest = 0, rest = 0;
  for (std::size_t row = 0; row < table.at("travel").size(); ++row) {
    double sum = std::hypot(uncovered[3 * row], uncovered[3 * row + 1], uncovered[3 * row + 2]);
    rest = std::max(rest, sum);
    for (int id = 0; id < 12; ++id) sum += table.at("taxel_" + std::to_string(id))[row];
    const double force = std::hypot(table.at("force_x")[row], table.at("force_y")[row], table.at("force_z")[row]);
    EXPECT_GE(sum, 0.8 * force) << row;  // friction of 0.5 and damping are part of the force
    largest = std::max(largest, sum);
  }
  EXPECT_GT(largest, 0.1);
  const Json sensor = Json::parse(file_text(out / "sweep.json"))["sensors"][0];
  EXPECT_EQ(sensor["aggregate"], "force");
  EXPECT_NEAR(sensor["largest_uncovered"].get<double>(), rest, 1e-12 * rest);
  EXPECT_NE(arrays.at("units").texts()[0].find(R"("readings": "N")"), std::string::npos);
}

TEST(Check, RefusesShearThatIsNotTrueOrFalse) {
  const fs::path folder = finger_on_box(R"([{"op": "add", "path": "/readout/shear", "value": 1}])");
  const Outcome outcome = taxel({"read", "fingertip.taxels.json", "case.json"}, folder);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("/readout/shear: must be true or false, is 1"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace taxel::test
