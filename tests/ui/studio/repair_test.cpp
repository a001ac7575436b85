// A mesh that needs repair in the window: it opens, the changes are reported and shown, and the mesh is kept as it is
// on request.
#include <gtest/gtest.h>

#include "core/mesh/mesh_io.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

/// Writes our fingertip without its first face and with a fin.
std::string broken_finger(const std::filesystem::path& folder) {
  const TriMesh whole = *load_mesh(kMeshFile).mesh;
  std::vector<dvec3> vertices = whole.vertices();
  std::vector<ivec3> faces(whole.faces().begin() + 1, whole.faces().end());
  const ivec3 some = whole.faces()[500];
  faces.emplace_back(some.x, some.y, static_cast<int>(vertices.size()));
  vertices.push_back(whole.vertex(500, 0) + 0.003 * whole.face_normals()[500]);
  const std::string file = (folder / "broken.obj").string();
  save_mesh(file, TriMesh(std::move(vertices), std::move(faces)));
  return file;
}

/// Writes a layout of two taxels on the broken finger.
std::string broken_layout(const StudioProgram& studio, const std::string& level) {
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = broken_finger(studio.folder());
  layout["mesh"]["sha256"] = "";
  if (!level.empty()) layout["mesh"]["repair"] = {{"level", level}};
  layout["sampling"]["density"] = 1e6;
  const std::string file = (studio.folder() / "broken.taxels.json").string();
  write_text(file, layout.dump());
  return file;
}

const Json& mesh_of(const Json& state) {
  return state["document"]["mesh"];
}

bool any_message(const Json& state, const std::string& severity, const std::string& text) {
  for (const Json& message : state["messages"])
    if (message["severity"] == severity && message["text"].get<std::string>().find(text) != std::string::npos)
      return true;
  return false;
}

bool has_step(const Json& state, const std::string& code) {
  for (const Json& step : mesh_of(state)["steps"])
    if (step["code"] == code) return true;
  return false;
}

TEST(MeshRepair, OpensABrokenMeshWithAToast) {
  const StudioProgram studio;
  const std::string file = broken_finger(studio.folder()), bytes = file_text(file);
  studio.play({kIdle, dump("opened.json")}, {file});
  const Json state = studio.state("opened.json");
  EXPECT_EQ(state["history"]["problem"], "");
  EXPECT_EQ(mesh_of(state)["closed"], true);
  EXPECT_EQ(mesh_of(state)["repaired"], true);
  EXPECT_EQ(mesh_of(state)["level"], "auto");
  EXPECT_TRUE(has_step(state, "repair_fin"));
  EXPECT_TRUE(has_step(state, "repair_filled"));
  EXPECT_TRUE(any_message(state, "note", mesh_of(state)["summary"].get<std::string>()));
  EXPECT_EQ(file_text(file), bytes);
}

TEST(MeshRepair, SimulatesABrokenMesh) {
  const StudioProgram studio;
  studio.play({kIdle, dump("state.json")}, {broken_layout(studio, "")});
  const Json state = studio.state("state.json");
  EXPECT_EQ(state["mode"], "simulate");
  EXPECT_FALSE(state["simulation"].is_null());
}

TEST(MeshRepair, ShowsItsChangesAndFramesAStep) {
  const StudioProgram studio;
  std::vector<std::string> arguments = tall_window(studio, broken_layout(studio, ""));
  const auto shot = [](const std::string& file) { return R"({"do": "screenshot", "file": ")" + file + R"("})"; };
  studio.play({kIdle, kLayoutMode, kIdle, press("Step repair_fin"), kIdle, dump("framed.json"), shot("shown.png"),
               press("Show changes"), kIdle, dump("hidden.json"), shot("hidden.png")},
              arguments);
  const Json framed = studio.state("framed.json"), hidden = studio.state("hidden.json");
  EXPECT_EQ(mesh_of(framed)["show_changes"], true);
  EXPECT_EQ(mesh_of(hidden)["show_changes"], false);
  dvec3 place(0);
  for (const Json& step : mesh_of(framed)["steps"])
    if (step["code"] == "repair_fin") place = vector_of(step["place"]);
  EXPECT_LT(glm::distance(vector_of(framed["camera"]["target"]), place), 1e-9);
  const Picture with = studio.picture("shown.png"), without = studio.picture("hidden.png");
  const auto red = [](const Picture& picture) {
    int count = 0;
    for (std::size_t i = 0; i + 2 < picture.rgb.size(); i += 3)
      count += picture.rgb[i] > 180 && picture.rgb[i + 1] < 90 && picture.rgb[i + 2] < 90 ? 1 : 0;
    return count;
  };
  EXPECT_GT(red(with), red(without) + 100) << "the outline of the fin";
}

TEST(MeshRepair, ColoursAWrapByItsDistance) {
  const StudioProgram studio;
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"] = {{"file", kMeshFile}, {"repair", {{"level", "wrap"}, {"edge", 1e-3}}}};
  layout["taxels"] = Json::array();
  layout["sampling"]["density"] = 1e5;
  write_text(studio.folder() / "wrap.taxels.json", layout.dump());
  studio.play({kIdle, kLayoutMode, kIdle, R"({"do": "screenshot", "file": "hidden.png"})", press("Show changes"), kIdle,
               dump("state.json"), R"({"do": "screenshot", "file": "wrap.png"})"},
              tall_window(studio, (studio.folder() / "wrap.taxels.json").string()));
  const Json state = studio.state("state.json");
  EXPECT_TRUE(has_step(state, "repair_wrapped"));
  EXPECT_EQ(mesh_of(state)["show_changes"], true);
  // The scale is viridis from 0 to the largest distance: green at half of the largest distance, yellow at the largest.
  const auto pixels = [](const Picture& picture, const auto& is) {
    int count = 0;
    for (std::size_t i = 0; i + 2 < picture.rgb.size(); i += 3)
      count += is(picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]) ? 1 : 0;
    return count;
  };
  const auto green = [](int r, int g, int b) { return r < 80 && g > 120 && g < 200 && b > 90 && b < 150; };
  const auto yellow = [](int r, int g, int b) { return r > 190 && g > 190 && b < 70; };
  const Picture shown = studio.picture("wrap.png"), hidden = studio.picture("hidden.png");
  EXPECT_GT(pixels(shown, green), pixels(hidden, green) + 20000);
  EXPECT_GT(pixels(shown, yellow), pixels(hidden, yellow) + 200);
}

TEST(MeshRepair, IsUndoneAndRedone) {
  const StudioProgram studio;
  std::vector<std::string> arguments = tall_window(studio, broken_layout(studio, "keep"));
  studio.play({kIdle, kLayoutMode, kIdle, dump("kept.json"), press("Repair"), kIdle, dump("repaired.json"),
               key("z", kCtrl), kIdle, dump("undone.json"), press("Fix all"), kIdle, dump("fixed.json")},
              arguments);
  const Json kept = studio.state("kept.json"), repaired = studio.state("repaired.json"),
             undone = studio.state("undone.json"), fixed = studio.state("fixed.json");
  EXPECT_EQ(mesh_of(kept)["closed"], false);
  EXPECT_NE(kept["history"]["problem"].get<std::string>().find("not closed"), std::string::npos);
  EXPECT_EQ(mesh_of(repaired)["closed"], true);
  EXPECT_EQ(mesh_of(repaired)["level"], "auto");
  EXPECT_EQ(repaired["history"]["problem"], "");
  EXPECT_EQ(repaired["history"]["undo"], "Undo Change the repair of the mesh");
  EXPECT_EQ(mesh_of(undone)["closed"], false);
  EXPECT_EQ(mesh_of(undone)["level"], "keep");
  EXPECT_EQ(mesh_of(fixed)["closed"], true);
}

TEST(MeshRepair, ShowsFacesThatEncloseNothing) {
  const StudioProgram studio;
  write_text(studio.folder() / "flat.obj",
             "v 0 0 0\nv 0.01 0 0\nv 0.01 0.01 0\nv 0 0.01 0\nf 1 2 3\nf 1 3 2\nf 1 3 4\nf 1 4 3\n");
  studio.play({kIdle, dump("state.json")}, {"flat.obj"});
  const Json state = studio.state("state.json");
  EXPECT_NE(state["history"]["problem"].get<std::string>().find("not closed"), std::string::npos);
  EXPECT_TRUE(any_message(state, "warning", "not closed"));
  EXPECT_GT(state["document"]["samples"], 100) << "it can be looked at";
}

}  // namespace
}  // namespace taxel::test
