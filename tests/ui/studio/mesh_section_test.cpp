// The mesh of the document: its unit, its report, and the operations that an open mesh allows.
#include <gtest/gtest.h>

#include <sstream>

#include "core/mesh/mesh_io.h"
#include "core/mesh/topology/mesh_check.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

const std::string kPlay = key("2", kCtrl);

/// Writes our fingertip twice, a millimetre apart, with faces that cut through each other.
std::string with_cut(const std::filesystem::path& folder) {
  const TriMesh whole = *load_mesh(kMeshFile).mesh;
  std::vector<dvec3> vertices = whole.vertices();
  std::vector<ivec3> faces = whole.faces();
  for (const dvec3& v : whole.vertices()) vertices.push_back(v + dvec3(0.001));
  for (const ivec3& f : whole.faces()) faces.push_back(f + ivec3(whole.vertex_count()));
  const std::string file = (folder / "cut.obj").string();
  save_mesh(file, TriMesh(vertices, faces));
  return file;
}

/// Writes a soft layout on our fingertip without its first face, which must be kept without repair.
std::string with_hole(const std::filesystem::path& folder) {
  const TriMesh whole = *load_mesh(kMeshFile).mesh;
  const std::vector<ivec3> faces(whole.faces().begin() + 1, whole.faces().end());
  save_mesh(folder / "hole.obj", TriMesh(whole.vertices(), faces));
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"] = {{"file", "hole.obj"}, {"repair", {{"level", "keep"}}}};
  layout["taxels"] = Json::array();
  const std::string file = (folder / "hole.taxels.json").string();
  write_text(file, layout.dump());
  return file;
}

double width_mm(const Json& state) {
  return state["document"]["mesh"]["size"][0].get<double>() * 1e3;
}

TEST(MeshUnit, IsShownChangedAndUndone) {
  const StudioProgram studio;
  const TriMesh finger = *load_mesh(kMeshFile).mesh;
  std::vector<dvec3> vertices = finger.vertices();
  for (dvec3& v : vertices) v *= 1000.0;
  save_mesh(studio.folder() / "mm.obj", TriMesh(vertices, finger.faces()));
  studio.play({kIdle, dump("guessed.json"), press("Unit"), kIdle, press("Unit: cm"), kIdle, dump("cm.json"),
               R"({"do": "screenshot", "file": "cm.png"})", key("z", kCtrl), kIdle, dump("undone.json")},
              {"mm.obj"});
  const Json guessed = studio.state("guessed.json"), cm = studio.state("cm.json"), undone = studio.state("undone.json");
  EXPECT_NEAR(width_mm(guessed), 1e3 * finger.bounds().extent().x, 1e-6);
  EXPECT_NEAR(width_mm(cm), 10 * width_mm(guessed), 1e-6);
  EXPECT_EQ(cm["document"]["layout"]["mesh"]["scale"][0], 0.01);
  EXPECT_NEAR(cm["document"]["samples"].get<double>(), guessed["document"]["samples"].get<double>(),
              0.5 * guessed["document"]["samples"].get<double>())
      << "as dense a picture as before";
  EXPECT_EQ(cm["history"]["depth"], 1) << "unit and density are one step";
  EXPECT_NEAR(cm["camera"]["distance"].get<double>() / guessed["camera"]["distance"].get<double>(), 10, 0.1);
  EXPECT_EQ(undone["document"]["layout"], guessed["document"]["layout"]);
  EXPECT_NEAR(width_mm(undone), width_mm(guessed), 1e-9);
}

TEST(MeshFrame, SetsTipAndPad) {
  const StudioProgram studio;
  studio.play({kIdle, press("Tip points to"), kIdle, press("Tip points to: +y"), kIdle, press("Pad faces"), kIdle,
               press("Pad faces: +z"), kIdle, dump("state.json")},
              {kMeshFile});
  const Json frame = studio.state("state.json")["document"]["layout"]["frame"];
  EXPECT_EQ(frame["distal"], Json({0, 1, 0}));
  EXPECT_EQ(frame["pad"], Json({0, 0, 1}));
}

TEST(MeshReport, StaysClosedIfTheRepairSucceedsAndOpensFromTheMenu) {
  const StudioProgram studio;
  const std::string file = with_cut(studio.folder());
  studio.play({kIdle, dump("opened.json"), R"({"do": "screenshot", "file": "report.png"})", press("Panels"), kIdle,
               press("Mesh report..."), kIdle, dump("shown.json"), press("Panels"), kIdle, press("Mesh report..."),
               kIdle, dump("closed.json")},
              {file});
  const std::string opened = studio.state("opened.json")["widgets"].dump();
  EXPECT_EQ(opened.find("faces cut through each other"), std::string::npos);
  EXPECT_NE(studio.state("shown.json")["widgets"].dump().find("faces cut through each other"), std::string::npos);
  EXPECT_EQ(studio.state("closed.json")["widgets"].dump().find("faces cut through each other"), std::string::npos);
  studio.play({kIdle, dump("sound.json")}, {kMeshFile});
  EXPECT_EQ(studio.state("sound.json")["widgets"].dump().find("Mesh report window"), std::string::npos);
}

TEST(MeshReport, OpensAutomaticallyForAMeshThatStaysOpen) {
  const StudioProgram studio;
  studio.play({kIdle, dump("opened.json"), R"({"do": "screenshot", "file": "report.png"})"},
              {with_hole(studio.folder())});
  const std::string opened = studio.state("opened.json")["widgets"].dump();
  EXPECT_NE(opened.find("Mesh report window"), std::string::npos);
  EXPECT_NE(opened.find("3 open edges around 1 hole, the first at ("), std::string::npos);
}

TEST(OpenMesh, IsDisplayedAndEditedButNotSimulated) {
  const StudioProgram studio;
  const std::string file = with_hole(studio.folder()), out = (studio.folder() / "out.taxels.json").string();
  const std::string place = click(R"({"world": [0.0083, 0.0007, 0.0194]})", kCtrl);
  studio.play(
      {kIdle, dump("opened.json"), place, kIdle, dump("placed.json"), kPlay, kIdle, dump("refused.json"),
       key("e", kCtrl), kIdle, type(out), kIdle, key("Enter"), kIdle, R"({"do": "screenshot", "file": "open.png"})"},
      {file});
  const Json opened = studio.state("opened.json"), placed = studio.state("placed.json");
  EXPECT_NE(opened["history"]["problem"].get<std::string>().find("not closed"), std::string::npos);
  EXPECT_GT(opened["document"]["samples"], 1000);
  EXPECT_EQ(placed["document"]["layout"]["taxels"].size(), 1U);
  EXPECT_TRUE(placed["history"]["compiled"]);
  const Json refused = studio.state("refused.json");
  EXPECT_EQ(refused["mode"], "layout");
  EXPECT_TRUE(refused["simulation"].is_null());
  EXPECT_EQ(refused["messages"].back()["severity"], "error");
  EXPECT_NE(refused["messages"].back()["text"].get<std::string>().find("not simulated"), std::string::npos);
  const Json exported = Json::parse(file_text(out));
  EXPECT_EQ(exported["taxels"].size(), 1U);
  EXPECT_GT(exported["material"]["modulus"], 0) << "it stays soft: the mesh is to be closed";

  studio.play({kIdle, dump("layout.json")}, {out});
  EXPECT_EQ(studio.state("layout.json")["mode"], "layout") << "its layout opens as well";
  EXPECT_EQ(studio.state("layout.json")["document"]["layout"]["taxels"].size(), 1U);
}

}  // namespace
}  // namespace taxel::test
