// Meshes that need repair are repaired with a report, or refused in one line that names the place. The file on disk is
// never changed.
#include "cli/taxel_program.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/mesh_io.h"
#include "fixtures/finger_scene_xml.h"
#include "fixtures/pad_meshes.h"
#include "unit/mesh/broken_mesh.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

Json set(const std::string& path, const Json& value) {
  return {{"op", "add"}, {"path", path}, {"value", value}};
}

TriMesh fingertip() {
  return *load_mesh(fingertip_layout().parent_path() / "../meshes/fingertip.obj").mesh;
}

/// Returns the OBJ text of our fingertip with a missing face, a fin and a folded pair of faces.
std::string broken_fingertip() {
  const TriMesh whole = fingertip();
  std::vector<dvec3> vertices = whole.vertices();
  std::vector<ivec3> faces(whole.faces().begin() + 1, whole.faces().end());
  const ivec3 some = whole.faces()[500], other = whole.faces()[900];
  const int fin = static_cast<int>(vertices.size());
  vertices.push_back(whole.vertex(500, 0) + 0.001 * whole.face_normals()[500]);
  vertices.push_back(whole.vertex(900, 0) + 0.002 * whole.face_normals()[900]);
  faces.emplace_back(some.x, some.y, fin);
  faces.emplace_back(other.x, other.y, fin + 1);
  faces.emplace_back(other.y, other.x, fin + 1);
  return write_obj(TriMesh(std::move(vertices), std::move(faces)));
}

/// Writes our layout on a mesh of this text.
fs::path layout_on(const fs::path& folder, const std::string& obj, const Json& more = Json::array()) {
  write_text(folder / "m.obj", obj);
  Json patch = Json::array({set("/mesh/file", "m.obj"), set("/mesh/sha256", ""), set("/sampling/density", 1e6)});
  for (const Json& one : more) patch.push_back(one);
  return changed_layout(folder, patch);
}

bool has_code(const Json& problems, const std::string& code, const std::string& severity) {
  return std::any_of(problems.begin(), problems.end(),
                     [&](const Json& p) { return p["code"] == code && p["severity"] == severity; });
}

TEST(RepairInput, ChecksABrokenMeshWithNotesAlone) {
  const fs::path folder = test_folder();
  const std::string obj = broken_fingertip();
  const fs::path layout = layout_on(folder, obj);
  const Outcome checked = taxel({"check", "--json", layout.string()});
  EXPECT_LE(checked.status, 1) << checked.err;
  const Json problems = Json::parse(checked.out)["problems"];
  EXPECT_TRUE(has_code(problems, "mesh_open", "note")) << problems.dump(1);
  EXPECT_TRUE(has_code(problems, "mesh_nonmanifold", "note"));
  EXPECT_TRUE(has_code(problems, "repair_fin", "note"));
  EXPECT_TRUE(has_code(problems, "repair_filled", "note") || has_code(problems, "repair_filled", "warning"));
  for (const Json& p : problems) EXPECT_NE(p["severity"], "error") << p.dump();
  EXPECT_EQ(file_text(folder / "m.obj"), obj);
}

TEST(RepairInput, RefusesABrokenMeshThatIsToBeKept) {
  const fs::path folder = test_folder();
  const fs::path layout =
      layout_on(folder, broken_fingertip(), Json::array({set("/mesh/repair", {{"level", "keep"}})}));
  for (const std::string command : {"samples", "check"}) {
    const Outcome refused = taxel({command, layout.string()});
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("/mesh/file: must be a closed mesh to be soft: "), std::string::npos) << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }
}

TEST(RepairInput, NamesARecipeThatIsOutOfItsRange) {
  const fs::path folder = test_folder();
  const auto refused = [&](const Json& repair, const std::string& complaint) {
    const fs::path layout = layout_on(folder, broken_fingertip(), Json::array({set("/mesh/repair", repair)}));
    expect_refusal(taxel({"samples", layout.string()}), "taxel: " + layout.string() + ": /mesh/repair" + complaint);
  };
  refused({{"edge", -3e-4}}, "/edge: must be greater than 0, is -0.0003");
  refused({{"fill", "wide"}}, "/fill: must be a number, is \"wide\"");
  refused({{"level", "best"}}, "/level: must be one of \"auto\", \"exact\", \"wrap\", \"keep\", is \"best\"");
  refused(7, ": must be an object, is 7");
}

TEST(RepairInput, RefusesFacesThatEncloseNothing) {
  const fs::path folder = test_folder();
  const fs::path layout = layout_on(folder, "v 0 0 0\nv 0.01 0 0\nv 0 0.01 0\nf 1 2 3\nf 1 3 2\n");
  const Outcome refused = taxel({"samples", layout.string()});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("/mesh/file: encloses nothing"), std::string::npos) << refused.err;
}

/// Writes our layout with one taxel at `center` on this mesh.
fs::path layout_of_one_taxel(const fs::path& folder, const TriMesh& mesh, const dvec3& center) {
  const Json taxel = {{"id", 0}, {"center", {center.x, center.y, center.z}}, {"normal", {0, 0, 1}}, {"radius", 0.003}};
  return layout_on(folder, write_obj(mesh), Json::array({set("/taxels", Json::array({taxel}))}));
}

/// A surface without an inside becomes a body, and the report says so.
void expect_thickened(const fs::path& folder, const TriMesh& sheet) {
  const fs::path layout = layout_of_one_taxel(folder, sheet, sheet.vertex(0, 0));
  const std::string before = file_text(folder / "m.obj");
  const Outcome checked = taxel({"check", layout.string()});
  EXPECT_EQ(checked.status, 1) << checked.err;
  EXPECT_NE(
      checked.out.find(layout.string() + ": /mesh/file: warning: repaired: 1 surface without an inside thickened"),
      std::string::npos)
      << checked.out;
  EXPECT_NE(checked.out.find("0 errors"), std::string::npos) << checked.out;
  const Json mesh = taxel_json({"mesh", "m.obj", "--repair", "auto"}, folder);
  EXPECT_EQ(mesh["repair"]["closed"], true);
  EXPECT_EQ(file_text(folder / "m.obj"), before);
}

TEST(RepairInput, ThickensOneTriangle) {
  const fs::path folder = test_folder();
  const TriMesh triangle({{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}}, {{0, 1, 2}});
  expect_thickened(folder, triangle);
  const Outcome whole = taxel({"mesh", "m.obj", "--repair", "auto"}, folder);
  EXPECT_NE(whole.out.find("thickened (50 mm², 100 % of the area)"), std::string::npos) << whole.out;
  const Outcome exact = taxel({"mesh", "m.obj", "--repair", "exact"}, folder);
  EXPECT_EQ(exact.status, 2);
  EXPECT_EQ(exact.err.rfind(
                "taxel: m.obj: /mesh/repair/level: is \"exact\", but exact steps cannot close the surface at (", 0),
            0U)
      << exact.err;
}

TEST(RepairInput, ThickensAMoebiusStrip) {
  expect_thickened(test_folder(), moebius_strip(0.01, 0.003, 60));
}

TEST(RepairInput, Unites180Shells) {
  const fs::path folder = test_folder();
  TriMesh all = make_icosphere(0.01, 1);
  for (int i = 1; i < 180; ++i)
    all = together(all, moved(make_icosphere(0.01, 1), {0.007 * (i % 20), 0.007 * (i / 20), 0}));
  save_mesh(folder / "shells.stl", all);
  const Json mesh = taxel_json({"mesh", "shells.stl", "--repair", "auto"}, folder);
  EXPECT_EQ(mesh["repair"]["shells_before"], 180);
  EXPECT_EQ(mesh["repair"]["shells_after"], 1);
  EXPECT_EQ(mesh["repair"]["closed"], true);
  const Json steps = mesh["repair"]["steps"];
  EXPECT_TRUE(std::any_of(steps.begin(), steps.end(), [](const Json& s) { return s["code"] == "repair_united"; }))
      << steps;
}

/// A ball of 2 million triangles with a missing one is filled exactly, and wrapped only with --edge.
TEST(RepairInput, ClosesAMeshOfTwoMillionTriangles) {
  const fs::path folder = test_folder();
  constexpr int kRings = 1000;
  std::vector<dvec2> outline;
  for (int i = 0; i <= kRings; ++i) {
    const double angle = kPi * i / kRings;
    outline.emplace_back(i == 0 || i == kRings ? 0 : 0.01 * std::sin(angle), -0.01 * std::cos(angle));
  }
  const TriMesh ball = swept_profile(outline, 1002);
  ASSERT_GT(ball.face_count(), 2000000);
  save_mesh(folder / "large.stl", without_faces(ball, {ball.face_count() / 2}));
  const Json mesh = taxel_json({"mesh", "large.stl", "--repair", "auto"}, folder);
  EXPECT_EQ(mesh["closed"], false);
  EXPECT_EQ(mesh["repair"]["level"], "exact");
  EXPECT_EQ(mesh["repair"]["closed"], true);
  EXPECT_EQ(mesh["repair"]["faces_after"], ball.face_count());
  const Outcome wrap = taxel({"mesh", "large.stl", "--repair", "wrap"}, folder);
  EXPECT_EQ(wrap.status, 2);
  EXPECT_EQ(wrap.err.rfind("taxel: large.stl: /mesh/repair/edge: must be set (in metres) to wrap a mesh of more than "
                           "500000 faces: it has 2001995, the first to wrap at (",
                           0),
            0U)
      << wrap.err;
  fs::remove(folder / "large.stl");
}

TEST(RepairInput, NamesTaxelsFarFromTheMesh) {
  const fs::path folder = test_folder();
  const fs::path layout = layout_of_one_taxel(folder, fingertip(), {0.5, 0, 4.5});
  const std::string place = ": /taxels/0/center: ";
  const Outcome samples = taxel({"samples", layout.string()});
  EXPECT_EQ(samples.status, 2);
  EXPECT_EQ(samples.err.rfind("taxel: " + layout.string() + place + "is 4", 0), 0U) << samples.err;
  EXPECT_NE(samples.err.find(" mm from the surface, the radius is 3 mm (taxel 0)"), std::string::npos) << samples.err;
  const Outcome checked = taxel({"check", layout.string()});
  EXPECT_EQ(checked.status, 1);
  EXPECT_NE(checked.out.find(layout.string() + place + "error: is 4"), std::string::npos) << checked.out;
  EXPECT_NE(checked.out.find("; nearest point of the surface: ["), std::string::npos) << checked.out;
}

TEST(RepairInput, RunsASceneAndReportsTheRepairOfItsLayout) {
  const fs::path folder = test_folder();
  const std::string obj = broken_fingertip();
  layout_on(folder, obj);
  write_text(folder / "fingertip.obj", write_obj(fingertip()));
  const std::string floor_and_finger = finger_body("tip", 0, true, "<freejoint/>");
  const auto run = [&](const std::string& xml, const std::vector<std::string>& more) {
    write_text(folder / "scene.xml", xml);
    std::vector<std::string> arguments{"run", "scene.xml", "--seconds", "0.004"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return taxel(arguments, folder);
  };
  const std::string note = "\"tip\": mesh of the layout: repaired: ";
  const Outcome declared = run(finger_scene(floor_and_finger, {"tip"}, "changed.taxels.json"), {});
  ASSERT_EQ(declared.status, 0) << declared.err;
  const auto first = declared.err.find(note);
  EXPECT_NE(first, std::string::npos) << declared.err;
  EXPECT_EQ(declared.err.find(note, first + 1), std::string::npos) << "once: " << declared.err;
  EXPECT_NE(declared.err.find("1 fin removed ("), std::string::npos) << declared.err;
  EXPECT_NE(declared.err.find(" mm\u00b2, "), std::string::npos) << declared.err;
  const Outcome attached = run(finger_scene(floor_and_finger), {"--layout", "changed.taxels.json", "--geom", "tip"});
  ASSERT_EQ(attached.status, 0) << attached.err;
  EXPECT_NE(attached.err.find("\"taxels of tip\": mesh of the layout: repaired: "), std::string::npos) << attached.err;
  // A sound mesh has nothing to report.
  layout_on(folder, write_obj(fingertip()));
  const Outcome sound = run(finger_scene(floor_and_finger, {"tip"}, "changed.taxels.json"), {});
  EXPECT_EQ(sound.err.find("repaired"), std::string::npos) << sound.err;
}

TEST(RepairInput, SweepsABrokenMeshIntoAFolderThatRunsElsewhere) {
  const fs::path folder = test_folder();
  const std::string obj = broken_fingertip();
  Json region = Json::array({Json::array({0, 700})});
  const fs::path layout = layout_on(folder, obj, Json::array({set("/sampling/region", region)}));
  const fs::path out = folder / "sweep";
  const Outcome swept = taxel({"sweep", "--layout", layout.string(), "--out", out.string(), "--quiet"});
  ASSERT_EQ(swept.status, 0) << swept.err;
  EXPECT_EQ(file_text(folder / "m.obj"), obj);
  const Json written = Json::parse(file_text(out / "finger.taxels.json"));
  EXPECT_FALSE(written["mesh"].contains("repair"));
  EXPECT_TRUE(load_mesh(out / "finger.obj").mesh->closed());
  // The written layout has the samples of the layout in the sweep.
  const fs::path a = folder / "a.csv", b = folder / "b.csv";
  ASSERT_EQ(taxel({"samples", layout.string(), "--out", a.string()}).status, 0);
  ASSERT_EQ(taxel({"samples", (out / "finger.taxels.json").string(), "--out", b.string()}).status, 0);
  const Table first = read_csv(a), second = read_csv(b);
  EXPECT_GT(first.at("x").size(), 100U);
  for (const char* column : {"x", "y", "z", "nx", "ny", "nz", "area"})
    EXPECT_EQ(first.at(column), second.at(column)) << column;
  for (const double face : first.at("face")) {
    ASSERT_GE(face, 0);
    ASSERT_LE(face, 700) << "faces are those of the file";
  }
}

}  // namespace
}  // namespace taxel::test
