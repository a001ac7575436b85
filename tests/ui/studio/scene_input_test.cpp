// Scenes and layouts that do not match: they are attached, and the mismatch is reported.
#include <gtest/gtest.h>

#include "script_lines.h"

namespace taxel::test {
namespace {

/// Writes the scene, a mesh and a coarse layout on the mesh.
void write_scene(const StudioProgram& studio, const std::string& xml) {
  std::filesystem::copy_file(kMeshFile, studio.folder() / "fingertip.obj",
                             std::filesystem::copy_options::skip_existing);
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"] = {{"file", "fingertip.obj"}, {"scale", {1, 1, 1}}};
  layout["sampling"]["density"] = 1e6;
  write_text(studio.folder() / "tip.taxels.json", layout.dump());
  write_text(studio.folder() / "scene.xml", xml);
}

TEST(SceneInput, ReportsAnotherMeshNoMeshAndALongTimeStep) {
  const StudioProgram studio;
  write_scene(studio, R"(<mujoco><option timestep='.02'/><asset>
    <mesh name='larger' file='fingertip.obj' scale='1.1 1.1 1.1'/></asset><worldbody>
    <geom name='floor' type='plane' size='.2 .2 .1'/>
    <body pos='0 0 .0061' quat='.70710678 .70710678 0 0'><freejoint/><geom name='large' type='mesh' mesh='larger'/></body>
    <body pos='.05 0 .0061' quat='.70710678 .70710678 0 0'><freejoint/><geom name='ball' size='.008'/></body>
    </worldbody></mujoco>)");
  studio.play({kIdle, key("Space"), kIdle, dump("open.json"), press("large"), kIdle, press("ball"), kIdle,
               press("Attach a layout to 2 geoms..."), kIdle, type((studio.folder() / "tip.taxels.json").string()),
               kIdle, key("Enter"), kIdle, kIdle, key("Right"), kIdle, dump("attached.json")},
              tall_window(studio, "scene.xml"));
  EXPECT_TRUE(studio.state("open.json")["messages"].empty()) << studio.state("open.json")["messages"];
  const Json attached = studio.state("attached.json");
  EXPECT_EQ(attached["simulation"]["sensors"].size(), 2U);
  const std::string said = attached["messages"].dump();
  for (const char* words : {"the mesh of geom \\\"large\\\" is not the layout's", "geom \\\"ball\\\" has no mesh",
                            " mm apart", "too stiff for the time step of 0.02 s", "the largest stable step is 0.0"})
    EXPECT_NE(said.find(words), std::string::npos) << words << "\n" << said;
}

TEST(SceneInput, RefusesTwoSensorsOnAGeomAndATimeStepOfZero) {
  const StudioProgram studio;
  const std::string instance =
      "<config key='layout' value='tip.taxels.json'/><config key='geom' value='tip'/></instance>";
  const auto refused = [&](const std::string& xml) {
    write_scene(studio, xml);
    const Outcome outcome = studio.run({kIdle, dump("state.json")}, {"scene.xml"});
    EXPECT_EQ(outcome.status, 2);
    return outcome.err;
  };
  EXPECT_NE(refused("<mujoco><option timestep='0'/><worldbody><geom size='1'/></worldbody></mujoco>")
                .find("scene.xml: option timestep: must be greater than 0, is 0"),
            std::string::npos);
  EXPECT_NE(refused("<mujoco><extension><plugin plugin='taxel.sensor'><instance name='a'>" + instance +
                    "<instance name='b'>" + instance +
                    R"(</plugin></extension><asset><mesh name='tip' file='fingertip.obj'/></asset><worldbody>
    <geom name='tip' type='mesh' mesh='tip'/></worldbody><sensor><plugin name='a' plugin='taxel.sensor' instance='a'/>
    <plugin name='b' plugin='taxel.sensor' instance='b'/></sensor></mujoco>)")
                .find("geom \"tip\" has two sensors, \"a\" and \"b\": a geom takes one layout"),
            std::string::npos);
}

}  // namespace
}  // namespace taxel::test
