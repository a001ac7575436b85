// The view of the cameras when a scene is created and after a change of mode, the message of a start without taxels,
// and the guessed direction of a finger.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/mesh/mesh_io.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

const std::string kSimulateMode = key("2", kCtrl);
const std::string kPlaceOne = click(R"({"world": [0, -0.0075, 0.015]})", kCtrl);

TEST(Framing, ShowsTheSensorWhenItsSceneFirstExists) {
  const StudioProgram studio;
  studio.play(
      {kIdle, kPlaceOne, kIdle, kSimulateMode, kIdle, dump("simulate.json"), kLayoutMode, kIdle, dump("layout.json")},
      {kMeshFile});
  for (const char* file : {"simulate.json", "layout.json"}) {
    const Json state = studio.state(file);
    ASSERT_EQ(state["sensor_boxes"].size(), 1U) << file;
    EXPECT_TRUE(state["sensor_boxes"][0]["inside"]) << file << state["sensor_boxes"][0]["corners"];
  }
  EXPECT_EQ(studio.state("simulate.json")["mode"], "simulate");
}

Lines drag_away() {
  return {R"({"event": "mouse_down", "button": "right", "at": {"view": [0.035, 0.681]}})",
          kIdle,
          R"({"event": "mouse_move", "at": {"view": [0.907, 0.681]}})",
          kIdle,
          R"({"event": "mouse_up", "button": "right"})",
          kIdle};
}

TEST(Framing, ShowsASensorOutsideTheViewAtAChangeOfMode) {
  const StudioProgram studio;
  studio.play(joined({{kIdle, key("Space"), kIdle},
                      drag_away(),
                      drag_away(),
                      {dump("away.json"), kLayoutMode, kIdle, kSimulateMode, kIdle, dump("back.json"),
                       R"({"event": "wheel", "at": {"view": [0.529, 0.681]}, "y": 6})", kIdle, dump("near.json"),
                       kLayoutMode, kIdle, kSimulateMode, kIdle, dump("kept.json")}}),
              {kLayoutFile});
  EXPECT_TRUE(studio.state("away.json")["sensor_boxes"][0]["outside"]);
  EXPECT_TRUE(studio.state("back.json")["sensor_boxes"][0]["inside"]);
  EXPECT_EQ(studio.state("kept.json")["camera"], studio.state("near.json")["camera"]) << "a sensor in view is left so";
}

TEST(Framing, LooksAtTheContactIfNothingIsSelected) {
  const StudioProgram studio;
  studio.play({kIdle,
               wait_time(1),
               key("Space"),
               kIdle,
               key("Home"),
               kIdle,
               dump("far.json"),
               key("Period"),
               kIdle,
               dump("near.json"),
               kLayoutMode,
               kIdle,
               key("x"),
               kIdle,
               R"({"event": "mouse_move", "at": {"taxel": 3}})",
               kIdle,
               click(taxel(3)),
               kIdle,
               dump("probe.json"),
               key("Period"),
               kIdle,
               dump("near_probe.json")});
  for (const auto& [from, to] : {std::pair{"far.json", "near.json"}, std::pair{"probe.json", "near_probe.json"}}) {
    const Json far = studio.state(from), near = studio.state(to);
    EXPECT_LT(near["camera"]["distance"].get<double>(), 0.7 * far["camera"]["distance"].get<double>()) << to;
    ASSERT_FALSE(near["polygons"].empty()) << to;
    dvec2 middle(0);
    for (const Json& polygon : near["polygons"])
      middle += dvec2(polygon["pixel"][0], polygon["pixel"][1]) / static_cast<double>(near["polygons"].size());
    const Json& view = near["view"]["rect"];
    EXPECT_LT(glm::distance(middle, 0.5 * dvec2(view[0].get<double>() + view[2].get<double>(),
                                                view[1].get<double>() + view[3].get<double>())),
              60)
        << to;
  }
}

TEST(Framing, ComesNearTheContactOfARunUntilTheUserMovesTheCamera) {
  const StudioProgram studio;
  const auto drag = [](const char* event, double u) {
    return std::string(R"({"event": ")") + event + R"(", "at": )" + in_view(u, 0.2) + "}";
  };
  studio.play({kIdle,
               wait_time(0.3),
               dump("begins.json"),
               wait_time(1.5),
               dump("touches.json"),
               key("Space"),
               kIdle,
               key("Home"),
               kIdle,
               dump("whole.json"),
               drag("mouse_down", 0.4),
               kIdle,
               drag("mouse_move", 0.5),
               kIdle,
               drag("mouse_up", 0.5),
               kIdle,
               dump("turned.json"),
               key("Space"),
               wait_time(1.8),
               dump("later.json")},
              sparse_fingertip(studio, 1e5, "1280x800"));
  const Json begins = studio.state("begins.json"), touches = studio.state("touches.json"),
             whole = studio.state("whole.json");
  EXPECT_TRUE(begins["sensor_boxes"][0]["inside"]) << "the first view has the whole sensor";
  const double near = touches["contact"]["part_of_view"], far = whole["contact"]["part_of_view"];
  ASSERT_GT(far, 0);
  EXPECT_GT(near, 1.7 * far);
  for (const Json& polygon : touches["polygons"]) EXPECT_TRUE(polygon["inside"]);
  EXPECT_NE(studio.state("turned.json")["camera"], whole["camera"]);
  EXPECT_EQ(studio.state("later.json")["camera"], studio.state("turned.json")["camera"]) << "that of the user";
  EXPECT_GT(studio.state("later.json")["simulation"]["time"], 1.7);
}

TEST(Framing, SeesATipAsAFingerFromItsPad) {
  const StudioProgram studio;
  studio.play({kIdle, dump("layout.json"), R"({"do": "screenshot", "file": "layout.png"})"}, {kMeshFile});
  const Json layout = studio.state("layout.json");
  EXPECT_FALSE(layout["overlays"]["sensor_transparent"]);
  EXPECT_NEAR(layout["camera"]["azimuth_deg"].get<double>(), -90, 1e-9) << "the pad faces -y";
  EXPECT_NEAR(layout["camera"]["elevation_deg"].get<double>(), 20, 1e-9);
  EXPECT_NEAR(layout["camera"]["roll_deg"].get<double>(), 0, 1e-9) << "the tip is +z";
}

TEST(Simulate, ReportsThatTaxelsAreMissing) {
  for (const std::string& start : {kSimulateMode, key("Space")}) {
    const StudioProgram studio;
    studio.play({kIdle, start, kIdle, dump("asked.json")}, {kMeshFile});
    const Json state = studio.state("asked.json");
    EXPECT_EQ(state["mode"], "layout");
    EXPECT_NE(state["messages"].dump().find("the layout has no taxels"), std::string::npos) << start;
  }
}

/// Writes the fingertip, rotated so that it points along +y and touches with +z.
std::string turned_finger(const std::filesystem::path& folder) {
  const TriMesh finger = *load_mesh(kMeshFile).mesh;
  std::vector<dvec3> vertices = finger.vertices();
  for (dvec3& v : vertices) v = dvec3(v.x, v.z, -v.y);
  const std::string file = (folder / "turned.obj").string();
  save_mesh(file, TriMesh(vertices, finger.faces()));
  return file;
}

TEST(TipAndPad, AreGuessedShownAndSetByAClick) {
  const StudioProgram studio;
  studio.play({kIdle, dump("guess.json"), R"({"do": "screenshot", "file": "arrows.png"})", press("Click the tip"),
               kIdle, click(R"({"world": [0, -0.0075, 0.015]})"), kIdle, dump("clicked.json")},
              {"--state-dir", "state", "--size", "1500x1800", kMeshFile});
  const Json guess = studio.state("guess.json"), clicked = studio.state("clicked.json");
  EXPECT_TRUE(guess["frame_guess"]["is_guess"]);
  EXPECT_EQ(guess["frame_guess"]["arrows"], 2);
  EXPECT_EQ(guess["document"]["layout"]["frame"]["distal"], Json({0.0, 0.0, 1.0}));
  EXPECT_EQ(guess["document"]["layout"]["frame"]["pad"], Json({0.0, -1.0, 0.0}));
  EXPECT_FALSE(clicked["frame_guess"]["is_guess"]);
  EXPECT_EQ(clicked["frame_guess"]["arrows"], 0);
  EXPECT_EQ(clicked["document"]["layout"]["frame"]["distal"], Json({0.0, -1.0, 0.0}));
  EXPECT_EQ(clicked["document"]["layout"]["frame"]["pad"], Json({0.0, 0.0, 1.0})) << "exchanged";
  EXPECT_TRUE(clicked["document"]["layout"]["taxels"].empty());

  studio.play({kIdle, dump("turned.json"), press("Confirm tip and pad"), kIdle, dump("confirmed.json")},
              {"--state-dir", "state", "--size", "1500x1800", turned_finger(studio.folder())});
  const Json frame = studio.state("turned.json")["document"]["layout"]["frame"];
  EXPECT_EQ(frame["distal"], Json({0.0, 1.0, 0.0}));
  EXPECT_EQ(frame["pad"], Json({0.0, 0.0, 1.0}));
  EXPECT_FALSE(studio.state("confirmed.json")["frame_guess"]["is_guess"]);
}

}  // namespace
}  // namespace taxel::test
