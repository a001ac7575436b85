// Pipes, devices, folders and links to them in the place of files that other files name: each is refused at once, or
// ignored if it is not needed. A program that opened a pipe would wait for its writer for ever.
#include <sys/stat.h>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

constexpr const char* kSeconds = "10";  // a refusal takes much less, also on a busy machine

Outcome guarded_taxel(const std::vector<std::string>& arguments, const fs::path& folder) {
  std::vector<std::string> words{kSeconds, TAXEL_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_program("/usr/bin/timeout", words, folder);
}

/// Kinds of paths that are no files.
constexpr const char* kKinds[] = {"pipe", "device", "folder", "link to a pipe", "link to a folder"};

/// Makes a path of a kind, in place of the old one.
void make_irregular(const fs::path& path, const std::string& kind) {
  fs::remove_all(path);
  const fs::path target = path.string() + ".target";
  fs::remove_all(target);
  const fs::path real = kind.starts_with("link") ? target : path;
  if (kind.ends_with("pipe")) {
    ASSERT_EQ(::mkfifo(real.c_str(), 0600), 0);
  }
  if (kind.ends_with("folder")) fs::create_directory(real);
  if (kind == "device") fs::create_symlink("/dev/zero", path);
  if (kind.starts_with("link")) fs::create_symlink(target.filename(), path);
}

/// Expects exit status 2 and a message that names the file and says that it is a folder or no regular file.
void expect_refused(const Outcome& outcome, const std::string& name) {
  EXPECT_EQ(outcome.status, 2) << outcome.out << outcome.err;
  const bool is_named = outcome.err.find(name + ": is not a regular file") != std::string::npos ||
                        outcome.err.find(name + ": is a folder, not a file") != std::string::npos;
  EXPECT_TRUE(is_named) << outcome.err;
}

/// Expects the refusal of `name`, made as each kind.
void expect_refused_as_each_kind(const fs::path& folder, const std::vector<std::string>& arguments,
                                 const std::string& name) {
  for (const char* kind : kKinds) {
    SCOPED_TRACE(name + ", a " + kind);
    make_irregular(folder / name, kind);
    expect_refused(guarded_taxel(arguments, folder), name);
  }
}

/// Returns a glTF document with one triangle, whose bytes are in the uri or in a file.
Json gltf_triangle(const std::string& uri) {
  return {{"asset", {{"version", "2.0"}}},
          {"buffers", {{{"byteLength", 36}, {"uri", uri}}}},
          {"bufferViews", {{{"buffer", 0}, {"byteLength", 36}}}},
          {"accessors", {{{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}}}},
          {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}}},
          {"nodes", {{{"mesh", 0}}}},
          {"scenes", {{{"nodes", {0}}}}}};
}

constexpr const char* kTriangle =
    "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";

TEST(IrregularFiles, AreRefusedAsBuffersOfGltf) {
  const fs::path folder = test_folder();
  write_text(folder / "m.gltf", gltf_triangle("b.bin").dump());
  expect_refused_as_each_kind(folder, {"mesh", "m.gltf"}, "b.bin");
  for (const char* uri : {"/dev/zero", "%2Fdev%2fzero"}) {
    write_text(folder / "m.gltf", gltf_triangle(uri).dump());
    expect_refused(guarded_taxel({"mesh", "m.gltf"}, folder), "m.gltf: /buffers/0/uri: /dev/zero");
  }
}

TEST(IrregularFiles, AreIgnoredIfAMeshDoesNotNeedThem) {
  const fs::path folder = test_folder();
  Json gltf = gltf_triangle(kTriangle);
  gltf["images"] = {{{"uri", "needless"}}};
  gltf["textures"] = {{{"source", 0}}};
  gltf["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  gltf["meshes"][0]["primitives"][0]["material"] = 0;
  write_text(folder / "m.gltf", gltf.dump());
  std::string json = gltf.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto number = [](std::size_t value) {
    std::string bytes;
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xFF);
    return bytes;
  };
  write_text(folder / "m.glb", "glTF" + number(2) + number(20 + json.size()) + number(json.size()) + "JSON" + json);
  write_text(folder / "m.obj", "mtllib needless\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write_text(folder / "m.ply",
             "ply\nformat ascii 1.0\ncomment TextureFile needless\nelement vertex 3\nproperty float x\nproperty float "
             "y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 "
             "0\n0 1 0\n3 0 1 2\n");
  for (const char* kind : kKinds) {
    make_irregular(folder / "needless", kind);
    for (const char* mesh : {"m.gltf", "m.glb", "m.obj", "m.ply"}) {
      SCOPED_TRACE(std::string(mesh) + ", " + kind);
      const Outcome outcome = guarded_taxel({"mesh", mesh, "--json"}, folder);
      ASSERT_EQ(outcome.status, 0) << outcome.err;
      EXPECT_EQ(Json::parse(outcome.out)["triangles"], 1);
    }
  }
}

TEST(IrregularFiles, AreRefusedAsFilesThatOtherFilesName) {
  const fs::path folder = test_folder();
  (void)changed_layout(folder, Json::parse(R"([{"op": "replace", "path": "/mesh/file", "value": "f.obj"}])"));
  Json project = {
      {"format", "taxel-project"}, {"version", 1}, {"layout", Json::parse(file_text(folder / "changed.taxels.json"))}};
  write_text(folder / "p.taxelproj", project.dump());
  const std::string head = R"({"format": "contact-case", "version": 1, "b": {"shape": {"type": "plane"}}, "a": )";
  write_text(folder / "layout.json", head + R"({"layout": "f.taxels.json"}})");
  write_text(folder / "mesh.json",
             head + R"({"shape": {"type": "mesh", "file": "f.obj"}, "material": {"modulus": 5e4}}})");
  write_text(folder / "tets.json",
             head + R"({"shape": {"type": "tets", "file": "f.vtk"}, "material": {"modulus": 5e4}}})");
  write_text(folder / "object.json", R"({"object": "f.obj"})");
  write_text(folder / "replay.json", R"({"kind": "replay", "source": "f.npz"})");
  expect_refused_as_each_kind(folder, {"samples", "changed.taxels.json"}, "f.obj");
  expect_refused_as_each_kind(folder, {"contact", "layout.json"}, "f.taxels.json");
  expect_refused_as_each_kind(folder, {"contact", "mesh.json"}, "f.obj");
  expect_refused_as_each_kind(folder, {"contact", "tets.json"}, "f.vtk");
  expect_refused_as_each_kind(folder, {"play", "object.json"}, "f.obj");
  make_irregular(folder / "f.npz", "pipe");  // a folder may be the source of a replay
  expect_refused(guarded_taxel({"play", "replay.json"}, folder), "f.npz");
  make_irregular(folder / "f.obj", "pipe");
  const Outcome check = guarded_taxel({"check", "p.taxelproj"}, folder);
  EXPECT_NE((check.out + check.err).find("f.obj: is not a regular file"), std::string::npos) << check.out << check.err;
}

TEST(IrregularFiles, AreRefusedAsArgumentsOfCommands) {
  const fs::path folder = test_folder();
  const std::string layout = fingertip_layout().string();
  using Words = std::vector<std::string>;
  for (const Words& words :
       {Words{"f.stl", "mesh", "f.stl"}, Words{"f.off", "mesh", "f.off"}, Words{"f.glb", "mesh", "f.glb"},
        Words{"f.vtk", "mesh", "f.vtk"}, Words{"f.npz", "plot", "f.npz"}, Words{"f.npz", "models", "f.npz"},
        Words{"f.yaml", "samples", "f.yaml", "--mesh", "m.obj"}, Words{"f.npz", "convert", "f.npz", "o.taxels.json"},
        Words{"f.urdf", "convert", "f.urdf", "o.taxels.json"}, Words{"f.xml", "convert", "f.xml", "o.taxels.json"},
        Words{"f.csv", "convert", "f.csv", "o.taxels.json"}, Words{"f.jsonl", "batch", "f.jsonl", "--out", "o"},
        Words{"f.json", "study", "f.json"}, Words{"f.json", "read", layout, "f.json"},
        Words{"f.json", "sweep", "--scenario", "f.json"}, Words{"f.obj", "sweep", "--object", "f.obj"}}) {
    SCOPED_TRACE(words[1] + " " + words[0]);
    for (const char* kind : {"pipe", "device"}) {
      make_irregular(folder / words[0], kind);
      const Outcome outcome = guarded_taxel({words.begin() + 1, words.end()}, folder);
      EXPECT_EQ(outcome.status, 2) << outcome.out << outcome.err;
      EXPECT_NE(outcome.err.find("is not a regular file"), std::string::npos) << outcome.err;
    }
    fs::remove_all(folder / words[0]);
  }
}

/// A file that a scene names.
struct NamedInScene {
  std::string asset;  ///< MJCF
  std::string name;   ///< path of the irregular file in the scene's folder
};

TEST(IrregularFiles, AreRefusedInScenes) {
  const fs::path folder = test_folder();
  fs::create_directory(folder / "sub");
  const std::string box = R"(<worldbody><geom type="box" size="1 1 1"/></worldbody></mujoco>)";
  const std::string child = R"(<mujoco><asset><mesh name="m" file="f.stl"/></asset>)";
  write_text(folder / "sub" / "child.xml",
             child + R"(<worldbody><body name="b"><geom type="mesh" mesh="m"/></body></worldbody></mujoco>)");
  write_text(folder / "sub" / "part.xml", R"(<mujoco><asset><mesh name="m" file="f.stl"/></asset></mujoco>)");
  const auto asset = [&](const std::string& text) { return "<asset>" + text + "</asset>" + box; };
  for (const NamedInScene& one :
       {NamedInScene{asset(R"(<mesh name="m" file="f.obj"/>)"), "f.obj"},
        NamedInScene{asset(R"(<mesh name="m" file="f.msh"/>)"), "f.msh"},
        NamedInScene{asset(R"(<hfield name="h" file="f.png" size="1 1 1 1"/>)"), "f.png"},
        NamedInScene{asset(R"(<skin name="s" file="f.skn"/>)"), "f.skn"},
        NamedInScene{asset(R"(<texture name="t" type="2d" file="f.png"/>)"), "f.png"},
        NamedInScene{asset(R"(<texture name="t" type="cube" fileup="f.png"/>)"), "f.png"},
        NamedInScene{R"(<compiler meshdir="sub"/>)" + asset(R"(<mesh name="m" file="f.stl"/>)"), "sub/f.stl"},
        NamedInScene{R"(<compiler assetdir="sub"/>)" + asset(R"(<texture name="t" type="2d" file="f.png"/>)"),
                     "sub/f.png"},
        NamedInScene{R"(<compiler strippath="true"/>)" + asset(R"(<mesh name="m" file="gone/f.stl"/>)"), "f.stl"},
        NamedInScene{R"(<worldbody><flexcomp name="f" type="mesh" file="f.obj" dim="2"/></worldbody></mujoco>)",
                     "f.obj"},
        NamedInScene{R"(<worldbody><flexcomp name="f" type="gmsh" file="f.msh" dim="3"/></worldbody></mujoco>)",
                     "f.msh"},
        NamedInScene{R"(<asset><model name="c" file="sub/child.xml"/></asset><worldbody><attach model="c" body="b"
                        prefix="x"/></worldbody></mujoco>)",
                     "sub/f.stl"},
        NamedInScene{R"(<include file="sub/part.xml"/>)" + box, "sub/f.stl"},
        NamedInScene{R"(<include file="f.xml"/>)" + box, "f.xml"}}) {
    write_text(folder / "scene.xml", "<mujoco>" + one.asset);
    for (const char* kind : {"pipe", "device", "folder", "link to a pipe"}) {
      SCOPED_TRACE(one.asset + ", " + kind);
      make_irregular(folder / one.name, kind);
      expect_refused(guarded_taxel({"run", "scene.xml"}, folder), fs::path(one.name).filename().string());
    }
    fs::remove_all(folder / one.name);
  }
}

TEST(IrregularFiles, AreRefusedInRobotDescriptions) {
  const fs::path folder = test_folder();
  for (const char* name : {"f.stl", "package://robot/meshes/f.stl"}) {
    write_text(folder / "robot.xml",
               std::string(R"(<robot name="r"><link name="l"><collision><geometry><mesh filename=")") + name +
                   R"("/></geometry></collision></link></robot>)");
    make_irregular(folder / "f.stl", "pipe");
    expect_refused(guarded_taxel({"run", "robot.xml"}, folder), "f.stl");
  }
}

TEST(IrregularFiles, AreRefusedAsLayoutsAndPluginsOfScenes) {
  const fs::path folder = test_folder();
  write_text(folder / "scene.xml", R"(<mujoco><extension><plugin plugin="taxel.sensor"><instance name="s"><config
      key="layout" value="f.taxels.json"/><config key="geom" value="g"/></instance></plugin></extension><worldbody>
      <geom name="g" size="1"/></worldbody><sensor><plugin name="s" plugin="taxel.sensor" instance="s"/></sensor>
      </mujoco>)");
  for (const char* kind : kKinds) {
    make_irregular(folder / "f.taxels.json", kind);
    EXPECT_EQ(guarded_taxel({"run", "scene.xml"}, folder).status, 2) << kind;
  }
  fs::create_directory(folder / "plugins");
  for (const char* kind : kKinds) {
    make_irregular(folder / "plugins" / "f.so", kind);
    expect_refused(guarded_taxel({"run", "scene.xml", "--plugins", "plugins"}, folder), "plugins/f.so");
  }
}

}  // namespace
}  // namespace taxel::test
