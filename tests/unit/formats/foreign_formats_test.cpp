// Files of other programs: the values that are read from them, and the line, path or row of each mistake.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <numeric>

#include "core/base/archive/npz.h"
#include "core/base/files.h"
#include "core/layout/formats/layout_format.h"
#include "fixtures/complaint.h"

namespace taxel {
namespace {

std::vector<ImportedLayout> parsed(const char* word, const std::string& text) {
  return find_layout_format(word)->parse(text, "f");
}

std::string format_complaint(const char* word, const std::string& text) {
  return test::complaint_of([&] { parsed(word, text); });
}

bool has_note(const ImportedLayout& one, const std::string& part) {
  return std::any_of(one.notes.begin(), one.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

TEST(GentactTable, IsReadWithItsUsdPrims) {
  const std::string head = "Index,X,Y,Z,NormX,NormY,NormZ,Radius,Parent,Object Name in Blender\n";
  const std::vector<ImportedLayout> one = parsed("csv", head + "0,1,2,3,0,0,1,0.006,/World/finger,skin\n");
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].geom, "/World/finger");
  EXPECT_EQ(one[0].layout.taxels[0].name, "skin");
  EXPECT_TRUE(has_note(one[0], "in the frame of the mesh of \"/World/finger\""));
  const std::vector<ImportedLayout> two = parsed(
      "csv", head + "0,1,2,3,0,0,1,0.006,/World/a,s\n0,4,5,6,0,0,1,0.006,/World/b,s\n1,7,8,9,0,0,1,0.006,/World/a,s\n");
  ASSERT_EQ(two.size(), 2U) << "each prim has a frame of its own";
  EXPECT_EQ(two[0].layout.name, "a");
  EXPECT_EQ(two[0].layout.taxels.size(), 2U);
  EXPECT_EQ(two[1].layout.taxels[0].center, dvec3(4, 5, 6));
  EXPECT_NE(format_complaint("csv", head + "0,1,2,3,0,0,1,0.006,World,s\n").find("line 2, column Parent"),
            std::string::npos);
}

const std::string kIcubHead = "name left_hand\nspatial_sampling triangle\ntaxel2Repr (1 1)\n\n[calibration]\n";

TEST(IcubText, KeepsTheRowNumbersAsIds) {
  const ImportedLayout read = parsed(
      "icub", kIcubHead + "0 0 0 0 0 0\r\n0.1\t0.2 0.3 0 0 1\n0.1 0.2 0.3 0 0 1\n0 0 0 0 0 0\n1 0 0 1 0 0 7\n")[0];
  EXPECT_EQ(read.layout.name, "left_hand");
  ASSERT_EQ(read.layout.taxels.size(), 3U);
  EXPECT_EQ(read.layout.taxels[0].id, 1);
  EXPECT_EQ(read.layout.taxels[2].id, 4);
  EXPECT_EQ(read.layout.taxels[1].center, dvec3(0.1, 0.2, 0.3));
  EXPECT_FALSE(read.has_radii());
  EXPECT_TRUE(has_note(read, "2 of 5 rows are zero"));
  EXPECT_TRUE(has_note(read, "3 taxels are at 2 places"));
  EXPECT_TRUE(has_note(read, "columns after the sixth"));
  EXPECT_TRUE(has_note(read, "not carried over: spatial_sampling, taxel2Repr"));
  const std::string written = find_layout_format("icub")->write({read}).bytes;
  EXPECT_NE(written.find("[calibration]\n0 0 0 0 0 0\n0.1 0.2 0.3 0 0 1\n"), std::string::npos) << written;
  EXPECT_EQ(parsed("icub", written)[0].layout.taxels, read.layout.taxels);
}

TEST(IcubText, LeavesTheNormalsOfRowsWithoutOneToTheSkin) {
  const ImportedLayout read = parsed("icub", kIcubHead + "1 0 0 0 0 0\n0 0 0 0 0 0\n1 0 0 0 0 1\n")[0];
  ASSERT_EQ(read.layout.taxels.size(), 2U);
  EXPECT_EQ(read.layout.taxels[0].normal, dvec3(0));
  EXPECT_FALSE(read.has_normals);
  EXPECT_TRUE(has_note(read, "1 rows have a place but no normal, which the skin gives: 0"));
}

TEST(IcubText, NamesLineAndRow) {
  EXPECT_EQ(format_complaint("icub", "1 2 3\n"),
            "f: has no line [calibration]: it is no file of taxel positions of an iCub");
  EXPECT_EQ(format_complaint("icub", kIcubHead), "f: holds no taxel: all rows are zero, or there are none");
  EXPECT_EQ(format_complaint("icub", kIcubHead + "0 0 0 0 0 0\n1 2 3\n"),
            "f: line 7 (row 1): must have 6 numbers, x y z nx ny nz, has 3");
  EXPECT_EQ(format_complaint("icub", kIcubHead + "1 2 3 4 5 nan\n"),
            "f: line 6 (row 0): must have 6 numbers, x y z nx ny nz, but \"nan\" is none");
  EXPECT_EQ(format_complaint("icub", "[other]\n"), "f: line 1: section [other] is not known, only [calibration]");
  EXPECT_EQ(format_complaint("icub", kIcubHead + "[calibration]\n"),
            "f: line 6 (row 0): [calibration] is in the file twice");
}

TEST(IcubText, RefusesToLoseATaxel) {
  ImportedLayout one;
  one.layout.taxels = {{3, "", dvec3(1), dvec3(0, 0, 1), 1, {}}, {3, "", dvec3(2), dvec3(0, 0, 1), 1, {}}};
  const LayoutFormat& icub = *find_layout_format("icub");
  EXPECT_EQ(test::complaint_of([&] { icub.write({one}); }),
            "taxel 3: is there twice: a row holds one taxel, give them other ids");
  one.layout.taxels[0].id = 2'000'000;
  EXPECT_EQ(test::complaint_of([&] { icub.write({one}); }),
            "taxel 2000000: has an id that is no row number from 0 to 99999");
}

std::string probe_text(const std::string& x) {
  return R"({"radius": 0.004, "pos": [)" + x + R"(, 0, 0], "normal": [0, 0, 1]})";
}

TEST(GenesisProbes, AreReadAsOneLayoutForEachLink) {
  const std::string grid = R"({"link_name": "dp", "kind": "grid", "probes": [[)" + probe_text("1") + "," +
                           probe_text("2") + "],[" + probe_text("3") + "]]}";
  const std::string flat = R"({"link_name": "mp", "probes": [)" + probe_text("4") + R"(], "more": 1})";
  const std::vector<ImportedLayout> read = parsed("genesis", "[" + grid + "," + flat + "]");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].layout.name, "dp");
  EXPECT_EQ(read[0].geom, "dp");
  ASSERT_EQ(read[0].layout.taxels.size(), 3U);
  EXPECT_EQ(read[0].layout.taxels[2].name, "row 1 column 0");
  EXPECT_EQ(read[0].layout.taxels[2].radius, 0.004);
  EXPECT_EQ(read[1].layout.taxels[0].center.x, 4);
  EXPECT_TRUE(has_note(read[1], "not carried over: /1/more"));
  const std::string written = find_layout_format("genesis")->write({read[0]}).bytes;
  EXPECT_EQ(parsed("genesis", written)[0].layout, read[0].layout) << "the rows are kept";
  EXPECT_NE(written.find("\"grid\""), std::string::npos);
}

TEST(GenesisProbes, LeaveOutTheCellsOfRadiusZero) {
  const std::string padding = R"({"pos": [0,0,0], "normal": [0,0,0], "radius": 0})";
  const std::string head = R"([{"link_name": "a", "kind": "grid", "probes": [[)";
  const ImportedLayout read = parsed("genesis", head + padding + "," + probe_text("3") + "," + padding + "]]}]")[0];
  ASSERT_EQ(read.layout.taxels.size(), 1U);
  EXPECT_EQ(read.layout.taxels[0].center.x, 3);
  EXPECT_TRUE(has_note(read, "2 probes of radius 0 fill up the grid and are left out"));
  EXPECT_EQ(format_complaint("genesis", head + padding + "]]}]"), "f: /0/probes: holds only probes of radius 0");
}

TEST(GenesisProbes, NameThePathOfEachMistake) {
  const auto with = [](const std::string& probe) { return R"([{"link_name": "a", "probes": [[)" + probe + "]]}]"; };
  EXPECT_EQ(format_complaint("genesis", with("{\"pos\": [0, 0]}")),
            "f: /0/probes/0/0/pos: must be an array of 3 numbers, is [0,0]");
  EXPECT_EQ(format_complaint("genesis", with(R"({"pos": [0,0,0]})")), "f: /0/probes/0/0/normal: is missing");
  EXPECT_EQ(format_complaint("genesis", with(R"({"pos": [0,0,0], "normal": [0,0,0], "radius": 1})")),
            "f: /0/probes/0/0/normal: must be a direction, is [0, 0, 0]");
  EXPECT_EQ(format_complaint("genesis", with(R"({"pos": [0,0,0], "normal": [0,0,1], "radius": -1})")),
            "f: /0/probes/0/0/radius: must be greater than 0, is -1");
  EXPECT_EQ(format_complaint("genesis", R"([{"probes": []}])"), "f: /0/link_name: is missing");
  EXPECT_EQ(format_complaint("genesis", R"([{"link_name": "a", "probes": []}])"), "f: /0/probes: holds no probe");
  EXPECT_EQ(format_complaint("genesis", "[]"), "f: holds no sensor");
  EXPECT_EQ(format_complaint("genesis", R"({"canvas_hw": [2, 3]})").substr(0, 37),
            "f: is the canvas of a hand, which pla");
}

TEST(NpzPoses, AreReadWithAndWithoutALastRow) {
  NpzWriter npz;
  npz.add("poses", {1, 4, 4}, std::vector<double>{1, 0, 0, 7, 0, 0, 1, 8, 0, -1, 0, 9, 0, 0, 0, 1});
  const ImportedLayout read = parsed("npz", npz.bytes())[0];
  EXPECT_EQ(read.layout.taxels[0].center, dvec3(7, 8, 9));
  EXPECT_EQ(read.layout.taxels[0].normal, dvec3(0, 1, 0));
  EXPECT_FALSE(read.has_radii());
}

TEST(NpzPoses, NameTheArrayOfEachMistake) {
  const auto archive = [](const NpzWriter::Shape& shape, std::vector<double> poses, std::vector<double> radii) {
    NpzWriter npz;
    npz.add("poses", shape, poses);
    if (!radii.empty()) npz.add("radii", {radii.size()}, radii);
    return npz.bytes();
  };
  const std::vector<double> good{1, 0, 0, 7, 0, 1, 0, 8, 0, 0, 1, 9};
  EXPECT_EQ(format_complaint("npz", archive({1, 3, 4}, good, {0.1})), "accepted");
  EXPECT_EQ(format_complaint("npz", archive({3, 4}, good, {})), "f: poses: is of shape (3, 4), must be (any, 3, 4)");
  EXPECT_EQ(format_complaint("npz", archive({0, 3, 4}, {}, {})), "f: poses: holds no taxel");
  EXPECT_EQ(format_complaint("npz", archive({1, 3, 4}, good, {0})), "f: radii[0]: must be greater than 0, is 0");
  EXPECT_EQ(format_complaint("npz", archive({1, 3, 4}, good, {1, 2})), "f: radii: is of shape (2), must be (1)");
  EXPECT_EQ(format_complaint("npz", archive({1, 3, 4}, std::vector<double>(12), {})),
            "f: poses[0]: the normal (column 2) must be a direction, is 0 0 0");
  std::vector<double> nan = good;
  nan[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(format_complaint("npz", archive({1, 3, 4}, nan, {})), "f: poses[0]: the centre (column 3) must be finite");
  NpzWriter other;
  other.add("time", {1}, std::vector<double>{0});
  EXPECT_EQ(
      format_complaint("npz", other.bytes()),
      "f: poses: is missing: an archive of taxels has the array poses (taxels, 3, 4) with the normal in the third "
      "and the centre in the fourth column");
  EXPECT_NE(format_complaint("npz", "PK").find("cannot be read as .npz"), std::string::npos);
}

TEST(NpzPoses, RefuseMatricesThatAreNoRotation) {
  const auto complaint = [](std::vector<double> pose) {
    NpzWriter npz;
    npz.add("poses", {1, pose.size() / 4, 4}, pose);
    return format_complaint("npz", npz.bytes());
  };
  const std::string rotation = "f: poses[0]: columns 0 to 2 must be a rotation: they are off by ";
  EXPECT_EQ(complaint({1, 0, 0, 0, 0, 1.001, 0, 0, 0, 0, 1, 0}), "accepted") << "three decimals";
  EXPECT_TRUE(complaint({2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0}).starts_with(rotation)) << "scaled";
  EXPECT_TRUE(complaint({1, 0.1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}).starts_with(rotation)) << "sheared";
  EXPECT_TRUE(complaint({-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}).starts_with(rotation)) << "mirrored";
  EXPECT_EQ(complaint({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1}),
            "f: poses[0]: the last row must be 0 0 0 1, is 7 8 9 1: is the matrix transposed?");
}

std::string urdf_of(const std::string& tactile, const std::string& origin = "") {
  return "<robot name=\"r\">\n<sensor name=\"s\">\n<parent link=\"l\"/>" + origin + "\n<tactile>\n" + tactile +
         "\n</tactile>\n</sensor>\n</robot>\n";
}

TEST(UrdfTactile, PlacesTaxelsInTheFrameOfTheLink) {
  const std::string taxel =
      "<taxel idx=\"5\" xyz=\"1 0 0\" rpy=\"0 1.5707963267948966 0\"><geometry><sphere "
      "radius=\"0.1\"/></geometry></taxel>";
  const ImportedLayout read =
      parsed("urdf", urdf_of(taxel, "<origin xyz=\"0 0 10\" rpy=\"0 0 1.5707963267948966\"/>"))[0];
  EXPECT_EQ(read.layout.name, "s");
  EXPECT_EQ(read.geom, "l");
  ASSERT_EQ(read.layout.taxels.size(), 1U);
  EXPECT_EQ(read.layout.taxels[0].id, 5);
  EXPECT_EQ(read.layout.taxels[0].radius, 0.1);
  EXPECT_LT(glm::distance(read.layout.taxels[0].center, dvec3(0, 1, 10)), 1e-15);
  EXPECT_LT(glm::distance(read.layout.taxels[0].normal, dvec3(0, 1, 0)), 1e-15) << "x of the sensor is y of the link";
}

TEST(UrdfTactile, RefusesAnglesThatHaveNoMeaning) {
  EXPECT_EQ(format_complaint("urdf", urdf_of("<taxel idx=\"0\" rpy=\"-1e300 0 1\"/>")),
            "f: line 5, <taxel rpy>: must be angles of at most 1000 rad, one is 1e+300");
  EXPECT_EQ(parsed("urdf", urdf_of("<taxel idx=\"0\" rpy=\"-1000 0 1\"/>")).size(), 1U);
}

TEST(UrdfTactile, CountsRowsIfAnIndexIsRepeated) {
  const ImportedLayout read = parsed("urdf", urdf_of("<taxel idx=\"0\"/><taxel idx=\"0\" xyz=\"1 2 3\"/><array/>"))[0];
  EXPECT_EQ(read.layout.taxels[1].id, 1);
  EXPECT_TRUE(has_note(read, "idx 0 is there more than once"));
  EXPECT_TRUE(has_note(read, "2 of 2 taxels have no sphere"));
  EXPECT_TRUE(has_note(read, "<array> is left out"));
  EXPECT_FALSE(read.has_radii());
}

TEST(UrdfTactile, KnowsWhichTaxelsHaveNoRadius) {
  const std::string sphere = "<taxel idx=\"0\"><geometry><sphere radius=\"0.006\"/></geometry></taxel>";
  const ImportedLayout read = parsed("urdf", urdf_of(sphere + "<taxel idx=\"1\"/>"))[0];
  EXPECT_EQ(read.missing_radii, std::vector<std::size_t>{1}) << "a radius that equals the default is one";
  const ImportedLayout again = parsed("urdf", find_layout_format("urdf")->write({read}).bytes)[0];
  EXPECT_EQ(again.missing_radii, read.missing_radii);
}

TEST(UrdfTactile, SpreadsAnArrayInItsOrder) {
  const std::string array = R"(<array rows="2" cols="3" size="0.1 0.2" spacing="1 -10" offset="100 1000")";
  const std::vector<Taxel> rows = parsed("urdf", urdf_of(array + "/>"))[0].layout.taxels;
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows[1].center, dvec3(-100, -1010, 0)) << "the next column";
  EXPECT_EQ(rows[3].center, dvec3(-99, -1000, 0)) << "the next row";
  EXPECT_EQ(rows[0].radius, 0.05);
  const std::vector<Taxel> columns = parsed("urdf", urdf_of(array + " order=\"col-major\"/>"))[0].layout.taxels;
  EXPECT_EQ(columns[1].center, dvec3(-99, -1000, 0));
  EXPECT_EQ(columns[2].center, dvec3(-100, -1010, 0));
}

TEST(UrdfTactile, NamesTheLineOfEachMistake) {
  EXPECT_EQ(format_complaint("urdf", "<robot>"), "f: line 1: is no XML: mismatched element");
  EXPECT_EQ(format_complaint("urdf", "<robo/>"), "f: line 1, <robo>: must be <robot>: the file is no URDF");
  EXPECT_EQ(format_complaint("urdf", "<robot/>"), "f: has no <sensor> with <tactile>, and no links that are taxels");
  EXPECT_EQ(
      format_complaint("urdf", "<robot><sensor name=\"c\"><camera/></sensor></robot>"),
      "f: has no <sensor> with <tactile>, and no links that are taxels, but sensors of other kinds: \"c\" (<camera>)");
  EXPECT_EQ(format_complaint("urdf", urdf_of("")), "f: line 4, <tactile>: has no <taxel> and no <array>");
  EXPECT_EQ(format_complaint("urdf", urdf_of("<taxel idx=\"-1\"/>")),
            "f: line 5, <taxel idx>: must be a whole number from 0 to 2000000000, is \"-1\"");
  EXPECT_EQ(format_complaint("urdf", urdf_of("<taxel xyz=\"1 2\"/>")),
            "f: line 5, <taxel xyz>: must be 3 finite numbers, is \"1 2\"");
  EXPECT_EQ(format_complaint("urdf", urdf_of("<taxel><geometry><sphere radius=\"0\"/></geometry></taxel>")),
            "f: line 5, <sphere radius>: must be greater than 0, is 0");
  EXPECT_EQ(format_complaint("urdf", urdf_of("<array rows=\"2\" cols=\"2\"/>")), "f: line 5, <array size>: is missing");
  EXPECT_EQ(format_complaint("urdf", urdf_of("<array rows=\"99999\" cols=\"99999\" size=\"1 1\"/>")),
            "f: line 5, <array>: has 99999 x 99999 taxels, at most 100000 are read");
}

TEST(MjcfLayout, ReadsTouchSitesOfEachBody) {
  const std::vector<ImportedLayout> read = parsed("mjcf", R"(<mujoco><default><site size="0.01"/></default><worldbody>
    <body name="tip"><site name="a" pos="1 2 3" zaxis="0 1 0"/><site name="b" size="0.002" quat="0 1 0 0"/>
    <body name="pad"><site name="c"/></body></body></worldbody>
    <sensor><touch site="c"/><touch site="a"/><touch site="b"/></sensor></mujoco>)");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].layout.name, "pad");
  EXPECT_FALSE(read[0].has_normals);
  EXPECT_EQ(read[1].layout.name, "tip");
  ASSERT_EQ(read[1].layout.taxels.size(), 2U);
  EXPECT_EQ(read[1].layout.taxels[0], (Taxel{0, "a", dvec3(1, 2, 3), dvec3(0, 1, 0), 0.01, {}}));
  EXPECT_EQ(read[1].layout.taxels[1].normal, dvec3(0, 0, -1));
  EXPECT_EQ(read[1].layout.taxels[1].radius, 0.002);
}

TEST(MjcfLayout, NamesTheLineOfEachMistake) {
  EXPECT_EQ(format_complaint("mjcf", "<mujoco/>"), "f: holds no layout: no plugin taxel.sensor and no <touch> sensor");
  EXPECT_EQ(format_complaint("mjcf", "<robot/>"), "f: line 1, <robot>: must be <mujoco>: the file is no MuJoCo scene");
  EXPECT_EQ(format_complaint("mjcf", "<mujoco><sensor>\n<touch site=\"x\"/></sensor></mujoco>"),
            "f: line 2, <touch site>: there is no site \"x\"");
  const std::string head = "<mujoco><extension><plugin plugin=\"taxel.sensor\">\n<instance>",
                    tail = "</instance></plugin></extension></mujoco>";
  EXPECT_EQ(format_complaint("mjcf", head + tail), "f: line 2, <instance>: has no <config key=\"layout\">");
  EXPECT_EQ(format_complaint("mjcf", head + "<config key=\"layout\" value=\"{}\"/>" + tail),
            "f: line 2, <config value>: /format: is missing");
  EXPECT_EQ(format_complaint("mjcf", head + "<config key=\"layout\" value=\"gone.json\"/>" + tail),
            "gone.json: no such file");
}

TEST(RealFormats, HaveTheirNumbersOfTaxels) {
  const std::filesystem::path real(TAXEL_REAL_DATA);
  if (!std::filesystem::exists(real / "formats")) GTEST_SKIP() << real << " has no folder formats";
  const auto counts = [&](const char* file) {
    std::vector<std::size_t> taxels;
    for (const ImportedLayout& one : read_layouts(*layout_format_of(real / file), real / file))
      taxels.push_back(one.layout.taxels.size());
    return taxels;
  };
  const std::vector<std::size_t> probes = counts("formats/genesis_probes_98_sharpa.json");
  EXPECT_EQ(probes.size(), 17U);
  EXPECT_EQ(std::accumulate(probes.begin(), probes.end(), std::size_t{0}), 98U);
  EXPECT_EQ(counts("formats/ubi_tactile.urdf"), (std::vector<std::size_t>{256, 2}));
  EXPECT_EQ(counts("formats/gentact_header.csv"), std::vector<std::size_t>{2});
  EXPECT_EQ(counts("paper/curved_fingertip.yaml"), std::vector<std::size_t>{12});
  EXPECT_EQ(counts("flat_taxel_sensor.yaml"), std::vector<std::size_t>{256});
}

}  // namespace
}  // namespace taxel
