// Bodies from files: problems of a mesh are reported with their place and repair; pressure fields are reported, written
// and read; height fields and tets are shapes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/taxel_program.h"
#include "fixtures/pad_meshes.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

/// Builds the text of an OBJ file of boxes.
class Obj {
 public:
  Obj& box(double half, double x = 0) {
    for (int i = 0; i < 8; ++i) {
      vertices_ += "v " + std::to_string((i & 1 ? half : -half) + x) + " " + std::to_string(i & 2 ? half : -half) +
                   " " + std::to_string(i & 4 ? half : -half) + "\n";
    }
    for (const auto& f : {std::array{1, 3, 4},
                          {1, 4, 2},
                          {5, 6, 8},
                          {5, 8, 7},
                          {1, 2, 6},
                          {1, 6, 5},
                          {3, 7, 8},
                          {3, 8, 4},
                          {1, 5, 7},
                          {1, 7, 3},
                          {2, 4, 8},
                          {2, 8, 6}})
      faces_.push_back({f[0] + count_, f[1] + count_, f[2] + count_});
    count_ += 8;
    return *this;
  }
  Obj& vertex(const std::string& xyz) {
    vertices_ += "v " + xyz + "\n";
    ++count_;
    return *this;
  }
  Obj& face(const std::array<int, 3>& f) {
    faces_.push_back(f);
    return *this;
  }
  Obj& without(std::size_t face) {
    faces_.erase(faces_.begin() + static_cast<std::ptrdiff_t>(face));
    return *this;
  }
  Obj& turned(std::size_t first, std::size_t end) {
    for (std::size_t f = first; f < end; ++f) std::swap(faces_[f][1], faces_[f][2]);
    return *this;
  }
  [[nodiscard]] std::string text() const {
    std::string text = vertices_;
    for (const auto& f : faces_)
      text += "f " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " + std::to_string(f[2]) + "\n";
    return text;
  }

 private:
  std::string vertices_;
  std::vector<std::array<int, 3>> faces_;
  int count_ = 0;
};

const Json kSoft = {{"modulus", 5e4}, {"thickness", 0.004}};

/// Writes a case of m.obj, soft by default, 1 mm deep in a plane.
fs::path mesh_case(const std::string& obj, const Json& material = kSoft, double half = 0.02) {
  const fs::path folder = test_folder();
  write_text(folder / "m.obj", obj);
  Json plane = {{"shape", {{"type", "plane"}}}};
  if (material.value("modulus", 0.0) == 0) plane["material"] = {{"modulus", 1e5}, {"thickness", 0.01}};
  const Json json = {
      {"format", "contact-case"},
      {"version", 1},
      {"a", {{"shape", {{"type", "mesh"}, {"file", "m.obj"}}}, {"material", material}, {"pos", {0, 0, half - 0.001}}}},
      {"b", plane}};
  write_text(folder / "case.json", json.dump());
  return folder;
}

/// Expects a contact with exactly one warning, which contains these words.
void expect_contact_warns(const std::string& obj, const std::string& words, const Json& material = kSoft,
                          double half = 0.02) {
  const fs::path folder = mesh_case(obj, material, half);
  const Outcome outcome = taxel({"contact", "case.json", "--json"}, folder);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const Json result = Json::parse(outcome.out);
  ASSERT_EQ(result["warnings"].size(), 1U) << result["warnings"];
  EXPECT_NE(result["warnings"][0].get<std::string>().find(words), std::string::npos) << result["warnings"];
  EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  EXPECT_GT(result["area"].get<double>(), 0);
  EXPECT_EQ(taxel({"check", "case.json"}, folder).status, 1);
}

/// Expects the messages of `taxel mesh` and `taxel check` about the file.
void expect_mesh_told(const std::string& obj, const std::string& code, const std::string& words) {
  const fs::path folder = test_folder();
  write_text(folder / "m.obj", obj);
  const Outcome mesh = taxel({"mesh", "m.obj"}, folder);
  EXPECT_EQ(mesh.status, 0) << mesh.err;
  EXPECT_NE(mesh.out.find(words), std::string::npos) << mesh.out;
  const Json problems = Json::parse(taxel({"check", "m.obj", "--json"}, folder).out)["problems"];
  EXPECT_TRUE(std::any_of(problems.begin(), problems.end(), [&](const Json& p) { return p["code"] == code; }))
      << problems;
}

TEST(BadMesh, GivesNoWarningIfItIsSound) {
  const fs::path folder = mesh_case(Obj().box(0.02).text());
  const Json result = taxel_json({"contact", "case.json"}, folder);
  EXPECT_EQ(result["warnings"], Json::array());
  EXPECT_EQ(taxel({"check", "case.json"}, folder).status, 0);
}

TEST(BadMesh, IsReportedIfItIsOpen) {
  const std::string open = Obj().box(0.02).without(2).text();
  const Json soft = taxel_json({"contact", "case.json"}, mesh_case(open));
  EXPECT_NE(soft["warnings"].dump().find("1 hole"), std::string::npos) << soft["warnings"];
  EXPECT_GT(soft["area"], 0);
  expect_contact_warns(open, "1 hole filled", Json::object());
  expect_mesh_told(open, "mesh_open", "3 open edges");
}

TEST(BadMesh, LosesItsFinsAndIsReported) {
  const auto with_fin = [](const char* tip) { return Obj().box(0.02).vertex(tip).face({7, 8, 9}).text(); };
  const Json sound = taxel_json({"contact", "case.json"}, mesh_case(Obj().box(0.02).text()));
  const std::string fin = with_fin("0 0.02 0.026");  // 1.2 % of the area; fins of up to 2 % are removed
  const Json soft = taxel_json({"contact", "case.json"}, mesh_case(fin));
  EXPECT_NE(soft["warnings"].dump().find("1 fin removed"), std::string::npos) << soft["warnings"];
  EXPECT_EQ(soft["area"], sound["area"]);
  // With 7 % of the area its hole is filled by the reversed face, and both faces are removed.
  const Json large = taxel_json({"contact", "case.json"}, mesh_case(with_fin("0 0 0.05")));
  EXPECT_NE(large["warnings"].dump().find("2 folded faces removed"), std::string::npos) << large["warnings"];
  EXPECT_NEAR(large["area"].get<double>(), sound["area"].get<double>(), 1e-9 * sound["area"].get<double>());
  expect_mesh_told(fin, "mesh_nonmanifold", "1 edge with more than two faces");
}

TEST(BadMesh, IsRepairedIfItsWindingIsWrong) {
  const std::string inverted = Obj().box(0.02).turned(0, 12).text();
  for (const std::string& obj : {Obj().box(0.02).turned(4, 5).text(), inverted}) {
    const Json soft = taxel_json({"contact", "case.json"}, mesh_case(obj));
    EXPECT_NE(soft["warnings"].dump().find("repaired: "), std::string::npos) << soft["warnings"];
    EXPECT_GT(soft["area"], 0);
  }
  expect_mesh_told(inverted, "mesh_inverted", "the volume is negative");
}

/// A rigid box of 10 mm, pressed 0.5 mm into a soft one of 40 mm: 1.25 N.
Json felt(const std::string& touched, const char* repair = "auto") {
  const std::string box = Obj().box(0.02).text();
  const Json body = {{"type", "mesh"}, {"file", "touched.obj"}, {"repair", repair}};
  const Json pad = {{"shape", {{"type", "mesh"}, {"file", "pad.obj"}}},
                    {"material", {{"modulus", 5e4}, {"thickness", 0.002}, {"field", "pad"}}}};
  const Json contact = {
      {"format", "contact-case"}, {"version", 1}, {"a", pad}, {"b", {{"shape", body}, {"pos", {0, 0, 0.0245}}}}};
  const fs::path folder = test_folder();
  write_text(folder / "pad.obj", box);
  write_text(folder / "touched.obj", touched);
  write_text(folder / "case.json", contact.dump());
  return taxel_json({"contact", "case.json"}, folder);
}

TEST(BadMesh, IsFeltLikeASoundOne) {
  const Json sound = felt(Obj().box(0.005).text());
  EXPECT_NEAR(sound["force"][2].get<double>(), -1.25, 1e-9);
  EXPECT_EQ(sound["warnings"].dump().find("repaired"), std::string::npos) << sound["warnings"];
  const std::pair<const char*, std::string> faults[] = {{"one face turned", Obj().box(0.005).turned(0, 1).text()},
                                                        {"the lower face turned", Obj().box(0.005).turned(0, 2).text()},
                                                        {"inside out", Obj().box(0.005).turned(0, 12).text()},
                                                        {"no lid", Obj().box(0.005).without(2).text()},
                                                        {"a body inside", Obj().box(0.005).box(0.002).text()},
                                                        {"the box twice", Obj().box(0.005).box(0.005).text()}};
  for (const auto& [fault, obj] : faults) {
    SCOPED_TRACE(fault);
    const Json broken = felt(obj);
    EXPECT_NEAR(broken["force"][2].get<double>(), -1.25, 1e-9) << broken["warnings"];
  }
}

TEST(BadMesh, IsFeltAsItIsWithoutRepair) {
  const std::string turned = Obj().box(0.005).turned(0, 2).text();
  EXPECT_EQ(felt(turned, "off")["force"][2], 0);  // the front face is left out as a back face
  EXPECT_NEAR(felt(turned, "exact")["force"][2].get<double>(), -1.25, 1e-9);
}

/// One triangle has no inside: it is felt from the side from which it is touched, whichever way it winds.
TEST(BadMesh, IsTwoSidedIfItIsASheet) {
  const auto sheet = [](const std::array<int, 3>& face) {
    return Obj()
        .vertex("-0.005 -0.005 -0.005")
        .vertex("0.005 -0.005 -0.005")
        .vertex("-0.005 0.005 -0.005")
        .face(face)
        .text();
  };
  for (const std::array<int, 3>& face : {std::array{1, 2, 3}, std::array{1, 3, 2}}) {
    const Json thin = felt(sheet(face));
    EXPECT_NEAR(thin["force"][2].get<double>(), -0.625, 1e-9);  // half of the box's face
    EXPECT_NE(thin["warnings"].dump().find("1 surface without an inside made two-sided"), std::string::npos)
        << thin["warnings"];
  }
}

TEST(CheckScene, ListsSensorsWithTheirGeomsAndRepairs) {
  const fs::path folder = test_folder();
  write_text(folder / "box.obj", Obj().box(0.005).text());
  const Json press = {{"kind", "press"}, {"depth", 0.0005}, {"object", "box.obj"}};
  write_text(folder / "p.scn.json", Json{{"format", "taxel-scenario"}, {"version", 1}, {"scenario", press}}.dump());
  const Outcome played = taxel({"play", "p.scn.json", "--out", "run"}, folder);
  ASSERT_EQ(played.status, 0) << played.err;
  const auto check = [&] { return Json::parse(taxel({"check", "run/scene.xml", "--json"}, folder).out)["problems"]; };
  const Json sound = check();
  ASSERT_EQ(sound.size(), 1U) << sound;
  EXPECT_EQ(sound[0]["code"], "sensor");
  EXPECT_NE(sound[0]["message"].get<std::string>().find("of 12 taxels, touches \"box\""), std::string::npos) << sound;
  write_text(folder / "run/object.obj", Obj().box(0.005).turned(0, 1).text());
  const Json turned = check();
  ASSERT_EQ(turned.size(), 2U) << turned;
  EXPECT_EQ(turned[1]["code"], "mesh_repaired");
  EXPECT_EQ(turned[1]["severity"], "note");
  EXPECT_NE(turned[1]["message"].get<std::string>().find("geom \"box\": repaired: 1 face turned outward"),
            std::string::npos)
      << turned;
}

TEST(BadMesh, IsUnitedIfItsShellsOverlap) {
  const std::string two = Obj().box(0.02).box(0.0199, 0.013).text();
  expect_contact_warns(two, "2 overlapping shells united");
  expect_mesh_told(two, "mesh_self_intersection", "cut through each other");
}

TEST(BadMesh, LosesRepeatedAndFlatTrianglesWithAWarning) {
  expect_contact_warns(Obj().box(0.02).face({1, 3, 4}).text(), "dropped 1 repeated triangles (first: triangle 12)");
  expect_contact_warns(Obj().box(0.02).face({1, 2, 2}).text(), "dropped 1 triangles without area (first: triangle 12)");
  const std::string twice = Obj().box(0.02).box(0.02).text();
  const Json result = taxel_json({"contact", "case.json"}, mesh_case(twice));
  EXPECT_EQ(result["warnings"].size(), 2U);  // welded, dropped
  EXPECT_EQ(result["fields"][0]["tets"], 36);
}

TEST(BadMesh, IsRefusedIfItIsEmptyOrNotFinite) {
  const std::string file = (test_folder() / "m.obj").filename().string();
  const auto refused = [&](const std::string& obj, const std::string& words) {
    const fs::path folder = mesh_case(obj);
    const Outcome outcome = taxel({"contact", "case.json"}, folder);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(file + ": " + words), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
    for (const char* command : {"mesh", "check"}) {
      const Outcome other = taxel({command, "m.obj"}, folder);
      EXPECT_EQ(other.status, 2) << command;
      EXPECT_NE(other.err.find("m.obj: " + words), std::string::npos) << other.err;
    }
  };
  refused("v 0 0 0\nv 1 inf 0\n", "line 2: coordinate is not finite");
  refused("", "is empty");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\n", "has no triangles");
}

TEST(BadMesh, GivesAWarningIfItsUnitIsWrong) {
  expect_contact_warns(Obj().box(20).text(), "its unit is probably mm; set the scale to 0.001", kSoft, 20);
  const fs::path folder = test_folder();
  const fs::path mesh = folder / "finger.obj";
  const fs::path source = fingertip_layout().parent_path() / Json::parse(file_text(fingertip_layout()))["mesh"]["file"];
  ASSERT_EQ(taxel({"mesh", source.string(), "--scale", "1000", "--out", mesh.string()}).status, 0);
  const fs::path layout =
      changed_layout(folder, Json::parse(R"([{"op": "replace", "path": "/mesh/file", "value": "finger.obj"},
                              {"op": "replace", "path": "/sampling/density", "value": 10},
                              {"op": "remove", "path": "/mesh/sha256"}])"));
  Json json = Json::parse(file_text(layout));
  for (Json& taxel : json["taxels"]) {
    for (Json& x : taxel["center"]) x = 1000 * x.get<double>();
    taxel["radius"] = 1000 * taxel["radius"].get<double>();
  }
  write_text(layout, json.dump());
  const Json problems = Json::parse(taxel({"check", layout.string(), "--json"}, folder).out)["problems"];
  const auto units =
      std::find_if(problems.begin(), problems.end(), [](const Json& p) { return p["code"] == "mesh_units"; });
  ASSERT_NE(units, problems.end()) << problems;
  EXPECT_EQ((*units)["severity"], "warning");
  EXPECT_EQ((*units)["pointer"], "/mesh/scale");
}

TEST(BadMesh, GivesAWarningIfThePadIsThickerThanTheBody) {
  expect_contact_warns(Obj().box(0.02).text(),
                       "the pad is 50 mm thick, more than half of the body's smallest extent, 20 mm",
                       {{"modulus", 5e4}, {"thickness", 0.05}});
}

TEST(BadMesh, IsRefusedIfAModulusIsNegative) {
  const fs::path folder = mesh_case(Obj().box(0.02).text(), {{"modulus", -5}});
  const std::string line = "taxel: case.json: /a/material/modulus: must not be negative, is -5";
  expect_refusal(taxel({"contact", "case.json"}, folder), line);
  Json json = Json::parse(file_text(folder / "case.json"));
  json["a"]["material"]["modulus"] = 5;
  json["b"]["material"]["modulus"] = -1;
  write_text(folder / "case.json", json.dump());
  const Outcome check = taxel({"check", "case.json"}, folder);
  EXPECT_EQ(check.status, 2);
  EXPECT_EQ(check.err, "taxel: case.json: /b/material/modulus: must not be negative, is -1\n");
}

TEST(FieldReports, AreListedByCheckForALayout) {
  const Json problems = Json::parse(taxel({"check", fingertip_layout().string(), "--json"}).out)["problems"];
  const auto find = [&](const char* code) {
    return std::find_if(problems.begin(), problems.end(), [&](const Json& p) { return p["code"] == code; });
  };
  ASSERT_NE(find("field_report"), problems.end()) << problems;
  EXPECT_EQ((*find("field_report"))["severity"], "note");
  EXPECT_EQ((*find("field_report"))["pointer"], "/material");
  const std::string message = (*find("field_report"))["message"];
  EXPECT_NE(message.find("6012 tets"), std::string::npos);
  EXPECT_NE(message.find("; one layer of prisms, 0.0"), std::string::npos) << message;  // in percent of the modulus
  ASSERT_NE(find("field_thickness_limited"), problems.end());
  EXPECT_EQ(find("field_inverted"), problems.end());
}

TEST(FieldReports, ArePartOfTheResultOfAContact) {
  const Json layout = {{"format", "contact-case"},
                       {"version", 1},
                       {"a", {{"layout", fingertip_layout().string()}}},
                       {"b", {{"shape", {{"type", "plane"}}}}}};
  const fs::path folder = test_folder();
  write_text(folder / "case.json", layout.dump());
  const Json field = taxel_json({"contact", "case.json"}, folder)["fields"].at(0);
  EXPECT_EQ(field["body"], "a");
  EXPECT_EQ(field["tets"], 6012);
  EXPECT_EQ(field["inverted"], 0);
  EXPECT_EQ(field["zero_gradient"], 0);
  EXPECT_LT(field["stiffness"]["cv"].get<double>(), 0.02);
  EXPECT_LE(field["stiffness"]["min"], field["stiffness"]["mean"]);
  EXPECT_EQ(field["bare"]["faces"], 0);
  EXPECT_GT(field["limited"]["faces"], 0);
  EXPECT_LT(field["limited"]["least_part"], 1);
  EXPECT_EQ(field["limited"]["bounds"].size(), 2U);
  EXPECT_EQ(field["limited"]["worst_place"].size(), 3U);
}

/// A blade that cuts 2 mm into a concave edge, along the plane between its faces. At the tip the distance to the skin
/// is 2 mm, and the depth below the planes of the faces is 1.4 mm, which a single layer of prisms would give.
TEST(FieldReports, FollowTheDistanceBelowAConcaveEdgeWithTwoPrismLayers) {
  const TriMesh step = make_l_block(0.0005, 20);
  std::string obj;
  for (const dvec3& v : step.vertices()) obj += fmt::format("v {} {} {}\n", v.x, v.y, v.z);
  for (const ivec3& f : step.faces()) obj += fmt::format("f {} {} {}\n", f.x + 1, f.y + 1, f.z + 1);
  const fs::path folder = test_folder();
  write_text(folder / "step.obj", obj);
  const double middle = 0.005 + 0.002 * std::sqrt(0.5);  // middle of the blade; the edge is at x = z = 5 mm
  const Json json = {
      {"format", "contact-case"},
      {"version", 1},
      {"a",
       {{"shape", {{"type", "mesh"}, {"file", "step.obj"}}}, {"material", {{"modulus", 1e5}, {"thickness", 0.0025}}}}},
      {"b",
       {{"shape", {{"type", "box"}, {"size", {0.0001, 0.003, 0.004}}}},
        {"pos", {middle, 0.005, middle}},
        {"quat", {std::cos(kPi / 8), 0, std::sin(kPi / 8), 0}}}}};
  write_text(folder / "case.json", json.dump());
  const Json result = taxel_json({"contact", "case.json"}, folder);
  EXPECT_GT(result["max_pressure"].get<double>(), 0.68e5);
  EXPECT_LT(result["max_pressure"].get<double>(), 0.81e5);
  EXPECT_NEAR(result["centroid"][0].get<double>(), result["centroid"][2].get<double>(), 1e-4);
  const Json field = result["fields"].at(0);
  EXPECT_GT(field["two_layer_faces"].get<int>(), 100);
  EXPECT_LT(field["two_layer_faces"].get<int>(), step.face_count() / 10);
  EXPECT_NEAR(field["depth_error"]["rms"].get<double>(), 0.0113, 0.004);
  EXPECT_LT(field["depth_error"]["mean"], field["depth_error"]["rms"]);
}

TEST(Tets, GiveTheSameForceAfterTheyAreWrittenAndRead) {
  const fs::path folder = test_folder();
  Json json = Json::parse(R"({"format": "contact-case", "version": 1,
    "a": {"shape": {"type": "capsule", "size": [0.02, 0.03]}, "material": {"modulus": 5e4}, "pos": [0, 0, 0.048]},
    "b": {"shape": {"type": "plane"}}})");
  write_text(folder / "capsule.json", json.dump());
  const Json own = taxel_json({"contact", "capsule.json", "--tets", "capsule.vtk"}, folder);
  json["a"]["shape"] = {{"type", "tets"}, {"file", "capsule.vtk"}};
  write_text(folder / "tets.json", json.dump());
  const Json read = taxel_json({"contact", "tets.json"}, folder);
  EXPECT_GT(own["polygons"], 20);
  for (const char* key : {"force", "area", "polygons", "centroid"}) EXPECT_EQ(own[key], read[key]) << key;
  EXPECT_EQ(own["fields"][0]["tets"], read["fields"][0]["tets"]);
  // Without pressures in the file the field is the distance to the boundary: that of a capsule, except for the facets.
  std::string text = file_text(folder / "capsule.vtk");
  write_text(folder / "capsule.vtk", text.substr(0, text.find("POINT_DATA")));
  const double force = taxel_json({"contact", "tets.json"}, folder)["force"][2];
  EXPECT_NEAR(force, own["force"][2].get<double>(), 0.02 * force);
  // A rigid body is the boundary.
  json["a"]["material"]["modulus"] = 0;
  json["b"]["material"] = {{"modulus", 5e4}, {"thickness", 0.02}};
  write_text(folder / "rigid.json", json.dump());
  EXPECT_GT(taxel_json({"contact", "rigid.json"}, folder)["force"][2], 0);
}

TEST(Tets, AreRefusedByLineIfTheFileIsBad) {
  const fs::path folder = test_folder();
  write_text(folder / "case.json", R"({"format": "contact-case", "version": 1,
    "a": {"shape": {"type": "tets", "file": "t.vtk"}, "material": {"modulus": 5e4}}, "b": {"shape": {"type": "plane"}}})");
  const auto refused = [&](const std::string& vtk, const std::string& line) {
    write_text(folder / "t.vtk", vtk);
    expect_refusal(taxel({"contact", "case.json"}, folder), "taxel: " + line);
  };
  expect_refusal(taxel({"contact", "case.json"}, folder), "taxel: t.vtk: no such file");
  refused("", "t.vtk: line 0: is not a legacy VTK file: it does not begin with '# vtk DataFile Version'");
  const std::string head = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n";
  refused(head + "0 0 0\n1 0 0\n0 one 0\n", "t.vtk: line 8: 'one' is not a number");
  refused(head + "0 0 0\n1 0 0\n0 1 0\n0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n",
          "case.json: /a: no vertex of the tetrahedral mesh lies inside of it: it has no pressure field");
  refused(head + "0 0 0\n1 0 0\n0 1 0\n1 1 0\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n",
          "case.json: /a: tet 0 has no volume");
}

TEST(HeightFields, AreRigidShapes) {
  const fs::path folder = test_folder();
  Json json = Json::parse(R"({"format": "contact-case", "version": 1,
    "a": {"shape": {"type": "box", "size": [0.02, 0.02, 0.01]}, "material": {"modulus": 5e4}, "pos": [0, 0, 0.008]},
    "b": {"shape": {"type": "hfield", "size": [0.1, 0.1, 0.05, 0.02], "elevation": [[0, 0, 0], [0, 0, 0], [0, 0, 0]]}}})");
  const auto contact = [&](const Json& contact_case) {
    write_text(folder / "case.json", contact_case.dump());
    return taxel({"contact", "case.json", "--json"}, folder);
  };
  const double force = Json::parse(contact(json).out)["force"][2];
  const double x = 0.002, exact = 5e4 / 0.01 * (x * 0.04 * 0.04 - x * x * 0.08 + 4 * x * x * x / 3);  // A4
  EXPECT_NEAR(force, exact, 1e-9 * exact);
  const auto refused = [&](const char* pointer, const Json& value, const std::string& line) {
    Json bad = json;
    bad[Json::json_pointer(pointer)] = value;
    expect_refusal(contact(bad), "taxel: case.json: " + line);
  };
  refused("/b/shape/elevation/1", {0, 0}, "/b/shape/elevation/1: must be an array of 3 numbers, is [0,0]");
  refused("/b/shape/elevation/1/2", 1.5, "/b/shape/elevation/1: must be between 0 and 1, is 1.5");
  refused("/b/shape/elevation", {{0, 0}}, "/b/shape/elevation: must be an array of 2 rows or more, is [[0,0]]");
  refused("/b/shape/size/3", 0, "/b/shape/size/3: must be greater than 0, is 0");
  refused("/b/material", {{"modulus", 1e5}}, "/b: a height field can only be rigid: its modulus must be 0, is 100000");
}

}  // namespace
}  // namespace taxel::test
