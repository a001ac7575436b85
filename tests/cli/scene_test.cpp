// `taxel run` on scenes of the predecessor, on a whole robot hand, and on scenes that cannot run.
#include <cmath>
#include <sstream>

#include "cli/taxel_program.h"
#include "core/base/math.h"
#include "fixtures/finger_scene_xml.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

/// The published scenes of the predecessor: the force on the foam is the weight of the bodies on it.
TEST(Scenes, RunUnmodifiedFromThePredecessorAndCarryTheWeight) {
  const fs::path real = TAXEL_REAL_DATA;
  if (!fs::exists(real / "myrmex_box_world.xml")) GTEST_SKIP() << real << " is absent";
  const fs::path folder = test_folder();
  // The box has MuJoCo's default density; the other bodies have a mass.
  const std::vector<std::pair<std::string, double>> scenes{{"myrmex_box_world.xml", 1000 * 0.2 * 0.2 * 0.2},
                                                           {"myrmex_plate_world.xml", 0.375},
                                                           {"myrmex_spot_world.xml", 0.375}};
  for (const auto& [scene, mass] : scenes) {
    const Json run = taxel_json({"run", (real / scene).string(), "--seconds", "1.2", "--out", scene + ".out"}, folder);
    EXPECT_EQ(run["sensors"][0]["geom"], "myrmex_foam") << scene;
    const Table table = read_csv(folder / (scene + ".out") / "readings.csv");
    const std::vector<double>& force = table.at("force_z");
    double mean = 0;
    const std::size_t last = 200;
    for (std::size_t i = force.size() - last; i < force.size(); ++i) mean += force[i] / static_cast<double>(last);
    EXPECT_NEAR(mean, -9.81 * mass, 0.02 * 9.81 * mass) << scene;
    double pressure = 0;
    for (const auto& [name, column] : table)
      if (name.starts_with("taxel_")) pressure += column.back();
    EXPECT_GT(pressure, 0) << scene;
  }
}

constexpr double kBallWeight = 9.81 * 0.06;  // of the scene's ball [N]

/// Runs the shipped hand and expects that it holds the ball at the end: no warning, all taxels respond, and the five
/// forces sum to the weight.
void expect_held_ball(const std::string& seconds, double tolerance) {
  const fs::path folder = test_folder(), scene = fs::path(TAXEL_SOURCE_DIR) / "assets/scenes/hand_grasps_ball.xml";
  const Outcome outcome = taxel({"run", scene.string(), "--seconds", seconds, "--out", "out", "--json"}, folder);
  EXPECT_EQ(outcome.err.find("warning"), std::string::npos) << outcome.err;
  const Json run = Json::parse(outcome.out);
  ASSERT_EQ(run["sensors"].size(), 5U);
  const Table table = read_csv(folder / "out" / "readings.csv");
  dvec3 sum(0);
  for (const Json& sensor : run["sensors"]) {
    const std::string geom = sensor["geom"];
    const std::size_t last = table.at(geom + "/area").size() - 1;
    const dvec3 force(table.at(geom + "/force_x")[last], table.at(geom + "/force_y")[last],
                      table.at(geom + "/force_z")[last]);
    EXPECT_GT(table.at(geom + "/area")[last], 1e-5) << geom;
    EXPECT_GT(glm::length(force), 0.05) << geom;
    for (int taxel = 0; taxel < 12; ++taxel)
      EXPECT_GT(table.at(geom + "/taxel_" + std::to_string(taxel))[last], 0) << geom << " " << taxel;
    sum += force;
  }
  EXPECT_NEAR(sum.z, -kBallWeight, tolerance * kBallWeight);
  EXPECT_LT(std::hypot(sum.x, sum.y), tolerance * kBallWeight);
}

TEST(Scenes, LiftTheBallOfTheExample) {
  expect_held_ball("1.2", 0.01);
}

TEST(Scenes, HoldTheBallOfTheExampleForTwentySeconds) {
  expect_held_ball("20", 1e-4);
}

/// The shells of the artificial hand have no mass and touch nothing: without them, every row has the same bytes.
TEST(Scenes, GiveTheSameReadingsWithAndWithoutVisualGeoms) {
  const fs::path folder = test_folder(), assets = fs::path(TAXEL_SOURCE_DIR) / "assets";
  std::istringstream lines(file_text(assets / "scenes/hand_grasps_ball.xml"));
  std::string bare;
  int removed = 0;
  for (std::string line; std::getline(lines, line);) {
    const bool visual = line.find("<geom class=\"shell\"") != std::string::npos ||
                        line.find("<geom class=\"hinge\"") != std::string::npos;
    removed += visual ? 1 : 0;
    if (!visual) bare += line + "\n";
  }
  EXPECT_EQ(removed, 27) << "palm, forearm, wrist, five of four fingers, and four of the thumb";
  fs::create_directories(folder / "scenes");
  for (const char* name : {"meshes", "layouts"}) fs::copy(assets / name, folder / name, fs::copy_options::recursive);
  write_text(folder / "scenes/bare.xml", bare);
  (void)taxel_json({"run", "scenes/bare.xml", "--seconds", "0.2", "--out", "bare"}, folder);
  (void)taxel_json({"run", (assets / "scenes/hand_grasps_ball.xml").string(), "--seconds", "0.2", "--out", "skin"},
                   folder);
  EXPECT_EQ(file_text(folder / "bare/readings.csv"), file_text(folder / "skin/readings.csv"));
}

TEST(Scenes, AreRefusedWithFileBodyAndNumber) {
  const fs::path folder = test_folder();
  write_text(folder / "primitive.xml", "<mujoco><worldbody><geom size='1'/></worldbody></mujoco>");
  expect_refusal(
      taxel({"run", "primitive.xml"}, folder),
      "taxel: primitive.xml: declares no taxel.sensor and no taxel.contact; attach a layout with --layout and --geom");
  write_text(folder / "no_plugin.xml",
             "<mujoco><extension><plugin plugin='mujoco.sdf.torus'><instance name='t'/></plugin></extension>"
             "<worldbody><geom size='1'/></worldbody></mujoco>");
  EXPECT_NE(taxel({"run", "no_plugin.xml"}, folder).err.find("loaded with --plugins FOLDER"), std::string::npos);

  fs::copy(fs::path(TAXEL_SOURCE_DIR) / "assets" / "meshes" / "fingertip.obj", folder);
  changed_layout(folder, Json::parse(R"([{"op": "replace", "path": "/mesh/file", "value": "fingertip.obj"},
                                         {"op": "replace", "path": "/sampling/density", "value": 1e6}])"));
  const std::vector<std::string> attach{"--layout", "changed.taxels.json", "--geom", "tip"};
  const auto run = [&](std::vector<std::string> more, const std::string& scene) {
    write_text(folder / "scene.xml", scene);
    std::vector<std::string> arguments{"run", "scene.xml", "--seconds", "0.3"};
    arguments.insert(arguments.end(), attach.begin(), attach.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return taxel(arguments, folder);
  };
  const std::string floor = finger_scene(finger_body("tip", 0, true, "<freejoint/>"));
  expect_refusal(run(attach, floor), "taxel: scene.xml: two layouts are attached to geom \"tip\": a geom takes one");
  // A finger of a few grams on a soft pad, with a time step that is far too long.
  std::string slow = floor;
  slow.insert(slow.find("<asset>"), "<option timestep='0.02'/>");
  const std::string told = run({}, slow).err;
  EXPECT_NE(told.find("is too stiff for the time step of 0.02 s"), std::string::npos) << told;
  EXPECT_NE(told.find("the largest stable step is 0.0"), std::string::npos) << told;
  // An unstable joint.
  std::string wild = floor;
  wild.insert(
      wild.find("</worldbody>"),
      "<body name='rocket' pos='1 0 1'><joint type='slide' axis='0 0 1' stiffness='-1e7'/><geom size='.1'/></body>");
  wild.insert(wild.find("<asset>"), "<option gravity='0 0 -1'/>");
  const Outcome unstable = run({}, wild);
  EXPECT_EQ(unstable.status, 2);
  EXPECT_NE(unstable.err.find("became unstable at"), std::string::npos) << unstable.err;
  EXPECT_NE(unstable.err.find("body \"rocket\""), std::string::npos) << unstable.err;
}

TEST(Scenes, AreRefusedIfTheTimeStepIsNotPositive) {
  const fs::path folder = test_folder();
  for (const std::string step : {"0", "-0.001", "nan"}) {
    write_text(folder / "step.xml",
               "<mujoco><option timestep='" + step + "'/><worldbody><geom name='g' size='1'/></worldbody></mujoco>");
    const std::string complaint = "taxel: step.xml: option timestep: must be greater than 0, is " + step;
    expect_refusal(taxel({"run", "step.xml", "--layout", TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json",
                          "--geom", "g", "--seconds", "0.01"},
                         folder),
                   complaint);
    EXPECT_EQ(taxel({"check", "step.xml"}, folder).err, complaint + "\n");
  }
}

TEST(Scenes, AreRefusedIfAGeomGetsTwoLayouts) {
  const fs::path folder = test_folder();
  fs::copy(fs::path(TAXEL_SOURCE_DIR) / "assets" / "meshes" / "fingertip.obj", folder);
  changed_layout(folder, Json::parse(R"([{"op": "replace", "path": "/mesh/file", "value": "fingertip.obj"},
                                         {"op": "replace", "path": "/sampling/density", "value": 1e6}])"));
  const auto write_scene = [&](const std::vector<std::string>& sensors) {
    std::string instances, reads;
    for (const std::string& name : sensors) {
      instances += "<instance name='" + name + "'><config key='layout' value='changed.taxels.json'/>" +
                   "<config key='geom' value='tip'/></instance>";
      reads += "<plugin name='" + name + "' plugin='taxel.sensor' instance='" + name + "'/>";
    }
    std::string scene = finger_scene(finger_body("tip", 0, true, "<freejoint/>"));
    scene.insert(scene.find("<asset>"),
                 "<extension><plugin plugin='taxel.sensor'>" + instances + "</plugin></extension>");
    scene.insert(scene.find("</mujoco>"), "<sensor>" + reads + "</sensor>");
    write_text(folder / "scene.xml", scene);
  };
  write_scene({"left", "right"});
  expect_refusal(taxel({"run", "scene.xml"}, folder),
                 "taxel: scene.xml: geom \"tip\" has two sensors, \"left\" and \"right\": a geom takes one layout");
  write_scene({"left"});
  expect_refusal(taxel({"run", "scene.xml", "--layout", "changed.taxels.json", "--geom", "tip"}, folder),
                 "taxel: scene.xml: geom \"tip\" has a sensor already, \"left\": a geom takes one layout");
  expect_refusal(
      taxel({"run", "scene.xml", "--layout", "changed.taxels.json", "--geom", "top"}, folder),
      "taxel: scene.xml: taxel.sensor \"taxels of top\": geom: there is no geom named \"top\"; if <compiler "
      "discardvisual=\"true\"/> has removed it because it cannot collide, leave that out, or, for the geom of "
      "a sensor, let the entry under <sensor> refer to it (objtype=\"geom\" objname=\"top\")");
}

TEST(Scenes, SayThatAFlexTakesNoLayout) {
  const fs::path folder = test_folder();
  write_text(folder / "scene.xml",
             "<mujoco><worldbody><flexcomp name='cloth' type='grid' count='4 4 1' spacing='.01 .01 .01' mass='.1' "
             "radius='.001' dim='2'><edge equality='true'/></flexcomp></worldbody></mujoco>");
  const std::string layout = TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json";
  expect_refusal(taxel({"attach", "scene.xml", "--layout", layout, "--geom", "cloth", "--out", "out.xml"}, folder),
                 "taxel: scene.xml: taxel.sensor \"taxels of cloth\": geom: there is no geom named \"cloth\"; it is a "
                 "flex, and taxels need a geom with the mesh of their layout: give a rigid body that mesh");
  expect_refusal(taxel({"attach", "scene.xml", "--layout", layout, "--body", "cloth_1", "--out", "out.xml"}, folder),
                 "taxel: scene.xml: body \"cloth_1\" has no geoms, and taxels need one with a mesh");
  EXPECT_FALSE(fs::exists(folder / "out.xml"));
}

}  // namespace
}  // namespace taxel::test
