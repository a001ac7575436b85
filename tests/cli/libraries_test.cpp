// Results of libraries that a user sees: half-edges (OpenMesh), GLB (tinygltf), rotations (GLM), JSON (nlohmann-json).
#include <cmath>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

/// Writes a layout with one taxel on top of a box with half size 0.01, on this mesh file of the folder.
void write_box_layout(const fs::path& folder, const std::string& mesh) {
  Json layout = Json::parse(file_text(fingertip_layout()));
  Json taxel = layout["taxels"][0];
  taxel["center"] = {0, 0, 0.01};
  taxel["normal"] = {0, 0, 1};
  layout["mesh"] = {{"file", mesh}};
  layout["taxels"] = Json::array({taxel});
  layout["sampling"]["density"] = 1e6;
  write_text(folder / "box.taxels.json", layout.dump());
}

const Json* problem_of(const Json& problems, const std::string& code) {
  for (const Json& problem : problems) {
    if (problem["code"] == code) return &problem;
  }
  return nullptr;
}

TEST(Libraries, FindTheEdgeWithThreeFacesByHalfEdges) {
  const fs::path folder = test_folder();
  // The fin is a triangle of corners 6 and 8, on the upper edge at +x, and a point above.
  write_text(folder / "fin.obj", box_obj(0.01) + "v 0.03 0 0.03\nf 6 8 9\n");
  const std::string bad = "1 edge with more than two faces, the first at (10, 0, 10) mm (3 faces)";
  const Outcome check = taxel({"check", "fin.obj", "--json"}, folder);
  EXPECT_EQ(check.status, 1);
  const Json problems = Json::parse(check.out)["problems"];
  const Json* found = problem_of(problems, "mesh_nonmanifold");
  ASSERT_NE(found, nullptr) << check.out;
  EXPECT_EQ((*found)["message"], bad);
  ASSERT_NE(problem_of(problems, "mesh_open"), nullptr) << "the free edges of the fin";
  const Json mesh = taxel_json({"mesh", "fin.obj"}, folder);
  ASSERT_NE(problem_of(mesh["problems"], "mesh_nonmanifold"), nullptr) << mesh;
  EXPECT_NE(taxel({"mesh", "fin.obj"}, folder).out.find("error: " + bad), std::string::npos);
  write_box_layout(folder, "fin.obj");
  const Outcome sweep = taxel({"sweep", "--layout", "box.taxels.json"}, folder);
  EXPECT_EQ(sweep.status, 0) << sweep.err;
  EXPECT_NE(sweep.err.find("/mesh/file: repaired: "), std::string::npos) << sweep.err;
}

TEST(Libraries, FindTheReversedFaceByHalfEdges) {
  const fs::path folder = test_folder();
  std::string obj = box_obj(0.01);
  const std::size_t last = obj.rfind("f 4 8 6");
  ASSERT_NE(last, std::string::npos);
  obj.replace(last, 7, "f 4 6 8");
  write_text(folder / "turned.obj", obj);
  const Json problems = Json::parse(taxel({"check", "turned.obj", "--json"}, folder).out)["problems"];
  ASSERT_EQ(problems.size(), 1U) << problems;
  EXPECT_EQ(problems[0]["code"], "mesh_winding");
  EXPECT_EQ(problems[0]["message"].get<std::string>().rfind("3 edges between faces that wind differently", 0), 0U);
}

TEST(Libraries, ReadAWrittenGlbAndRefuseACutOne) {
  const fs::path folder = test_folder();
  write_text(folder / "box.obj", box_obj(0.01));
  const Json obj = taxel_json({"mesh", "box.obj", "--out", "box.glb"}, folder);
  const std::string bytes = file_text(folder / "box.glb");
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  const Json glb = taxel_json({"mesh", "box.glb"}, folder);
  EXPECT_EQ(glb["triangles"], 12);
  EXPECT_EQ(glb["closed"], true);
  EXPECT_NEAR(glb["volume"].get<double>(), obj["volume"].get<double>(), 1e-6 * 8e-6);  // GLB contains floats
  write_box_layout(folder, "box.glb");
  EXPECT_EQ(taxel_json({"samples", "box.taxels.json", "--quiet"}, folder)["samples"], 2400);
  write_text(folder / "cut.glb", bytes.substr(0, bytes.size() / 2));
  const Outcome cut = taxel({"mesh", "cut.glb"}, folder);
  EXPECT_EQ(cut.status, 2);
  EXPECT_EQ(cut.err.rfind("taxel: cut.glb: ", 0), 0U) << cut.err;
}

TEST(Libraries, RotateAContactWithItsWorld) {
  const fs::path folder = test_folder();
  const auto force = [&](const Json& position, const Json& quaternion) {
    const Json ball = {{"shape", {{"type", "sphere"}, {"size", {0.05}}}},
                       {"resolution", 0.01},
                       {"material", {{"modulus", 5e4}}},
                       {"pos", position},
                       {"quat", quaternion}};
    const Json plane = {{"shape", {{"type", "plane"}}}, {"quat", quaternion}};
    const Json contact = {{"format", "contact-case"}, {"version", 1}, {"a", ball}, {"b", plane}};
    write_text(folder / "case.json", contact.dump());
    return taxel_json({"contact", "case.json"}, folder)["force"].get<std::vector<double>>();
  };
  const double half = std::sqrt(0.5);
  const std::vector<double> upright = force({0, 0, 0.047}, {1, 0, 0, 0});
  const std::vector<double> turned = force({0, -0.047, 0}, {half, half, 0, 0});  // a quarter turn about x: z goes to -y
  ASSERT_GT(upright[2], 1);
  EXPECT_NEAR(turned[1], -upright[2], 1e-12 * upright[2]);
  EXPECT_NEAR(turned[2], upright[1], 1e-12 * upright[2]);
  EXPECT_NEAR(turned[0], upright[0], 1e-12 * upright[2]);
}

TEST(Libraries, KeepTheBytesOfJsonLayoutsAndPointAtErrors) {
  const fs::path folder = test_folder();
  const fs::path layout = changed_layout(folder, Json::array());
  const auto written = [&](const fs::path& from, const std::string& to) {
    const Outcome sweep = taxel({"sweep", "--quiet", "--layout", from.string(), "--density", "1e4", "--object", "box",
                                 "--before", "0", "--past", "0.0001", "--out", to},
                                folder);
    EXPECT_EQ(sweep.status, 0) << sweep.err;
    return folder / to / "finger.taxels.json";
  };
  const fs::path once = written(layout, "once"), twice = written(once, "twice");
  EXPECT_EQ(file_text(once), file_text(twice));
  const Json before = Json::parse(file_text(layout)), after = Json::parse(file_text(once));
  EXPECT_EQ(before["taxels"], after["taxels"]);
  changed_layout(folder, Json::parse(R"([{"op": "replace", "path": "/taxels/7/center/2", "value": "up"}])"));
  const Outcome refused = taxel({"samples", layout.string()}, folder);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find(": /taxels/7/center"), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace taxel::test
