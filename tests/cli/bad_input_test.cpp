// Bad input gives one clear line and exit status 2, and no file is written.
#include <algorithm>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

Json replace(const std::string& path, const Json& value) {
  return Json::array({{{"op", "replace"}, {"path", path}, {"value", value}}});
}

/// Writes a layout on a mesh of this text.
fs::path layout_on(const fs::path& folder, const std::string& obj) {
  write_text(folder / "m.obj", obj);
  return changed_layout(folder, replace("/mesh/file", "m.obj"));
}

/// Expects `taxel samples` and `taxel sweep` to refuse a layout with the same line.
void expect_layout_refused(const fs::path& layout, const std::string& complaint) {
  expect_refusal(taxel({"samples", layout.string()}), "taxel: " + complaint);
  const fs::path out = layout.parent_path() / "out" / "deep";
  expect_refusal(taxel({"sweep", "--layout", layout.string(), "--out", out.string()}), "taxel: " + complaint);
  EXPECT_FALSE(fs::exists(out.parent_path())) << "something was written";
}

TEST(BadInput, IsRefusedInLayoutValues) {
  const fs::path folder = test_folder();
  const std::string file = (folder / "changed.taxels.json").string();
  const auto refused = [&](const std::string& pointer, const Json& value, const std::string& message) {
    expect_layout_refused(changed_layout(folder, replace(pointer, value)), file + ": " + pointer + ": " + message);
  };
  refused("/taxels/3/radius", -0.006, "must be greater than 0, is -0.006 (taxel 3)");
  refused("/taxels/3/radius", 0, "must be greater than 0, is 0 (taxel 3)");
  refused("/taxels/3/radius", "wide", "must be a number, is \"wide\"");
  refused("/taxels/5/normal", {0, 0, 0}, "must be a direction, is [0, 0, 0] (taxel 5)");
  refused("/taxels/5/center", {0, 0}, "must be an array of 3 numbers, is [0,0]");
  refused("/version", 99, "99 is unknown, this program reads version 1 and older ones");
  refused("/format", "something", "must be \"taxel-layout\", is \"something\"");
  refused("/taxels", 7, "must be an array, is 7");
}

// A message quotes a file, but not all of it, and names the place.
TEST(BadInput, IsRefusedInFewWords) {
  const fs::path folder = test_folder();
  const std::string much(100'000, 'x'), file = (folder / "changed.taxels.json").string();
  const auto refused = [&](const fs::path& path, const std::string& place) {
    for (const char* command : {"check", "samples"}) {
      const Outcome outcome = taxel({command, path.string()});
      EXPECT_NE(outcome.status, 0) << place;
      EXPECT_NE((outcome.out + outcome.err).find(path.string() + ": " + place), std::string::npos) << outcome.err;
      for (const std::string& text : {outcome.out, outcome.err})
        for (std::size_t line = 0; line < text.size(); line = text.find('\n', line) + 1)
          EXPECT_LE(text.find('\n', line) - line, path.string().size() + 950) << text.substr(line, 2000);
    }
  };
  refused(changed_layout(folder, replace("/taxels/3/radius", much)), "/taxels/3/radius: ");
  refused(changed_layout(folder, replace("/version", much)), "/version: ");
  write_text(folder / "wide.csv", "x,y," + much + "\n1,2,3\n");
  refused(folder / "wide.csv", "");
  write_text(folder / "skin.yaml", "MujocoPlugins:\n  - type: " + much + "\n    include_margin: " + much + "\n");
  refused(folder / "skin.yaml", "");
  write_text(folder / "robot.urdf", "<robot><link name=\"" + much + "\"><visual>" + much + "</visual></link></robot>");
  refused(folder / "robot.urdf", "");
  write_text(folder / "raw.json", "\x89PNG\r\n\x1a\n" + much);
  refused(folder / "raw.json", "");
}

TEST(BadInput, IsRefusedInCalibrations) {
  const fs::path folder = test_folder();
  const std::string file = (folder / "changed.taxels.json").string();
  const auto refused = [&](const Json& calibration, const std::string& complaint) {
    const Json patch = Json::array({{{"op", "add"}, {"path", "/calibration"}, {"value", calibration}}});
    expect_layout_refused(changed_layout(folder, patch), file + ": " + complaint);
  };
  refused({{"noise", -1}}, "/calibration/noise: must be 0 or more, is -1");
  refused({{"rate", "fast"}}, "/calibration/rate: must be a number, is \"fast\"");
  refused({{"taxels", {{{"id", 4}, {"gain", 0}}}}}, "/calibration/taxels/0/gain: must not be 0, is 0 (taxel 4)");
}

TEST(BadInput, IsRefusedInMeshes) {
  const fs::path folder = test_folder();
  const std::string mesh = (folder / "m.obj").string();
  expect_layout_refused(layout_on(folder, "v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n"),
                        mesh + ": line 3: coordinate is not finite (nan, 1, 0)");
  expect_layout_refused(layout_on(folder, "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), mesh + ": has no triangles");
  expect_layout_refused(layout_on(folder, ""), mesh + ": is empty");
  expect_layout_refused(changed_layout(folder, replace("/mesh/file", "gone.obj")),
                        (folder / "gone.obj").string() + ": no such file");
}

TEST(BadInput, IsRefusedIfFilesAreMissing) {
  const fs::path folder = test_folder();
  write_text(folder / "broken.taxels.json", "{\n  \"format\": ,\n}");
  const Outcome broken = taxel({"samples", "broken.taxels.json"}, folder);
  EXPECT_EQ(broken.status, 2);
  EXPECT_EQ(broken.err.rfind("taxel: broken.taxels.json: line 2, column 13: is not JSON", 0), 0U) << broken.err;
  expect_refusal(taxel({"samples", "gone.taxels.json"}, folder), "taxel: gone.taxels.json: no such file");
  expect_refusal(taxel({"samples", "."}, folder), "taxel: .: is a folder, not a file");
  expect_refusal(taxel({"contact", "gone.json"}, folder), "taxel: gone.json: no such file");
  expect_refusal(taxel({"mesh", "gone.stl"}, folder), "taxel: gone.stl: no such file");
}

TEST(BadInput, IsRefusedInScenes) {
  const fs::path folder = test_folder();
  write_text(folder / "broken.xml", "<mujoco><worldbody><geom type=\"sphere\"/></worldbody></mujoco>");
  write_text(folder / "plain.xml", "<mujoco><worldbody><geom name=\"ball\" size=\"1\"/></worldbody></mujoco>");
  const Outcome broken = taxel({"run", "broken.xml"}, folder);
  EXPECT_EQ(broken.status, 2);
  EXPECT_EQ(broken.err.rfind("taxel: broken.xml: ", 0), 0U) << broken.err;
  EXPECT_EQ(std::count(broken.err.begin(), broken.err.end(), '\n'), 1) << broken.err;
  expect_refusal(taxel({"run", "gone.xml"}, folder), "taxel: gone.xml: no such file");
  expect_refusal(
      taxel({"run", "plain.xml"}, folder),
      "taxel: plain.xml: declares no taxel.sensor and no taxel.contact; attach a layout with --layout and --geom");
  const Outcome unknown =
      taxel({"run", "plain.xml", "--layout", fingertip_layout().string(), "--geom", "hand"}, folder);
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("\"hand\""), std::string::npos) << unknown.err;
  EXPECT_EQ(std::count(unknown.err.begin(), unknown.err.end(), '\n'), 1) << unknown.err;
  expect_refusal(taxel({"run", "plain.xml", "--geom", "ball"}, folder),
                 "taxel: run: --layout and --geom must be given equally often");
  std::vector<std::string> left;
  for (const auto& entry : fs::directory_iterator(folder)) left.push_back(entry.path().filename().string());
  std::sort(left.begin(), left.end());
  EXPECT_EQ(left, (std::vector<std::string>{"broken.xml", "plain.xml"}));  // no log files and no incomplete output
}

TEST(BadInput, IsRefusedForFoldersThatCannotBeWritten) {
  const fs::path folder = test_folder();
  write_text(folder / "file", "in the way");
  const Outcome sweep = taxel({"sweep", "--out", "file/out"}, folder);
  expect_refusal(sweep, "taxel: file/out: folder cannot be made: Not a directory");
  expect_refusal(taxel({"sweep", "--out", "file"}, folder), "taxel: file: is a file, a folder is needed");
  EXPECT_EQ(file_text(folder / "file"), "in the way");
  const Outcome samples =
      taxel({"samples", fingertip_layout().string(), "--quiet", "--density", "1e5", "--out", "gone/s.csv"}, folder);
  EXPECT_EQ(samples.status, 2);
  EXPECT_EQ(samples.err, "taxel: gone/s.csv: cannot be written: No such file or directory\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
  if (fs::exists("/dev/full")) {
    const Outcome full = run_program(TAXEL_PROGRAM, {"validate"}, folder, "/dev/full");
    EXPECT_EQ(full.status, 2);
    EXPECT_EQ(full.err, "taxel: stdout: cannot be written\n");
  }
}

TEST(BadInput, IsRefusedInContactCases) {
  const fs::path folder = test_folder();
  const auto refused = [&](const Json& patch, const std::string& line) {
    Json good = Json::parse(R"({"format": "contact-case", "version": 1,
      "a": {"shape": {"type": "sphere", "size": [0.05]}, "material": {"modulus": 5e4}}, "b": {"shape": {"type": "plane"}}})");
    write_text(folder / "case.json", good.patch(patch).dump());
    expect_refusal(taxel({"contact", "case.json"}, folder), "taxel: case.json: " + line);
  };
  refused(replace("/a/material/modulus", 0), "a and b are both rigid; one must have a modulus");
  refused(replace("/a/shape", {{"type", "plane"}}), "/a: a soft plane needs a thickness > 0");
  refused(Json::array({{{"op", "replace"}, {"path", "/a/shape"}, {"value", {{"type", "plane"}}}},
                       {{"op", "add"}, {"path", "/a/material/thickness"}, {"value", 0.01}}}),
          "a and b are both planes: their contact is unbounded");
  refused(replace("/b", {{"pos", {0, 0, 0}}}), "/b: needs a shape or a layout");
  refused(replace("/a/shape/size/0", 0), "/a/shape/size/0: must be greater than 0, is 0");
  refused(replace("/version", 2), "/version: 2 is unknown, this program reads version 1");
  write_text(folder / "case.json",
             R"({"format": "contact-case", "version": 1, "a": {"layout": "gone.taxels.json"}, "b": {}})");
  expect_refusal(taxel({"contact", "case.json"}, folder), "taxel: gone.taxels.json: no such file");
}

TEST(BadInput, IsRefusedOnTheCommandLine) {
  const auto refused = [](const std::vector<std::string>& arguments, const std::string& line) {
    expect_refusal(taxel(arguments), "taxel: " + line);
  };
  refused({}, "a command is required; `taxel --help` lists them");
  refused({"dance"}, "unknown command dance");
  refused({"swep"}, "unknown command swep; did you mean \"sweep\"?");
  refused({"--versoin"}, "unknown argument --versoin; did you mean \"--version\"?");
  refused({"sweep", "--dept", "1"}, "sweep: unknown argument --dept; did you mean \"--depth\"?");
  refused({"sweep", "--dept=1"}, "sweep: unknown argument --dept=1; did you mean \"--depth\"?");
  refused({"sweep", "--dance"}, "sweep: unknown argument --dance");
  refused({"sweep", "--depth", "-0.001"}, "sweep: --depth: must be greater than 0, is -0.001");
  refused({"sweep", "--depth", "nan"}, "sweep: --depth: must be greater than 0, is nan");
  refused({"sweep", "--object", "box", "--before", "0", "--past", "0"},
          "/past: before and past together must be greater than 0");
  refused({"sweep", "--timestep", "1e-8"},
          "the scenario would take 5e+08 steps, at most 1e+08 are made: is the time step too small?");
  refused({"sweep", "--object", "box", "--edge-radius", "0.001"}, "--edge-radius: is used by the object \"edge\" only");
  refused({"sweep", "--edge-radius", "0.03"}, "/edge_radius: must be less than half of box_size, 0.025, is 0.03");
  refused({"sweep", "--object", "gone.obj"}, "gone.obj: no such file");
  refused({"sweep", "--as-in-the-paper", "--depth", "0.001"}, "--depth: is not used by the kind \"paper\"");
  refused({"sweep", "--as-in-the-paper", "--object", "box"}, "sweep: --object excludes --as-in-the-paper");
  refused({"sweep", "--density", "0"}, "sweep: --density: must be greater than 0, is 0");
  const std::string words = R"("weighted_mean", "weighted_sum", "mean", "nearest", "max", "force")";
  for (const char* command : {"sweep", "run", "read"})
    refused({command, "--aggregate", "median"},
            std::string(command) + ": --aggregate: must be one of " + words + ", is median");
  refused({"samples"}, "samples: LAYOUT is required");
  refused({"sweep", "--depth"}, "sweep: --depth needs a value");
  refused({"sweep", "--depth", "--json"}, "sweep: --depth needs a value");
  refused({"sweep", "--depth", "0.001", "--depth", "0.002"}, "sweep: --depth must be given once, is given 2 times");
  refused({"sweep", "--json=perhaps"}, "sweep: --json takes no value, is given perhaps");
  refused({"sweep", "--threads", "two"}, "sweep: --threads: must be a whole number from 1 to 4096, is two");
  refused({"samples", "x.taxels.json", "--mcap", "x"}, "samples: unknown argument --mcap");
  refused({"play", "x.json", "--tactile-state"}, "play: --tactile-state requires --out");
  refused({"play", "x.json", "--out", "o", "--mcap"}, "play: unknown argument --mcap");
  refused({"mesh", "x.obj", "--decimate", "few"},
          "mesh: --decimate: must be a whole number of at most 31 bits, is few");
  refused({"material", "--youngs", "1e6Pa"}, "material: --youngs: must be a finite number, is 1e6Pa");
  refused({"plot", "x", "--over", "depth"}, "plot: --over: must be one of travel, time, is depth");
  refused({"--completion", "tcsh"}, "--completion: must be one of bash, fish, zsh, is tcsh");
  refused({"contact", "x.json", "--repeat", "0"}, "contact: --repeat: must be a whole number from 1 to 1000000, is 0");
}

}  // namespace
}  // namespace taxel::test
