// Source files of a scene, as MuJoCo finds them.
#include "core/sim/scene/loaded_scene.h"

#include <gtest/gtest.h>

#include "core/mesh/mesh_io.h"
#include "core/sim/scene/mjcf_text.h"
#include "core/sim/simulator.h"
#include "fixtures/temp_folder.h"

namespace taxel::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names(const std::vector<std::string>& files, const fs::path& folder) {
  std::vector<std::string> out;
  for (const std::string& file : files) out.push_back(fs::path(file).lexically_relative(folder).string());
  return out;
}

void write_text(const fs::path& path, std::string_view text) {
  write_file_atomically(path, text);
}

constexpr const char* kNothing = "<mujoco><worldbody/></mujoco>";

TEST(SceneSources, AreTheFilesThatMujocoReads) {
  const TempFolder temp;
  const fs::path folder = temp.path();
  for (const char* name : {"parts", "models", "meshes"}) fs::create_directories(folder / name);
  save_mesh(folder / "meshes/ball.obj", *load_mesh(TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj").mesh);
  fs::copy_file(folder / "meshes/ball.obj", folder / "models/other.obj");
  // 2 x 2 heights
  write_text(folder / "meshes/hill.bin", std::string("\2\0\0\0\2\0\0\0", 8) + std::string(16, '\0'));
  write_text(folder / "scene.xml", R"(<mujoco><compiler meshdir="meshes"/>
    <!-- <include file="not_this.xml"/> --> <include
      file = 'parts/a.xml' />
    <asset><mesh name="ball" file="ball.obj"/><hfield name="hill" file="hill.bin" size="1 1 1 1"/>
      <model name="m" file="models/m.xml"/></asset>
    <worldbody><body><geom type="mesh" mesh="ball"/></body><geom type="hfield" hfield="hill"/>
      <body><attach model="m" body="b" prefix="m_"/></body></worldbody></mujoco>)");
  write_text(folder / "parts/a.xml", R"(<mujoco><include file="here.xml"/><include file="both.xml"/></mujoco>)");
  write_text(folder / "parts/here.xml", kNothing);
  write_text(folder / "parts/both.xml", "not read: the one next to the scene is");
  write_text(folder / "both.xml", kNothing);
  write_text(folder / "not_this.xml", kNothing);
  write_text(folder / "models/m.xml",
             R"(<mujoco><include file="inner.xml"/><asset><mesh name="o" file="other.obj"/></asset>
    <worldbody><body name="b"><geom type="mesh" mesh="o"/></body></worldbody></mujoco>)");
  write_text(folder / "models/inner.xml", kNothing);
  const auto simulator = Simulator::load(folder / "scene.xml");
  EXPECT_EQ(names(simulator->scene()->files, folder),
            (std::vector<std::string>{"both.xml", "meshes/ball.obj", "meshes/hill.bin", "models/inner.xml",
                                      "models/m.xml", "models/other.obj", "parts/a.xml", "parts/here.xml"}));
}

TEST(SceneSources, IncludeTheLayoutsOfTheScene) {
  const TempFolder temp;
  fs::create_directories(temp / "layouts");
  fs::copy_file(TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj", temp / "fingertip.obj");
  fs::copy_file(TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj", temp / "layouts/own.obj");
  write_text(temp / "layouts/few.taxels.json", R"({"format": "taxel-layout", "version": 1, "mesh": {"file": "own.obj"},
    "sampling": {"density": 1e4}, "taxels": [{"id": 0, "center": [0, 0, 0.03], "normal": [0, 0, 1], "radius": 0.01}]})");
  write_text(temp / "scene.xml", R"(<mujoco><extension><plugin plugin="taxel.sensor"><instance name="s">
    <config key="layout" value="layouts/few.taxels.json"/><config key="geom" value="tip"/></instance></plugin></extension>
    <asset><mesh name="tip" file="fingertip.obj"/></asset>
    <worldbody><body><freejoint/><geom name="tip" type="mesh" mesh="tip"/></body></worldbody>
    <sensor><plugin name="t" plugin="taxel.sensor" instance="s"/></sensor></mujoco>)");
  const auto simulator = Simulator::load(temp / "scene.xml");
  EXPECT_EQ(names(simulator->scene()->files, temp.path()),
            (std::vector<std::string>{"fingertip.obj", "layouts/few.taxels.json", "layouts/own.obj"}));
}

TEST(SceneSources, EndForAnIncludeThatIncludesItself) {
  const TempFolder temp;
  write_text(temp.path() / "scene.xml", R"(<mujoco><include file="a.xml"/></mujoco>)");
  write_text(temp.path() / "a.xml", R"(<mujoco><include file="a.xml"/><include file="scene.xml"/></mujoco>)");
  EXPECT_EQ(included_files(temp.path() / "scene.xml"), std::vector<fs::path>{temp.path() / "a.xml"});
}

}  // namespace
}  // namespace taxel::test
