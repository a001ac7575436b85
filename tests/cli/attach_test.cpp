// `taxel attach`: a saved scene differs from its file by additions only, and reads as `taxel run` with the same layout.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

/// A scene of tests/fixtures/scenes_to_patch with its options.
struct SceneToPatch {
  std::string file;
  std::vector<std::string> places;
};

std::vector<SceneToPatch> scenes_to_patch() {
  std::istringstream lines(file_text(fs::path(TAXEL_SOURCE_DIR) / "tests/fixtures/scenes_to_patch/scenes.txt"));
  std::vector<SceneToPatch> scenes;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream words(line);
    SceneToPatch& scene = scenes.emplace_back();
    words >> scene.file;
    for (std::string word; words >> word;) scene.places.push_back(word);
  }
  return scenes;
}

/// Returns a folder with the scenes, our fingertip and a quick layout of it.
fs::path folder_of_scenes() {
  const fs::path folder = test_folder();
  fs::copy(fs::path(TAXEL_SOURCE_DIR) / "tests/fixtures/scenes_to_patch", folder, fs::copy_options::recursive);
  fs::create_directory(folder / "meshes");
  for (const fs::path& place : {folder, folder / "meshes"})
    fs::copy(fs::path(TAXEL_SOURCE_DIR) / "assets/meshes/fingertip.obj", place);
  fs::rename(changed_layout(folder, Json::parse(R"([{"op": "replace", "path": "/mesh/file", "value": "fingertip.obj"},
                                                    {"op": "replace", "path": "/sampling/density", "value": 2e5}])")),
             folder / "tip.taxels.json");
  return folder;
}

std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Returns true if `saved` is `original` with additions only.
bool is_contained(const std::string& original, const std::string& saved) {
  std::size_t at = 0;
  for (const char c : saved)
    if (at < original.size() && original[at] == c) ++at;
  return at == original.size();
}

/// Returns the numbers of a table without its head: names of columns follow the names of geoms.
std::string rows_of(const fs::path& run) {
  const std::string text = file_text(run / "readings.csv");
  return text.substr(text.find('\n'));
}

/// Runs a scene for a moment. Returns the folder of the result.
fs::path run(const fs::path& folder, const std::string& name, const std::string& scene,
             const std::vector<std::string>& options = {}) {
  const Outcome outcome = taxel(joined({"run", scene, "--seconds", "0.04", "--quiet", "--out", name}, options), folder);
  EXPECT_EQ(outcome.status, 0) << scene << ": " << outcome.err;
  return folder / name;
}

/// Returns the attachments of `taxel run` that `taxel attach` makes for these places.
std::vector<std::string> attachments_of_run(const std::vector<std::string>& places) {
  if (places[0] != "--mesh") return joined({"--layout", "tip.taxels.json"}, places);
  return {"--layout", "tip.taxels.json", "--geom", "geom 1", "--layout", "tip.taxels.json", "--geom", "geom 3"};
}

TEST(Attach, AddsTextAndChangesNothingElse) {
  const fs::path folder = folder_of_scenes();
  for (const auto& [file, places] : scenes_to_patch()) {
    const Outcome outcome =
        taxel(joined({"attach", file, "--layout", "tip.taxels.json", "--out", "saved.xml", "--json"}, places), folder);
    ASSERT_EQ(outcome.status, 0) << file << ": " << outcome.err;
    const Json report = Json::parse(outcome.out);
    const std::string saved = file_text(folder / "saved.xml");
    const bool is_old = file == "old.xml";
    std::string original = file_text(folder / file);
    // The masks of contact change from 1 to 0, names of included files change, dropped attributes become spaces.
    const auto forget = [](std::string text, const std::string& words) {
      for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words))
        text.erase(at, words.size());
      return text;
    };
    if (is_old) original = forget(original, "collision=\"all\"");
    for (const char* words : {"\"robot.xml\"", "\"parts/world.xml\"", "contype=\"1\"", "conaffinity='1'"})
      original = forget(original, words);
    EXPECT_TRUE(is_contained(original, saved)) << file << "\n" << saved;
    for (const Json& copy : report["files"])
      if (const std::string name = copy; name.ends_with(".xml")) {
        const std::string part = name.substr(std::string("saved_").size());
        const fs::path source = fs::exists(folder / part) ? folder / part : folder / "parts" / part;
        EXPECT_TRUE(is_contained(forget(forget(file_text(source), "\"parts/finger.xml\""), "contype=\"3\""),
                                 file_text(folder / name)))
            << name;
      }
  }
}

TEST(Attach, ReadsToTheLastBitAsTheRunOfTheLayout) {
  const fs::path folder = folder_of_scenes();
  bool is_elsewhere = false;
  for (const auto& [file, places] : scenes_to_patch()) {
    const std::string expected = rows_of(run(folder, "run", file, attachments_of_run(places)));
    EXPECT_NE(expected.find_first_of("123456789"), std::string::npos);
    is_elsewhere = !is_elsewhere;
    const std::string out = is_elsewhere ? "elsewhere/deep/saved.xml" : "saved.xml";
    const Outcome outcome =
        taxel(joined({"attach", file, "--layout", "tip.taxels.json", "--out", out, "--quiet"}, places), folder);
    ASSERT_EQ(outcome.status, 0) << file << ": " << outcome.err;
    EXPECT_EQ(rows_of(run(folder, "saved", out)), expected) << file << " as " << out;
  }
}

TEST(Attach, ReportsNamesAndFilesAndKeepsTheScene) {
  const fs::path folder = folder_of_scenes();
  const std::string before = file_text(folder / "robot.xml");
  const Json report = taxel_json(
      {"attach", "included.xml", "--body", "distal", "--layout", "tip.taxels.json", "--out", "out/sensed.xml"}, folder);
  EXPECT_EQ(report["scene"], "out/sensed.xml");
  const Json& sensor = report["sensors"].at(0);
  EXPECT_EQ(sensor["name"], "distal taxels");
  EXPECT_EQ(sensor["geom"], "distal");
  EXPECT_EQ(sensor["layout"], "tip.taxels.json");
  EXPECT_EQ(sensor["taxels"], 12);
  EXPECT_EQ(report["files"], Json::parse(R"(["sensed_robot.xml", "tip.taxels.json"])"));
  const std::string robot = file_text(folder / "out/sensed_robot.xml");
  EXPECT_NE(robot.find(R"(<geom name="distal" class="visual" mesh="fingertip"/>   <!-- drawn -->)"), std::string::npos);
  EXPECT_NE(robot.find("mass=\"0\" contype=\"0\" conaffinity=\"0\"/>"), std::string::npos) << robot;
  const std::string saved = file_text(folder / "out/sensed.xml");
  for (const char* part : {"<include file=\"sensed_robot.xml\"/>", "<compiler meshdir=\"../meshes\"/>",
                           "key=\"contype\" value=\"3\"", "key=\"layout\" value=\"../out/tip.taxels.json\""})
    EXPECT_NE(saved.find(part), std::string::npos) << part << "\n" << saved;
  EXPECT_EQ(Json::parse(file_text(folder / "out/tip.taxels.json"))["mesh"]["file"], "../fingertip.obj");
  EXPECT_EQ(file_text(folder / "robot.xml"), before);
}

TEST(Attach, SaysWhyALayoutIsRefused) {
  const fs::path folder = folder_of_scenes();
  write_text(folder / "bad.xml",
             R"(<mujoco><asset><mesh name="tip" file="fingertip.obj"/><mesh name="big" file="fingertip.obj"
    scale="1000 1000 1000"/><mesh name="mirrored" file="fingertip.obj" scale="1 -1 1"/>
    <hfield name="h" nrow="2" ncol="2" size="1 1 1 1"/></asset><worldbody>
    <geom name="floor" type="plane" size="1 1 1"/><geom name="hills" type="hfield" hfield="h" pos="9 9 -9"/>
    <body name="bare"/><body name="box"><geom name="box" type="box" size="1 1 1"/></body>
    <body name="two"><geom name="one" type="mesh" mesh="tip"/><geom name="other" type="mesh" mesh="big"/></body>
    <body name="m"><freejoint/><geom name="mirror" type="mesh" mesh="mirrored"/></body></worldbody></mujoco>)");
  Json far = Json::parse(file_text(folder / "tip.taxels.json"));
  for (Json& taxel : far["taxels"]) taxel["center"][0] = taxel["center"][0].get<double>() + 0.1;
  const auto refused = [&](const std::vector<std::string>& options, const std::string& words) {
    const Outcome outcome = taxel(joined({"attach", "bad.xml", "--out", "saved.xml"}, options), folder);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(words), std::string::npos) << words << "\n" << outcome.err;
    EXPECT_FALSE(fs::exists(folder / "saved.xml"));
  };
  const std::vector<std::string> layout{"--layout", "tip.taxels.json"};
  refused(joined(layout, {"--geom", "floor"}), "geom \"floor\" is a plane, which takes no skin");
  refused(joined(layout, {"--geom", "hills"}), "geom \"hills\" is a height field, which takes no skin");
  refused(joined(layout, {"--geom", "box"}), "lies elsewhere: its taxels are ");
  refused(joined(layout, {"--geom", "other"}), "/mesh/scale right?");
  refused(joined(layout, {"--geom", "mirror"}), "`taxel convert LAYOUT MIRRORED --mirror y` mirrors the layout");
  refused(joined(layout, {"--geom", "none"}), "no geom named \"none\"");
  refused(joined(layout, {"--body", "none"}), "has no body \"none\"");
  refused(joined(layout, {"--body", "bare"}), "body \"bare\" has no geoms");
  refused(joined(layout, {"--body", "box"}),
          "body \"box\" has no geom with a mesh: choose one of its geoms with --geom");
  refused(joined(layout, {"--body", "two"}),
          "body \"two\" has the meshes of \"one\" (tip) and \"other\" (big): choose one");
  refused(joined(layout, {"--mesh", "none"}), "has no mesh \"none\"");
  refused(layout, "needs a place: --geom, --body or --mesh");
  refused(joined(joined(layout, layout), {"--geom", "one"}), "2 layouts need as many --geom or as many --body");
  refused({"--layout", "gone.taxels.json", "--geom", "one"}, "gone.taxels.json");
  expect_refusal(
      taxel({"attach", "comments.xml", "--layout", "tip.taxels.json", "--body", "finger", "--out", "comments.xml"},
            folder),
      "taxel: comments.xml: is a file of the scene itself: choose another name");
}

/// A layout goes to the other hand, whose mesh is mirrored by its scale, after `convert --mirror`.
TEST(Attach, TakesAMirroredLayoutForTheOtherHand) {
  const fs::path folder = folder_of_scenes();
  write_text(folder / "left.xml",
             R"(<mujoco><asset><mesh name="tip" file="fingertip.obj" scale="1 -1 1"/></asset><worldbody>
    <geom type="plane" size="1 1 1" pos="0 0 -1"/>
    <body name="finger"><freejoint/><geom name="tip" type="mesh" mesh="tip"/></body></worldbody></mujoco>)");
  ASSERT_EQ(taxel({"convert", "tip.taxels.json", "left.taxels.json", "--mirror", "y"}, folder).status, 0);
  const Json before = Json::parse(file_text(folder / "tip.taxels.json")),
             after = Json::parse(file_text(folder / "left.taxels.json"));
  EXPECT_EQ(after["mesh"]["scale"], Json({1.0, -1.0, 1.0}));
  EXPECT_EQ(after["taxels"][0]["center"][1].get<double>(), -before["taxels"][0]["center"][1].get<double>());
  EXPECT_EQ(after["taxels"][0]["id"], before["taxels"][0]["id"]);
  const Json report = taxel_json(
      {"attach", "left.xml", "--body", "finger", "--layout", "left.taxels.json", "--out", "sensed.xml"}, folder);
  EXPECT_EQ(report["sensors"].size(), 1U);
  EXPECT_EQ(taxel({"run", "sensed.xml", "--seconds", "0.01"}, folder).status, 0);
  expect_refusal(taxel({"convert", "tip.taxels.json", "bad.taxels.json", "--mirror", "w"}, folder),
                 "taxel: convert: --mirror: must be one of x, y, z, is w");
}

/// The scenes of real hands, each of which includes a robot: all fingertips at once, in the folder of the scene's copy.
TEST(Attach, PatchesTheHandsOfMenagerie) {
  const fs::path hands = fs::path(TAXEL_REAL_DATA) / "hands";
  if (!fs::exists(hands)) GTEST_SKIP() << hands << " is absent";
  const fs::path folder = test_folder();
  fs::copy(hands, folder, fs::copy_options::recursive);
  const auto layout = [&](const std::string& name, const std::string& mesh, double scale, const Json& center,
                          const Json& normal) {
    Json json = Json::parse(file_text(fingertip_layout()));
    json["mesh"] = {{"file", mesh}, {"scale", {scale, scale, scale}}};
    json["sampling"]["density"] = 2e5;
    json["taxels"] = Json::array({{{"id", 0}, {"center", center}, {"normal", normal}, {"radius", 0.005}}});
    write_text(folder / name, json.dump());
  };
  layout("shadow_hand/tip.taxels.json", "assets/f_distal_pst.obj", 0.001, {0, -0.0073, 0.02}, {0, -1, 0});
  layout("wonik_allegro/tip.taxels.json", "assets/link_3.0_tip.stl", 1, {0.012, 0, 0}, {1, 0, 0});
  for (const auto& [hand, mesh, count] :
       {std::tuple("shadow_hand", "f_distal_pst", 4), std::tuple("wonik_allegro", "link_3.0_tip", 3)}) {
    const std::string scene = std::string(hand) + "/scene_right.xml", saved = std::string(hand) + "/sensed.xml";
    const Json report = taxel_json(
        {"attach", scene, "--mesh", mesh, "--layout", std::string(hand) + "/tip.taxels.json", "--out", saved}, folder);
    ASSERT_EQ(report["sensors"].size(), static_cast<std::size_t>(count));
    EXPECT_EQ(report["files"], Json::array({"sensed_right_hand.xml"})) << hand;
    EXPECT_TRUE(
        is_contained(file_text(folder / hand / "right_hand.xml"), file_text(folder / hand / "sensed_right_hand.xml")));
    std::vector<std::string> pairs;
    for (const Json& sensor : report["sensors"])
      for (const std::string& word : {std::string("--layout"), std::string(hand) + "/tip.taxels.json",
                                      std::string("--body"), sensor["body"].get<std::string>()})
        pairs.push_back(word);
    EXPECT_EQ(rows_of(run(folder, "saved", saved)), rows_of(run(folder, "run", scene, pairs))) << hand;
  }
}

}  // namespace
}  // namespace taxel::test
