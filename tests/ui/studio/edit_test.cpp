// Editing a layout with the mouse and keys: raw events in, the document and its history out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/mesh/mesh_io.h"
#include "core/mesh/query/closest_point.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

/// Returns the taxel with an id from a dumped state.
Json edited(const Json& state, int id) {
  return taxel_of(state["document"]["layout"], id);
}

/// Returns the skin of the fingertip.
const MeshIndex& skin() {
  static const MeshIndex index(load_mesh(kMeshFile).mesh);
  return index;
}

void expect_on_skin(const Json& taxel) {
  const SurfacePoint near = skin().closest_point(vector_of(taxel["center"]));
  EXPECT_LT(near.distance, 1e-6 * skin().mesh().bounds().diagonal());
  const dvec3 normal = glm::normalize(vector_of(taxel["normal"]));
  const dvec3 face = skin().mesh().face_normals()[static_cast<std::size_t>(near.face)];
  EXPECT_GT(glm::dot(normal, face), std::cos(glm::radians(0.1))) << taxel.dump();
}

/// Returns a drag of taxel 3 in ten frames, each state dumped. `end` are the lines that end the drag.
Lines dragged(const Lines& end) {
  Lines script{
      kLayoutMode, kIdle, click(taxel(3)), kIdle, dump("before.json"), R"({"event": "mouse_down", "at": {"taxel": 3}})",
      kIdle};
  for (int i = 1; i <= 10; ++i) {
    script.push_back(R"({"event": "mouse_move", "at": )" + in_view(0.5 + 0.0087 * i, 0.507 + 0.0076 * i) + "}");
    script.push_back(kIdle);
    script.push_back(dump("drag" + std::to_string(i) + ".json"));
  }
  script.insert(script.end(), end.begin(), end.end());
  script.insert(script.end(), {kIdle, dump("after.json"), key("z", kCtrl), kIdle, dump("undone.json")});
  return script;
}

/// Returns the place of a pixel in the view along an axis, from 0 to 1.
double part_of_view(const Json& state, const Json& pixel, std::size_t axis) {
  const Json& view = state["view"]["rect"];
  const double from = view[axis], to = view[axis + 2];
  return (pixel[axis].get<double>() - from) / (to - from);
}

TEST(Edit, AddsATaxelByCtrlClickOnTheMeshOnly) {
  const StudioProgram studio;
  studio.play({kIdle, click(in_view(0.471, 0.507), kCtrl), kIdle, dump("added.json"),
               click(in_view(0.209, 0.108), kCtrl), kIdle, dump("background.json")},
              {kMeshFile});
  const Json added = studio.state("added.json");
  ASSERT_EQ(added["document"]["layout"]["taxels"].size(), 1U);
  expect_on_skin(added["document"]["layout"]["taxels"][0]);
  EXPECT_EQ(added["history"]["depth"], 1);
  EXPECT_EQ(added["history"]["undo"], "Undo Add taxel 0");
  EXPECT_TRUE(added["history"]["compiled"]);
  EXPECT_EQ(added["selection"]["taxels"], Json::array({0}));
  EXPECT_EQ(added["title"].get<std::string>().front(), '*');
  ASSERT_EQ(added["taxels"].size(), 1U) << "the model shown has it";
  EXPECT_NEAR(part_of_view(added, added["taxels"][0]["pixel"], 0), 0.471, 1e-3);
  EXPECT_NEAR(part_of_view(added, added["taxels"][0]["pixel"], 1), 0.507, 1e-3);
  EXPECT_EQ(studio.state("background.json")["document"], added["document"]);
  EXPECT_EQ(studio.state("background.json")["history"], added["history"]);
}

TEST(Edit, PlacesTaxelsByShiftAUntilEsc) {
  const StudioProgram studio;
  studio.play({kIdle, key("a", kShift), kIdle, click(in_view(0.471, 0.507)), kIdle, click(in_view(0.471, 0.639)), kIdle,
               dump("two.json"), key("Esc"), kIdle, click(in_view(0.5, 0.564)), kIdle, dump("ended.json")},
              {kMeshFile});
  EXPECT_EQ(studio.state("two.json")["tool"]["name"], "place");
  EXPECT_EQ(studio.state("two.json")["document"]["layout"]["taxels"].size(), 2U);
  EXPECT_EQ(studio.state("two.json")["history"]["depth"], 2);
  EXPECT_EQ(studio.state("ended.json")["tool"]["name"], "none");
  EXPECT_EQ(studio.state("ended.json")["document"]["layout"]["taxels"].size(), 2U);
}

TEST(Edit, SlidesATaxelAlongTheMeshInOneStep) {
  const StudioProgram studio;
  studio.play(dragged({R"({"event": "mouse_up"})"}), {kLayoutFile});
  const Json before = studio.state("before.json"), after = studio.state("after.json");
  for (int i = 1; i <= 10; ++i) {
    const Json state = studio.state("drag" + std::to_string(i) + ".json");
    EXPECT_EQ(state["tool"]["name"], "slide");
    EXPECT_EQ(state["history"]["depth"], 1) << i;
    const dvec3 center = vector_of(edited(state, 3)["center"]);
    EXPECT_LT(skin().closest_point(center).distance, 1e-6 * skin().mesh().bounds().diagonal()) << i;
    EXPECT_EQ(state["camera"], before["camera"]);
  }
  EXPECT_NE(edited(after, 3), edited(before, 3));
  EXPECT_EQ(after["history"]["depth"], 1);
  EXPECT_EQ(after["tool"]["name"], "none");
  EXPECT_EQ(after["selection"]["taxels"], Json({3}));
  EXPECT_EQ(studio.state("undone.json")["document"], before["document"]);
  EXPECT_EQ(studio.state("undone.json")["history"]["depth"], 0);
  EXPECT_FALSE(studio.state("undone.json")["history"]["dirty"]) << "it is as it was opened";
}

TEST(Edit, RestoresADragBitForBitByEsc) {
  const StudioProgram studio;
  studio.play(dragged({key("Esc"), kIdle, dump("escaped.json"),
                       R"({"event": "mouse_move", "at": {"view": [0.326, 0.45]}})", kIdle, R"({"event": "mouse_up"})"}),
              {kLayoutFile});
  const Json before = studio.state("before.json"), after = studio.state("after.json");
  EXPECT_NE(studio.state("drag10.json")["document"], before["document"]);
  EXPECT_EQ(studio.state("escaped.json")["document"], before["document"]);
  EXPECT_EQ(after["document"], before["document"]);
  EXPECT_EQ(after["history"]["depth"], 0);
  EXPECT_EQ(after["selection"], before["selection"]);
  EXPECT_EQ(after["camera"], before["camera"]) << "the rest of the drag does not orbit";
}

TEST(Edit, MovesTurnsAndResizesExactlyByTypedNumbers) {
  const StudioProgram studio;
  studio.play({kLayoutMode,
               kIdle,
               click(taxel(3)),
               kIdle,
               dump("before.json"),
               key("g"),
               key("y"),
               type("1.5"),
               kIdle,
               dump("typing.json"),
               key("Enter"),
               kIdle,
               dump("moved.json"),
               key("r"),
               key("z"),
               type("-90"),
               kIdle,
               key("Enter"),
               kIdle,
               dump("turned.json"),
               key("f"),
               type("4.2"),
               kIdle,
               key("Enter"),
               kIdle,
               dump("resized.json"),
               key("f"),
               type("9"),
               kIdle,
               key("Esc"),
               kIdle,
               dump("escaped.json")},
              {kLayoutFile});
  const Json before = edited(studio.state("before.json"), 3), moved = edited(studio.state("moved.json"), 3);
  EXPECT_EQ(studio.state("typing.json")["tool"]["value"], "1.500 mm along Y");
  EXPECT_EQ(vector_of(moved["center"]), vector_of(before["center"]) + dvec3(0, 1.5e-3, 0));
  EXPECT_EQ(moved["normal"], before["normal"]);
  const dvec3 n = vector_of(before["normal"]);
  const dvec3 turned = vector_of(edited(studio.state("turned.json"), 3)["normal"]);
  EXPECT_LT(glm::length(turned - dvec3(n.y, -n.x, n.z)), 1e-12);
  EXPECT_EQ(edited(studio.state("resized.json"), 3)["radius"], 4.2e-3);
  EXPECT_EQ(studio.state("resized.json")["history"]["depth"], 3);
  EXPECT_EQ(studio.state("resized.json")["history"]["undo"], "Undo Resize taxel 3");
  EXPECT_EQ(studio.state("escaped.json")["document"], studio.state("resized.json")["document"]);
  EXPECT_EQ(studio.state("escaped.json")["overlays"], studio.state("before.json")["overlays"])
      << "Y and digits belong to the gesture";
}

TEST(Edit, RefusesAnInvalidRadiusAndChangesNothing) {
  const StudioProgram studio;
  studio.play({kLayoutMode, kIdle, click(taxel(3)), kIdle, dump("before.json"), key("f"), type("-1"), kIdle,
               dump("typing.json"), key("Enter"), kIdle, dump("after.json")},
              {kLayoutFile});
  EXPECT_NE(studio.state("typing.json")["tool"]["problem"].get<std::string>().find("taxel 3: radius"),
            std::string::npos);
  EXPECT_EQ(studio.state("after.json")["document"], studio.state("before.json")["document"]);
  EXPECT_EQ(studio.state("after.json")["history"]["depth"], 0);
}

TEST(Edit, GivesTheSameBytesAfterKUndosAndKRedos) {
  const StudioProgram studio;
  Lines script{kLayoutMode, kIdle, click(taxel(3)), kIdle, dump("state0.json")};
  const std::vector<Lines> edits{{key("g"), key("x"), type("0.4"), key("Enter")},
                                 {key("n", kShift)},
                                 {click(in_view(0.5, 0.677), kCtrl)},
                                 {R"({"event": "wheel", "at": {"view": [0.326, 0.45]}, "y": 3, "mods": ["ctrl"]})"},
                                 {key("d", kShift), key("z"), type("1"), key("Enter")},
                                 {key("Delete")},
                                 {key("a"), key("c", kCtrl), key("v", kCtrl)}};
  const int count = static_cast<int>(edits.size());
  for (int k = 1; k <= count; ++k) {
    for (const std::string& line : edits[static_cast<std::size_t>(k - 1)]) {
      script.push_back(line);
      script.push_back(kIdle);
    }
    script.push_back(dump("state" + std::to_string(k) + ".json"));
  }
  for (int k = count - 1; k >= 0; --k) {
    script.insert(script.end(), {key("z", kCtrl), kIdle, dump("undo" + std::to_string(k) + ".json")});
  }
  for (int k = 1; k <= count; ++k) {
    script.insert(script.end(), {k % 2 == 0 ? key("y", kCtrl) : key("z", kCtrlShift), kIdle,
                                 dump("redo" + std::to_string(k) + ".json")});
  }
  studio.play(script, {kLayoutFile});
  const auto layout = [&](const std::string& name, int k) {
    return studio.state(name + std::to_string(k) + ".json")["document"]["layout"].dump();
  };
  for (int k = 0; k <= count; ++k) {
    EXPECT_EQ(studio.state("state" + std::to_string(k) + ".json")["history"]["depth"], k);
    if (k < count) {
      EXPECT_EQ(layout("undo", k), layout("state", k)) << k;
    }
    if (k > 0) {
      EXPECT_EQ(layout("redo", k), layout("state", k)) << k;
      EXPECT_NE(layout("state", k), layout("state", k - 1)) << k;
    }
  }
  EXPECT_EQ(studio.state("state7.json")["document"]["layout"]["taxels"].size(), 26U);
}

TEST(Edit, MirrorsSixTaxelsToTwelveAndTheTwinsFollow) {
  const StudioProgram studio;
  Json layout = Json::parse(file_text(kLayoutFile));
  Json six = Json::array();
  for (const Json& taxel : layout["taxels"])
    if (taxel["center"][0] > 0) six.push_back(taxel);
  ASSERT_EQ(six.size(), 6U);
  layout["taxels"] = six;
  layout["mesh"]["file"] = kMeshFile;
  write_text(studio.folder() / "six.taxels.json", layout.dump());
  const int first = six[0]["id"];
  studio.play({kLayoutMode, kIdle, key("a"), kIdle, key("m", kCtrl), kIdle, dump("mirrored.json"),
               click(R"({"widget": "Taxel )" + std::to_string(first) + R"("})"), kIdle, key("g"), key("x"), type("0.5"),
               key("Enter"), kIdle, dump("moved.json")},
              {"six.taxels.json"});
  const Json mirrored = studio.state("mirrored.json"), moved = studio.state("moved.json");
  ASSERT_EQ(mirrored["document"]["layout"]["taxels"].size(), 12U);
  const dvec3 before = vector_of(six[0]["center"]);
  int twin = -1;
  for (const Json& taxel : mirrored["document"]["layout"]["taxels"])
    if (vector_of(taxel["center"]) == before * dvec3(-1, 1, 1)) twin = taxel["id"];
  ASSERT_GE(twin, 0);
  const dvec3 at = vector_of(edited(moved, first)["center"]);
  EXPECT_EQ(at, before + dvec3(5e-4, 0, 0));
  EXPECT_EQ(vector_of(edited(moved, twin)["center"]), at * dvec3(-1, 1, 1));
}

TEST(Edit, SelectsTheTaxelsInABox) {
  const StudioProgram studio;
  const Lines box{key("b"),
                  kIdle,
                  R"({"event": "mouse_down", "at": {"view": [0.224, 0.127]}})",
                  kIdle,
                  R"({"event": "mouse_move", "at": {"view": [0.529, 0.943]}})",
                  kIdle,
                  R"({"event": "mouse_up"})",
                  kIdle};
  studio.play(joined({{kLayoutMode, kIdle, dump("before.json")},
                      box,
                      {dump("after.json"), key("T"), kIdle},
                      box,
                      {dump("x_ray.json")}}),
              {kLayoutFile});
  const Json before = studio.state("before.json"), after = studio.state("after.json");
  Json inside = Json::array(), seen = Json::array();
  for (const Json& mark : before["taxels"]) {
    const double u = part_of_view(before, mark["pixel"], 0), v = part_of_view(before, mark["pixel"], 1);
    if (!(u >= 0.224 && u <= 0.529 && v >= 0.127 && v <= 0.943)) continue;
    inside.push_back(mark["id"]);
    if (mark["facing"]) seen.push_back(mark["id"]);
  }
  EXPECT_GT(seen.size(), 1U);
  EXPECT_LT(seen.size(), inside.size()) << "the skin is opaque";
  EXPECT_LT(inside.size(), 12U);
  EXPECT_EQ(after["selection"]["taxels"], seen);
  EXPECT_EQ(after["camera"], before["camera"]);
  EXPECT_EQ(studio.state("x_ray.json")["selection"]["taxels"], inside);
}

/// Types into a field of the inspector.
Lines fill(const std::string& field, const std::string& text, const std::string& end = "Enter") {
  return {click(R"({"widget": "Inspector/)" + field + R"("})"), kIdle, type(text), kIdle, key(end), kIdle};
}

TEST(Inspector, EditsOneTaxelAndSeveralAtOnce) {
  const StudioProgram studio;
  Lines script{kLayoutMode, kIdle, click(taxel(3)), kIdle, dump("before.json")};
  const auto then = [&](const Lines& lines) { script.insert(script.end(), lines.begin(), lines.end()); };
  then(fill("Radius (mm)", "2*1.5 mm + 0.025 cm"));
  then(fill("Name", "thumb"));
  then(fill("Centre (mm) Y", "-6.5"));
  then(fill("Id", "5"));
  then({dump("taken.json")});
  then(fill("Id", "40"));
  then({dump("one.json"), R"({"event": "click", "at": {"widget": "Taxel 5"}, "mods": ["shift"]})", kIdle,
        dump("two.json"), R"({"do": "screenshot", "file": "mixed.png"})"});
  then(fill("Radius (mm)", "5"));
  then({dump("both.json")});
  then(fill("Radius (mm)", "nonsense"));
  then(fill("Radius (mm)", "7", "Esc"));
  then(fill("Radius (mm)", "1/0"));
  then({dump("same.json")});
  studio.play(script, {kLayoutFile});
  const Json before = edited(studio.state("before.json"), 3), one = edited(studio.state("one.json"), 40);
  EXPECT_EQ(studio.state("taken.json")["selection"]["taxels"], Json({3}));
  EXPECT_EQ(studio.state("taken.json")["refused"]["words"], "Id: 5 is that of another taxel");
  EXPECT_EQ(one["radius"], 3.25e-3);
  EXPECT_EQ(one["name"], "thumb");
  EXPECT_EQ(one["center"][1], -6.5e-3);
  EXPECT_EQ(one["center"][0], before["center"][0]) << "to the last bit, though it shows three digits";
  EXPECT_EQ(one["normal"], before["normal"]);
  EXPECT_EQ(studio.state("one.json")["history"]["depth"], 4);
  EXPECT_EQ(studio.state("one.json")["selection"]["taxels"], Json({40}));
  const Json both = studio.state("both.json");
  EXPECT_EQ(edited(both, 40)["radius"], 5e-3);
  EXPECT_EQ(edited(both, 5)["radius"], 5e-3);
  EXPECT_EQ(edited(both, 5)["name"], edited(studio.state("before.json"), 5)["name"]);
  EXPECT_EQ(studio.state("same.json")["document"], both["document"]);
  EXPECT_EQ(studio.state("same.json")["refused"]["typed"], "1/0");
  EXPECT_NE(studio.state("same.json")["refused"]["words"].get<std::string>().find("Radius (mm): "), std::string::npos);
}

TEST(Edit, NeitherDrawsNorPicksHiddenTaxels) {
  const StudioProgram studio;
  studio.play({kLayoutMode,
               kIdle,
               click(taxel(3)),
               kIdle,
               dump("before.json"),
               key("h"),
               kIdle,
               R"({"event": "mouse_move", "at": {"view": [0.035, 0.45]}})",
               kIdle,
               R"({"do": "screenshot", "file": "hidden.png"})",
               click(taxel(3)),
               kIdle,
               dump("hidden.json"),
               key("h", R"("alt")"),
               kIdle,
               click(taxel(3)),
               kIdle,
               dump("shown.json"),
               key("/"),
               kIdle,
               click(taxel(9)),
               kIdle,
               dump("alone.json"),
               click(taxel(3)),
               kIdle,
               dump("picked.json"),
               key("/"),
               kIdle,
               click(taxel(9)),
               kIdle,
               dump("all.json")},
              {kLayoutFile});
  const auto selected = [&](const std::string& file) { return studio.state(file)["selection"]["taxels"]; };
  EXPECT_EQ(selected("hidden.json"), Json::array());
  EXPECT_EQ(selected("shown.json"), Json({3}));
  EXPECT_EQ(selected("alone.json"), Json::array()) << "9 cannot be picked";
  EXPECT_EQ(selected("picked.json"), Json({3}));
  EXPECT_EQ(selected("all.json"), Json({9}));
  EXPECT_EQ(studio.state("hidden.json")["document"], studio.state("before.json")["document"]) << "it stays a taxel";
  const Json marks = studio.state("before.json")["taxels"];
  bool was_drawn = false;
  for (const Json& mark : marks) {
    if (mark["id"] != 3) continue;
    was_drawn = true;
    EXPECT_GT(color_distance(studio.picture("hidden.png").pixel(mark["pixel"][0], mark["pixel"][1]), mark["color"]), 8);
  }
  EXPECT_TRUE(was_drawn);
}

TEST(Edit, ReportsAnEmptyClipboardAndChangesNothing) {
  const StudioProgram studio;
  studio.play({kLayoutMode, kIdle, dump("before.json"), key("v", kCtrl), kIdle, dump("after.json")}, {kLayoutFile});
  EXPECT_EQ(studio.state("after.json")["document"], studio.state("before.json")["document"]);
  EXPECT_NE(studio.state("after.json")["messages"].dump().find("clipboard: is empty"), std::string::npos);
}

TEST(Edit, GivesTheEditedLayoutToTheSimulationOnSwitching) {
  const StudioProgram studio;
  studio.play({key("Space"),
               kIdle,
               kLayoutMode,
               kIdle,
               dump("before.json"),
               click(taxel(3)),
               kIdle,
               key("f"),
               type("3"),
               key("Enter"),
               kIdle,
               dump("resized.json"),
               key("2", kCtrl),
               kIdle,
               dump("simulated.json"),
               kLayoutMode,
               kIdle,
               key("Delete"),
               kIdle,
               key("2", kCtrl),
               kIdle,
               dump("fewer.json")},
              {kLayoutFile});
  const Json simulated = studio.state("simulated.json"), resized = studio.state("resized.json");
  EXPECT_EQ(studio.state("resized.json")["simulation"], studio.state("before.json")["simulation"]) << "left alone";
  EXPECT_EQ(simulated["simulation"]["step"], resized["simulation"]["step"]) << "the run goes on";
  EXPECT_EQ(simulated["simulation"]["readings"].size(), 12U);
  const auto samples_of_3 = [](const Json& state) {
    return std::count_if(state["samples"].begin(), state["samples"].end(),
                         [](const Json& sample) { return sample["taxel"] == 3; });
  };
  EXPECT_LT(samples_of_3(simulated), samples_of_3(studio.state("before.json")));
  EXPECT_EQ(studio.state("fewer.json")["simulation"]["readings"].size(), 11U);
  EXPECT_EQ(studio.state("fewer.json")["mode"], "simulate");
}

}  // namespace
}  // namespace taxel::test
