// glTF files: buffers, nodes, primitives, quantised positions, and broken references.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/base/text/base64.h"
#include "core/mesh/mesh_io.h"
#include "fixtures/temp_folder.h"
#include "unit/mesh/random_mesh.h"

namespace taxel {
namespace {

using nlohmann::json;
using test::TempFolder;

/// A unit tetrahedron with a buffer file in the folder of the glTF: 4 points (float), 12 indices (uint16), strip and
/// fan indices.
struct TetFile {
  json document;
  std::string buffer;

  template <class T>
  int add(const std::vector<T>& numbers, int component_type, const char* type, int count) {
    json view = {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", numbers.size() * sizeof(T)}};
    buffer.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T));
    document["bufferViews"].push_back(view);
    document["accessors"].push_back({{"bufferView", document["bufferViews"].size() - 1},
                                     {"componentType", component_type},
                                     {"type", type},
                                     {"count", count}});
    return static_cast<int>(document["accessors"].size()) - 1;
  }

  TetFile() {
    document = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", {0}}}}}};
    add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 5126, "VEC3", 4);
    add<std::uint16_t>({0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}, 5123, "SCALAR", 12);
    document["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}};
    document["nodes"] = {{{"mesh", 0}}};
  }

  [[nodiscard]] std::filesystem::path write(const TempFolder& folder) {
    document["buffers"] = {{{"uri", "tet.bin"}, {"byteLength", buffer.size()}}};
    (void)folder.write("tet.bin", buffer);
    return folder.write("tet.gltf", document.dump());
  }
};

TEST(Gltf, ReadsABufferInTheFolderOfTheFile) {
  const TempFolder folder;
  TetFile file;
  const TriMesh mesh = *load_mesh(file.write(folder)).mesh;
  EXPECT_TRUE(mesh.closed());
  EXPECT_NEAR(mesh.volume(), 1.0 / 6.0, 1e-15);
}

TEST(Gltf, AppliesNodesToTheirMeshesAndChildren) {
  const TempFolder folder;
  TetFile file;
  const double h = std::sqrt(0.5);
  file.document["nodes"] = {
      {{"children", {1, 2}}, {"translation", {10, 0, 0}}, {"rotation", {0, 0, h, h}}},  // 90 degrees about z
      {{"mesh", 0}, {"scale", {2, 2, 2}}, {"translation", {0, 5, 0}}},
      {{"mesh", 0}, {"matrix", {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -7, 1}}}};  // a mirror
  const TriMesh mesh = *load_mesh(file.write(folder)).mesh;
  ASSERT_EQ(mesh.shell_count(), 2);
  EXPECT_NEAR(mesh.volume(), 8.0 / 6.0 + 1.0 / 6.0, 1e-12) << "a mirrored node keeps its faces outward";
  // (0,0,0) -> (0,5,0) -> turned (-5,0,0) -> (5,0,0); (1,0,0) -> (2,5,0) -> (-5,2,0) -> (5,2,0)
  EXPECT_NEAR(glm::distance(mesh.vertices()[0], dvec3(5, 0, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(mesh.vertices()[1], dvec3(5, 2, 0)), 0, 1e-12);
  EXPECT_NEAR(mesh.bounds().lo.z, -7, 1e-12);
}

TEST(Gltf, NormalisesRotationsWithinOnePercentAndRefusesOthers) {
  const TempFolder folder;
  TetFile file;
  const double h = std::sqrt(0.5);
  const auto rotate = [&](double length) {
    file.document["nodes"] = {{{"mesh", 0}, {"rotation", {0, 0, length * h, length * h}}}};
    return load_mesh(file.write(folder));
  };
  const LoadedMesh near = rotate(1.008);
  EXPECT_NEAR(near.mesh->volume(), 1.0 / 6.0, 1e-15);
  EXPECT_NEAR(glm::distance(near.mesh->bounds().lo, dvec3(-1, 0, 0)), 0, 1e-15);
  ASSERT_FALSE(near.notes.empty());
  EXPECT_EQ(near.notes.front(), "normalised /nodes/0/rotation: its length is 1.008");
  EXPECT_TRUE(rotate(1).notes.empty());
  for (const double length : {0.0, 0.98, 1.02, 2.0}) EXPECT_THROW(rotate(length), Error) << length;
}

TEST(Gltf, RefusesTextForANumberAndReadsABufferWithoutItsType) {
  const TempFolder folder;
  TetFile file;
  const auto load = [&](const json& length) {
    file.document["buffers"] = {{{"uri", "data:;base64," + base64(file.buffer)}, {"byteLength", length}}};
    return load_mesh(folder.write("tet.gltf", file.document.dump()));
  };
  EXPECT_EQ(load(file.buffer.size()).mesh->face_count(), 4);
  EXPECT_THROW(load(std::to_string(file.buffer.size())), Error);
}

TEST(Gltf, ReadsStripsFansAndListsAlike) {
  const TempFolder folder;
  const auto area_and_normals = [&](TetFile& file, int mode) {
    file.document["meshes"][0]["primitives"][0]["mode"] = mode;
    const TriMesh mesh = *load_mesh(file.write(folder)).mesh;
    for (const dvec3& n : mesh.face_normals()) EXPECT_EQ(n, dvec3(0, 0, 1));
    return mesh.area();
  };
  const auto quad = [](std::vector<float> points) {
    TetFile file;
    const int count = static_cast<int>(points.size()) / 3;
    const int accessor = file.add<float>(points, 5126, "VEC3", count);
    file.document["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", accessor}}}}}}}};
    return file;
  };
  TetFile strip = quad({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0, 1, 2, 0});
  EXPECT_NEAR(area_and_normals(strip, 5), 2, 1e-12);
  TetFile fan = quad({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  EXPECT_NEAR(area_and_normals(fan, 6), 1, 1e-12);
  TetFile list = quad({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0});
  EXPECT_NEAR(area_and_normals(list, 4), 1, 1e-12);
}

TEST(Gltf, SkipsLinesPointsAndUnusedMeshes) {
  const TempFolder folder;
  TetFile file;
  json lines = file.document["meshes"][0];
  lines["primitives"][0]["mode"] = 1;
  file.document["meshes"].push_back(lines);
  file.document["meshes"][0]["primitives"].push_back(lines["primitives"][0]);
  file.document["nodes"].push_back({{"mesh", 0}, {"translation", {9, 9, 9}}});  // not in the scene
  EXPECT_EQ(load_mesh(file.write(folder)).mesh->face_count(), 4);
}

TEST(Gltf, ReadsEveryRootWithoutAScene) {
  const TempFolder folder;
  TetFile file;
  file.document.erase("scene");
  file.document.erase("scenes");
  file.document["nodes"] = {{{"mesh", 0}}, {{"children", {2}}, {"translation", {5, 0, 0}}}, {{"mesh", 0}}};
  EXPECT_EQ(load_mesh(file.write(folder)).mesh->shell_count(), 2);
}

TEST(Gltf, ScalesQuantisedPositionsBack) {
  const TempFolder folder;
  TetFile file;
  const int accessor = file.add<std::int16_t>({0, 0, 0, 32767, 0, 0, 0, 32767, 0, 0, 0, 32767}, 5122, "VEC3", 4);
  file.document["accessors"][static_cast<std::size_t>(accessor)]["normalized"] = true;
  file.document["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = accessor;
  EXPECT_NEAR(load_mesh(file.write(folder)).mesh->volume(), 1.0 / 6.0, 1e-15);
}

TEST(Gltf, IgnoresMissingImages) {
  const TempFolder folder;
  TetFile file;
  file.document["images"] = {{{"uri", "nowhere.png"}}};
  file.document["textures"] = {{{"source", 0}}};
  EXPECT_EQ(load_mesh(file.write(folder)).mesh->face_count(), 4);
}

std::string message_of(TetFile& file) {
  const TempFolder folder;
  const auto path = file.write(folder);
  try {
    load_mesh(path);
  } catch (const Error& error) {
    EXPECT_EQ(error.file(), path.string());
    return error.what();
  }
  ADD_FAILURE() << "was read";
  return "";
}

TEST(Gltf, RefusesReferencesToMissingElements) {
  const auto with = [](const json::json_pointer& place, const json& value) {
    TetFile file;
    file.document[place] = value;
    return message_of(file);
  };
  using Pointer = json::json_pointer;
  EXPECT_NE(with(Pointer("/accessors/0/count"), 5000).find("beyond its buffer"), std::string::npos);
  EXPECT_NE(with(Pointer("/accessors/1/byteOffset"), 1000).find("beyond its buffer view"), std::string::npos);
  EXPECT_NE(with(Pointer("/accessors/0/bufferView"), 9).find("buffer view"), std::string::npos);
  EXPECT_NE(with(Pointer("/meshes/0/primitives/0/attributes/POSITION"), 7).find("does not exist"), std::string::npos);
  EXPECT_NE(with(Pointer("/meshes/0/primitives/0/indices"), 0).find("vertex numbers"), std::string::npos);
  EXPECT_NE(with(Pointer("/nodes/0/mesh"), 3).find("mesh 3"), std::string::npos);
  EXPECT_NE(with(Pointer("/scenes/0/nodes/0"), 4).find("node 4"), std::string::npos);
  EXPECT_NE(with(Pointer("/nodes/0/children"), json::array({0})).find("own descendant"), std::string::npos);
  EXPECT_NE(with(Pointer("/accessors/0/sparse"),
                 {{"count", 1},
                  {"indices", {{"bufferView", 0}, {"byteOffset", 14}, {"componentType", 5123}}},
                  {"values", {{"bufferView", 0}}}})
                .find("accessor 0 sparse indices: no element 16256 (there are 4)"),
            std::string::npos);
  TetFile no_bin;
  no_bin.document["buffers"] = {{{"uri", "none.bin"}, {"byteLength", 4}}};
  const TempFolder folder;
  EXPECT_THROW(load_mesh(folder.write("a.gltf", no_bin.document.dump())), Error);
}

TEST(Gltf, ReplacesElementsOfSparseAccessors) {
  const TempFolder folder;
  TetFile file;
  const auto at_end = [&](int accessor) { return file.document["accessors"][at(accessor)]["bufferView"]; };
  const int elements = file.add<std::uint8_t>({1, 3, 0, 0}, 5121, "SCALAR", 2);
  const int points = file.add<float>({2, 0, 0, 0, 0, 3}, 5126, "VEC3", 2);
  file.document["accessors"][0]["sparse"] = {{"count", 2},
                                             {"indices", {{"bufferView", at_end(elements)}, {"componentType", 5121}}},
                                             {"values", {{"bufferView", at_end(points)}}}};
  EXPECT_NEAR(load_mesh(file.write(folder)).mesh->volume(), 2.0 * 3.0 / 6.0, 1e-15);
  // Without a buffer view, the elements that are not replaced are zeros: then these four points are three, and no
  // volume is left.
  file.document["accessors"][0].erase("bufferView");
  const TriMesh flat = *load_mesh(file.write(folder)).mesh;
  EXPECT_EQ(flat.vertex_count(), 3);
  EXPECT_EQ(flat.vertices()[0], dvec3(0));
}

TEST(Gltf, NamesExtensionsThatItDoesNotRead) {
  const auto with = [](const char* name) {
    TetFile file;
    file.document["extensionsUsed"] = file.document["extensionsRequired"] = {name};
    return message_of(file);
  };
  EXPECT_NE(with("KHR_draco_mesh_compression")
                .find("KHR_draco_mesh_compression, which is not read: export the mesh "
                      "without compression"),
            std::string::npos);
  EXPECT_NE(with("EXT_meshopt_compression").find("without compression"), std::string::npos);
  EXPECT_NE(with("ACME_curved").find("the extension ACME_curved, which is not read"), std::string::npos);
}

TEST(Gltf, RefusesOffsetsWhoseSumWraps) {
  TetFile file;
  const std::uint64_t half = std::uint64_t{1} << 63;  // half + half is 0 in 64 bits
  file.document["bufferViews"][0]["byteOffset"] = half;
  file.document["accessors"][0]["byteOffset"] = half;
  EXPECT_NE(message_of(file).find("buffer view reaches beyond its buffer"), std::string::npos);
  TetFile inside;
  inside.document["bufferViews"][0]["byteLength"] = 12;
  EXPECT_NE(message_of(inside).find("reaches beyond its buffer view"), std::string::npos);
}

TEST(Gltf, RefusesNodesWithSeveralParents) {
  TetFile shared;
  json nodes = json::array();
  for (int i = 1; i <= 30; ++i) nodes.push_back({{"children", {i, i}}});
  nodes.push_back({{"mesh", 0}});
  shared.document["nodes"] = nodes;
  EXPECT_NE(message_of(shared).find("node 30 has several parents"), std::string::npos);
  TetFile twice;
  twice.document["scenes"][0]["nodes"] = {0, 0};
  EXPECT_NE(message_of(twice).find("node 0 has several parents"), std::string::npos);
}

TEST(Gltf, RefusesScenesOfTooManyVertices) {
  TetFile file;
  json primitive = file.document["meshes"][0]["primitives"][0];
  primitive.erase("indices");
  file.buffer.resize(12'000'000);
  file.document["bufferViews"][0]["byteLength"] = file.buffer.size();
  file.document["accessors"][0]["count"] = 1'000'000;
  file.document["meshes"][0]["primitives"] = json::array();
  for (int i = 0; i < 11; ++i) file.document["meshes"][0]["primitives"].push_back(primitive);
  EXPECT_NE(message_of(file).find("more than 10000000 vertices"), std::string::npos);
}

TEST(Gltf, RefusesBuffersThatAreNotRegularFiles) {
  ::alarm(20);  // ends the program if a pipe is opened
  for (const std::string uri : {".", "pipe", "zero", "link", "%70ipe"}) {
    const TempFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    std::filesystem::create_symlink("/dev/zero", folder / "zero");
    std::filesystem::create_symlink("pipe", folder / "link");
    TetFile file;
    const auto path = file.write(folder);
    file.document["buffers"][0]["uri"] = uri;
    (void)folder.write("tet.gltf", file.document.dump());
    try {
      load_mesh(path);
      ADD_FAILURE() << uri << " was read";
    } catch (const Error& error) {
      EXPECT_EQ(error.where(), "/buffers/0/uri");
      const std::string name = uri == "%70ipe" ? "pipe" : uri;
      EXPECT_EQ(error.message(), name + (uri == "." ? ": is a folder, not a file" : ": is not a regular file"));
    }
  }
  ::alarm(0);
}

TEST(Gltf, NamesTheFieldThatIsNotValid) {
  const auto with = [](const char* pointer, const json& value) {
    TetFile file;
    const TempFolder folder;
    (void)file.write(folder);
    file.document[json::json_pointer(pointer)] = value;
    try {
      load_mesh(folder.write("tet.gltf", file.document.dump()));
    } catch (const Error& error) {
      return error.where() + ": " + error.message();
    }
    return std::string("was read");
  };
  EXPECT_EQ(with("/asset", json::object()), "/asset/version: is missing");
  EXPECT_EQ(with("/asset/version", "1.0"), "/asset/version: must be 2.0, the version that is read, is \"1.0\"");
  EXPECT_EQ(with("/buffers/0", json::object()), "/buffers/0/byteLength: is missing");
  EXPECT_EQ(with("/buffers/0", {{"byteLength", 3}}),
            "/buffers/0/uri: is missing, and the file has no bytes for the buffer");
  EXPECT_EQ(with("/buffers/0/uri", "data:,abc"),
            "/buffers/0/uri: must begin with \"data:TYPE;base64,\", begins with \"data:,abc\"");
  EXPECT_EQ(with("/buffers/0/uri", "data:a/b;base64,a*bc"), "/buffers/0/uri: is not Base64");
  EXPECT_EQ(with("/buffers/0/uri", "a%00b"), "/buffers/0/uri: must be the name of a file, has a zero byte");
  EXPECT_EQ(with("/buffers/0/byteLength", 1000),
            "/buffers/0/byteLength: must be at most 72, the number of bytes of the buffer, is 1000");
  EXPECT_EQ(with("/bufferViews/0/buffer", -1), "/bufferViews/0/buffer: must be a whole number, 0 or more, is -1");
  EXPECT_EQ(with("/accessors/0/type", 3), "/accessors/0/type: must be a text, is 3");
  EXPECT_EQ(with("/meshes/0/primitives/0", json::object()), "/meshes/0/primitives/0/attributes: is missing");
  EXPECT_EQ(with("/nodes/0/matrix", {1, 2}), "/nodes/0/matrix: must be an array of 16 numbers, is [1,2]");
  EXPECT_EQ(with("/nodes", 5), "/nodes: must be an array, is 5");
}

TEST(Gltf, ReadsBuffersInTheirUriAndNamesWithEscapes) {
  const TempFolder folder;
  TetFile file;
  (void)file.write(folder);
  file.document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(file.buffer);
  EXPECT_NEAR(load_mesh(folder.write("a.gltf", file.document.dump())).mesh->volume(), 1.0 / 6.0, 1e-15);
  (void)folder.write("a b%.bin", file.buffer);
  file.document["buffers"][0]["uri"] = "a%20b%25.bin";
  EXPECT_NEAR(load_mesh(folder.write("b.gltf", file.document.dump())).mesh->volume(), 1.0 / 6.0, 1e-15);
}

TEST(Gltf, RefusesNan) {
  TetFile file;
  const float nan = std::nanf("");
  std::memcpy(file.buffer.data() + 16, &nan, sizeof nan);
  EXPECT_NE(message_of(file).find("not finite"), std::string::npos);
}

}  // namespace
}  // namespace taxel
