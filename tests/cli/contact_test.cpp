// `taxel contact` and `taxel validate`: closed forms, action and reaction, velocities, polygons.
#include <cmath>
#include <numbers>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

Json case_of(const Json& a, const Json& b) {
  return {{"format", "contact-case"}, {"version", 1}, {"a", a}, {"b", b}};
}
Json soft_sphere(double height) {
  return {{"shape", {{"type", "sphere"}, {"size", {0.05}}}},
          {"resolution", 0.0085},
          {"material", {{"field", "medial_axis"}, {"modulus", 5.0e4}, {"dissipation", 0}, {"friction", 0.5}}},
          {"pos", {0, 0, height}}};
}
const Json kPlane = {{"shape", {{"type", "plane"}}}};

Json contact(const Json& contact_case, std::vector<std::string> options = {}) {
  const fs::path folder = test_folder();
  write_text(folder / "case.json", contact_case.dump());
  options.insert(options.begin(), {"contact", "case.json"});
  return taxel_json(options, folder);
}

std::vector<double> vector_of(const Json& json) {
  return json.get<std::vector<double>>();
}

void expect_opposite(const Json& one, const Json& other, const char* key) {
  const std::vector<double> a = vector_of(one[key]), b = vector_of(other[key]);
  const double size = std::hypot(a[0], a[1], a[2]);
  ASSERT_GT(size, 0);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], -b[i], 1e-10 * size);
}

TEST(Contact, EqualsA1ForASoftSphereOnAPlane) {
  const double R = 0.05, x = 0.0025, E = 5e4;
  const Json result = contact(case_of(soft_sphere(R - x), kPlane));
  const double force = std::numbers::pi * E * x * x * (1 - 2 * x / (3 * R));
  EXPECT_NEAR(result["force"][2].get<double>(), force, 0.03 * force);
  EXPECT_NEAR(result["area"].get<double>(), std::numbers::pi * (2 * R * x - x * x),
              0.03 * std::numbers::pi * 2 * R * x);
  EXPECT_NEAR(result["max_pressure"].get<double>(), E * x / R,
              0.06 * E * x / R);                                    // the largest pressure is that of one vertex
  EXPECT_NEAR(result["force"][0].get<double>(), 0, 1e-10 * force);  // a plane pushes only along its normal
  EXPECT_NEAR(result["centroid"][2].get<double>(), 0, 1e-12);
  EXPECT_EQ(result["rejected"], Json::array());
  EXPECT_EQ(result["warnings"], Json::array());
  EXPECT_GE(result["triangles"].get<int>(), result["polygons"].get<int>());
  EXPECT_GT(result["microseconds"].get<double>(), 0);
}

TEST(Contact, EqualsA2ForARigidSphereInASoftHalfSpace) {
  const double R = 0.02, x = 0.004, kappa = 5e4 / 0.05;
  const Json sphere = {{"shape", {{"type", "sphere"}, {"size", {R}}}}, {"resolution", 0.002}, {"pos", {0, 0, R - x}}};
  const Json ground = {{"shape", {{"type", "plane"}}}, {"material", {{"modulus", 5e4}, {"thickness", 0.05}}}};
  const Json result = contact(case_of(sphere, ground));
  const double force = kappa * std::numbers::pi * x * x * (R - x / 3);
  EXPECT_NEAR(result["force"][2].get<double>(), force, 0.03 * force);
  EXPECT_NEAR(result["area"].get<double>(), 2 * std::numbers::pi * R * x, 0.03 * 2 * std::numbers::pi * R * x);
}

TEST(Contact, EqualsA3ExactlyForARigidBoxInASoftHalfSpace) {
  // A box of 2a x 2b x 2c, rotated by 45 degrees about its long horizontal edge: the wedge below depth x has the
  // cross-section x^2, and its centroid is x/3 below the surface.
  const double half_length = 0.03, x = 0.01, kappa = 5e4 / 0.1, half = 0.02;
  const Json box = {{"shape", {{"type", "box"}, {"size", {half_length, half, half}}}},
                    {"pos", {0, 0, half * std::sqrt(2.0) - x}},
                    {"quat", {std::cos(std::numbers::pi / 8), std::sin(std::numbers::pi / 8), 0, 0}}};
  const Json ground = {{"shape", {{"type", "plane"}}}, {"material", {{"modulus", 5e4}, {"thickness", 0.1}}}};
  const Json result = contact(case_of(box, ground));
  const double force = kappa * x * x * 2 * half_length;
  EXPECT_NEAR(result["force"][2].get<double>(), force, 1e-10 * force);
  EXPECT_NEAR(result["max_pressure"].get<double>(), kappa * x, 1e-10 * kappa * x);
}

/// p = (E/H)(R - r) at any depth: F = (E/H) pi (R x^2 - 2/3 x^3), also below the thickness of the pad. The vertices of
/// a mesh with the exact volume are outside of the sphere, and p is (E/H) times the distance to the mesh, so the mesh
/// is fine.
TEST(Contact, HasNoHoleInAPadPressedDeeperThanItsThickness) {
  const double R = 0.05, kappa = 5e4 / 0.002;
  for (const double x : {0.0015, 0.003, 0.006}) {
    Json ball = soft_sphere(R - x);
    ball["resolution"] = 0.0022;
    ball["material"] = {{"field", "pad"}, {"modulus", 5e4}, {"thickness", 0.002}};
    const Json result = contact(case_of(ball, kPlane));
    const double force = kappa * std::numbers::pi * (R * x * x - 2.0 / 3.0 * x * x * x);
    EXPECT_NEAR(result["force"][2].get<double>(), force, 0.01 * force) << x;
    EXPECT_NEAR(result["max_pressure"].get<double>(), kappa * x, 0.01 * kappa * x) << x;
    EXPECT_EQ(result["warnings"], Json::array());
  }
}

TEST(Contact, PushesBWithMinusTheForceOnA) {
  Json a = soft_sphere(0.047), b = kPlane;
  a["quat"] = {0.3, 0.5, -0.2, 0.7};
  a["linear_velocity"] = {0.02, 0.01, -0.1};
  a["material"]["dissipation"] = 4;
  b["quat"] = {0.98, 0.1, 0.05, 0};
  const Json on_a = contact(case_of(a, b)), on_b = contact(case_of(b, a));
  EXPECT_EQ(on_a["polygons"], on_b["polygons"]);
  expect_opposite(on_a, on_b, "force");
  const std::vector<double> r{0, 0, 0.047};  // torques about two origins differ by r x F
  const std::vector<double> F = vector_of(on_a["force"]), at_a = vector_of(on_a["torque"]),
                            at_b = vector_of(on_b["torque"]);
  const double size = std::hypot(F[0], F[1], F[2]) * 0.047;
  EXPECT_NEAR(at_b[0], -(at_a[0] + r[1] * F[2] - r[2] * F[1]), 1e-10 * size);
  EXPECT_NEAR(at_b[1], -(at_a[1] + r[2] * F[0] - r[0] * F[2]), 1e-10 * size);
  EXPECT_NEAR(at_b[2], -(at_a[2] + r[0] * F[1] - r[1] * F[0]), 1e-10 * size);
}

TEST(Contact, AddsDampingAndFrictionForVelocities) {
  Json a = soft_sphere(0.0475);
  a["material"]["dissipation"] = 3;
  const auto force = [&](const Json& linear, const Json& angular, const Json& of_b) {
    Json moving = a, plane = kPlane;
    moving["linear_velocity"] = linear;
    moving["angular_velocity"] = angular;
    plane["linear_velocity"] = of_b;
    return vector_of(contact(case_of(moving, plane))["force"]);
  };
  const Json still = {0, 0, 0};
  const double rest = force(still, still, still)[2];
  // Hunt-Crossley: p = p0 (1 - d vn). A rising plane has the same effect as a falling sphere.
  EXPECT_NEAR(force({0, 0, -0.1}, still, still)[2], rest * 1.3, 1e-10 * rest);
  EXPECT_NEAR(force(still, still, {0, 0, 0.1})[2], rest * 1.3, 1e-10 * rest);
  EXPECT_NEAR(force({0, 0, 1}, still, still)[2], 0, 1e-10 * rest);  // nothing pulls on a body that leaves fast
  // Sliding with mu = 2 mu1 mu2/(mu1 + mu2) = 0.5, far above the regularisation speed of 0.1 mm/s
  const std::vector<double> sliding = force({0.5, 0, 0}, still, still);
  EXPECT_NEAR(sliding[0], -0.5 * rest * 2 / std::numbers::pi * std::atan(0.5 / 1e-4), 1e-6 * rest);
  // Rolling about y moves the contact point towards -x, so friction pushes towards +x.
  EXPECT_GT(force(still, {0, 10, 0}, still)[0], 0.49 * rest);
}

TEST(Contact, WritesTheSurfaceToThePolygonFile) {
  const fs::path folder = test_folder();
  write_text(folder / "case.json", case_of(soft_sphere(0.0475), kPlane).dump());
  const Json result = taxel_json({"contact", "case.json", "--polygons", "p.json", "--repeat", "3"}, folder);
  const Json file = Json::parse(file_text(folder / "p.json"));
  ASSERT_EQ(file["polygons"].size(), result["polygons"].get<std::size_t>());
  double area = 0, force = 0;
  int triangles = 0;
  for (const Json& polygon : file["polygons"]) {
    area += polygon["area"].get<double>();
    triangles += static_cast<int>(polygon["vertices"].size()) - 2;
    EXPECT_EQ(polygon["vertices"].size(), polygon["pressures"].size());
    EXPECT_NEAR(polygon["normal"][2].get<double>(), 1, 1e-12);
    for (std::size_t i = 2; i < polygon["vertices"].size();
         ++i) {  // area times mean of the corners is exact for a linear pressure
      const auto v = [&](std::size_t k) { return vector_of(polygon["vertices"][k]); };
      const double twice =
          (v(i - 1)[0] - v(0)[0]) * (v(i)[1] - v(0)[1]) - (v(i - 1)[1] - v(0)[1]) * (v(i)[0] - v(0)[0]);
      EXPECT_GE(twice, 0);
      force += twice / 6 *
               (polygon["pressures"][0].get<double>() + polygon["pressures"][i - 1].get<double>() +
                polygon["pressures"][i].get<double>());
    }
  }
  EXPECT_NEAR(area, result["area"].get<double>(), 1e-12 * area);
  EXPECT_NEAR(force, result["force"][2].get<double>(), 1e-10 * force);
  EXPECT_EQ(triangles, result["triangles"].get<int>());

  ASSERT_EQ(taxel({"contact", "case.json", "--polygons", "p.csv"}, folder).status, 0);
  const Table table = read_csv(folder / "p.csv");
  std::size_t corner = 0;
  for (const Json& polygon : file["polygons"]) {
    for (std::size_t i = 0; i < polygon["vertices"].size(); ++i, ++corner) {
      EXPECT_EQ(table.at("x").at(corner), polygon["vertices"][i][0].get<double>());
      EXPECT_EQ(table.at("pressure").at(corner), polygon["pressures"][i].get<double>());
      EXPECT_EQ(table.at("tet").at(corner), polygon["tet"].get<double>());
    }
  }
  EXPECT_EQ(corner, table.at("x").size());
}

TEST(Contact, FindsMeshesAndLayoutsInTheFolderOfTheCase) {
  const fs::path folder = test_folder();
  fs::create_directories(folder / "sub");
  fs::copy(fs::path(TAXEL_SOURCE_DIR) / "assets" / "meshes" / "fingertip.obj", folder / "sub" / "finger.obj");
  const fs::path layout = changed_layout(folder / "sub", Json::parse(R"([
      {"op": "replace", "path": "/mesh/file", "value": "finger.obj"},
      {"op": "replace", "path": "/sampling/density", "value": 1e5}])"));
  const Json material = Json::parse(file_text(layout))["material"];
  const Json pose = {0, 0, -0.030};
  write_text(folder / "sub" / "mesh.json", case_of({{"shape", {{"type", "mesh"}, {"file", "finger.obj"}}},
                                                    {"material", material},
                                                    {"pos", pose},
                                                    {"quat", {0, 1, 0, 0}}},
                                                   {{"shape", {{"type", "plane"}}}, {"pos", {0, 0, -0.059}}})
                                               .dump());
  write_text(folder / "sub" / "layout.json",
             case_of({{"layout", "changed.taxels.json"}, {"pos", pose}, {"quat", {0, 1, 0, 0}}},
                     {{"shape", {{"type", "plane"}}}, {"pos", {0, 0, -0.059}}})
                 .dump());
  Json mesh = taxel_json({"contact", "sub/mesh.json"}, folder),
       of_layout = taxel_json({"contact", "sub/layout.json"}, folder);
  EXPECT_GT(mesh["polygons"].get<int>(), 10);
  for (Json* json : {&mesh, &of_layout}) {
    json->erase("microseconds");
    json->erase("warnings");
  }
  EXPECT_EQ(mesh, of_layout);
}

TEST(Validate, FindsEveryClosedFormWithinItsBound) {
  const Json result = taxel_json({"validate"});
  EXPECT_EQ(result["pass"], true);
  std::map<std::string, int> forms;
  for (const Json& check : result["checks"]) {
    ++forms[check["form"]];
    EXPECT_LE(check["error"].get<double>(), check["bound"].get<double>()) << check;
    EXPECT_LE(check["bound"].get<double>(), 0.03);
    EXPECT_EQ(check["pass"], true);
  }
  EXPECT_EQ(forms.size(), 18U);  // A1 to A15, B1 to B3
  EXPECT_GE(forms["A1"], 2);
  EXPECT_GE(forms["B1"], 6);
}

TEST(Validate, WritesTheValidationPageOfTheDocuments) {
  const Outcome outcome = taxel({"validate", "--markdown"});
  ASSERT_EQ(outcome.status, 0);
  const std::string page = file_text(fs::path(TAXEL_SOURCE_DIR) / "docs" / "validation.md");
  EXPECT_EQ(outcome.out, page.substr(0, outcome.out.size())) << "run: scripts/validation --no-bench";
  // The rest of the page is from bench_artifact, which takes a minute.
  EXPECT_EQ(page.substr(outcome.out.size()).rfind("\n## The artifact of the paper\n", 0), 0U);
}

}  // namespace
}  // namespace taxel::test
