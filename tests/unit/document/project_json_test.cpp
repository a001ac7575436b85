// Project files: reading returns the written values, every wrong field is named, and paths have the same meaning in
// every folder.
#include "core/document/project.h"

#include <gtest/gtest.h>

#include <iterator>
#include <limits>

#include "core/base/files.h"
#include "core/base/rng.h"
#include "core/document/scenario/scenario.h"
#include "core/layout/file/layout_json.h"
#include "fixtures/complaint.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

using test::complaint_of;
using test::TempFolder;

Project full_project() {
  Project project;
  Layout& layout = project.layout;
  layout.name = "tip \"A\" \xC3\xA9";
  layout.mesh = {"m.obj", dvec3(0.001, -1, 1.0 / 3.0), "abc"};
  layout.sampling.seed = 0xffffffffffffffffULL;
  layout.taxels = {{7, "left 1", dvec3(1e-9, -0.0, 0.1 + 0.2), dvec3(0, 1, 0), 0.006, {}},
                   {2, "", dvec3(0.1), dvec3(1e20, 0, 0), 5e-324, {{dvec3(1, 2, 3), dvec3(0, 0, 1), 0.5}, {}}}};
  layout.unknown = {{"/taxels/0/note", "{\"a\":[1,2.5]}"}, {"/made", "null"}};
  Scenario& scenario = project.scenario = with_object({}, "object.obj");
  double value = 1;
  for (const ScenarioNumber& number : numbers_of(scenario)) *number.value = value++;
  scenario.as<scenarios::Sweep>().depth = 0.1 + 0.2;
  scenario.as<scenarios::Sweep>().tilt_deg = -30;
  project.view = View{dvec3(1, 2, 1.0 / 3.0), -200, 89.5, 1e-3, 35};
  project.mirrors = {{{dvec3(0, 0.1, 0), {0, 2, 0.3}}, {{7, 2}}}, {{}, {{2, 7}}}};
  project.hidden = {2, 7};
  project.layout.sampling.region = std::vector{0, 1, 2, 9, 20, 21};
  return project;
}

TEST(ProjectJson, KeepsEveryValue) {
  const std::string text = project_to_json(full_project());
  EXPECT_EQ(parse_project(text), full_project());
  EXPECT_EQ(project_to_json(parse_project(text)), text);
  EXPECT_EQ(parse_project(project_to_json({})), Project{});
  EXPECT_NE(text.find("\"region\": [\n        [0, 2],\n        [9, 9],\n        [20, 21]"), std::string::npos) << text;
}

TEST(ProjectJson, ContainsTheLayoutAsInALayoutFile) {
  const std::string text = project_to_json(full_project());
  std::string layout = layout_to_json(full_project().layout), indented = "  \"layout\": ";
  layout.pop_back();
  for (const char c : layout) indented += c == '\n' ? std::string("\n  ") : std::string(1, c);
  EXPECT_NE(text.find(indented + ",\n"), std::string::npos);
}

TEST(ProjectJson, NeedsOnlyALayout) {
  const Project project = parse_project(R"({"format": "taxel-project", "version": 1, "layout":
      {"format": "taxel-layout", "version": 1, "mesh": {"file": "a"}, "taxels": []}})");
  EXPECT_EQ(project.layout.mesh.file, "a");
  EXPECT_EQ(project.scenario, with_shape({}, ObjectShape::box)) << "what such files always meant";
  EXPECT_FALSE(project.view);
}

TEST(ProjectJson, RefusesPathsThatAreNotUtf8) {
  const test::TempFolder folder;
  Project project = full_project();
  project.layout.mesh.file =
      "na\xef"
      "ve.obj";
  const auto said = test::complaint_of([&] { write_project(folder / "p.taxelproj", project); });
  EXPECT_EQ(said, (folder / "p.taxelproj").string() +
                      ": /layout/mesh/file: the path is not UTF-8, which a JSON file cannot hold: rename the folder or "
                      "file");
  EXPECT_FALSE(std::filesystem::exists(folder / "p.taxelproj"));
  Scenario scenario;
  scenario.shape = ObjectShape::box;
  scenario.object =
      "na\xef"
      "ve.obj";
  EXPECT_EQ(test::complaint_of([&] { check_scenario(scenario); }).rfind("/object: the path is not UTF-8", 0), 0U);
  EXPECT_FALSE(scenario_to_json(scenario).empty());
}

struct Broken {
  const char* what;
  const char* with;
  const char* complaint;
};

/// In each line: a part of the full project's text, its replacement, and the resulting error message.
const Broken kBroken[] = {
    {"\"taxel-project\"", "\"taxel-layout\"", "/format: must be \"taxel-project\", is \"taxel-layout\""},
    {"\"taxel-project\"", "7", "/format: must be a text, is 7"},
    {"\"version\": 1,\n  \"layout\"", "\"version\": 2,\n  \"layout\"",
     "/version: 2 is unknown, this program reads version 1"},
    {"\"hidden\"", "\"hiden\"", "/hiden: unknown key; did you mean \"hidden\"?"},
    {"\"format\": \"taxel-layout\"", "\"format\": 1", "/layout/format: must be a text, is 1"},
    {"\"radius\": 0.006", "\"radius\": \"6 mm\"", "/layout/taxels/0/radius: must be a number, is \"6 mm\""},
    {"\"id\": 7", "\"id\": 2", "/layout/taxels/1/id: 2 is also the id of another taxel"},
    {"\"id\": 7", "\"id\": -7", "/layout/taxels/0/id: must be 0 or more, is -7"},
    {"\"speed\": 2.0", "\"speed\": -2", "/scenario/speed: must be greater than 0, is -2"},
    {"\"speed\": 2.0", "\"spead\": -2", "/scenario/spead: unknown key; did you mean \"speed\"?"},
    {"\"speed\": 2.0", "\"scenario\": {}", "/scenario/scenario: unknown key"},
    {"\"azimuth_deg\": -200", "\"azimuth_deg\": null", "/view/azimuth_deg: must be a number, is null"},
    {"\"elevation_deg\": 89.5", "\"elevation_deg\": 90.5", "/view/elevation_deg: must be between -90 and 90, is 90.5"},
    {"\"distance\": 0.001", "\"distance\": 0", "/view/distance: must be greater than 0, is 0"},
    {"\"distance\": 0.001", "\"distance\": 1e308", "/view/distance: must be between -1000000 and 1000000, is 1e+308"},
    {"\"distance\": 0.001", "\"distance\": 1e-308", "/view/distance: must be at least 1e-06, is 1e-308"},
    {"\"azimuth_deg\": -200", "\"azimuth_deg\": 1e308",
     "/view/azimuth_deg: must be between -36000000 and 36000000, is 1e+308"},
    {"\"target\": [1, 2,", "\"target\": [1, 1e308,", "/view/target/1: must be between -1000000 and 1000000, is 1e+308"},
    {"\"fov_deg\": 35", "\"fov_deg\": 180", "/view/fov_deg: must be between 0 and 180, is 180"},
    {"\"fov_deg\": 35", "\"fow_deg\": 35", "/view/fow_deg: unknown key; did you mean \"fov_deg\"?"},
    {"\"target\": [1, 2,", "\"target\": [2,", "/view/target: must be an array of 3 numbers, is [2,0.3333333333333333]"},
    {"\"normal\": [0, 2, 0.3]", "\"normal\": [0, 0, 0]", "/mirrors/0/plane/normal: must be a direction"},
    {"\"point\": [0, 0.1, 0]", "\"point\": [0, 0.1]",
     "/mirrors/0/plane/point: must be an array of 3 numbers, is [0,0.1]"},
    {"[7, 2]", "[7]", "/mirrors/0/links/0: must be an array of 2 ids, is [7]"},
    {"[7, 2]", "[7, 1.5]", "/mirrors/0/links/0/1: must be a whole number from 0, of at most 31 bits, is 1.5"},
    {"[7, 2]", "[7, 3]", "/mirrors/0/links/0: there is no taxel 3"},
    {"[7, 2]", "[7, 7]", "/mirrors/0/links/0: taxel 7 is linked twice across one plane"},
    {"\"hidden\": [2, 7]", "\"hidden\": {}", "/hidden: must be an array, is {}"},
    {"\"hidden\": [2, 7]", "\"hidden\": [2, \"7\"]", "/hidden/1: must be a number, is \"7\""},
    {"\"hidden\": [2, 7]", "\"hidden\": [7, 2]", "/hidden/1: must ascend from 0 or more"},
    {"\"hidden\": [2, 7]", "\"hidden\": [2, 8]", "/hidden/1: there is no taxel 8"},
    {"\"mirrors\"", "\"hidden\"", "has the key \"hidden\" twice in one object"},
};

TEST(ProjectJson, NamesTheWrongField) {
  const std::string text = project_to_json(full_project());
  for (const Broken& broken : kBroken) {
    const std::size_t at = text.find(broken.what);
    ASSERT_NE(at, std::string::npos) << broken.what;
    std::string wrong = text;
    wrong.replace(at, std::string(broken.what).size(), broken.with);
    EXPECT_EQ(complaint_of([&] { parse_project(wrong, "p.taxelproj"); }),
              std::string("p.taxelproj: ") + broken.complaint);
  }
  EXPECT_EQ(complaint_of([&] { parse_project("[]", "p"); }), "p: must be an object, is []");
  EXPECT_EQ(complaint_of([&] { parse_project("{\"format\": \"taxel-project\", \"version\": 1}", "p"); }),
            "p: /layout: is missing");
  const std::string half = text.substr(0, text.size() / 2);
  EXPECT_NE(complaint_of([&] { parse_project(half, "p"); }).find("is not JSON"), std::string::npos);
}

TEST(ProjectJson, RefusesEveryShortenedFile) {
  const std::string text = project_to_json(full_project());
  for (std::size_t size = 0; size + 2 < text.size(); ++size)
    ASSERT_NE(complaint_of([&] { parse_project(text.substr(0, size), "p"); }), "accepted") << size;
}

/// Changed, doubled and removed bytes and exchanged values must give an Error or a project.
TEST(ProjectJson, SurvivesAnyDamage) {
  const std::string text = project_to_json(full_project());
  const std::string values[] = {"null", "{}", "[]", "-1", "1e300", "\"\"", "[[[]]]", "true", "9999999999999999999"};
  const CounterRng rng(12);
  int refused = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    std::string wrong = text;
    const std::size_t at = rng.bits(4 * i) % wrong.size(), count = rng.bits(4 * i + 1) % 20;
    const std::string& value = values[rng.bits(4 * i + 2) % std::size(values)];
    const std::size_t colon = wrong.find(": ", at), end = wrong.find_first_of(",\n", colon);
    switch (rng.bits(4 * i + 3) % 4) {
      case 0:
        wrong[at] = static_cast<char>(rng.bits(4 * i + 2));
        break;
      case 1:
        wrong.erase(at, count);
        break;
      case 2:
        wrong.insert(at, wrong.substr(at, count));
        break;
      default:
        if (end != std::string::npos) wrong.replace(colon + 2, end - colon - 2, value);
    }
    refused += complaint_of([&] { project_to_json(parse_project(wrong, "p")); }) != "accepted";
  }
  EXPECT_GT(refused, 2000);
}

TEST(ProjectJson, NamesUnwritableValuesAndKeepsTheOldFile) {
  const TempFolder folder;
  const auto path = folder.write("a.taxelproj", "old");
  Project project = full_project();
  project.layout.taxels[1].center.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaint_of([&] { write_project(path, project); }),
            path.string() + ": /layout/taxels/1/center/1: must be finite to be written, is nan");
  project = full_project();
  project.view->distance = std::numeric_limits<double>::infinity();
  EXPECT_EQ(complaint_of([&] { write_project(path, project); }),
            path.string() + ": /view/distance: must be finite to be written, is inf");
  project = full_project();
  project.scenario.as<scenarios::Sweep>().depth = std::numeric_limits<double>::infinity();
  EXPECT_EQ(complaint_of([&] { write_project(path, project); }),
            path.string() + ": /scenario/depth: must be finite, is inf");
  EXPECT_EQ(read_file(path), "old");
  EXPECT_NE(complaint_of([&] { read_project(folder / "none.taxelproj"); }).find("no such file"), std::string::npos);
}

TEST(ProjectJson, KeepsTheMeaningOfPathsInAnyFolder) {
  const TempFolder folder;
  make_folder(folder / "a/b");
  Project project = full_project();
  project.layout.mesh.file = (folder / "meshes/m.obj").string();
  project.scenario = with_object({}, (folder / "a/b/o.stl").string());
  write_project(folder / "a/p.taxelproj", project);
  write_project(folder / "a/b/p.taxelproj", project);
  EXPECT_EQ(read_project(folder / "a/p.taxelproj"), project);
  EXPECT_EQ(read_project(folder / "a/b/p.taxelproj"), project);
  const Project written = parse_project(read_file(folder / "a/b/p.taxelproj"));
  EXPECT_EQ(written.layout.mesh.file, "../../meshes/m.obj");
  EXPECT_EQ(written.scenario.object, "o.stl");

  export_layout(folder / "a/l.taxels.json", project);
  const Layout layout = read_layout(folder / "a/l.taxels.json");
  EXPECT_EQ(layout.mesh.file, "../meshes/m.obj");
  const ProjectOfLayout opened = read_layout_as_project(folder / "a/l.taxels.json");
  EXPECT_EQ(opened.project.layout, project.layout);
  EXPECT_TRUE(opened.notes.empty());
  export_layout(folder / "a/again.taxels.json", opened.project);
  EXPECT_EQ(read_file(folder / "a/again.taxels.json"), read_file(folder / "a/l.taxels.json"));
}

TEST(ProjectJson, ExportsTheLayoutWithoutOtherKeys) {
  const TempFolder folder;
  Project bare;
  bare.layout = full_project().layout;
  export_layout(folder / "full.taxels.json", full_project());
  export_layout(folder / "bare.taxels.json", bare);
  EXPECT_EQ(read_file(folder / "full.taxels.json"), read_file(folder / "bare.taxels.json"));
  EXPECT_EQ(read_file(folder / "full.taxels.json"), layout_to_json(full_project().layout));
}

TEST(ProjectJson, KeepsDeepUnknownKeysInARoundTrip) {
  Project project = full_project();
  const std::size_t levels = 63;  // below the layout's own object: the maximum of a layout file
  project.layout.unknown = {{"/deep", std::string(levels, '[') + std::string(levels, ']')}};
  EXPECT_EQ(parse_layout(layout_to_json(project.layout)), project.layout);
  EXPECT_EQ(parse_project(project_to_json(project)), project);
}

}  // namespace
}  // namespace taxel
