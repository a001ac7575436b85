// Layouts on the geoms of a scene in the window: made, edited while the scene runs, attached to sister geoms and saved.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "fixtures/run_program.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

namespace fs = std::filesystem;

/// A hand of three fingers whose geoms have no names, as those of most robots, above a floor. Each finger is pressed
/// onto the floor by its weight.
constexpr const char* kHand = R"(<mujoco><option timestep='.001' integrator='implicitfast'/>
  <asset><mesh name='tip' file='fingertip.obj'/></asset><worldbody>
  <geom name='floor' type='plane' size='.2 .2 .1'/>
  <body name='index' pos='0 0 .0085' quat='.70710678 .70710678 0 0'><joint type='slide' axis='0 1 0' damping='1'/>
    <geom type='mesh' mesh='tip' mass='.05'/></body>
  <body name='middle' pos='.05 0 .0085' quat='.70710678 .70710678 0 0'><joint type='slide' axis='0 1 0' damping='1'/>
    <geom type='mesh' mesh='tip' mass='.05'/></body>
  <body name='ring' pos='.1 0 .0085' quat='.70710678 .70710678 0 0'><joint type='slide' axis='0 1 0' damping='1'/>
    <geom type='mesh' mesh='tip' mass='.05'/></body>
  <body name='ball' pos='-.1 0 .02'><geom name='ball' type='sphere' size='.01'/></body>
  </worldbody></mujoco>)";

void write_hand(const fs::path& folder) {
  fs::copy_file(kMeshFile, folder / "fingertip.obj");
  write_text(folder / "hand.xml", kHand);
}
std::string double_click_at(double x, double y, double z) {
  return R"({"event": "double_click", "button": "left", "at": )" + Json{{"world", {x, y, z}}}.dump() + "}";
}
std::string picture(const std::string& name) {
  return R"({"do": "screenshot", "file": ")" + name + R"("})";
}
Lines type_over(const std::string& label, const std::string& text) {
  return {press(label), kIdle, key("a", kCtrl), kIdle, type(text), kIdle, key("Enter"), kIdle, kIdle};
}
std::string messages_of(const Json& state) {
  return state["messages"].dump();
}
/// Lines that make a layout of generated taxels on the geom of the index finger and simulate with it.
Lines make_layout_on_index() {
  return {kIdle,
          key("Space"),
          kIdle,
          double_click_at(0, 0, 0.0085),
          kIdle,
          dump("chosen.json"),
          press("Controls/New layout on this geom"),
          kIdle,
          kIdle,
          dump("new.json"),
          picture("new.png"),
          key("g", kCtrl),
          kIdle,
          kIdle,
          press("Generate/Add taxels"),
          kIdle,
          kIdle,
          key("Escape"),
          kIdle,
          key("a"),
          kIdle,
          dump("made.json"),
          picture("made.png"),
          key("2", kCtrl),
          kIdle,
          kIdle,
          dump("felt.json")};
}

TEST(SceneLayout, SaysInLayoutModeHowToMakeAnotherOne) {
  const StudioProgram studio;
  write_hand(studio.folder());
  studio.play({kIdle, key("Space"), kIdle, kLayoutMode, kIdle, kIdle, dump("empty.json"), picture("empty.png"),
               double_click_at(0.05, 0, 0.0085), kIdle, dump("chosen.json"), press("New layout on middle, tip"), kIdle,
               kIdle, dump("new.json"), press("All layouts"), kIdle, dump("all.json")},
              {"--size", "1400x900", "hand.xml"});
  const Json empty = studio.state("empty.json");
  EXPECT_EQ(empty["mode"], "layout");
  EXPECT_TRUE(empty["scene_layout"].is_null());
  std::string labels;
  for (const Json& widget : empty["widgets"]) labels += widget["label"].get<std::string>() + "|";
  for (const char* label : {"Layouts of this scene", "New layout on this geom", "Attach a layout file...",
                            "Open a mesh or another file..."})
    EXPECT_NE(labels.find(label), std::string::npos) << label << " in " << labels;
  EXPECT_EQ(studio.state("chosen.json")["scene"]["chosen"], Json({"middle"}));
  EXPECT_EQ(studio.state("new.json")["scene_layout"]["geoms"], Json({"middle"}));
  EXPECT_TRUE(studio.state("all.json")["scene_layout"].is_null());
}

TEST(SceneLayout, HasAReadableHeadingOnABrightSky) {
  const StudioProgram studio;
  studio.play({kIdle, key("Space"), kIdle, kLayoutMode, kIdle, kIdle, dump("layout.json"), picture("layout.png")},
              {TAXEL_SOURCE_DIR "/assets/scenes/hand_grasps_ball.xml"});
  const Json rect = studio.state("layout.json")["view"]["rect"];
  const Picture layout = studio.picture("layout.png");
  const auto light = [&](double x, double y) {  // at a distance from the upper left corner of the view
    const std::array<int, 3> pixel = layout.pixel(rect[0].get<double>() + x, rect[1].get<double>() + y);
    return (pixel[0] + pixel[1] + pixel[2]) / 3;
  };
  EXPECT_LT(light(83, 20), 90) << "the plate, left of the name of the scene";
  EXPECT_GT(light(300, 20), 150) << "the sky";
}

TEST(SceneLayout, IsMadeOnAGeomFeltEditedAttachedAndSaved) {
  const StudioProgram studio;
  write_hand(studio.folder());
  const std::string folder = fs::canonical(studio.folder()).string();
  studio.play(joined({make_layout_on_index(),
                      {key("Space"), wait_time(0.05), key("Space"), kIdle, dump("before.json"), picture("before.png"),
                       press("Inspector tab"), kIdle},
                      type_over("Inspector/Radius (mm)", "4"),
                      {dump("edited.json"),
                       key("z", kCtrl),
                       kIdle,
                       kIdle,
                       dump("undone.json"),
                       key("y", kCtrl),
                       kIdle,
                       kIdle,
                       kLayoutMode,
                       kIdle,
                       press("Attach to every geom of this mesh"),
                       kIdle,
                       kIdle,
                       dump("attached.json"),
                       picture("attached.png"),
                       key("s", kCtrl),
                       kIdle,
                       dump("saved.json"),
                       key("2", kCtrl),
                       kIdle,
                       key("Space"),
                       wait_time(0.05),
                       key("Space"),
                       kIdle,
                       dump("stepped.json"),
                       key("s", kCtrlShift),
                       kIdle,
                       type(folder + "/felt.xml"),
                       kIdle,
                       key("Enter"),
                       kIdle,
                       kIdle,
                       dump("scene.json")}}),
              tall_window(studio, "hand.xml"));
  const Json made = studio.state("new.json"), felt = studio.state("felt.json"), edited = studio.state("edited.json");
  EXPECT_EQ(made["mode"], "layout");
  EXPECT_EQ(made["scene_layout"]["geoms"], Json({"index"}));
  EXPECT_EQ(made["scene_layout"]["file"], folder + "/index.taxels.json");
  ASSERT_FALSE(made["document"].is_null());
  EXPECT_EQ(made["document"]["layout"]["mesh"]["file"], folder + "/fingertip.obj");
  EXPECT_TRUE(felt["history"]["dirty"]);
  ASSERT_EQ(felt["simulation"]["sensors"].size(), 1U) << messages_of(felt);
  // The edit of a radius is felt in the same step of the same run, and undone and redone there.
  const Json before = studio.state("before.json"), undone = studio.state("undone.json");
  EXPECT_EQ(edited["simulation"]["step"], before["simulation"]["step"]);
  EXPECT_GT(before["simulation"]["step"], 10);
  EXPECT_NE(edited["simulation"]["sensors"][0]["readings"], before["simulation"]["sensors"][0]["readings"]);
  EXPECT_EQ(undone["simulation"]["sensors"][0]["readings"], before["simulation"]["sensors"][0]["readings"]);
  // The other fingers get the layout with its edit.
  const Json attached = studio.state("attached.json"), stepped = studio.state("stepped.json");
  EXPECT_EQ(attached["scene_layout"]["geoms"], Json({"index", "middle", "ring"}));
  EXPECT_EQ(attached["mode"], "layout");
  ASSERT_EQ(stepped["simulation"]["sensors"].size(), 3U) << messages_of(stepped);
  const Json saved = studio.state("saved.json");
  EXPECT_FALSE(saved["history"]["dirty"]) << messages_of(saved);
  const Json layout = Json::parse(file_text(studio.folder() / "index.taxels.json"));
  EXPECT_EQ(layout["mesh"]["file"], "fingertip.obj") << "relative to the layout";
  for (const Json& taxel : layout["taxels"]) EXPECT_NEAR(taxel["radius"].get<double>(), 0.004, 1e-12);
  EXPECT_EQ(file_text(studio.folder() / "hand.xml"), kHand) << "the scene's file stays as it is";
  // The saved scene has the sensors and reads as the window does.
  ASSERT_TRUE(fs::exists(studio.folder() / "felt.xml")) << messages_of(studio.state("scene.json"));
  studio.play({kIdle, key("Space"), kIdle, key("Backspace"), kIdle, key("Space"), wait_time(0.05), key("Space"), kIdle,
               dump("again.json")},
              {"felt.xml"});
  const Json again = studio.state("again.json")["simulation"]["sensors"];
  ASSERT_EQ(again.size(), 3U);
  EXPECT_EQ(studio.state("again.json")["simulation"]["step"], stepped["simulation"]["step"]);
  EXPECT_GT(again[0]["max_pressure"], 0);
  for (std::size_t i = 0; i < again.size(); ++i)
    EXPECT_EQ(again[i]["readings"], stepped["simulation"]["sensors"][i]["readings"]);
}

/// A slider closes the hand; it stays closed with the sensors of more fingers. The file dialog suggests a name that can
/// be saved at once.
TEST(SceneLayout, KeepsControlsWhenFingersAreAddedAndSuggestsAName) {
  const StudioProgram studio;
  write_hand(studio.folder());
  std::string hand = kHand;
  hand.replace(hand.find("<joint"), 6, "<joint name='lift'");
  hand.replace(hand.find("</worldbody>"), 12,
               "</worldbody><actuator><motor name='lift' joint='lift' ctrlrange='0 2'/></actuator>");
  write_text(studio.folder() / "hand.xml", hand);
  studio.play(joined({make_layout_on_index(),
                      {press("Actuator lift"), kIdle, kLayoutMode, kIdle, press("Attach to every geom of this mesh"),
                       kIdle, kIdle, dump("attached.json"), key("s", kCtrlShift), kIdle, key("Enter"), kIdle, kIdle,
                       dump("saved.json")}}),
              tall_window(studio, "hand.xml"));
  const Json attached = studio.state("attached.json");
  EXPECT_EQ(attached["scene_layout"]["geoms"].size(), 3U) << messages_of(attached);
  EXPECT_EQ(attached["simulation"]["step"], 0);
  EXPECT_EQ(attached["scene"]["actuators"], Json::parse(R"([{"name": "lift", "value": 1.0}])"));
  EXPECT_TRUE(fs::exists(studio.folder() / "hand_taxels.xml")) << messages_of(studio.state("saved.json"));
}

TEST(SceneLayout, AsksBeforeUnsavedEditsAreLostAndSaysWhyAGeomTakesNone) {
  const StudioProgram studio;
  write_hand(studio.folder());
  studio.play(joined({make_layout_on_index(),
                      {kLayoutMode,
                       kIdle,
                       press("All layouts"),
                       kIdle,
                       dump("asked.json"),
                       press("Discard"),
                       kIdle,
                       kIdle,
                       dump("discarded.json"),
                       key("2", kCtrl),
                       kIdle,
                       kIdle,
                       dump("without.json"),
                       press("Outliner/floor"),
                       kIdle,
                       key("k", kCtrl),
                       kIdle,
                       type("new layout on this"),
                       kIdle,
                       key("Enter"),
                       kIdle,
                       kIdle,
                       dump("floor.json")}}),
              tall_window(studio, "hand.xml"));
  EXPECT_TRUE(studio.state("asked.json")["scene_layout"].is_object()) << "the question is open";
  EXPECT_TRUE(studio.state("discarded.json")["scene_layout"].is_null());
  EXPECT_TRUE(studio.state("without.json")["simulation"]["sensors"].empty());
  EXPECT_FALSE(fs::exists(studio.folder() / "index.taxels.json"));
  const std::string messages = messages_of(studio.state("floor.json"));
  EXPECT_NE(messages.find("No layout can be on geom floor of body world: it is a plane"), std::string::npos)
      << messages;
}

TEST(SceneLayout, SaysThatAHeightFieldCanOnlyBeRigid) {
  const StudioProgram studio;
  write_text(studio.folder() / "hill.xml",
             "<mujoco><asset><hfield name='hill' nrow='2' ncol='2' size='.05 .05 .01 .01' elevation='0 1 1 0'/></asset>"
             "<worldbody><geom name='hill' type='hfield' hfield='hill'/></worldbody></mujoco>");
  studio.play({kIdle, press("Outliner/hill"), kIdle, press("Controls/New layout on this geom"), kIdle, kIdle,
               dump("hill.json")},
              tall_window(studio, "hill.xml"));
  const Json hill = studio.state("hill.json");
  EXPECT_NE(messages_of(hill).find("No layout can be on geom hill of body world: it is a height field, which can only "
                                   "be rigid. Choose a mesh, box,"),
            std::string::npos)
      << messages_of(hill);
  EXPECT_TRUE(hill["scene_layout"].is_null());
}

TEST(SceneLayout, PutsAPrimitiveOnAMeshOfItsOwn) {
  const StudioProgram studio;
  write_hand(studio.folder());
  studio.play({kIdle,
               key("Space"),
               kIdle,
               press("Outliner/ball"),
               kIdle,
               press("Controls/New layout on this geom"),
               kIdle,
               kIdle,
               key("g", kCtrl),
               kIdle,
               kIdle,
               press("Generate/Add taxels"),
               kIdle,
               kIdle,
               key("s", kCtrl),
               kIdle,
               dump("saved.json"),
               key("2", kCtrl),
               kIdle,
               kIdle,
               dump("felt.json")},
              tall_window(studio, "hand.xml"));
  const Json felt = studio.state("felt.json");
  ASSERT_EQ(felt["simulation"]["sensors"].size(), 1U) << messages_of(felt);
  ASSERT_TRUE(fs::exists(studio.folder() / "ball.taxels.json")) << messages_of(felt);
  const Json layout = Json::parse(file_text(studio.folder() / "ball.taxels.json"));
  EXPECT_EQ(layout["mesh"]["file"], "ball.obj");
  EXPECT_TRUE(fs::exists(studio.folder() / "ball.obj"));
}

/// A layout that the scene's file declares is edited in place; the shared layout changes on all of its geoms.
TEST(SceneLayout, EditsADeclaredLayoutOnAllItsGeoms) {
  const StudioProgram studio;
  studio.play(joined({{kIdle, wait_time(0.1), key("Space"), kIdle, dump("before.json"),
                       R"({"event": "double_click", "button": "left", "at": {"widget": "Outliner/index"}})", kIdle,
                       kIdle, dump("layout.json"), picture("layout.png"), key("a"), kIdle, key("2", kCtrl), kIdle,
                       press("Inspector tab"), kIdle},
                      type_over("Inspector/Radius (mm)", "2"),
                      {dump("edited.json")}}),
              {"--size", "1500x1400", TAXEL_SOURCE_DIR "/assets/scenes/hand_grasps_ball.xml"});
  const Json layout = studio.state("layout.json"), before = studio.state("before.json");
  EXPECT_EQ(layout["mode"], "layout");
  ASSERT_TRUE(layout["scene_layout"].is_object()) << messages_of(layout);
  EXPECT_EQ(layout["scene_layout"]["geoms"].size(), 5U);
  EXPECT_EQ(layout["scene_layout"]["is_written"], true);
  EXPECT_FALSE(layout["history"]["dirty"]);
  const Json edited = studio.state("edited.json");
  EXPECT_EQ(edited["simulation"]["step"], before["simulation"]["step"]) << messages_of(edited);
  EXPECT_TRUE(edited["history"]["dirty"]);
}

/// Writes the hand with sensors on two fingers, declared with `layout` as the value of their keys.
void write_declared(const fs::path& folder, const std::string& layout) {
  write_hand(folder);
  Json file = Json::parse(file_text(kLayoutFile));
  file["mesh"]["file"] = "fingertip.obj";
  write_text(folder / "tip.taxels.json", file.dump(1));
  std::string hand = kHand, instances, sensors;
  for (const char* finger : {"index", "middle"}) {
    const std::string body = std::string("<body name='") + finger + "'";
    const std::size_t geom = hand.find("<geom ", hand.find(body));
    hand.insert(geom + 6, std::string("name='") + finger + "' contype='0' conaffinity='0' ");
    instances += std::string("<instance name='") + finger + "'><config key='layout' value='" + layout +
                 "'/><config key='geom' value='" + finger + "'/><config key='others' value='floor'/></instance>\n";
    sensors += std::string("<plugin plugin='taxel.sensor' instance='") + finger + "'/>";
  }
  hand.insert(hand.find("<asset>"), "<!-- declared -->\n<extension><plugin plugin='taxel.sensor'>\n" + instances +
                                        "</plugin></extension>\n<sensor>" + sensors + "</sensor>\n");
  write_text(folder / "hand.xml", hand);
}

/// Lines that remove a taxel of the layout of the index finger, and let its hand feel without it for a time.
Lines feel_without_a_taxel() {
  return {kIdle,
          key("Space"),
          kIdle,
          R"({"event": "double_click", "button": "left", "at": {"widget": "Outliner/index"}})",
          kIdle,
          kIdle,
          dump("layout.json"),
          click(taxel(3)),
          kIdle,
          key("Delete"),
          kIdle,
          kIdle,
          key("2", kCtrl),
          kIdle,
          kIdle,
          key("Backspace"),
          kIdle,
          key("Space"),
          wait_time(0.05),
          key("Space"),
          kIdle,
          dump("felt.json")};
}

#ifdef TAXEL_PROGRAM
/// Expects that `taxel run` reads a scene as the window does in felt.json.
void expect_run_as_felt(const StudioProgram& studio, const std::string& scene) {
  const Json felt = studio.state("felt.json")["simulation"];
  constexpr double kStep = 0.001;  // of the scene [s]
  const std::string seconds = std::to_string(kStep * felt["step"].get<double>());
  const Outcome outcome =
      run_program(TAXEL_PROGRAM, {"run", scene, "--seconds", seconds, "--out", scene + ".run"}, studio.folder());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::istringstream csv(file_text(studio.folder() / (scene + ".run/readings.csv")));
  std::string heads, line, last;
  std::getline(csv, heads);
  while (std::getline(csv, line)) last = line;
  std::istringstream names(heads), values(last);
  std::string name, value;
  std::vector<double> readings, expected;
  while (std::getline(names, name, ',') && std::getline(values, value, ','))
    if (name.find("/taxel_") != std::string::npos) readings.push_back(std::stod(value));
  ASSERT_EQ(felt["sensors"].size(), 2U);
  for (const Json& sensor : felt["sensors"])
    for (const Json& reading : sensor["readings"]) expected.push_back(reading.get<double>());
  EXPECT_EQ(expected.size(), 22U) << "both fingers have a taxel less";
  EXPECT_GT(*std::max_element(expected.begin(), expected.end()), 0);
  EXPECT_EQ(readings, expected);
}

TEST(SceneLayout, SavesAnEditedDeclaredLayoutNextToThePatchedScene) {
  const StudioProgram studio;
  write_declared(studio.folder(), "tip.taxels.json");
  const std::string hand = file_text(studio.folder() / "hand.xml"),
                    tip = file_text(studio.folder() / "tip.taxels.json");
  studio.play(joined({feel_without_a_taxel(),
                      {key("s", kCtrlShift), kIdle, type((studio.folder() / "felt.xml").string()), kIdle, key("Enter"),
                       kIdle, kIdle, dump("saved.json")}}),
              tall_window(studio, "hand.xml"));
  EXPECT_EQ(studio.state("layout.json")["scene_layout"]["geoms"], Json({"index", "middle"}));
  EXPECT_NE(messages_of(studio.state("layout.json")).find("index, middle have this layout, and change with it."),
            std::string::npos);
  const Json saved = studio.state("saved.json");
  EXPECT_TRUE(saved["history"]["dirty"]) << "the open scene keeps its layout";
  EXPECT_NE(messages_of(saved).find("felt.xml has the edited layout. The open scene has its layout of before"),
            std::string::npos)
      << messages_of(saved);
  EXPECT_EQ(file_text(studio.folder() / "hand.xml"), hand);
  EXPECT_EQ(file_text(studio.folder() / "tip.taxels.json"), tip);
  std::string patched = hand;
  for (std::size_t at = 0; (at = patched.find("tip.taxels.json", at)) != std::string::npos; at += 10)
    patched.insert(at, "felt_");
  EXPECT_EQ(file_text(studio.folder() / "felt.xml"), patched);
  EXPECT_EQ(Json::parse(file_text(studio.folder() / "felt_tip.taxels.json"))["taxels"].size(), 11U);
  expect_run_as_felt(studio, "felt.xml");
  studio.play(joined({feel_without_a_taxel(), {key("s", kCtrl), kIdle, kIdle, dump("in_place.json")}}),
              tall_window(studio, "hand.xml"));
  EXPECT_FALSE(studio.state("in_place.json")["history"]["dirty"]) << messages_of(studio.state("in_place.json"));
  EXPECT_EQ(file_text(studio.folder() / "hand.xml"), hand);
  EXPECT_EQ(Json::parse(file_text(studio.folder() / "tip.taxels.json"))["taxels"].size(), 11U);
  expect_run_as_felt(studio, "hand.xml");
}

TEST(SceneLayout, SavesADeclaredLayoutThatIsTextAsAFile) {
  const StudioProgram studio;
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = "fingertip.obj";
  write_declared(studio.folder(), layout.dump());
  std::string hand = file_text(studio.folder() / "hand.xml");
  studio.play(joined({feel_without_a_taxel(), {key("s", kCtrl), kIdle, kIdle, kIdle, dump("saved.json")}}),
              tall_window(studio, "hand.xml"));
  const Json saved = studio.state("saved.json");
  EXPECT_FALSE(saved["history"]["dirty"]) << messages_of(saved);
  const std::string file = fs::path(studio.state("felt.json")["scene_layout"]["file"].get<std::string>()).filename();
  ASSERT_TRUE(fs::exists(studio.folder() / file)) << messages_of(saved);
  for (std::size_t at = 0; (at = hand.find(layout.dump())) != std::string::npos;)
    hand.replace(at, layout.dump().size(), file);
  EXPECT_EQ(file_text(studio.folder() / "hand.xml"), hand);
  expect_run_as_felt(studio, "hand.xml");
}
#endif

}  // namespace
}  // namespace taxel::test
