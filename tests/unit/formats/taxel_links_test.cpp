// Taxels that are links of a URDF, as in XELA's models, and messages that hold no layout.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "core/base/files.h"
#include "core/layout/formats/layout_format.h"
#include "fixtures/complaint.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

std::string link_xml(const std::string& name, const std::string& shape = "") {
  return fmt::format("<link name=\"{}\">{}</link>", name, shape);
}

std::string joint_xml(const std::string& parent, const std::string& child, const std::string& xyz,
                      const std::string& rpy = "0 0 0", const std::string& type = "fixed") {
  return fmt::format(
      "<joint name=\"{1}_joint\" type=\"{4}\"><origin xyz=\"{2}\" rpy=\"{3}\"/><parent link=\"{0}\"/><child "
      "link=\"{1}\"/><limit lower=\"-0.001\" upper=\"0\"/></joint>",
      parent, child, xyz, rpy, type);
}

std::string mesh_shape(const std::string& kind, const std::string& file, const std::string& origin = "") {
  return fmt::format("<{0}>{2}<geometry><mesh filename=\"{1}\" scale=\"0.001 0.001 0.001\"/></geometry></{0}>", kind,
                     file, origin);
}

const char* const kMark = "<visual><geometry><sphere radius=\"0.001\"/></geometry></visual>";

std::vector<ImportedLayout> read_links(const std::string& body, const std::string& file = "f") {
  return find_layout_format("urdf")->parse("<robot name=\"r\">" + body + "</robot>", file);
}

bool notes_have(const ImportedLayout& one, const std::string& part) {
  return std::any_of(one.notes.begin(), one.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

// GenTact's: the base has no mesh, and a link of its own next to the taxels shows it.
TEST(TaxelLinks, AreOnTheMeshOfALinkNextToThem) {
  const std::string gentact = link_xml("skin/base") + link_xml("skin/sensor_0", kMark) +
                              link_xml("skin/sensor_1", kMark) + joint_xml("skin/base", "skin/sensor_0", "0.3 0 0") +
                              joint_xml("skin/base", "skin/sensor_1", "0 0.4 0", "1.5707963267948966 0 0");
  const std::string shown = link_xml("skin/shown", mesh_shape("visual", "skin.stl", "<origin xyz=\"0 0 0.2\"/>")) +
                            joint_xml("skin/base", "skin/shown", "0.1 0 0");
  const std::vector<ImportedLayout> read = read_links(gentact + shown);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].geom, "skin/base");
  ASSERT_EQ(read[0].layout.taxels.size(), 2U);
  EXPECT_LT(glm::distance(read[0].layout.taxels[0].center, dvec3(0.2, 0, -0.2)), 1e-15) << "in the frame of the mesh";
  EXPECT_LT(glm::distance(read[0].layout.taxels[1].center, dvec3(-0.1, 0.4, -0.2)), 1e-15);
  EXPECT_LT(glm::distance(read[0].layout.taxels[1].normal, dvec3(0, -1, 0)), 1e-15);
  EXPECT_EQ(read[0].layout.taxels[1].id, 1);
  EXPECT_TRUE(notes_have(read[0], "skin.stl"));
  // Of two meshes neither is known to be the skin.
  const std::string second =
      link_xml("skin/cable", mesh_shape("visual", "cable.stl")) + joint_xml("skin/base", "skin/cable", "0 0 0");
  EXPECT_TRUE(notes_have(read_links(gentact + shown + second)[0], "link \"skin/base\" has no mesh"));
}

TEST(TaxelLinks, AreComposedAlongTheirJoints) {
  const double quarter = 1.5707963267948966;
  const ImportedLayout read =
      read_links(link_xml("pad", mesh_shape("visual", "p.stl")) + link_xml("a") + link_xml("b") +
                 link_xml("x_taxel_1_link") + joint_xml("pad", "a", "1 0 0", fmt::format("0 0 {}", quarter)) +
                 joint_xml("a", "b", "0 2 0", fmt::format("{} 0 0", quarter), "prismatic") +
                 joint_xml("b", "x_taxel_1_link", "0 0 3"))[0];
  ASSERT_EQ(read.layout.taxels.size(), 1U);
  const Taxel& taxel = read.layout.taxels[0];
  EXPECT_LT(glm::distance(taxel.center, dvec3(2, 0, 0)), 1e-15) << taxel.center.x << " " << taxel.center.y;
  EXPECT_LT(glm::distance(taxel.normal, dvec3(1, 0, 0)), 1e-15) << "z of the taxel's link";
  EXPECT_EQ(taxel.name, "x_taxel_1_link");
  EXPECT_EQ(read.geom, "pad");
  EXPECT_TRUE(notes_have(read, "1 taxels are on joints that slide"));
  EXPECT_FALSE(read.has_radii()) << "the marks are no receptive radii";
}

TEST(TaxelLinks, AreOrderedByTheirNumbers) {
  std::string body = link_xml("pad", mesh_shape("visual", "p.stl"));
  for (const int i : {10, 2, 16, 1}) {
    const std::string name = fmt::format("0_uSPa44_{:02}_link", i);
    body += link_xml(name, kMark) + joint_xml("pad", name, fmt::format("{} 0 0", i), "0 0 0", "prismatic");
  }
  const ImportedLayout read = read_links(body)[0];
  EXPECT_EQ(read.layout.name, "0_uSPa44") << "the number of the sensor is no number of a taxel";
  std::vector<int> ids;
  for (const Taxel& taxel : read.layout.taxels) {
    ids.push_back(taxel.id);
    EXPECT_EQ(taxel.center.x, taxel.id);
  }
  EXPECT_EQ(ids, (std::vector<int>{1, 2, 10, 16}));
}

TEST(TaxelLinks, AreOneLayoutForEachSensor) {
  std::string body;
  for (const char* side : {"left", "right"}) {
    const std::string pad = std::string(side) + "_pad";
    body += link_xml(pad, mesh_shape("collision", "p.stl"));
    for (int i = 1; i <= 3; ++i) {
      const std::string front = fmt::format("{}_taxel_f_{}", side, i), rear = fmt::format("{}_taxel_r_{}", side, i);
      body += link_xml(front) + joint_xml(pad, front, "0 0 1") + link_xml(rear) + joint_xml(pad, rear, "0 0 -1");
    }
  }
  const std::vector<ImportedLayout> read = read_links(body);
  ASSERT_EQ(read.size(), 4U);
  EXPECT_EQ(read[1].layout.name, "left_taxel_r");
  EXPECT_EQ(read[1].geom, "left_pad");
  EXPECT_EQ(read[1].layout.taxels.size(), 3U);
}

TEST(TaxelLinks, CountRowsAndColumnsInOrder) {
  std::string body = link_xml("pad", mesh_shape("visual", "p.stl"));
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 2; ++column) {
      const std::string name = fmt::format("taxel_{}_{}", row, column);
      body += link_xml(name) + joint_xml("pad", name, fmt::format("{} {} 0", row, column));
    }
  const ImportedLayout read = read_links(body)[0];
  EXPECT_EQ(read.layout.taxels[2].center, dvec3(1, 0, 0));
  EXPECT_EQ(read.layout.taxels[2].id, 2);
  EXPECT_TRUE(notes_have(read, "differ in several numbers"));
}

TEST(TaxelLinks, AreInTheFrameOfTheMesh) {
  const test::TempFolder folder;
  std::filesystem::create_directories(folder / "pads/mesh");
  std::filesystem::create_directories(folder / "pads/urdf");
  write_file_atomically(folder / "pads/mesh/p.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string file = (folder / "pads/urdf/r.urdf").string();
  const std::string origin = "<origin xyz=\"0 0 0.5\" rpy=\"3.141592653589793 0 0\"/>";
  const std::string tip = link_xml("taxel_1") + joint_xml("pad", "taxel_1", "1 2 3");
  const auto pad = [&](const char* mesh) { return link_xml("pad", mesh_shape("collision", mesh, origin)); };
  const ImportedLayout read = read_links(pad("package://pads/mesh/p.obj") + tip, file)[0];
  EXPECT_EQ(read.layout.mesh.file, (folder / "pads/mesh/p.obj").string());
  EXPECT_EQ(read.layout.mesh.scale, dvec3(0.001));
  EXPECT_LT(glm::distance(read.layout.taxels[0].center, dvec3(1, -2, -2.5)), 1e-15);
  EXPECT_LT(glm::distance(read.layout.taxels[0].normal, dvec3(0, 0, -1)), 1e-15);
  EXPECT_EQ(read_links(pad("../mesh/p.obj") + tip, file)[0].layout.mesh.file, read.layout.mesh.file);
  EXPECT_EQ(read_links(pad("package://renamed/mesh/p.obj") + tip, file)[0].layout.mesh.file, read.layout.mesh.file);
  const ImportedLayout without_mesh = read_links(pad("package://pads/mesh/gone.obj") + tip, file)[0];
  EXPECT_EQ(without_mesh.layout.mesh.file, "");
  EXPECT_TRUE(notes_have(without_mesh, "name the mesh with --mesh FILE --scale 0.001,0.001,0.001"));
}

TEST(TaxelLinks, AreNoOtherLinks) {
  const std::string pad = link_xml("pad", mesh_shape("visual", "p.stl"));
  std::string tips;
  for (int i = 0; i < 5; ++i)
    tips += link_xml(fmt::format("tip_{}", i)) + joint_xml("pad", fmt::format("tip_{}", i), "0 0 1");
  EXPECT_EQ(test::complaint_of([&] { read_links(pad + tips); }),
            "f: has no <sensor> with <tactile>, and no links that are taxels")
      << "frames without the word and without a sphere";
  std::string joined = pad;
  for (int i = 0; i < 5; ++i)
    joined += link_xml(fmt::format("taxel_{}", i)) +
              joint_xml("pad", fmt::format("taxel_{}", i), "0 0 1", "0 0 0", "revolute");
  EXPECT_EQ(test::complaint_of([&] { read_links(joined); }),
            "f: has no <sensor> with <tactile>, and no links that are taxels");
}

TEST(TactileStates, HoldNoLayout) {
  const LayoutFormat& format = *find_layout_format("tactile_state");
  EXPECT_EQ(
      test::complaint_of(
          [&] { format.parse(R"({"header": {"stamp": {}}, "sensors": [{"name": "tip", "values": [0, 1]}]})", "f"); }),
      "f: /sensors: holds readings of \"tip\" (2 values) but no positions of taxels, so it is no layout: take the "
      "sensor's own description (URDF, YAML, a table or a layout), whose taxels are in the order of the values");
  const test::TempFolder folder;
  const auto file = folder.write("a.json", R"({"header": {"stamp": {}}, "sensors": [{"name": "a", "values": []}]})");
  EXPECT_EQ(layout_format_of(file), &format);
  EXPECT_FALSE(looks_like_foreign_layout(file)) << "a dialog for layouts does not list it";
  EXPECT_EQ(test::complaint_of([&] { write_layout_as(format, folder / "b.jsonl", Layout()); }),
            (folder / "b.jsonl").string() + ": is not written: Message TactileState of ROS holds no layout");
}

}  // namespace
}  // namespace taxel
