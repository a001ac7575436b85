// `taxel run` on foreign scenes: a layout attached to a geom, and two sensors that a scene declares.
#include <algorithm>
#include <cmath>

#include "cli/taxel_program.h"
#include "fixtures/finger_scene_xml.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

/// A folder with the fingertip's mesh and a coarse layout on it.
fs::path folder_with_layout() {
  const fs::path folder = test_folder();
  fs::copy(fs::path(TAXEL_SOURCE_DIR) / "assets" / "meshes" / "fingertip.obj", folder);
  changed_layout(folder, Json::parse(R"([{"op": "replace", "path": "/mesh/file", "value": "fingertip.obj"},
                                         {"op": "replace", "path": "/sampling/density", "value": 1e6}])"));
  return folder;
}

TEST(Run, AttachesALayoutToAGeom) {
  const fs::path folder = folder_with_layout();
  // The sensor touches the plane, because the plane can collide with the finger.
  write_text(folder / "scene.xml", finger_scene(finger_body("tip", 0, true, "<freejoint/>")));
  const Json run = taxel_json(
      {"run", "scene.xml", "--layout", "changed.taxels.json", "--geom", "tip", "--seconds", "0.01", "--out", "out"},
      folder);
  EXPECT_EQ(run["rows"], run["steps"]);
  EXPECT_EQ(run["sensors"][0]["geom"], "tip");
  const Table table = read_csv(folder / "out" / "readings.csv");
  ASSERT_GE(table.at("area").size(), 5U);
  EXPECT_GT(table.at("force_z").front(), 0.01);
  EXPECT_GT(table.at("area").front(), 1e-6);
  double pad = 0, side = 0;
  for (const int id : {0, 3, 6, 9}) pad += table.at("taxel_" + std::to_string(id)).front();
  for (const int id : {1, 2, 7, 8}) side += table.at("taxel_" + std::to_string(id)).front();
  EXPECT_GT(pad, 10 * side);
  // The written folder is complete. MuJoCo writes its XML with rounded numbers.
  const Json again = taxel_json({"run", "out/scene.xml", "--seconds", "0.01"}, folder);
  const double force = run["sensors"][0]["largest_force"];
  EXPECT_NEAR(again["sensors"][0]["largest_force"].get<double>(), force, 1e-9 * force);
}

/// Returns a finger as robots have it: no geom has a name, the mesh is only drawn, and a capsule in it collides.
std::string robots_finger() {
  return R"(<body name="link" pos="0 0 0.0061" quat="0.70710678 0.70710678 0 0"><freejoint/>
      <geom type="mesh" mesh="tip" contype="0" conaffinity="0"/><geom type="capsule" size="0.004 0.004" pos="0 0 0.01"/></body>)";
}

TEST(Run, AttachesALayoutToTheDrawnMeshOfABody) {
  const fs::path folder = folder_with_layout();
  write_text(folder / "scene.xml", finger_scene(robots_finger()));
  const std::vector<std::string> with_body{"run",       "scene.xml", "--layout", "changed.taxels.json",
                                           "--seconds", "0.01",      "--body",   "link"};
  const auto run = [&](std::vector<std::string> more) {
    more.insert(more.begin(), with_body.begin(), with_body.end());
    return taxel(more, folder);
  };
  const Outcome replaced = run({"--out", "out"});
  EXPECT_EQ(replaced.status, 0) << replaced.err;
  EXPECT_NE(replaced.err.find("replaces the contacts of what lies within it: \"link, capsule\" (100 % of its surface)"),
            std::string::npos)
      << replaced.err;
  EXPECT_GT(read_csv(folder / "out" / "readings.csv").at("force_z").front(), 0.01);
  EXPECT_NE(replaced.out.find(", moved up to "), std::string::npos) << replaced.out;
  EXPECT_EQ(replaced.out.find("mocap"), std::string::npos) << replaced.out;
  EXPECT_EQ(run({"--sisters", "keep"}).err.find("replaces"), std::string::npos);
  expect_refusal(run({"--geom", "tip"}), "taxel: run: --body: excludes --geom");
  expect_refusal(run({"--others", "hand"}),
                 "taxel: scene.xml: taxel.sensor \"taxels of link\": others: there is no geom named \"hand\"");
  expect_refusal(taxel({"run", "scene.xml", "--others", "floor"}, folder),
                 "taxel: run: --others and --sisters go with --layout");
}

TEST(Run, CalibratesEachSensorAndLeavesNoTableOfAnEarlierRun) {
  const fs::path folder = folder_with_layout();
  write_text(folder / "scene.xml", finger_scene(finger_body("tip", 0, true, "<freejoint/>")));
  const auto run = [&](const Json& patch) {
    const Json original = Json::parse(file_text(folder / "changed.taxels.json"));
    write_text(folder / "l.taxels.json", original.patch(patch).dump());
    return taxel_json(
        {"run", "scene.xml", "--layout", "l.taxels.json", "--geom", "tip", "--seconds", "0.01", "--out", "out"},
        folder);
  };
  const Json calibration = {{"tare", "first_reading"}, {"noise", 1}};
  const Json patch = Json::array({{{"op", "add"}, {"path", "/calibration"}, {"value", calibration}}});
  const Json files = run(patch)["files"];
  EXPECT_NE(std::find(files.begin(), files.end(), "calibrated.csv"), files.end());
  const Table raw = read_csv(folder / "out" / "readings.csv"), table = read_csv(folder / "out" / "calibrated.csv");
  const std::string first = file_text(folder / "out" / "calibrated.csv");
  for (const char* taxel : {"taxel_0", "taxel_1"}) {
    bool noisy = false;
    for (std::size_t i = 0; i < table.at("time").size(); ++i) {
      const double tared = raw.at(taxel)[i] - raw.at(taxel)[0];
      EXPECT_NEAR(table.at(taxel)[i], tared, 6) << taxel << ", row " << i;  // noise is at most 6 deviations
      noisy |= table.at(taxel)[i] != tared;
    }
    EXPECT_TRUE(noisy);
  }
  run(patch);
  EXPECT_EQ(file_text(folder / "out" / "calibrated.csv"), first);  // the seed determines the noise
  run(Json::array());
  EXPECT_FALSE(fs::exists(folder / "out" / "calibrated.csv"));
}

/// A height field and a signed distance function of MuJoCo, 1 mm deep in the tip of a finger, at z = 30.5 mm.
TEST(Run, TouchesHeightFieldsAndSignedDistanceFunctions) {
  const fs::path folder = folder_with_layout();
  const auto first_force = [&](const std::string& head, const std::string& ground) {
    write_text(folder / "scene.xml", "<mujoco><option gravity='0 0 0'/>" + head +
                                         "<asset><mesh name='tip' file='fingertip.obj'/></asset><worldbody>" + ground +
                                         "<body><freejoint/><geom name='tip' type='mesh' mesh='tip'/></body>"
                                         "</worldbody></mujoco>");
    fs::remove_all(folder / "out");
    taxel_json({"run", "scene.xml", "--plugins", TAXEL_MUJOCO_PLUGINS, "--layout", "changed.taxels.json", "--geom",
                "tip", "--seconds", "0.004", "--out", "out"},
               folder);
    return read_csv(folder / "out" / "readings.csv").at("force_z").front();
  };
  const double on_box = first_force("", "<geom type='box' size='0.05 0.05 0.05' pos='0 0 0.0795'/>");
  EXPECT_LT(on_box, -0.001);
  const double on_hills =
      first_force("<asset><hfield name='h' nrow='3' ncol='3' size='0.05 0.05 0.01 0.05'/></asset>",
                  "<geom type='hfield' hfield='h' pos='0 0 0.0295' euler='180 0 0'/>");  // upside down
  EXPECT_NEAR(on_hills, on_box, 1e-6 * std::abs(on_box));
  const double on_torus = first_force(
      "<extension><plugin plugin='mujoco.sdf.torus'><instance name='t'><config key='radius1' value='0.03'/>"
      "<config key='radius2' value='0.01'/></instance></plugin></extension>"
      "<asset><mesh name='t'><plugin instance='t'/></mesh></asset>",
      "<geom type='sdf' mesh='t' pos='0.03 0 0.0395'><plugin instance='t'/></geom>");
  EXPECT_LT(on_torus, -0.1 * std::abs(on_box));
  EXPECT_GT(on_torus, on_box);  // a round body touches a smaller area than a plane
  expect_refusal(taxel({"run", "scene.xml", "--plugins", "gone"}, folder), "taxel: gone: is no folder");
  expect_refusal(taxel({"run", "scene.xml", "--plugins", "out"}, folder),
                 "taxel: out: holds no plugin that MuJoCo loads");
}

TEST(Run, NamesSeveralSensorsByTheirGeoms) {
  const fs::path folder = folder_with_layout();
  write_text(folder / "scene.xml", finger_scene(finger_body("thumb", 0) + finger_body("index", 0.1), {"thumb", "index"},
                                                "changed.taxels.json"));
  const Json run = taxel_json({"run", (folder / "scene.xml").string(), "--seconds", "0.004", "--out", "out"}, folder);
  EXPECT_EQ(run["sensors"].size(), 2U);
  const Table table = read_csv(folder / "out" / "readings.csv");
  EXPECT_EQ(table.size(), 2U + 2U * (5U + 12U));
  EXPECT_GT(table.at("thumb/force_z").front(), 0.01);
  // A second finger at another position reads the same, up to the rounding of its position.
  EXPECT_NEAR(table.at("thumb/taxel_3").front(), table.at("index/taxel_3").front(),
              1e-6 * table.at("thumb/taxel_3").front());
  const auto arrays = parse_npz(file_text(folder / "out" / "readings.npz"));
  EXPECT_EQ(arrays.at("sensor_geoms").texts(), (std::vector<std::string>{"thumb", "index"}));
  EXPECT_EQ(arrays.at("index/readings").shape, (std::vector<std::size_t>{table.at("time").size(), 12}));
}

TEST(Run, WarnsOnceIfMuJoCosContactActsOnASensor) {
  const fs::path folder = folder_with_layout();
  write_text(folder / "scene.xml",
             finger_scene(finger_body("thumb", 0, true, "<freejoint/>") + finger_body("index", 0.1), {"thumb", "index"},
                          "changed.taxels.json"));
  const Outcome run = taxel({"run", "scene.xml", "--seconds", "0.02"}, folder);
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err,
            "taxel: warning: sensor \"thumb\": MuJoCo's own contact of geoms \"thumb\" and \"floor\" acts as well: "
            "exclude the pair, or set contype and conaffinity to 0 and name the geom in \"others\"\n");
  EXPECT_EQ(taxel({"run", "scene.xml", "--seconds", "0.02", "--quiet"}, folder).err, "");
}

}  // namespace
}  // namespace taxel::test
