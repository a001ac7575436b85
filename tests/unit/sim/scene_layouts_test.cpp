// Layouts in MuJoCo scenes that only the compiled scene has.
#include "core/sim/scene/scene_layouts.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/files.h"
#include "core/layout/formats/layout_format.h"
#include "fixtures/complaint.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

/// A box from the origin to (2, 2, 1), which MuJoCo moves to its centre.
const char* const kCornerBox =
    "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 1\nv 2 0 1\nv 2 2 1\nv 0 2 1\n"
    "f 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n";

class SceneLayouts : public testing::Test {
 protected:
  void SetUp() override { write_file_atomically(folder / "box.obj", kCornerBox); }
  std::vector<ImportedLayout> read(const std::string& body) {
    return read_scene_layouts(folder.write("scene.xml", "<mujoco>" + body + "</mujoco>"));
  }
  test::TempFolder folder;
};

const char* const kBoxAsset = "<asset><mesh name=\"m\" file=\"box.obj\" scale=\"0.01 0.01 0.01\"/></asset>";

TEST_F(SceneLayouts, ReadSitesWithClassesFramesAndAngles) {
  const ImportedLayout one = read(R"(
    <compiler angle="degree" eulerseq="xyz"/>
    <default><default class="dot"><site size="0.002" euler="0 90 0"/></default></default>
    <worldbody><body name="tip" childclass="dot" pos="5 5 5"><geom size="1"/>
      <frame pos="1 0 0" axisangle="0 0 1 90"><site name="a" pos="0 1 2"/></frame>
      <site name="b" euler="90 0 0" size="0.003"/><site name="c" fromto="0 0 0 0 0 -2" type="capsule"/>
      <site name="d" zaxis="1 0 0" pos="0 0 1"/></body></worldbody>
    <sensor><touch site="a"/><touch site="b"/><touch site="c"/><touch site="d"/></sensor>)")[0];
  const std::vector<Taxel>& taxels = one.layout.taxels;
  ASSERT_EQ(taxels.size(), 4U);
  EXPECT_EQ(one.layout.name, "tip");
  EXPECT_LT(glm::distance(taxels[0].center, dvec3(0, 0, 2)), 1e-15) << "the frame turns and moves the site";
  EXPECT_LT(glm::distance(taxels[0].normal, dvec3(0, 1, 0)), 1e-15);
  EXPECT_EQ(taxels[0].radius, 0.002) << "of the class";
  EXPECT_LT(glm::distance(taxels[1].normal, dvec3(0, -1, 0)), 1e-15);
  EXPECT_EQ(taxels[1].radius, 0.003);
  EXPECT_EQ(taxels[2].center, dvec3(0, 0, -1)) << "the middle of the capsule";
  EXPECT_LT(glm::distance(taxels[3].normal, dvec3(1, 0, 0)), 1e-15);
}

TEST_F(SceneLayouts, ReadSitesOfIncludedFilesInTheFrameOfTheMesh) {
  write_file_atomically(folder / "pad.xml",
                        R"(<mujocoinclude><body name="pad"><geom name="skin" type="mesh" mesh="m" pos="1 0 0"
    quat="0 0 0 1"/><site name="s" pos="1 0 0.01"/></body></mujocoinclude>)");
  const ImportedLayout one =
      read(std::string(kBoxAsset) +
           "<worldbody><include file=\"pad.xml\"/></worldbody><sensor><touch site=\"s\"/></sensor>")[0];
  EXPECT_EQ(one.geom, "skin");
  EXPECT_EQ(one.layout.mesh.file, (folder / "box.obj").string());
  EXPECT_EQ(one.layout.mesh.scale, dvec3(0.01));
  EXPECT_LT(glm::distance(one.layout.taxels[0].center, dvec3(0, 0, 0.01)), 1e-9) << "MuJoCo has moved the mesh";
}

TEST_F(SceneLayouts, ReadTheVerticesOfTactileSensors) {
  const std::vector<ImportedLayout> read_all =
      read(std::string(R"(<asset><mesh name="w" builtin="wedge" params="3 4 30 30 0"/>
    <mesh name="p" builtin="plate" params="5 4" scale="0.01 0.008 0.002"/>)") +
           (kBoxAsset + 7) + R"(
    <worldbody><body name="b" pos="1 2 3"><geom size="0.1"/>
    <geom name="wedge" type="mesh" mesh="w" contype="0" conaffinity="0"/>
    <geom name="plate" type="mesh" mesh="p" contype="0" conaffinity="0" pos="0 0 1" euler="0 0 30"/>
    <geom name="box" type="mesh" mesh="m"/></body></worldbody>
    <sensor><tactile name="eye" geom="wedge" mesh="w"/><tactile geom="plate" mesh="p"/><tactile geom="box" mesh="m"/></sensor>)");
  ASSERT_EQ(read_all.size(), 3U);
  const ImportedLayout &wedge = read_all[0], &plate = read_all[1], &box = read_all[2];
  EXPECT_EQ(wedge.layout.name, "eye");
  ASSERT_EQ(wedge.layout.taxels.size(), 12U);
  for (const Taxel& taxel : wedge.layout.taxels) {
    EXPECT_NEAR(glm::length(taxel.center), 1, 1e-6) << "on the unit sphere of the file, not about its own centre";
    EXPECT_LT(glm::distance(taxel.normal, taxel.center), 1e-6) << "outward";
  }
  EXPECT_FALSE(wedge.has_radii());
  EXPECT_EQ(plate.layout.taxels.size(), 20U);
  EXPECT_EQ(plate.layout.mesh.file, "") << "made by MuJoCo";
  for (const Taxel& taxel : plate.layout.taxels)
    EXPECT_LT(glm::distance(taxel.normal, dvec3(0, 0, 1)), 1e-6) << "in the frame of the plate";
  ASSERT_EQ(box.layout.taxels.size(), 8U);
  EXPECT_EQ(box.layout.mesh.file, (folder / "box.obj").string());
  EXPECT_LT(glm::distance(box.layout.taxels[6].center, dvec3(0.02, 0.02, 0.01)), 1e-8) << "a vertex of the file";
}

TEST_F(SceneLayouts, ReadBackTheSitesThatAreWritten) {
  ImportedLayout one;
  one.layout.name = "tip";
  one.layout.mesh.file = "box.obj";
  one.layout.mesh.scale = dvec3(0.01);
  one.geom = "skin";
  one.layout.taxels = {{7, "", dvec3(0.001, 0.002, 0.01), glm::normalize(dvec3(1, 2, 3)), 0.003, {}},
                       {3, "b \"<", dvec3(0.02, 0.01, 0.005), dvec3(1, 0, 0), 0.004, {}},
                       {9, "b \"<", dvec3(0.01, 0.01, 0), dvec3(0, 0, -1), 0.004, {}}};
  const LayoutFormat& format = *find_layout_format("mjcf-sites");
  const WrittenLayouts written = format.write({one});
  EXPECT_TRUE(std::any_of(written.notes.begin(), written.notes.end(), [](const std::string& note) {
    return note.find("taxel 9: another site is named") != std::string::npos;
  }));
  one.layout.taxels[2].name.clear();
  EXPECT_EQ(format.parse(written.bytes, "f")[0].layout.taxels, one.layout.taxels) << "as text, to the last bit";
  const ImportedLayout back = read_scene_layouts(folder.write("tip.sites.xml", written.bytes))[0];
  ASSERT_EQ(back.layout.taxels.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(glm::distance(back.layout.taxels[i].normal, one.layout.taxels[i].normal), 1e-14);
    one.layout.taxels[i].normal = back.layout.taxels[i].normal;
    EXPECT_LT(glm::distance(back.layout.taxels[i].center, one.layout.taxels[i].center), 1e-9);
    one.layout.taxels[i].center = back.layout.taxels[i].center;
  }
  EXPECT_EQ(back.layout.taxels, one.layout.taxels);
  EXPECT_EQ(back.geom, "skin");
}

TEST_F(SceneLayouts, NameTheMistake) {
  const std::string file = (folder / "scene.xml").string();
  EXPECT_EQ(test::complaint_of([&] { read(""); }),
            file + ": holds no layout: no plugin taxel.sensor, no <touch> and no <tactile> sensor");
  EXPECT_NE(test::complaint_of([&] { read("<sensor><touch site=\"gone\"/></sensor>"); }).find("gone"),
            std::string::npos);
  EXPECT_EQ(test::complaint_of([&] { read_scene_layouts(folder.write("r.xml", "<robot/>")); }),
            (folder / "r.xml").string() + ": line 1, <robot>: must be <mujoco>: the file is no MuJoCo scene");
}

}  // namespace
}  // namespace taxel
