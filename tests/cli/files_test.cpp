// `taxel samples`, `taxel mesh` and `taxel check` on files, and the help texts.
#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "cli/taxel_program.h"
#include "core/base/files.h"
#include "core/mesh/mesh_io.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

TEST(Help, ShowsUnitsAndAnExampleForEveryCommand) {
  for (const char* command : {"sweep", "run", "contact", "read", "samples", "mesh", "check", "validate"}) {
    const Outcome outcome = taxel({command, "--help"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.out.find("\nExample: taxel " + std::string(command)), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("\nUsage: taxel " + std::string(command) + " "), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.err, "");
  }
  const std::string sweep = taxel({"sweep", "--help"}).out;
  EXPECT_TRUE(std::regex_search(sweep, std::regex(R"(--depth M=0\.0015 .*\[m\])"))) << sweep;
  EXPECT_EQ(taxel({"--help"}).status, 0);
}

TEST(Help, NamesCommitAndMuJoCoInTheVersion) {
  const Outcome outcome = taxel({"--version"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_TRUE(std::regex_match(
      outcome.out,
      std::regex(R"(taxel \d+\.\d+\.\d+, commit ([0-9a-f]{12}(-dirty)?|unknown), MuJoCo \d+\.\d+\.\d+\n)")))
      << outcome.out;
}

/// Expects every sample on the face that its row names, a face of the file's outer shells.
void expect_on_faces(const Table& f, const TriMesh& mesh) {
  const std::vector<int> outer = outer_shells(mesh);
  double off = 0, tilted = 0;
  for (std::size_t i = 0; i < f.at("x").size(); ++i) {
    const int face = static_cast<int>(f.at("face")[i]);
    ASSERT_LT(face, mesh.face_count());
    const auto at = static_cast<std::size_t>(face);
    ASSERT_NE(std::find(outer.begin(), outer.end(), mesh.shell_of_face()[at]), outer.end()) << "face " << face;
    const dvec3 p(f.at("x")[i], f.at("y")[i], f.at("z")[i]), n(f.at("nx")[i], f.at("ny")[i], f.at("nz")[i]);
    off = std::max(off, std::abs(glm::dot(p - mesh.vertex(face, 0), mesh.face_normals()[at])));
    tilted = std::max(tilted, glm::distance(n, mesh.face_normals()[at]));
  }
  EXPECT_LT(off, 1e-12 * mesh.bounds().diagonal());
  EXPECT_LT(tilted, 1e-12);
}

/// Expects the rows of both files to agree with each other and with the summary.
void expect_consistent(const fs::path& layout, const fs::path& folder, double radius) {
  const Json summary =
      taxel_json({"samples", layout.string(), "--out", "f.csv", "--fields", "g.csv", "--quiet"}, folder);
  const Table f = read_csv(folder / "f.csv"), g = read_csv(folder / "g.csv");
  const std::size_t count = f.at("x").size();
  EXPECT_EQ(summary["samples"].get<std::size_t>(), count);
  const double wanted = summary["density"].get<double>() * summary["area"].get<double>();
  EXPECT_EQ(static_cast<double>(count), std::round(wanted));
  double area = 0;
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(f.at("id")[i], static_cast<double>(i));
    EXPECT_NEAR(std::hypot(f.at("nx")[i], f.at("ny")[i], f.at("nz")[i]), 1, 1e-12);
    area += f.at("area")[i];
  }
  EXPECT_NEAR(area, summary["area"].get<double>(), 1e-9 * area);
  std::set<std::size_t> used;
  for (std::size_t i = 0; i < g.at("sample").size(); ++i) {
    used.insert(static_cast<std::size_t>(g.at("sample")[i]));
    const double d = g.at("distance")[i];
    EXPECT_LE(d, radius);
    EXPECT_NEAR(g.at("weight")[i], (radius - d) * (radius - d), 1e-15);
  }
  for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(f.at("used")[i] == 1, used.contains(i)) << "sample " << i;
  EXPECT_EQ(summary["used"].get<std::size_t>(), used.size());
}

TEST(Samples, AgreeInBothTablesAndTheSummary) {
  const fs::path folder = test_folder();
  expect_consistent(fingertip_layout(), folder, 0.006);
  expect_on_faces(read_csv(folder / "f.csv"),
                  *load_mesh(fs::path(TAXEL_SOURCE_DIR) / "assets/meshes/fingertip.obj").mesh);
}

/// The file has a triangle without area and a cavity before the skin. Neither is sensed, and both are counted.
TEST(Samples, NumberFacesInTheOrderOfTheFile) {
  const fs::path folder = test_folder();
  const double half = 0.01;
  write_text(folder / "hollow.obj", box_obj(0.004, 1, false) + "f 1 1 2\n" + box_obj(half, 9, true));
  Json layout = Json::parse(file_text(fingertip_layout()));
  Json taxel = layout["taxels"][0];
  taxel["center"] = {0, 0, half};
  taxel["normal"] = {0, 0, 1};
  layout["mesh"] = {{"file", "hollow.obj"}};
  layout["taxels"] = Json::array({taxel});
  write_text(folder / "hollow.taxels.json", layout.dump());
  const Json summary = taxel_json({"samples", "hollow.taxels.json", "--quiet", "--out", "f.csv"}, folder);
  EXPECT_NEAR(summary["area"].get<double>(), 24 * half * half, 1e-12) << "the skin alone";
  const Table f = read_csv(folder / "f.csv");
  std::set<int> faces;
  for (std::size_t i = 0; i < f.at("x").size(); ++i) {
    // Each side has two triangles, in the order of box_obj: -z, +z, -y, +y, -x, +x.
    const int face = static_cast<int>(f.at("face")[i]), side = (face - 13) / 2;
    ASSERT_GE(face, 13) << "12 of the cavity and one without area come first";
    ASSERT_LT(face, 25);
    faces.insert(face);
    const char* normal = side < 2 ? "nz" : side < 4 ? "ny" : "nx";
    const char* position = side < 2 ? "z" : side < 4 ? "y" : "x";
    const double sign = side % 2 == 0 ? -1 : 1;
    EXPECT_NEAR(f.at(normal)[i], sign, 1e-12) << "face " << face;
    EXPECT_NEAR(f.at(position)[i], sign * half, 1e-12) << "face " << face;
  }
  EXPECT_EQ(faces.size(), 12U);
}

TEST(Samples, AvoidTheCavityOfTheRealMesh) {
  SKIP_WITHOUT_REAL_DATA();
  const fs::path folder = test_folder();
  expect_consistent(real_layout(), folder, 0.006);
  const fs::path file = real_layout().parent_path() / "meshes" / "shadow_f_distal_pst.stl";
  expect_on_faces(read_csv(folder / "f.csv"), *load_mesh(file, dvec3(0.001)).mesh);
  const Json mesh = taxel_json({"mesh", file.string(), "--scale", "0.001"});
  EXPECT_EQ(mesh["triangles"], 5374);
  EXPECT_EQ(mesh["shells"], 2);
  EXPECT_EQ(mesh["enclosed_shells"], 1);
  EXPECT_EQ(mesh["closed"], true);
}

TEST(Samples, DependOnTheSeedAndNotOnThreads) {
  const fs::path folder = test_folder();
  const auto text = [&](std::vector<std::string> options) {
    std::vector<std::string> arguments{"samples", fingertip_layout().string(), "--density", "3e6", "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = taxel(arguments, folder);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  };
  const std::string one = text({"--threads", "1"});
  EXPECT_EQ(one.substr(0, one.find('\n')), "x,y,z,nx,ny,nz,face,area,id,used");
  for (const char* threads : {"2", "8"}) EXPECT_TRUE(one == text({"--threads", threads})) << threads;
  EXPECT_FALSE(one == text({"--seed", "43"}));
}

TEST(Mesh, ReportsAndRepairs) {
  const fs::path folder = test_folder();
  // A tetrahedron with a duplicate vertex and a face without area.
  write_text(folder / "t.obj",
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 5\nf 1 4 3\nf 4 5 1\n");
  const Json mesh = taxel_json({"mesh", "t.obj", "--scale", "2", "--out", "fixed.obj"}, folder);
  EXPECT_EQ(mesh["vertices"], 4);
  EXPECT_EQ(mesh["triangles"], 4);
  EXPECT_EQ(mesh["closed"], true);
  EXPECT_NEAR(mesh["volume"].get<double>(), 8.0 / 6.0, 1e-15);
  EXPECT_EQ(mesh["notes"].size(), 2U);
  const Json fixed = taxel_json({"mesh", "fixed.obj"}, folder);
  EXPECT_EQ(fixed["notes"], Json::array());
  EXPECT_EQ(fixed["volume"], mesh["volume"]);
  const Json mirrored = taxel_json({"mesh", "--scale", "1,1,-3", "t.obj"}, folder);
  EXPECT_NEAR(mirrored["volume"].get<double>(), 0.5, 1e-15);  // the winding follows the mirror
  expect_refusal(taxel({"mesh", "t.obj", "--scale", "1,2"}, folder),
                 "taxel: mesh: --scale: must be one number or three, is 1,2");
}

TEST(Check, ListsEveryProblemWithItsPointer) {
  const fs::path folder = test_folder();
  const fs::path layout = changed_layout(folder, Json::parse(R"([
    {"op": "replace", "path": "/taxels/3/radius", "value": -0.006},
    {"op": "replace", "path": "/taxels/5/normal", "value": [0, 0, 0]}])"));
  const Outcome outcome = taxel({"check", layout.string(), "--json"}, folder);
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  std::map<std::string, Json> problems;
  const Json report = Json::parse(outcome.out);
  for (const Json& problem : report["problems"]) {
    EXPECT_EQ(problem["file"], layout.string());
    if (problem["severity"] == "error") problems[problem["pointer"]] = problem;
  }
  ASSERT_EQ(problems.size(), 2U) << outcome.out;
  EXPECT_EQ(problems["/taxels/3/radius"]["message"], "must be greater than 0, is -0.006 (taxel 3)");
  EXPECT_EQ(problems["/taxels/3/radius"].size(), 6U);  // file, pointer, severity, code, message, fix
  EXPECT_EQ(problems.count("/taxels/5/normal"), 1U);
  const Outcome text = taxel({"check", layout.string()}, folder);
  EXPECT_EQ(text.status, 1);
  EXPECT_NE(text.out.find(layout.string() + ": /taxels/3/radius: error: must be greater than 0, is -0.006 (taxel 3)"),
            std::string::npos)
      << text.out;
}

TEST(Check, FindsOurFingertipCleanAndNoErrorInTheRealOne) {
  const Outcome ours = taxel({"check", fingertip_layout().string()});
  EXPECT_EQ(ours.status, 0) << ours.out;
  SKIP_WITHOUT_REAL_DATA();
  const Outcome real = taxel({"check", real_layout().string(), "--json"});
  const Json problems = Json::parse(real.out)["problems"];
  bool cavity = false, any_warning = false;
  for (const Json& problem : problems) {
    EXPECT_NE(problem["severity"], "error") << problem;
    any_warning = any_warning || problem["severity"] == "warning";
    cavity = cavity || problem["message"].get<std::string>().find("320 of 5374 faces") != std::string::npos;
  }
  EXPECT_TRUE(cavity) << real.out;
  EXPECT_EQ(real.status, any_warning ? 1 : 0);
}

TEST(Check, ContinuesAfterAFileThatCannotBeRead) {
  const fs::path folder = test_folder();
  const fs::path layout =
      changed_layout(folder, Json::parse(R"([{"op": "replace", "path": "/mesh/file", "value": "gone.obj"}])"));
  const Outcome outcome = taxel({"check", "nowhere.taxels.json", layout.string(), "--json"}, folder);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "taxel: nowhere.taxels.json: no such file\n");
  const Json problems = Json::parse(outcome.out)["problems"];
  ASSERT_EQ(problems.size(), 2U) << problems;
  EXPECT_EQ(problems[1]["pointer"], "/mesh/file");
  EXPECT_EQ(taxel({"check", layout.string()}, folder).status, 1);
}

TEST(Check, AcceptsCasesSweepsMeshesAndScenes) {
  const fs::path folder = test_folder();
  write_text(
      folder / "case.json",
      R"({"format": "contact-case", "version": 1, "a": {"shape": {"type": "sphere", "size": [1]}}, "b": {"shape": {"type": "plane"}}})");
  write_text(folder / "open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write_text(folder / "scene.xml", "<mujoco><worldbody><geom size=\"1\"/></worldbody></mujoco>");
  write_text(folder / "bad.xml", "<mujoco><nonsense/></mujoco>");
  const auto code = [&](const char* file) {
    return Json::parse(taxel({"check", file, "--json"}, folder).out)["problems"].at(0)["code"];
  };
  EXPECT_EQ(code("case.json"), "both_rigid");
  EXPECT_EQ(code("open.obj"), "mesh_open");
  EXPECT_EQ(taxel({"check", "scene.xml"}, folder).status, 0);
  EXPECT_EQ(taxel({"check", "bad.xml"}, folder).status, 2);
  write_text(folder / "run.json", R"({"format": "taxel-run", "version": 1})");
  const Outcome run = taxel({"check", "run.json"}, folder);
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err,
            "taxel: run.json: /format: is \"taxel-run\"; must be taxel-layout, taxel-project, taxel-scenario, "
            "taxel-study, contact-case, taxel-sweep or taxel-play\n");
  EXPECT_EQ(taxel({"check", (shared_box_sweep({"--density", "1e6"}) / "sweep.json").string()}, folder).status, 0);
  EXPECT_EQ(taxel({"check", (shared_box_sweep({"--density", "1e6"}) / "scene.xml").string()}, folder).status, 0);
}

TEST(Check, RefusesScenariosThatPlayRefuses) {
  const fs::path folder = test_folder();
  const auto refused = [&](const std::string& scenario, const std::string& message) {
    write_text(folder / "s.json", R"({"format": "taxel-scenario", "version": 1, "scenario": )" + scenario + "}");
    const Outcome check = taxel({"check", "s.json"}, folder), play = taxel({"play", "s.json"}, folder);
    EXPECT_EQ(check.status, 2);
    EXPECT_EQ(play.status, 2);
    EXPECT_NE(check.err.find(message), std::string::npos) << check.err;
    EXPECT_NE(play.err.find(message), std::string::npos) << play.err;
  };
  refused(R"({"object": "gone.obj"})", "gone.obj: no such file");
  refused(R"({"kind": "replay", "source": "gone.npz"})", "gone.npz: no such file");
  refused(R"({"timestep": 1e-9})", "is the time step too small?");
  write_text(folder / "study.json", R"({"format": "taxel-study", "version": 1, "scenario": {"object": "gone.obj"},
      "parameters": [{"parameter": "depth", "values": [0.001, 0.002]}]})");
  EXPECT_NE(taxel({"check", "study.json"}, folder).err.find("gone.obj: no such file"), std::string::npos);
  write_text(folder / "part.json", R"({"format": "taxel-study", "version": 1, "scenario": {},
      "parameters": [{"parameter": "timestep", "values": [0.001, 1e-9]}]})");
  const Outcome part = taxel({"check", "part.json"}, folder);
  EXPECT_EQ(part.status, 1);
  EXPECT_NE(part.out.find("warning: run 2 of 2 cannot be made"), std::string::npos) << part.out;
}

TEST(Check, ReportsUnknownKeys) {
  const fs::path folder = test_folder();
  const fs::path layout = changed_layout(folder, Json::parse(R"([
      {"op": "add", "path": "/taxels/3/centre", "value": [0, 0, 0]},
      {"op": "add", "path": "/sampling/colour_of_the_skin", "value": 7}])"));
  const Outcome text = taxel({"check", layout.string()});
  EXPECT_EQ(text.status, 1);
  const std::string unknown = "is an unknown key: it is kept and has no effect";
  const std::string meant = "/taxels/3/centre: warning: " + unknown + " (taxel 3); did you mean \"center\"?";
  EXPECT_NE(text.out.find(meant), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("/sampling/colour_of_the_skin: note: " + unknown + "\n"), std::string::npos) << text.out;
}

TEST(Check, NotesTheChangesOfAnEarlierVersion) {
  const fs::path folder = test_folder();
  const fs::path layout = changed_layout(folder, Json::parse(R"([
      {"op": "replace", "path": "/version", "value": 0},
      {"op": "move", "from": "/sampling/density", "path": "/density"},
      {"op": "move", "from": "/taxels/3/center", "path": "/taxels/3/position"}])"));
  const Outcome checked = taxel({"check", layout.string()});
  EXPECT_EQ(checked.status, 0) << checked.out;
  for (const char* note : {"note: is of version 0: it is read as version 1", R"("density" is "sampling/density")",
                           R"("position" and "direction" of 1 taxels are "center" and "normal")"})
    EXPECT_NE(checked.out.find(note), std::string::npos) << note << "\n" << checked.out;
  const Outcome converted = taxel({"convert", layout.string(), "new.taxels.json"}, folder);
  EXPECT_EQ(converted.status, 0) << converted.err;
  const Json written = Json::parse(read_file(folder / "new.taxels.json"));
  EXPECT_EQ(written["version"], 1);
  EXPECT_EQ(written, Json::parse(read_file(changed_layout(folder, Json::array()))));
}

TEST(Check, ListsTheProblemsOfAProject) {
  const fs::path folder = test_folder();
  const fs::path layout = changed_layout(folder, Json::parse(R"([
    {"op": "replace", "path": "/taxels/3/radius", "value": -0.006}])"));
  Json project = {{"format", "taxel-project"}, {"version", 1}, {"layout", Json::parse(read_file(layout))}};
  const auto codes = [&] {
    write_text(folder / "p.taxelproj", project.dump());
    std::map<std::string, std::string> found;
    const Json report = Json::parse(taxel({"check", "p.taxelproj", "--json"}, folder).out);
    for (const Json& problem : report["problems"])
      if (problem["severity"] != "note") found[problem["pointer"]] = problem["code"];
    return found;
  };
  using Codes = std::map<std::string, std::string>;
  EXPECT_EQ(codes(), (Codes{{"/layout/taxels/3/radius", "radius_not_positive"}}));
  project["layout"]["taxels"][3]["radius"] = 0.006;
  project["layout"]["sampling"]["region"] = Json::parse("[[0, 3000], [1000000, 1000001]]");
  EXPECT_EQ(codes().at("/layout/sampling/region"), "region_off_mesh");
  project["hidden"] = {77};
  write_text(folder / "p.taxelproj", project.dump());
  const Outcome refused = taxel({"check", "p.taxelproj"}, folder);
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.out.substr(0, refused.out.find('\n')), "p.taxelproj: /hidden/0: error: there is no taxel 77");
}

}  // namespace
}  // namespace taxel::test
