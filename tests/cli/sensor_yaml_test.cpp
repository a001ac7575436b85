// Sensor descriptions of the predecessor's code, with a mesh and on geoms of scenes.
#include <algorithm>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

/// Returns a sensor with two taxels on a box of half size 10 mm.
std::string yaml_of(const std::string& type, const std::string& geom) {
  return "MujocoPlugins:\n  - type: mocap\n  - type: surfaces\n    SurfacePlugins:\n    - {type: s/" + type +
         ", sensorName: tip, geomName: " + geom +
         ",\n       include_margin: 0.006, sample_resolution: 1.0e6, topicName: /t,\n"
         "       taxels: [[0, 0, 0.01], [0, 0, -0.01]],\n       normals: [[0, 0, 1], [0, 0, -1]]}\n";
}

bool mentions(const Outcome& outcome, const std::string& part) {
  return outcome.err.find(part) != std::string::npos;
}

double largest_value(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

class SensorYamlCli : public testing::Test {
 protected:
  void SetUp() override {
    folder = test_folder();
    write_text(folder / "box.obj", box_obj(10));  // in mm
    write_text(folder / "tip.yaml", yaml_of("CurvedSensor", "tip_geom"));
    yaml = (folder / "tip.yaml").string();
    mesh = (folder / "box.obj").string();
  }
  fs::path folder;
  std::string yaml, mesh;
};

TEST_F(SensorYamlCli, PlacesSamplesOnTheNamedMesh) {
  const Outcome outcome =
      taxel({"samples", yaml, "--mesh", mesh, "--scale", "0.001", "--out", (folder / "s.csv").string()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(mentions(outcome, "not carried over: topicName")) << outcome.err;
  EXPECT_EQ(read_csv(folder / "s.csv").at("x").size(), 2400U) << "1e6 per m^2 on 6 x 4 cm^2";
}

TEST_F(SensorYamlCli, GuessesTheScaleAndReportsIt) {
  const Outcome outcome = taxel({"samples", yaml, "--mesh", mesh, "--out", (folder / "s.csv").string()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(mentions(outcome, "box.obj is taken with scale 0.001")) << outcome.err;
}

TEST_F(SensorYamlCli, RefusesAFileWithoutAMesh) {
  expect_refusal(taxel({"sweep", "--layout", yaml}),
                 "taxel: " + yaml +
                     ": holds no mesh: name it with --mesh FILE, and its unit with --scale S (0.001 for millimetres)");
  expect_refusal(taxel({"sweep", "--mesh", mesh}), "taxel: --mesh, --scale and --sensor go with --layout");
  EXPECT_EQ(taxel({"check", yaml}).status, 0);
}

TEST_F(SensorYamlCli, ChecksTheLayoutOnItsMesh) {
  const Json good = taxel_json({"check", yaml, "--mesh", mesh, "--scale", "0.001"});
  for (const Json& problem : good["problems"]) EXPECT_EQ(problem["severity"], "note") << problem;
  const Outcome far = taxel({"check", yaml, "--mesh", mesh, "--scale", "1"});
  EXPECT_EQ(far.status, 2);
  EXPECT_NE(far.out.find("the mesh is 20 m large, but a sensor is 0.001 m to 1 m large: give its unit by --scale"),
            std::string::npos)
      << far.out;
}

/// Returns a scene with the box as a mesh in millimetres, or as a box, on another body.
std::string scene_of(const std::string& geom) {
  return "<mujoco><asset><mesh name='m' file='box.obj' scale='0.001 0.001 0.001'/></asset><worldbody>"
         "<body pos='0 0 0.0095'><freejoint/><geom name='tip_geom' " +
         geom + "/></body><geom name='floor' type='plane' size='1 1 1'/></worldbody></mujoco>";
}

TEST_F(SensorYamlCli, RunsOnTheGeomThatTheFileNames) {
  for (const std::string geom : {"type='mesh' mesh='m'", "type='box' size='0.01 0.01 0.01'"}) {
    write_text(folder / "scene.xml", scene_of(geom));
    const Json run = taxel_json({"run", (folder / "scene.xml").string(), "--layout", yaml, "--seconds", "0.01", "--out",
                                 (folder / "out").string()});
    EXPECT_FALSE(run.empty()) << geom;
    const Table rows = read_csv(folder / "out" / "readings.csv");
    EXPECT_GT(largest_value(rows.at("force_z")), 0) << geom;
    EXPECT_GT(largest_value(rows.at("taxel_1")), 0) << geom << ": the taxel that looks down";
    EXPECT_EQ(largest_value(rows.at("taxel_0")), 0) << geom;
  }
}

TEST_F(SensorYamlCli, NamesTheLineOfAGeomThatTheSceneLacks) {
  write_text(folder / "other.yaml", yaml_of("CurvedSensor", "thumb_geom"));
  write_text(folder / "scene.xml", scene_of("type='box' size='0.01 0.01 0.01'"));
  const std::string scene = (folder / "scene.xml").string(), other = (folder / "other.yaml").string();
  expect_refusal(
      taxel({"run", scene, "--layout", other}),
      "taxel: " + other + ": line 5, key geomName: the scene has no geom \"thumb_geom\"; it has floor, tip_geom");
  EXPECT_EQ(taxel({"run", scene, "--layout", other, "--geom", "tip_geom", "--seconds", "0.002"}).status, 0);
}

TEST_F(SensorYamlCli, NamesLineAndKeyOfBadFiles) {
  const std::string good = yaml_of("CurvedSensor", "tip_geom"), bad = (folder / "bad.yaml").string();
  write_text(folder / "scene.xml", scene_of("type='box' size='0.01 0.01 0.01'"));
  const auto refused = [&](const std::string& text, const std::string& complaint) {
    write_text(bad, text);
    expect_refusal(taxel({"samples", bad, "--mesh", mesh, "--scale", "0.001"}), "taxel: " + bad + ": " + complaint);
    expect_refusal(taxel({"run", (folder / "scene.xml").string(), "--layout", bad}),
                   "taxel: " + bad + ": " + complaint);
  };
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  refused(changed("0.006", "wide"), "line 6, key include_margin: must be a number, is \"wide\"");
  refused(changed("[0, 0, -0.01]", "[0, below, -0.01]"), "line 7, key taxels[1][1]: must be a number, is \"below\"");
  refused(changed(",\n       normals: [[0, 0, 1], [0, 0, -1]]", ""),
          "line 5, key SurfacePlugins[0]: key normals is missing: a CurvedSensor has one for each taxel");
  refused("MujocoPlugins:\n  - type: a/Mocap\n  - type: b/Ros\n",
          "key MujocoPlugins: no plugin holds SurfacePlugins; there are a/Mocap, b/Ros");
  refused("MujocoPlugins:\n  - type: a\n    SurfacePlugins: [{type: b/Other}]\n",
          "key SurfacePlugins: holds no CurvedSensor, TaxelSensor or FlatTactileSensor, but b/Other");
}

TEST_F(SensorYamlCli, UsesTheMaterialOfTheScenesField) {
  std::string text = scene_of("type='box' size='0.01 0.01 0.01'");
  text.insert(text.find("<asset>"),
              "<custom><numeric name='cs::tip_geom' data='3e4 2 0 0.1 0.2'/>"
              "<numeric name='cs::floor' data='0 1 0 0.1 0.2'/></custom>");
  write_text(folder / "scene.xml", text);
  const Outcome outcome = taxel({"run", (folder / "scene.xml").string(), "--layout", yaml, "--seconds", "0.002"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(
      mentions(outcome, "\"cs::tip_geom\" gives the material: modulus 30000 Pa, dissipation 2 s/m, friction 0.2"))
      << outcome.err;
}

TEST_F(SensorYamlCli, ReadsTheReleasedFiles) {
  const fs::path real = TAXEL_REAL_DATA;
  if (!fs::exists(real)) GTEST_SKIP() << "the released files are absent: " << real;
  const std::string paper = (real / "paper" / "curved_fingertip.yaml").string();
  const Json check =
      taxel_json({"check", paper, (real / "myrmex_sensor.yaml").string(), (real / "flat_taxel_sensor.yaml").string()});
  for (const Json& problem : check["problems"]) EXPECT_EQ(problem["severity"], "note") << problem;
  for (const std::string file : {"myrmex_sensor.yaml", "flat_taxel_sensor.yaml"}) {
    const Json run = taxel_json({"run", (real / "myrmex_box_world.xml").string(), "--layout", (real / file).string(),
                                 "--seconds", "0.002", "--out", (folder / "out").string()});
    EXPECT_EQ(read_csv(folder / "out" / "readings.csv").count("taxel_255"), 1U) << file;
  }
}

}  // namespace
}  // namespace taxel::test
