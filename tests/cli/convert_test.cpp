// taxel convert between all formats, and taxel check in the words of each format.
#include <fmt/format.h>

#include <set>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

const char* const kProbes =
    R"([{"link_name": "tip", "kind": "grid", "probes": [[{"radius": 0.004, "pos": [0, 0, 0.01], "normal": [0, 0, 1]},
{"radius": 0.004, "pos": [0.002, 0, 0.01], "normal": [0, 0, 1]}]]},
{"link_name": "pad", "kind": "grid", "probes": [[{"radius": 0.003, "pos": [0, 0, -0.01], "normal": [0, 0, -1]}]]}])";

class ConvertCli : public testing::Test {
 protected:
  void SetUp() override {
    folder = test_folder();
    write_text(folder / "box.obj", box_obj(0.01));
    write_text(folder / "probes.json", kProbes);
  }
  [[nodiscard]] Outcome convert(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "convert");
    return taxel(arguments, folder);
  }
  fs::path folder;
};

TEST_F(ConvertCli, WritesALayoutForEachLinkIntoAFolder) {
  const Outcome outcome = convert({"probes.json", "out", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json report = Json::parse(outcome.out);
  EXPECT_EQ(report["taxels"], 3);
  ASSERT_EQ(report["files"].size(), 2U);
  EXPECT_EQ(report["files"][0]["file"], "out/tip.taxels.json");
  EXPECT_EQ(report["files"][0]["layouts"][0]["taxels"], 2);
  EXPECT_NE(report["notes"].dump().find("the layout has no mesh yet"), std::string::npos) << report;
  const Outcome back = convert({"out", "back.probes.json"});
  ASSERT_EQ(back.status, 0) << back.err;
  Json was = Json::parse(kProbes), is = Json::parse(file_text(folder / "back.probes.json"));
  std::swap(was[0], was[1]);  // files of a folder are read by name
  EXPECT_EQ(is, was);
}

// The names of layouts become names of files: none of them is hidden, is a folder, leads out of the folder, or takes
// the place of another one.
TEST_F(ConvertCli, GivesEachLayoutItsOwnFileWhateverItsName) {
  const std::pair<const char*, const char*> names[] = {
      {"", "layout.csv"},      {".", "layout..csv"}, {"..", "layout...csv"},          {"../up", "layout.._up.csv"},
      {"a/b", "a_b.csv"},      {"tip", "tip.csv"},   {"tip_2", "tip_2.csv"},          {"tip", "tip_3.csv"},
      {"a\\\\b", "a_b_2.csv"}, {"x\\n", "x_.csv"},   {".hidden", "layout.hidden.csv"}};
  fs::create_directory(folder / "in");
  std::set<std::string> expected;
  for (const auto& [name, file] : names) {
    const std::size_t number = expected.size();
    write_text(folder / "in" / fmt::format("{:02}.taxels.json", number),
               fmt::format(R"({{"format": "taxel-layout", "version": 1, "name": "{}", "mesh": {{"file": "box.obj"}},
"taxels": [{{"id": {}, "center": [0, 0, 0.01], "normal": [0, 0, 1], "radius": 0.004}}]}})",
                           name, number));
    expected.insert(file);
  }
  const Outcome outcome = convert({"in", "out", "--to", "csv"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::set<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "out"))
    files.insert(entry.path().filename().string());
  EXPECT_EQ(files, expected);
  std::size_t number = 0;
  for (const auto& [name, file] : names)
    EXPECT_NE(file_text(folder / "out" / file).find(fmt::format("\n{},0,0,0.01,", number++)), std::string::npos)
        << file;
  EXPECT_FALSE(fs::exists(folder / "up.csv"));
}

// Scenes in a folder are no layouts. The mesh of a layout keeps its file from another folder, and a subtaxel gets the
// first id behind those of the taxels.
TEST_F(ConvertCli, TakesTheLayoutsOfAFolderWithTheirMeshes) {
  fs::create_directory(folder / "in");
  ASSERT_EQ(convert({"probes.json", "in/scene.xml", "--link", "tip", "--mesh", "box.obj"}).status, 0);
  write_text(folder / "in/tip.taxels.json", R"({"format": "taxel-layout", "version": 1, "name": "tip",
"mesh": {"file": "../box.obj"}, "taxels": [{"id": 7, "center": [0, 0, 0.01], "normal": [0, 0, 1], "radius": 0.004,
"subtaxels": [{"center": [0, 0, 0.01], "normal": [0, 0, 1], "radius": 0.002}]}]})");
  const Outcome table = convert({"in", "tip.csv"});
  ASSERT_EQ(table.status, 0) << table.err;
  const std::string text = file_text(folder / "tip.csv");
  EXPECT_NE(text.find("\n7,0,0,0.01,0,0,1,0.004,"), std::string::npos) << text;
  EXPECT_NE(text.find("\n8,0,0,0.01,0,0,1,0.002,7,"), std::string::npos) << text;
  ASSERT_EQ(convert({"in", "tip.taxels.json"}).status, 0);
  EXPECT_EQ(Json::parse(file_text(folder / "tip.taxels.json"))["mesh"]["file"], "box.obj");
}

TEST_F(ConvertCli, FindsASensorByItsNameOrItsLink) {
  write_text(folder / "two.urdf",
             "<robot name=\"r\"><sensor name=\"a\"><parent link=\"b\"/><tactile><taxel idx=\"1\"/></tactile></sensor>"
             "<sensor name=\"b\"><parent link=\"c\"/><tactile><taxel idx=\"2\"/></tactile></sensor></robot>");
  for (const auto& [sensor, id] : {std::pair("a", "\n1,"), {"b", "\n2,"}, {"c", "\n2,"}}) {
    ASSERT_EQ(convert({"two.urdf", "one.csv", "--sensor", sensor}).status, 0);
    EXPECT_NE(file_text(folder / "one.csv").find(id), std::string::npos) << sensor << ": a name before a link";
  }
}

// A mesh is named relative to its layout up to two folders above it, and by its whole path if it is farther away.
TEST_F(ConvertCli, NamesAFarMeshByItsWholePath) {
  const auto mesh_of = [&](const fs::path& below) {
    fs::create_directories(folder / below);
    const std::string out = (below / "tip.taxels.json").string();
    const Outcome outcome = convert({"probes.json", out, "--link", "tip", "--mesh", "box.obj"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Json::parse(file_text(folder / out))["mesh"]["file"].get<std::string>();
  };
  EXPECT_EQ(mesh_of("a"), "../box.obj");
  EXPECT_EQ(mesh_of("a/b"), "../../box.obj");
  EXPECT_EQ(mesh_of("a/b/c"), (folder / "box.obj").string());
  EXPECT_EQ(mesh_of("a/b/c/d"), (folder / "box.obj").string());
}

TEST_F(ConvertCli, KeepsTaxelsOnTheWayThroughEachFormat) {
  ASSERT_EQ(convert({"probes.json", "a.csv", "--link", "tip"}).status, 0);
  for (const std::string word : {"csv", "icub", "genesis", "npz", "urdf", "yaml"}) {
    ASSERT_EQ(convert({"a.csv", "b.x", "--to", word}).status, 0) << word;
    ASSERT_EQ(convert({"b.x", "c.csv", "--from", word, "--radius", "0.004"}).status, 0) << word;
    const auto without_names = [&](const char* file) {
      std::string text = file_text(folder / file);
      for (const char* name : {"row 0 column 0", "row 0 column 1"})
        if (const std::size_t at = text.find(name); at != std::string::npos) text.erase(at, 14);
      return text;
    };
    EXPECT_EQ(without_names("c.csv"), without_names("a.csv")) << word;
    fs::remove(folder / "b.x");
  }
}

TEST_F(ConvertCli, WritesAllFilesOfAFolderOrNone) {
  fs::create_directories(folder / "out" / "pad.taxels.json");
  expect_refusal(convert({"probes.json", "out"}), "taxel: " + (folder / "out/pad.taxels.json").string() +
                                                      ": is a folder, a file is needed; no file was written");
  EXPECT_FALSE(fs::exists(folder / "out" / "tip.taxels.json")) << "the first file is not written either";
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "out"), fs::directory_iterator()), 1);
  expect_refusal(convert({"probes.json", "scenes", "--to", "mjcf"}),
                 "taxel: scenes/tip.xml: tip: has no mesh, which a scene needs: name it with --mesh FILE");
  EXPECT_FALSE(fs::exists(folder / "scenes"));
}

TEST_F(ConvertCli, GivesRadiiOnlyToTaxelsWithoutOne) {
  write_text(
      folder / "a.urdf",
      "<robot><sensor name=\"s\"><tactile><taxel idx=\"0\"><geometry><sphere radius=\"0.006\"/></geometry></taxel>"
      "<taxel idx=\"1\"/></tactile></sensor></robot>");
  ASSERT_EQ(convert({"a.urdf", "a.taxels.json", "--radius", "0.002"}).status, 0);
  const Json layout = Json::parse(file_text(folder / "a.taxels.json"));
  EXPECT_EQ(layout["taxels"][0]["radius"], 0.006) << "a radius that equals the default is from the file";
  EXPECT_EQ(layout["taxels"][1]["radius"], 0.002);
}

TEST_F(ConvertCli, PutsALayoutOnAMesh) {
  const Outcome outcome = convert({"probes.json", "tip.taxels.json", "--link", "tip", "--mesh", "box.obj"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("note: the file holds no material"), std::string::npos) << outcome.out;
  const Json layout = Json::parse(file_text(folder / "tip.taxels.json"));
  EXPECT_EQ(layout["mesh"]["file"], "box.obj") << "relative to the layout";
  EXPECT_EQ(taxel({"check", "tip.taxels.json"}, folder).out.find("error:"), std::string::npos);
  EXPECT_EQ(taxel({"check", "probes.json", "--mesh", "box.obj"}, folder).out.find("error:"), std::string::npos);
}

TEST_F(ConvertCli, WritesASceneThatRunsAndReadsBack) {
  ASSERT_EQ(convert({"probes.json", "tip.xml", "--link", "tip", "--mesh", "box.obj", "--scale", "1"}).status, 0);
  EXPECT_EQ(taxel({"check", "tip.xml"}, folder).status, 0);
  const Outcome run = taxel({"run", "tip.xml", "--seconds", "0.01"}, folder);
  EXPECT_EQ(run.status, 0) << run.err;
  ASSERT_EQ(convert({"tip.xml", "back.taxels.json"}).status, 0);
  ASSERT_EQ(convert({"probes.json", "tip.taxels.json", "--link", "tip", "--mesh", "box.obj", "--scale", "1"}).status,
            0);
  EXPECT_EQ(file_text(folder / "back.taxels.json"), file_text(folder / "tip.taxels.json"));
}

TEST_F(ConvertCli, RefusesLayoutsThatTheFormatCannotHold) {
  expect_refusal(
      convert({"probes.json", "a.csv"}),
      "taxel: probes.json: holds 2 layouts, Table of taxels holds one: choose one with --sensor NAME, or name "
      "a folder; there are \"tip\", \"pad\"");
  EXPECT_FALSE(fs::exists(folder / "a.csv"));
  expect_refusal(convert({"probes.json", "a.csv", "--link", "thumb"}),
                 "taxel: probes.json: has no sensor \"thumb\", but \"tip\", \"pad\"");
  expect_refusal(
      convert({"probes.json", "a.abc"}),
      "taxel: a.abc: is no layout by its name: say its format with --to (taxels, csv, yaml, icub, genesis, npz, "
      "mjcf, mjcf-sites, urdf); a recorded run becomes .jsonl, or .mcap by python -m taxel.mcap");
  expect_refusal(convert({"probes.json", "a.yaml", "--mesh", "box.obj"}),
                 "taxel: convert: --mesh: goes with one layout: choose one of \"tip\", \"pad\" with --sensor");
  expect_refusal(convert({"probes.json", "a.xml", "--link", "tip"}),
                 "taxel: a.xml: tip: has no mesh, which a scene needs: name it with --mesh FILE");
  write_text(folder / "bare.csv", "x,y,z\n0,0,0.01\n");
  expect_refusal(
      convert({"bare.csv", "bare.txt"}),
      "taxel: bare.txt: bare: has no normals, which a file of an iCub needs: name the mesh that gives them with "
      "--mesh FILE");
  EXPECT_EQ(convert({"bare.csv", "bare.txt", "--mesh", "box.obj"}).status, 0);
  write_text(folder / "twice.csv", "id,x,y,z,nx,ny,nz\n3,0,0,1,0,0,1\n3,0,0,2,0,0,1\n");
  expect_refusal(convert({"twice.csv", "twice.txt"}),
                 "taxel: twice.txt: taxel 3: is there twice: a row holds one taxel, give them other ids");
  EXPECT_FALSE(fs::exists(folder / "twice.txt"));
  fs::create_directory(folder / "empty");
  expect_refusal(convert({"empty", "a.csv"}), "taxel: empty: is a folder without layouts");
  expect_refusal(convert({"gone.csv", "a.csv"}), "taxel: gone.csv: no such file");
}

TEST_F(ConvertCli, ListsEachSensorInItsCheck) {
  const Json report = taxel_json({"check", (folder / "probes.json").string()});
  const std::string problems = report["problems"].dump();
  EXPECT_NE(problems.find("positions are in the frame of the link"), std::string::npos) << problems;
  EXPECT_EQ(problems.find("error"), std::string::npos) << problems;
}

}  // namespace
}  // namespace taxel::test
