// Soft pairs without taxels through `taxel run`: closed forms A1 to A9 of the contact model, in MuJoCo scenes with
// fixed bodies, whose depth is known, or free bodies.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

constexpr double kGravity = 9.81;

/// Returns a scene with one `taxel.contact`.
std::string scene_of(const std::string& keys, const std::string& bodies,
                     const std::string& option = "gravity='0 0 0'") {
  return "<mujoco><option timestep='0.001' " + option +
         "/><extension><plugin plugin='taxel.contact'><instance name='soft'>" + keys +
         "</instance></plugin></extension><worldbody>" + bodies + "</worldbody></mujoco>";
}
std::string key(const std::string& name, const std::string& value) {
  return "<config key='" + name + "' value='" + value + "'/>";
}
std::string materials(const std::string& json) {
  return key("materials", "{" + json + "}");
}
/// Returns a body with one geom of this name.
std::string body(const std::string& name, const std::string& pos, const std::string& geom, const char* joint = "") {
  return "<body pos='" + pos + "'>" + joint + "<geom name='" + name + "' " + geom + "/></body>";
}

/// Returns the table that `taxel run` writes for the scene.
Table run_scene(const fs::path& folder, const std::string& xml, double seconds = 0.002) {
  write_text(folder / "scene.xml", xml);
  const Outcome outcome = taxel({"run", "scene.xml", "--seconds", fmt::format("{}", seconds), "--out", "out"}, folder);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return outcome.status == 0 ? read_csv(folder / "out" / "readings.csv") : Table{};
}

struct Contact {
  double force_z = 0, area = 0, polygons = 0;
};
/// The force on a soft geom in the first row.
Contact contact_of(const Table& table, const std::string& prefix = "") {
  if (table.empty()) return {};
  return {table.at(prefix + "force_z").front(), table.at(prefix + "area").front(),
          table.at(prefix + "polygons").front()};
}

constexpr double kModulus = 1e5;
const std::string kFloor = "<geom name='floor' type='plane' size='1 1 1'/>";

TEST(ContactPair, EqualsA1ForASoftSphereOnAPlane) {
  constexpr double R = 0.05, x = 0.0025;
  const Table table =
      run_scene(test_folder(),
                scene_of(materials(R"("ball": {"modulus": 1e5, "resolution": 0.005})") + key("pairs", "ball floor"),
                         kFloor + body("ball", fmt::format("0.3 0 {}", R - x), "type='sphere' size='.05'")));
  const Contact c = contact_of(table);
  EXPECT_NEAR(c.force_z, std::numbers::pi * kModulus * x * x * (1 - 2 * x / (3 * R)), 0.03 * c.force_z);
  EXPECT_NEAR(c.area, std::numbers::pi * (2 * R * x - x * x), 0.03 * c.area);
  EXPECT_GE(c.polygons, 10);
  // Without taxels there are no columns of taxels.
  EXPECT_EQ(table.size(), 7U);
}

TEST(ContactPair, EqualsA2ForARigidSphereInASoftHalfSpace) {
  constexpr double R = 0.05, x = 0.004, kappa = 1e5 / 0.02;
  const Contact c = contact_of(run_scene(
      test_folder(),
      scene_of(
          materials(R"("floor": {"modulus": 1e5, "thickness": 0.02}, "ball": {"resolution": 0.003, "friction": 0})"),
          kFloor + body("ball", fmt::format("0 0 {}", R - x), "type='sphere' size='.05'", "<freejoint/>"))));
  EXPECT_NEAR(-c.force_z, kappa * std::numbers::pi * x * x * (R - x / 3), 0.02 * -c.force_z);  // force on the floor
  EXPECT_NEAR(c.area, 2 * std::numbers::pi * R * x, 0.02 * c.area);
}

TEST(ContactPair, EqualsA3ForTheSubmergedVolumeOfAPolyhedron) {
  const Contact c = contact_of(run_scene(
      test_folder(), scene_of(materials(R"("floor": {"modulus": 2e5, "thickness": 0.04})") + key("pairs", "floor box"),
                              kFloor + body("box", "0 0 0.029", "type='box' size='.02 .01 .03'"))));
  EXPECT_NEAR(-c.force_z, 2e5 / 0.04 * (0.04 * 0.02 * 0.001), 1e-9);
}

TEST(ContactPair, EqualsA4ForASoftBoxOnAPlane) {
  constexpr double x = 0.002, L1 = 0.08, L2 = 0.06, H = 0.02;
  const Contact c = contact_of(
      run_scene(test_folder(), scene_of(materials(R"("box": {"modulus": 1e5})") + key("pairs", "floor box"),
                                        kFloor + body("box", "0 0 0.018", "type='box' size='.04 .03 .02'"))));
  const double force = kModulus / H * (x * L1 * L2 - x * x * (L1 + L2) + 4 * x * x * x / 3);
  EXPECT_NEAR(c.force_z, force, 1e-6 * force);
  EXPECT_NEAR(c.area, L1 * L2, 1e-6 * c.area);
}

TEST(ContactPair, EqualsA5ForASoftUprightCylinder) {
  constexpr double x = 0.002, R = 0.03, H = 0.03;
  const Contact c = contact_of(run_scene(
      test_folder(), scene_of(materials(R"("can": {"modulus": 1e5, "resolution": 0.003})") + key("pairs", "floor can"),
                              kFloor + body("can", "0 0 0.038", "type='cylinder' size='.03 .04'"))));
  const double force = std::numbers::pi * kModulus * (R * R * R - std::pow(R - x, 3)) / (3 * H);
  EXPECT_NEAR(c.force_z, force, 0.01 * force);
}

TEST(ContactPair, EqualsA6ForASoftLyingCylinder) {
  constexpr double x = 0.002, R = 0.02, h = R - x;
  const auto force_of = [&](double half_length) {
    return contact_of(
               run_scene(
                   test_folder(),
                   scene_of(materials(R"("log": {"modulus": 1e5, "resolution": 0.002})") + key("pairs", "floor log"),
                            kFloor + body("log", fmt::format("0 0 {}", h),
                                          fmt::format("type='cylinder' size='.02 {}' euler='0 90 0'", half_length)))))
        .force_z;
  };
  const double a = std::sqrt(R * R - h * h), per_length = kModulus * (a - h * h / R * std::asinh(a / h));
  EXPECT_NEAR((force_of(0.08) - force_of(0.06)) / 0.04, per_length, 0.02 * per_length);
}

TEST(ContactPair, EqualsA7ForTwoSoftSpheresWithOppositeForces) {
  const Table table = run_scene(
      test_folder(),
      scene_of(materials(R"("a": {"modulus": 1e5, "resolution": 0.003}, "b": {"modulus": 4e5, "resolution": 0.003})") +
                   key("geoms", "a b"),
               body("a", "0 0 0", "type='sphere' size='.05'") + body("b", "0 0 0.096", "type='sphere' size='.05'")));
  const Contact a = contact_of(table, "a/"), b = contact_of(table, "b/");
  EXPECT_NEAR(b.force_z, 1.9568, 0.01 * 1.9568);
  EXPECT_NEAR(a.force_z, -b.force_z, 1e-12);
  EXPECT_NEAR(a.area, 620.317e-6, 0.02 * a.area);
  EXPECT_NEAR(a.area, b.area, 1e-15);
  EXPECT_EQ(a.polygons, b.polygons);
}

TEST(ContactPair, EqualsA8ForStackedSlabsAndA4ForARigidOne) {
  constexpr double x = 0.0005, H = 0.01, L = 0.2;
  const auto press = [&](double upper, double lower) {
    const Table table = run_scene(
        test_folder(),
        scene_of(materials(fmt::format(R"("up": {{"modulus": {}}}, "low": {{"modulus": {}}})", upper, lower)) +
                     key("pairs", "up low"),
                 body("low", "0 0 -0.01", "type='box' size='.1 .1 .01'") +
                     body("up", fmt::format("0 0 {}", H - x), "type='box' size='.1 .1 .01'")));
    const Contact up = contact_of(table, "up/");
    EXPECT_NEAR(contact_of(table, "low/").force_z, -up.force_z, 1e-9 * up.force_z);
    return up.force_z;
  };
  const double expected = x / (H / 1e5 + H / 3e5) * L * L;  // except at a rim of width x
  EXPECT_NEAR(press(1e5, 3e5), expected, 0.01 * expected);
  const double rigid = kModulus / H * (x * L * L - x * x * 2 * L + 4 * x * x * x / 3);  // A4
  EXPECT_NEAR(press(1e5, 1e11), rigid, 0.002 * rigid);
}

TEST(ContactPair, CarriesTheWeightOfABallAtRest) {
  constexpr double mass = 0.2, R = 0.03;
  const Table table = run_scene(
      test_folder(),
      scene_of(
          materials(R"("ball": {"modulus": 1e5, "dissipation": 10, "resolution": 0.002})") + key("pairs", "ball floor"),
          kFloor + body("ball", "0 0 0.03", "type='sphere' size='.03' mass='.2' contype='0' conaffinity='0'",
                        "<freejoint/>"),
          "gravity='0 0 -9.81'"),
      1.0);
  ASSERT_FALSE(table.empty());
  const double weight = mass * kGravity, force = table.at("force_z").back();
  EXPECT_NEAR(force, weight, 1e-3 * weight);
  // Solves pi E x^2 (1 - 2x/(3R)) = m g for x.
  double x = 0;
  for (int n = 0; n < 50; ++n) x = std::sqrt(weight / (std::numbers::pi * kModulus * (1 - 2 * x / (3 * R))));
  EXPECT_NEAR(table.at("area").back(), std::numbers::pi * (2 * R * x - x * x), 0.04 * table.at("area").back());
}

/// Returns the positions of a soft geom in all rows, world frame [m].
std::vector<std::array<double, 3>> positions(const fs::path& folder, const std::string& prefix = "") {
  const std::vector<double> flat =
      parse_npz(file_text(folder / "out" / "readings.npz")).at(prefix + "sensor_pos").doubles();
  std::vector<std::array<double, 3>> rows;
  for (std::size_t i = 0; i + 3 <= flat.size(); i += 3) rows.push_back({flat[i], flat[i + 1], flat[i + 2]});
  return rows;
}

/// Returns a scene with a soft block of 0.5 kg on a plane under gravity that is tilted by an angle, as on a slope.
std::string slope(double angle, double x) {
  return scene_of(
      materials(R"("block": {"modulus": 1e6, "dissipation": 20, "friction": 0.5}, "floor": {"friction": 0.5})") +
          key("pairs", "block floor"),
      kFloor + body("block", fmt::format("0 0 {}", 0.02 - x),
                    "type='box' size='.04 .04 .02' mass='.5' contype='0' conaffinity='0'", "<freejoint/>"),
      fmt::format("gravity='{} 0 {}'", kGravity * std::sin(angle), -kGravity * std::cos(angle)));
}

TEST(ContactPair, LetsABlockOnASlopeCreepOrAccelerate) {
  constexpr double mu = 0.5, h = 0.001;
  const double rest = 0.5 * kGravity * 0.02 / (1e6 * 0.08 * 0.08);  // m g H/(E A)
  const auto speed = [&](double angle, double seconds) {
    const fs::path folder = test_folder();
    if (run_scene(folder, slope(angle, rest), seconds).empty()) return 0.0;
    const auto p = positions(folder);
    return (p[p.size() - 1][0] - p[p.size() - 51][0]) / (50 * h);
  };
  const double gentle = std::atan(0.6 * mu);
  const double creep = 1e-4 * std::tan(0.5 * std::numbers::pi * std::tan(gentle) / mu);
  EXPECT_NEAR(speed(gentle, 0.4), creep, 0.02 * creep);
  const double steep = std::atan(1.6 * mu), acceleration = kGravity * (std::sin(steep) - mu * std::cos(steep));
  EXPECT_NEAR(speed(steep, 0.2), acceleration * (0.2 - 25.5 * h), 0.03 * acceleration * 0.2);
}

TEST(ContactPair, LosesEnergyInABounceAndBoundsTheSpeedAfterIt) {
  constexpr double dissipation = 1.5, h = 0.001;
  const fs::path folder = test_folder();
  const std::string xml = scene_of(
      materials(
          fmt::format(R"("ball": {{"modulus": 2e5, "dissipation": {}}}, "anvil": {{"modulus": 8e5}})", dissipation)) +
          key("geoms", "ball anvil"),
      body("anvil", "0 0 -0.1", "type='box' size='.1 .1 .1' contype='0' conaffinity='0'") +
          body("ball", "0 0 0.13", "type='sphere' size='.03' mass='.1' contype='0' conaffinity='0'", "<freejoint/>"),
      "gravity='0 0 -9.81'");
  const Table table = run_scene(folder, xml, 1.2);
  ASSERT_FALSE(table.empty());
  const std::vector<double>& force = table.at("ball/force_z");
  std::vector<double> z;
  for (const auto& p : positions(folder, "ball/")) z.push_back(p[2]);
  // The energy of free flight between contacts never grows.
  double last = 1e9, fastest = 0;
  int flights = 0;
  for (std::size_t i = 1; i + 1 < z.size(); ++i) {
    const double v = (z[i + 1] - z[i]) / h;
    if (force[i] != 0 || force[i + 1] != 0) continue;
    const double energy = 0.5 * v * v + kGravity * (z[i] + z[i + 1]) / 2;
    EXPECT_LE(energy, last * (1 + 1e-4));
    flights += energy < 0.99 * last ? 1 : 0;
    last = energy;
    fastest = std::max(fastest, v);
  }
  EXPECT_GE(flights, 3);
  EXPECT_LE(fastest, 1 / (0.8 * dissipation));  // d* = (8e5 d + 2e5 0)/1e6
  EXPECT_GT(fastest, 0.05);
}

TEST(ContactPair, MovesNothingIfItsForcesAreOnlySensed) {
  const fs::path folder = test_folder();
  const Table table = run_scene(
      folder,
      scene_of(
          materials(R"("ball": {"modulus": 1e5})") + key("pairs", "ball floor") + key("force", "sense"),
          kFloor + body("ball", "0 0 0.048", "type='sphere' size='.05' contype='0' conaffinity='0'", "<freejoint/>")),
      0.05);
  ASSERT_FALSE(table.empty());
  EXPECT_GT(table.at("force_z").front(), 0.1);
  EXPECT_EQ(table.at("force_z").front(), table.at("force_z").back());
}

TEST(ContactPair, RefusesBadInputByACompileErrorThatNamesIt) {
  const fs::path folder = test_folder();
  const std::string bodies = kFloor + body("a", "0 0 1", "size='.1'") + body("b", "0 0 2", "size='.1'");
  const auto refusal = [&](const std::string& keys) {
    write_text(folder / "scene.xml", scene_of(keys, bodies));
    const Outcome outcome = taxel({"run", "scene.xml"}, folder);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    return outcome.err;
  };
  const auto expect_part = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  const std::string soft = materials(R"("a": {"modulus": 1e5})");
  expect_part(refusal(key("pairs", "a b")), "taxel.contact \"soft\": materials: is required");
  expect_part(refusal(materials(R"("gone": {"modulus": 1e5})")), "materials: there is no geom named \"gone\"");
  expect_part(refusal(materials(R"("a": {"modulus": 1e5}, "a": {"modulus": 2e5})")), "a");
  expect_part(refusal(materials(R"("a": {"modulos": 1e5})")), "/a/modulos: unknown key");
  expect_part(refusal(materials(R"("a": {"modulus": -1})")), "/a/modulus");
  expect_part(refusal(materials(R"("a": {"friction": 1})")), "materials: names no soft geom");
  expect_part(refusal(materials(R"("floor": {"modulus": 1e5})")), "a soft plane needs a thickness");
  expect_part(refusal(soft + key("pairs", "a gone")), "pairs: there is no geom named \"gone\"");
  expect_part(refusal(soft + key("pairs", "b floor")), "\"b\" and \"floor\" are both rigid");
  expect_part(refusal(soft + key("pairs", "a")), "pairs: must be pairs of geom names");
  expect_part(refusal(soft + key("pairs", "a a")), "paired with itself");
  expect_part(refusal(soft + key("geoms", "b floor")), "geoms: names no two geoms");
  expect_part(refusal(soft + key("geoms", "a b") + key("pairs", "a b")), "pairs: excludes \"geoms\"");
  expect_part(refusal(soft + key("force", "push")), "force: must be \"apply\" or \"sense\"");
  expect_part(refusal(soft + key("taste", "sweet")), "taste");
}

TEST(ContactPair, RefusesTwoInstancesForOneGeom) {
  const fs::path folder = test_folder();
  std::string xml = scene_of(materials(R"("a": {"modulus": 1e5})"), body("a", "0 0 1", "size='.1'"));
  const std::string instance = "<instance name='other'>" + materials(R"("a": {"modulus": 2e5})") + "</instance>";
  xml.insert(xml.find("</plugin>"), instance);
  write_text(folder / "scene.xml", xml);
  const Outcome outcome = taxel({"run", "scene.xml"}, folder);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("geom \"a\" has two materials, of \"soft\" and \"other\""), std::string::npos)
      << outcome.err;
}

/// Returns a scene with a soft ball, a soft can and a rigid floor with the fields of the predecessor's scenes.
std::string old_scene(int apply) {
  return fmt::format(
      "<mujoco><option collision='all' timestep='0.001'/><size nconmax='3000' njmax='4000'/><custom>"
      "<text name='cs::HydroelasticContactRepresentation' data='kPolygon'/>"
      "<numeric name='cs::ApplyContactSurfaceForces' data='{}'/><numeric name='cs::ground' data='0 1.0 0.1 0.3 0.3'/>"
      "<numeric name='cs::ball' data='5e4 5.0 0.05 0.3 0.3'/><numeric name='cs::can' data='7e4 5 0.005 0.3 0.3'/>"
      "</custom><worldbody><geom name='ground' type='plane' size='0 0 1'/>"
      "<body pos='0 0 0.05'><freejoint/><geom name='ball' type='sphere' size='.05' mass='.1'/></body>"
      "<body pos='.3 0 0.05'><freejoint/><geom name='can' type='cylinder' size='.05 .05' mass='.1'/></body>"
      "<body pos='.3 0 0.15'><freejoint/><geom name='rider' type='box' size='.04 .04 .0499' mass='.1'/></body>"
      "</worldbody></mujoco>",
      apply);
}

TEST(ContactPair, RunsASceneOfThePredecessorWithoutTaxels) {
  const fs::path folder = test_folder();
  const Table table = run_scene(folder, old_scene(1), 0.4);
  ASSERT_FALSE(table.empty());
  EXPECT_NEAR(table.at("ball/force_z").back(), 0.1 * kGravity, 0.02);
  // The rider has no field, so MuJoCo carries it on the can.
  EXPECT_NEAR(table.at("can/force_z").back(), 0.2 * kGravity, 0.05);
  // The written folder runs in the same way, with one contact.
  const Outcome again = taxel({"run", "out/scene.xml", "--seconds", "0.4", "--out", "again"}, folder);
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_NEAR(read_csv(folder / "again" / "readings.csv").at("ball/force_z").back(), 0.1 * kGravity, 0.02);
  const Table sensed = run_scene(folder, old_scene(0), 0.4);
  ASSERT_FALSE(sensed.empty());
  // MuJoCo's stiffer contact carries the ball on the surface of the can.
  EXPECT_LT(sensed.at("ball/force_z").back(), 0.5 * 0.1 * kGravity);
}

TEST(ContactPair, IsRefusedByCommandsThatReadTaxels) {
  const fs::path folder = test_folder();
  run_scene(folder, scene_of(materials(R"("ball": {"modulus": 1e5})") + key("pairs", "ball floor"),
                             kFloor + body("ball", "0 0 0.048", "type='sphere' size='.05'")));
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"models", "out"}, {"explain", "out", "--taxel", "0", "--time", "0"}}) {
    const Outcome outcome = taxel(command, folder);
    EXPECT_EQ(outcome.status, 2) << command[0];
    EXPECT_NE(outcome.err.find("has only soft geoms without taxels"), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace taxel::test
