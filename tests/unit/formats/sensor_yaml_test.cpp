// Sensor descriptions of the predecessor's code: three types, keys that are not imported, and bad input by line and
// key.
#include "core/layout/formats/layout_format.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>

#include "core/layout/file/imported_layout.h"
#include "core/mesh/make/primitives.h"
#include "fixtures/complaint.h"

namespace taxel {
namespace {

/// Returns a file with one sensor with these lines, after a plugin that contains no surfaces.
std::string yaml_of(const std::string& sensor) {
  return "MujocoPlugins:\n  - type: mujoco_ros_mocap/MocapPlugin\n  - type: surfaces\n    SurfacePlugins:\n"
         "    - {\n" +
         sensor + "      }\n";
}

const std::string kCurved =
    "      type: sensors/CurvedSensor,\n"
    "      sensorName: tip, geomName: tip_geom,\n"
    "      include_margin: 0.006, sample_resolution: 1e6, method: squared,\n"
    "      updateRate: 40.0, visualize: True,\n"
    "      taxels: [[0.01, 0, 0], [-0.01, 0, 0.002]],\n"
    "      normals: [[1, 0, 0], [-1, 0, 0]],\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

bool any_contains(const std::vector<std::string>& notes, const std::string& part) {
  return std::any_of(notes.begin(), notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

std::string complaint(const std::string& text) {
  return test::complaint_of([&] { parse_sensor_yaml(text, "s.yaml"); });
}

TEST(SensorYaml, RefusesACommaOutsideOfBrackets) {
  for (const char* text : {",", "a: 1\n,\n", "]\n", "- 1\n}\n"})
    EXPECT_NE(complaint(text).find("is no YAML"), std::string::npos) << text << ": " << complaint(text);
}

TEST(SensorYaml, ReadsACurvedSensor) {
  const ImportedLayout read = parse_sensor_yaml(yaml_of(kCurved), "s.yaml");
  EXPECT_EQ(read.layout.name, "tip");
  EXPECT_EQ(read.geom, "tip_geom");
  EXPECT_EQ(read.geom_place, "line 7, key geomName");
  ASSERT_EQ(read.layout.taxels.size(), 2U);
  EXPECT_EQ(read.layout.taxels[1].id, 1);
  EXPECT_EQ(read.layout.taxels[1].center, dvec3(-0.01, 0, 0.002));
  EXPECT_EQ(read.layout.taxels[1].normal, dvec3(-1, 0, 0));
  EXPECT_EQ(read.layout.taxels[1].radius, 0.006);
  EXPECT_EQ(read.layout.sampling.density, 1e6);
  EXPECT_TRUE(read.has_normals);
  EXPECT_EQ(read.layout.readout, Readout{}) << "the paper's weighted mean, whatever the method";
  EXPECT_TRUE(any_contains(read.notes, "method \"squared\""));
  EXPECT_TRUE(any_contains(read.notes, "not carried over: updateRate, visualize"));
}

TEST(SensorYaml, UsesTheNormalsOfTheSkinForATaxelSensor) {
  const std::string text = replaced(replaced(yaml_of(kCurved), "CurvedSensor", "TaxelSensor"),
                                    "      normals: [[1, 0, 0], [-1, 0, 0]],\n", "");
  ImportedLayout read = parse_sensor_yaml(text, "s.yaml");
  EXPECT_FALSE(read.has_normals);
  const auto box = std::make_shared<const TriMesh>(make_box({0.01, 0.005, 0.02}));
  put_on_skin(read, box, "s.yaml");
  EXPECT_EQ(read.layout.taxels[0].normal, dvec3(1, 0, 0));
  EXPECT_EQ(read.layout.taxels[1].normal, dvec3(-1, 0, 0));
}

TEST(SensorYaml, CoversTheTopWithCellsOfAFlatSensor) {
  ImportedLayout read =
      parse_sensor_yaml(yaml_of("type: s/FlatTactileSensor, geomName: foam, resolution: 0.025,\n"), "s.yaml");
  EXPECT_TRUE(read.layout.taxels.empty());
  const auto box = std::make_shared<const TriMesh>(make_box({0.2, 0.1, 0.02}));
  put_on_skin(read, box, "s.yaml");
  ASSERT_EQ(read.layout.taxels.size(), 16U * 8U);
  // The released code numbers cells along y first: cell (i, j) is i * rows + j.
  EXPECT_NEAR(glm::distance(read.layout.taxels[0].center, dvec3(-0.1875, -0.0875, 0.02)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(read.layout.taxels[1].center, dvec3(-0.1875, -0.0625, 0.02)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(read.layout.taxels[8].center, dvec3(-0.1625, -0.0875, 0.02)), 0, 1e-12);
  for (const Taxel& taxel : read.layout.taxels) EXPECT_EQ(taxel.normal, dvec3(0, 0, 1));
  EXPECT_EQ(read.layout.taxels[0].radius, 0.0125);
  EXPECT_EQ(read.layout.frame.pad, dvec3(0, 0, 1));
  EXPECT_EQ(read.layout.frame.distal, dvec3(1, 0, 0)) << "the longer side";
  EXPECT_LE(read.layout.sampling.density * box->area(), 1e5);
}

TEST(SensorYaml, OmitsCellsThatMissTheSkin) {
  const std::string text = yaml_of("type: s/FlatTactileSensor, geomName: foam, resolution: 0.025,\n");
  ImportedLayout read = parse_sensor_yaml(text, "s.yaml");
  const auto ball = std::make_shared<const TriMesh>(make_icosphere(0.05, 4));
  put_on_skin(read, ball, "s.yaml");
  ASSERT_EQ(read.layout.taxels.size(), 12U) << "4 x 4 cells without those at the corners";
  EXPECT_EQ(read.layout.taxels[0].id, 1) << "cells keep their numbers";
  EXPECT_TRUE(any_contains(read.notes, "4 of 16 cells are not above the skin: left out"));
  const auto refusal = [&](double size) {
    ImportedLayout other = parse_sensor_yaml(text, "s.yaml");
    const auto box = std::make_shared<const TriMesh>(make_box(dvec3(size)));
    return test::complaint_of([&] { put_on_skin(other, box, "s.yaml"); });
  };
  EXPECT_EQ(refusal(0.01), "s.yaml: a cell of 0.025 m is larger than the mesh, 0.02 x 0.02 m");
  EXPECT_EQ(refusal(10), "s.yaml: cells of 0.025 m over 20 x 20 m are more than 100000: check --scale");
}

/// Such a file contains neither the material nor the density nor the frame. put_on_skin() completes them, with notes.
TEST(SensorYaml, ListsValuesThatTheFileDoesNotGive) {
  ImportedLayout read = parse_sensor_yaml(yaml_of(replaced(kCurved, ", sample_resolution: 1e6", "")), "s.yaml");
  EXPECT_FALSE(read.has_density);
  EXPECT_FALSE(read.has_material);
  put_on_skin(read, std::make_shared<const TriMesh>(make_box(dvec3(0.01))), "s.yaml");
  EXPECT_TRUE(any_contains(read.notes, "the density of the samples is "));
  EXPECT_TRUE(any_contains(read.notes, "the file does not say where the sensor points: distal is ["));
}

TEST(SensorYaml, ReadsLengthBelowOneAsNoDensity) {
  const ImportedLayout read =
      parse_sensor_yaml(replaced(yaml_of(kCurved), "sample_resolution: 1e6", "sample_resolution: 0.01"), "s.yaml");
  EXPECT_EQ(read.layout.sampling.density, Sampling{}.density);
  EXPECT_TRUE(any_contains(read.notes, "sample_resolution 0.01 is below 1"));
}

TEST(SensorYaml, ChoosesOneOfSeveralAndNamesTheRest) {
  const std::string second = replaced(replaced(kCurved, "tip,", "thumb,"), "tip_geom", "thumb_geom");
  const std::string text = yaml_of(kCurved) + "    - {\n" + second + "      }\n";
  EXPECT_EQ(parse_sensor_yaml(text, "s.yaml").layout.name, "tip");
  EXPECT_TRUE(any_contains(parse_sensor_yaml(text, "s.yaml").notes, "left out: \"thumb\" on geom \"thumb_geom\""));
  EXPECT_EQ(parse_sensor_yaml(text, "s.yaml", "thumb").geom, "thumb_geom");
  EXPECT_EQ(parse_sensor_yaml(text, "s.yaml", "thumb_geom").layout.name, "thumb");
  EXPECT_EQ(test::complaint_of([&] { parse_sensor_yaml(text, "s.yaml", "toe"); }),
            "s.yaml: has no sensor \"toe\", but \"tip\" on geom \"tip_geom\", \"thumb\" on geom \"thumb_geom\"");
}

TEST(SensorYaml, NamesLineAndKeyOfBadValues) {
  const auto with = [](const std::string& from, const std::string& to) {
    return complaint(yaml_of(replaced(kCurved, from, to)));
  };
  EXPECT_EQ(with("0.006", "wide"), "s.yaml: line 8, key include_margin: must be a number, is \"wide\"");
  EXPECT_EQ(with("0.006", "\"0.006\""), "s.yaml: line 8, key include_margin: must be a number, is \"0.006\"");
  EXPECT_EQ(with("0.006", "-0.006"), "s.yaml: line 8, key include_margin: must be greater than 0, is -0.006");
  EXPECT_EQ(with("0.006", ".nan"), "s.yaml: line 8, key include_margin: must be a finite number, is \".nan\"");
  EXPECT_EQ(with("0.006", "1e999"), "s.yaml: line 8, key include_margin: must be a finite number, is \"1e999\"");
  EXPECT_EQ(with("0.01, 0, 0]", ".inf, 0, 0]"),
            "s.yaml: line 10, key taxels[0][0]: must be a finite number, is \".inf\"");
  EXPECT_EQ(with("0.01, 0, 0]", "0.01, 0]"),
            "s.yaml: line 10, key taxels[0]: must be a list of 3 numbers, is a list of 2");
  EXPECT_EQ(with("[1, 0, 0], ", ""), "s.yaml: line 11, key normals: must be as many as the 2 taxels, is a list of 1");
  EXPECT_EQ(with("[1, 0, 0]", "[0, 0, 0]"), "s.yaml: line 11, key normals[0]: must be a direction, is [0, 0, 0]");
  EXPECT_EQ(with("[[0.01, 0, 0], [-0.01, 0, 0.002]]", "[]"), "s.yaml: line 10, key taxels: holds no taxel");
  EXPECT_EQ(with("include_margin: 0.006, ", ""),
            "s.yaml: line 5, key SurfacePlugins[0]: key include_margin is missing: the receptive radius [m]");
  EXPECT_EQ(with("      normals: [[1, 0, 0], [-1, 0, 0]],\n", ""),
            "s.yaml: line 5, key SurfacePlugins[0]: key normals is missing: a CurvedSensor has one for each taxel");
  EXPECT_EQ(with("updateRate: 40.0", "include_margin: 2"), "s.yaml: line 9, key include_margin: is listed twice");
}

TEST(SensorYaml, ReportsTheContentOfAnotherFile) {
  EXPECT_EQ(complaint(""), "s.yaml: holds no key MujocoPlugins: it is no sensor description");
  EXPECT_EQ(complaint("a: 1"), "s.yaml: holds no key MujocoPlugins: it is no sensor description");
  EXPECT_EQ(complaint("MujocoPlugins:\n  - type: a/Mocap\n  - type: b/Ros\n"),
            "s.yaml: key MujocoPlugins: no plugin holds SurfacePlugins; there are a/Mocap, b/Ros");
  EXPECT_EQ(complaint("MujocoPlugins:\n  - type: a\n    SurfacePlugins: [{type: b/Other}]\n"),
            "s.yaml: key SurfacePlugins: holds no CurvedSensor, TaxelSensor or FlatTactileSensor, but b/Other");
  EXPECT_EQ(complaint("MujocoPlugins: 7\n"), "s.yaml: line 1, key MujocoPlugins: must be a list, is \"7\"");
  EXPECT_EQ(complaint("MujocoPlugins: [a\n").substr(0, 25), "s.yaml: line 2: is no YAM");
}

/// Files that make other readers hang, crash or run out of memory.
TEST(SensorYaml, RefusesHostileFilesQuickly) {
  std::string bomb = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 40; ++i) {
    const std::string last = fmt::format("*a{}", i - 1);
    bomb += fmt::format("a{}: &a{} [{}, {}, {}, {}, {}, {}, {}, {}]\n", i, i, last, last, last, last, last, last, last,
                        last);
  }
  bomb += "MujocoPlugins: *a39\n";
  const std::string cycle = "MujocoPlugins: &m\n  - type: t\n    SurfacePlugins: &s\n      - *s\n";
  const std::string deep = "MujocoPlugins: " + std::string(1 << 20, '[');
  const std::string deep_map = "MujocoPlugins: " + [] {
    std::string text;
    for (int i = 0; i < 100000; ++i) text += "{a: ";
    return text;
  }();
  const std::string large(17 << 20, ' ');
  const std::clock_t begin = std::clock();  // processor time, which does not depend on the load of the machine
  for (const std::string& text : {bomb, cycle, deep, deep_map, large, std::string("\0\xff\xfe", 3)})
    EXPECT_NE(complaint(text), "accepted") << text.substr(0, 40);
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 10.0);
}

/// Every prefix of a file, and every changed byte, must give an error or a layout.
TEST(SensorYaml, SurvivesCutAndChangedFiles) {
  const std::string text = yaml_of(kCurved);
  for (std::size_t size = 0; size < text.size(); ++size) complaint(text.substr(0, size));
  for (std::size_t at = 0; at < text.size(); ++at) {
    for (const char c : {'[', '{', ':', '*', '&', '\n', '"', '-', '\0', '\x80', '!', '|', '?'}) {
      std::string changed = text;
      changed[at] = c;
      complaint(changed);
    }
  }
}

TEST(ImportedSkin, FindsTheUnitWithWhichTaxelsAreOnTheMesh) {
  const ImportedLayout read = parse_sensor_yaml(yaml_of(kCurved), "s.yaml");
  for (const double scale : {1.0, 0.001, 0.01, 0.0254})
    EXPECT_EQ(guess_scale(read, make_box(dvec3(0.01, 0.005, 0.02) / scale)), scale);
}

}  // namespace
}  // namespace taxel
