// The Generate panel: previews that are not part of the document, and one step that adds them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/mesh_io.h"
#include "core/mesh/query/closest_point.h"
#include "script_lines.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace taxel::test {
namespace {

const std::string kGenerate = key("g", kCtrl);

const MeshIndex& generated_skin() {
  static const MeshIndex index(load_mesh(kMeshFile).mesh);
  return index;
}

/// Types into a field of the panel.
Lines set_field(const std::string& name, const std::string& text) {
  return {press("Generate/" + name), kIdle, key("a", kCtrl), kIdle, type(text), kIdle, key("Enter"), kIdle};
}

void expect_on_generated_skin(const Json& taxels) {
  for (const Json& taxel : taxels) EXPECT_LT(generated_skin().closest_point(vector_of(taxel["center"])).distance, 1e-7);
}

/// Returns the colours of the pixels of the view, row by row.
std::vector<std::array<int, 3>> view_pixels(const Picture& picture, const Json& state) {
  const Json& view = state["view"]["rect"];
  std::vector<std::array<int, 3>> pixels;
  for (double y = view[1]; y < view[3]; ++y)
    for (double x = view[0]; x < view[2]; ++x) pixels.push_back(picture.pixel(x, y));
  return pixels;
}

TEST(Generate, MakesAPreviewAnEditOnlyOnAccept) {
  const StudioProgram studio;
  studio.play({kIdle,
               dump("before.json"),
               R"({"do": "screenshot", "file": "before.png"})",
               kGenerate,
               kIdle,
               dump("open.json"),
               R"({"do": "screenshot", "file": "open.png"})",
               key("Esc"),
               kIdle,
               dump("closed.json"),
               R"({"do": "screenshot", "file": "closed.png"})",
               kGenerate,
               kIdle,
               key("Enter"),
               kIdle,
               dump("added.json"),
               R"({"do": "screenshot", "file": "added.png"})",
               key("z", kCtrl),
               kIdle,
               dump("undone.json")},
              {kMeshFile});
  const Json before = studio.state("before.json"), open = studio.state("open.json"), added = studio.state("added.json");
  EXPECT_EQ(open["document"], before["document"]);
  EXPECT_EQ(open["history"], before["history"]);
  const Json ghosts = open["generate"]["taxels"];
  EXPECT_EQ(ghosts.size() + open["generate"]["left_out"].get<std::size_t>(), 12U) << "3 rows of 4";
  EXPECT_GT(ghosts.size(), 5U);
  expect_on_generated_skin(ghosts);
  EXPECT_EQ(studio.state("closed.json")["document"], before["document"]);
  EXPECT_EQ(studio.state("closed.json")["history"], before["history"]);
  EXPECT_EQ(view_pixels(studio.picture("closed.png"), before), view_pixels(studio.picture("before.png"), before))
      << "nothing is left of it";
  const Json taxels = added["document"]["layout"]["taxels"];
  ASSERT_EQ(taxels.size(), ghosts.size());
  for (std::size_t i = 0; i < ghosts.size(); ++i) EXPECT_EQ(taxels[i]["center"], ghosts[i]["center"]);
  EXPECT_EQ(added["history"]["depth"], 1);
  EXPECT_EQ(added["selection"]["taxels"].size(), ghosts.size());
  EXPECT_TRUE(added["generate"].is_null());
  EXPECT_EQ(studio.state("undone.json")["document"], before["document"]);
}

TEST(Generate, BeginsOnThePadFromAnyViewAndSaysHowToMoveThePattern) {
  const StudioProgram studio;
  studio.play({kIdle, key("1", R"("alt")"), kIdle, kGenerate, kIdle, dump("front.json"),
               R"({"do": "screenshot", "file": "front.png"})", kGenerate, kIdle, key("1", R"("alt", "shift")"), kIdle,
               kGenerate, kIdle, dump("back.json"), R"({"do": "screenshot", "file": "back.png"})"},
              {kMeshFile});
  const Json front = studio.state("front.json"), back = studio.state("back.json");
  const Json& frame = front["document"]["layout"]["frame"];
  const dvec3 pad = frame.is_null() ? dvec3(0, -1, 0) : vector_of(frame["pad"]);
  const dvec3 center = vector_of(front["generate"]["center"]);
  const dvec3 from_middle = center - generated_skin().mesh().bounds().center();
  EXPECT_LT(glm::length(glm::cross(from_middle, pad)), 1e-9) << "under the middle of the mesh, along the pad";
  EXPECT_GT(glm::dot(from_middle, pad), 0);
  EXPECT_LT(glm::distance(vector_of(front["generate"]["normal"]), pad), 1e-12) << "straight, not along a face";
  EXPECT_LT(generated_skin().closest_point(center).distance, 1e-7);
  EXPECT_EQ(back["generate"]["center"], front["generate"]["center"]) << "from behind too";
  EXPECT_EQ(front["generate"]["hint"], "Pattern: click the surface to move it   Ctrl+wheel turns   Esc ends");
  EXPECT_EQ(back["generate"]["hint"],
            "Pattern on the far side: click the surface to move it   Ctrl+wheel turns   Esc ends");
}

TEST(Generate, LeavesTheGizmoOfTheViewToClicksWithEveryTool) {
  const StudioProgram studio;
  const std::string front = key("1", R"("alt")");
  studio.play({kIdle, front, kIdle, dump("place.json")}, {kMeshFile});
  const Json rect = studio.state("place.json")["view"]["rect"];
  // In the front view, the end of +x is 34 pixels to the right of the middle, which is 59 pixels from both edges.
  const std::string ball =
      "[" + std::to_string(rect[0].get<double>() + 93) + ", " + std::to_string(rect[3].get<double>() - 59) + "]";
  Lines script;
  const std::vector<std::pair<std::string, std::string>> tools{
      {"none", ""}, {"generate", kGenerate}, {"brush", key("q")}};
  for (const auto& [name, take] : tools) {
    script.insert(script.end(), {kIdle, front, kIdle});
    if (!take.empty()) script.insert(script.end(), {take, kIdle});
    script.insert(script.end(), {click(ball), kIdle, dump(name + ".json"), key("Esc"), kIdle});
  }
  studio.play(script, {kMeshFile});
  const Json generate = studio.state("generate.json")["generate"];
  ASSERT_FALSE(generate.is_null()) << "the panel stays open";
  for (const auto& [name, take] : tools)
    EXPECT_NEAR(studio.state(name + ".json")["camera"]["azimuth_deg"].get<double>(), 0, 1e-9) << name;
}

TEST(Generate, UpdatesThePreviewByFieldsAndRefusesNonsense) {
  const StudioProgram studio;
  studio.play(joined({{kIdle, kGenerate, kIdle},
                      set_field("Rows", "2"),
                      set_field("Columns", "2"),
                      set_field("Row pitch (mm)", "2*1.5"),
                      {dump("four.json")},
                      set_field("Radius (mm)", "0"),
                      {dump("zero.json"), key("Enter"), kIdle, dump("refused.json"),
                       R"({"do": "screenshot", "file": "zero.png"})"},
                      set_field("Radius (mm)", "3"),
                      set_field("Rows", "100000"),
                      {dump("many.json")},
                      set_field("Rows", "2.5"),
                      {dump("half.json")},
                      set_field("Rows", "none"),
                      {dump("word.json")}}),
              {"--size", "1280x1000", kMeshFile});
  const Json four = studio.state("four.json")["generate"]["taxels"];
  ASSERT_EQ(four.size(), 4U);
  const dvec3 normal = vector_of(studio.state("four.json")["generate"]["normal"]);
  const dvec3 step = vector_of(four[2]["center"]) - vector_of(four[0]["center"]);
  EXPECT_NEAR(glm::length(step - glm::dot(step, normal) * normal), 3e-3, 1e-9) << "seen along the normal";
  const Json zero = studio.state("zero.json")["generate"];
  EXPECT_EQ(zero["problem"], "Radius: must be greater than 0, is 0 mm");
  EXPECT_TRUE(zero["taxels"].empty());
  EXPECT_EQ(studio.state("refused.json")["history"]["depth"], 0) << "nothing to add";
  EXPECT_FALSE(studio.state("refused.json")["generate"].is_null()) << "and it stays open";
  EXPECT_NE(studio.state("many.json")["generate"]["problem"].get<std::string>().find("more than 100000"),
            std::string::npos);
  EXPECT_EQ(studio.state("half.json")["generate"]["file_problem"], "Rows: must be a whole number, is 2.5");
  EXPECT_EQ(studio.state("word.json")["refused"]["typed"], "none");
  EXPECT_NE(studio.state("word.json")["refused"]["words"], "");
}

TEST(Generate, MovesTheFrameByClicksAndDrags) {
  const StudioProgram studio;
  studio.play({kIdle,
               kGenerate,
               kIdle,
               dump("open.json"),
               click(in_view(0.456, 0.507)),
               kIdle,
               dump("clicked.json"),
               R"({"event": "mouse_down", "at": {"view": [0.456, 0.507]}})",
               kIdle,
               R"({"event": "mouse_move", "at": {"view": [0.471, 0.583]}})",
               kIdle,
               R"({"event": "mouse_move", "at": {"view": [0.478, 0.658]}})",
               kIdle,
               R"({"event": "mouse_up"})",
               kIdle,
               dump("dragged.json"),
               R"({"event": "wheel", "at": {"view": [0.478, 0.658]}, "y": 2, "mods": ["ctrl"]})",
               kIdle,
               dump("turned.json"),
               R"({"event": "mouse_down", "at": {"view": [0.209, 0.108]}})",
               kIdle,
               R"({"event": "mouse_move", "at": {"view": [0.238, 0.127]}})",
               kIdle,
               R"({"event": "mouse_up"})",
               kIdle,
               dump("orbited.json")},
              {kMeshFile});
  const Json clicked = studio.state("clicked.json"), dragged = studio.state("dragged.json");
  EXPECT_NE(clicked["generate"]["center"], studio.state("open.json")["generate"]["center"]);
  EXPECT_NE(dragged["generate"]["center"], clicked["generate"]["center"]);
  EXPECT_EQ(dragged["camera"], clicked["camera"]) << "the frame is dragged, not the view";
  for (const Json& state : {clicked, dragged}) {
    const SurfacePoint near = generated_skin().closest_point(vector_of(state["generate"]["center"]));
    EXPECT_LT(near.distance, 1e-7);
    EXPECT_EQ(vector_of(state["generate"]["normal"]),
              generated_skin().mesh().face_normals()[static_cast<std::size_t>(near.face)]);
  }
  EXPECT_EQ(studio.state("turned.json")["generate"]["turn_deg"], 10);
  EXPECT_NE(studio.state("turned.json")["generate"]["taxels"], dragged["generate"]["taxels"]);
  EXPECT_NE(studio.state("orbited.json")["camera"], dragged["camera"]) << "a drag outside the mesh orbits";
  EXPECT_EQ(studio.state("orbited.json")["generate"]["center"], dragged["generate"]["center"]);
}

TEST(Generate, PlacesTaxelsOfEveryKindOnTheSkin) {
  const StudioProgram studio;
  const std::vector<std::pair<std::string, std::size_t>> kinds{
      {"Ring", 24}, {"Helix", 24}, {"Spiral", 24}, {"Spread", 24}, {"Preset", 12}};
  Lines script{kIdle, kGenerate, kIdle};
  for (const auto& [name, count] : kinds) {
    script.insert(script.end(), {press("Generate/" + name), kIdle, dump(name + ".json"),
                                 R"({"do": "screenshot", "file": ")" + name + R"(.png"})"});
  }
  script.insert(script.end(), {press("Generate/Add taxels"), kIdle, dump("added.json")});
  studio.play(script, {kMeshFile});
  for (const auto& [name, count] : kinds) {
    const Json g = studio.state(name + ".json")["generate"];
    EXPECT_EQ(g["problem"], "") << name;
    EXPECT_EQ(g["taxels"].size() + g["left_out"].get<std::size_t>(), count) << name;
    expect_on_generated_skin(g["taxels"]);
  }
  EXPECT_GT(studio.state("Spread.json")["generate"]["least_distance"], 2e-3);
  const Json taxels = studio.state("added.json")["document"]["layout"]["taxels"];
  EXPECT_EQ(taxels.size(), 12U);
  EXPECT_EQ(taxels[0]["name"], "taxel 0") << "the preset's own names";
}

TEST(Generate, FillsThePaintedRegionByASpread) {
  const StudioProgram studio;
  studio.play({kIdle,
               key("q"),
               kIdle,
               R"({"event": "mouse_down", "at": {"view": [0.456, 0.507]}})",
               kIdle,
               R"({"event": "mouse_move", "at": {"view": [0.471, 0.592]}})",
               kIdle,
               R"({"event": "mouse_move", "at": {"view": [0.485, 0.677]}})",
               kIdle,
               R"({"event": "mouse_up"})",
               kIdle,
               kGenerate,
               kIdle,
               press("Generate/Spread"),
               kIdle,
               dump("spread.json"),
               R"({"do": "screenshot", "file": "spread.png"})",
               key("Enter"),
               kIdle,
               dump("added.json")},
              {kMeshFile});
  const Json state = studio.state("spread.json");
  const std::vector<int> region = state["region"];
  ASSERT_FALSE(region.empty());
  const Json taxels = state["generate"]["taxels"];
  ASSERT_EQ(taxels.size(), 24U);
  for (const Json& taxel : taxels) {
    const dvec3 p = vector_of(taxel["center"]);
    double nearest = 1;
    for (const int face : region) {
      const SurfacePoint at =
          MeshIndex(std::make_shared<TriMesh>(std::vector<dvec3>{generated_skin().mesh().vertex(face, 0),
                                                                 generated_skin().mesh().vertex(face, 1),
                                                                 generated_skin().mesh().vertex(face, 2)},
                                              std::vector<ivec3>{{0, 1, 2}}))
              .closest_point(p);
      nearest = std::min(nearest, at.distance);
    }
    EXPECT_LT(nearest, 1e-7);
  }
  EXPECT_EQ(studio.state("added.json")["document"]["layout"]["taxels"].size(), 24U);
}

TEST(Generate, ReadsTablesAndImages) {
  const StudioProgram studio;
  const std::string table = (studio.folder() / "points.csv").string();
  write_text(table, "x,y,z\n4.1,-6.1,14.6\n8.6,0.5,13.2\n-3.5,-5,23.9\n");
  write_text(studio.folder() / "broken.csv", "x,y,z\n1,2,three\n");
  write_text(studio.folder() / "broken.png", "no picture");
  constexpr int kSide = 64;
  std::vector<unsigned char> pixels(kSide * kSide, 255);
  for (const auto& [x, y] : {std::pair(20, 24), std::pair(44, 24), std::pair(32, 40)})
    for (int dy = 0; dy < 4; ++dy)
      for (int dx = 0; dx < 4; ++dx) pixels[static_cast<std::size_t>((y + dy) * kSide + x + dx)] = 0;
  const std::string picture = (studio.folder() / "dots.png").string();
  ASSERT_NE(stbi_write_png(picture.c_str(), kSide, kSide, 1, pixels.data(), kSide), 0);
  const auto drop = [](const std::string& file) { return R"({"event": "drop", "files": [")" + file + R"("]})"; };
  studio.play({kIdle,
               kGenerate,
               kIdle,
               press("Generate/Table"),
               kIdle,
               dump("asks.json"),
               press("Generate/File"),
               kIdle,
               type(table),
               kIdle,
               key("Enter"),
               kIdle,
               dump("table.json"),
               press("Generate/m"),
               kIdle,
               dump("metres.json"),
               drop("broken.csv"),
               kIdle,
               dump("broken.json"),
               drop("none.csv"),
               kIdle,
               dump("none.json"),
               drop("dots.png"),
               kIdle,
               dump("image.json"),
               R"({"do": "screenshot", "file": "image.png"})",
               drop("broken.png"),
               kIdle,
               dump("no_picture.json"),
               key("Enter"),
               kIdle,
               dump("added.json")},
              {kMeshFile});
  const auto panel = [&](const std::string& name) { return studio.state(name + ".json")["generate"]; };
  EXPECT_EQ(panel("asks")["problem"], "choose a CSV file with columns x, y and z");
  ASSERT_EQ(panel("table")["taxels"].size(), 3U) << panel("table")["problem"];
  expect_on_generated_skin(panel("table")["taxels"]);
  EXPECT_LT(glm::distance(vector_of(panel("table")["taxels"][1]["center"]), dvec3(0.0086, 0.0005, 0.0132)), 1.5e-3);
  EXPECT_NE(panel("metres")["problem"].get<std::string>().find("is the unit another one?"), std::string::npos);
  EXPECT_EQ(panel("broken")["problem"], "broken.csv: line 2, column Z: must be a number, is \"three\"");
  EXPECT_NE(panel("none")["file_problem"].get<std::string>().find("none.csv"), std::string::npos);
  EXPECT_EQ(panel("image")["problem"], "");
  ASSERT_EQ(panel("image")["taxels"].size(), 3U);
  expect_on_generated_skin(panel("image")["taxels"]);
  EXPECT_NE(panel("no_picture")["file_problem"].get<std::string>().find("broken.png"), std::string::npos);
  EXPECT_EQ(studio.state("added.json")["document"]["layout"]["taxels"].size(), 3U) << "the picture before it stays";
}

TEST(Generate, ClosesWithTheDocument) {
  const StudioProgram studio;
  studio.play({kLayoutMode, kIdle, kGenerate, kIdle, dump("open.json"), key("2", kCtrl), kIdle, dump("mode.json")},
              {kLayoutFile});
  EXPECT_FALSE(studio.state("open.json")["generate"].is_null());
  EXPECT_TRUE(studio.state("mode.json")["generate"].is_null());
}

}  // namespace
}  // namespace taxel::test
