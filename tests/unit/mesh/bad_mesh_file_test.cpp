// Broken mesh files: each gives an error that names the file and the fault.
#include <gtest/gtest.h>

#include <cstring>

#include "core/base/error.h"
#include "core/mesh/mesh_io.h"
#include "fixtures/temp_folder.h"
#include "unit/mesh/random_mesh.h"

namespace taxel {
namespace {

using test::TempFolder;

/// Returns the message of the Error that loading throws. Fails the test if the file loads, or if its name is missing.
std::string message_of(const std::filesystem::path& path, const dvec3& scale = dvec3(1)) {
  try {
    const LoadedMesh loaded = load_mesh(path, scale);
    ADD_FAILURE() << path << " was read: " << loaded.mesh->face_count() << " faces";
  } catch (const Error& error) {
    EXPECT_EQ(error.file(), path.string());
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "one line: " << error.what();
    return error.where() + ": " + error.message();
  }
  return "";
}

struct Bad {
  const char* name;
  const char* bytes;
  const char* expected;  ///< part of the message
};

class BadMeshFile : public testing::TestWithParam<Bad> {};

TEST_P(BadMeshFile, IsAnErrorThatNamesFileAndPlace) {
  const TempFolder folder;
  const Bad& bad = GetParam();
  const std::string message = message_of(folder.write(bad.name, bad.bytes));
  EXPECT_NE(message.find(bad.expected), std::string::npos) << message;
}

constexpr Bad kBad[] = {
    {"empty.obj", "", "empty"},
    {"empty.stl", "", "empty"},
    {"empty.ply", "", "empty"},
    {"empty.off", "", "empty"},
    {"empty.gltf", "", "empty"},
    {"empty.glb", "", "empty"},
    {"garbage.obj", "once upon a time\n", "no triangles"},
    {"garbage.stl", "once upon a time\n", "not an STL file"},
    {"garbage.ply", "once upon a time\n", "not a PLY file"},
    {"garbage.off", "once upon a time\n", "not an OFF file"},
    {"garbage.gltf", "once upon a time\n", "not valid glTF"},
    {"garbage.glb", "once upon a time\n", "not valid glTF"},
    {"points_only.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "no triangles"},
    {"flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "no triangles"},
    {"nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", "line 2: coordinate is not finite"},
    {"infinite.obj", "v 0 0 0\nv 1 0 0\nv 0 -inf 0\nf 1 2 3\n", "line 3: coordinate is not finite"},
    {"huge.obj", "v 0 0 0\nv 1e999 0 0\nv 0 1 0\nf 1 2 3\n", "line 2: '1e999' is not a number"},
    {"word.obj", "v 0 0 0\nv 1 zero 0\nv 0 1 0\nf 1 2 3\n", "line 2: 'zero' is not a number"},
    {"short.obj", "v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n", "line 2: a number is missing"},
    {"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "line 4: no vertex 4 (there are 3)"},
    {"zero.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "line 4: no vertex 0"},
    {"negative.obj", "v 0 0 0\nv 1 0 0\nf -1 -2 -3\nv 0 1 0\n", "line 3: no vertex -3"},
    {"overflow.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999999999999\n", "line 4"},
    {"nan.stl", "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 nan 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n",
     "line 5: coordinate is not finite"},
    {"cut.stl", "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n", "cut off"},
    {"two.stl", "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\nendsolid\n", "line 6"},
    {"none.stl", "solid\nendsolid\n", "no triangles"},
    {"counts.off", "OFF\n3\n", "a number is missing"},
    {"many.off", "OFF\n-3 1 0\n", "-3 vertices"},
    {"vertices.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n", "cut off: 2 of 3 vertices"},
    {"faces.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "cut off: 1 of 2 faces"},
    {"index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "line 6: no vertex 3"},
    {"corners.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n", "line 6"},
    {"nan.off", "OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n", "line 4: coordinate is not finite"},
    {"4d.off", "4OFF\n3 1 0\n", "three dimensions"},
    {"binary.off", "OFF BINARY\n", "binary OFF"},
    {"header.ply", "ply\nformat ascii 1.0\nelement vertex 3\n", "end_header"},
    {"format.ply", "ply\nformat morse 1.0\nend_header\n", "line 2: unknown format"},
    {"type.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty quad x\nend_header\n",
     "line 4: unknown number type"},
    {"orphan.ply", "ply\nformat ascii 1.0\nproperty float x\nend_header\n", "before the first element"},
    {"count.ply", "ply\nformat ascii 1.0\nelement vertex -3\nend_header\n", "line 3"},
    {"cut.ply",
     "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 "
     "0\n1",
     "cut off"},
    {"no_z.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
     "header: element 'vertex' has no property 'z'"},
    {"no_rows.ply",
     "ply\nformat ascii 1.0\nelement vertex 3\nelement face 1\nproperty list uchar int vertex_indices\n"
     "end_header\n3 0 1 2\n",
     "header: element 'vertex' has no property 'x'"},
    {"two_vertex.ply", "ply\nformat ascii 1.0\nelement vertex 3\nelement vertex 3\nend_header\n",
     "header: must have one element 'vertex', has 2"},
    {"no_newline.ply",
     "ply\nformat binary_little_endian 1.0\nelement a 2000000000\nproperty double q\nelement vertex 3\nproperty "
     "float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n"
     "end_header",
     "header: is cut off: 2000000000 elements 'a' need at least 16000000000 bytes, the rest of the file has 0"},
    {"one_vertex.ply",
     "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty char x\nproperty char y\nproperty char z\n"
     "end_header",
     "is cut off"},
    {"index.ply",
     "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
     "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
     "vertex number 3"},
    {"list.ply",
     "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list int int "
     "vertex_indices\nend_header\n\xff\xff\xff\x7f",
     "list length"},
};

INSTANTIATE_TEST_SUITE_P(All, BadMeshFile, testing::ValuesIn(kBad), [](const auto& test) {
  std::string name = test.param.name;
  std::replace(name.begin(), name.end(), '.', '_');
  return (name[0] >= '0' && name[0] <= '9' ? "In" : "") + name;
});

TEST(BadMesh, IsNamedIfMissingUnknownOrAFolder) {
  const TempFolder folder;
  EXPECT_NE(message_of(folder / "none.obj").find("no such file"), std::string::npos);
  EXPECT_NE(message_of(folder.write("a.doc", "x")).find("unknown mesh format"), std::string::npos);
  std::filesystem::create_directory(folder / "folder.obj");
  EXPECT_NE(message_of(folder / "folder.obj").find("folder"), std::string::npos);
}

TEST(BadMesh, IsRefusedIfTheScaleFlattensOrOverflows) {
  const TempFolder folder;
  save_mesh(folder / "a.obj", make_box(dvec3(1)));
  EXPECT_NE(message_of(folder / "a.obj", {1, 0, 1}).find("scale"), std::string::npos);
  EXPECT_NE(message_of(folder / "a.obj", {1, std::nan(""), 1}).find("scale"), std::string::npos);
  EXPECT_NE(message_of(folder.write("b.obj", "v 0 0 0\nv 1e300 0 0\nv 0 1 0\nf 1 2 3\n"), dvec3(1e10)).find("vertex 1"),
            std::string::npos);
}

TEST(BadMesh, NamesTheTriangleOfNanInABinaryStl) {
  const TempFolder folder;
  save_mesh(folder / "a.stl", make_box(dvec3(1)));
  std::string bytes = read_file(folder / "a.stl");
  const float nan = std::nanf("");
  std::memcpy(bytes.data() + 84 + 50 * 7 + 12 + 16, &nan, sizeof nan);
  EXPECT_NE(message_of(folder.write("b.stl", bytes)).find("triangle 7"), std::string::npos);
}

TEST(BadMesh, IsAnErrorForEveryCutOfABinaryStl) {
  const TempFolder folder;
  save_mesh(folder / "a.stl", make_box(dvec3(1)));
  const std::string bytes = read_file(folder / "a.stl");
  for (std::size_t size = 1; size < bytes.size(); size += 37) message_of(folder.write("b.stl", bytes.substr(0, size)));
}

TEST(BadMesh, IsAnErrorForEveryCutOfABinaryPly) {
  const TempFolder folder;
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::size_t header = bytes.size();
  const float points[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const int corners[3] = {0, 1, 2};
  bytes.append(reinterpret_cast<const char*>(points), sizeof points);
  bytes += '\3';
  bytes.append(reinterpret_cast<const char*>(corners), sizeof corners);
  EXPECT_EQ(load_mesh(folder.write("whole.ply", bytes)).mesh->face_count(), 1);
  for (std::size_t size = header; size < bytes.size(); ++size)
    EXPECT_NE(message_of(folder.write("cut.ply", bytes.substr(0, size))).find("cut off"), std::string::npos);
}

/// Any change of a few bytes must either load or give an Error.
void expect_no_crash(const TempFolder& folder, const std::string& name, std::uint64_t seed) {
  save_mesh(folder / name, make_icosphere(1, 0));
  const std::string good = read_file(folder / name);
  test::RandomStream random(seed);
  int errors = 0;
  for (int i = 0; i < 150; ++i) {
    std::string bytes = good.substr(0, static_cast<std::size_t>(random.below(static_cast<int>(good.size()))) + 1);
    if (i % 2 == 0) bytes = good;
    for (int k = random.below(6); k >= 0; --k)
      bytes[static_cast<std::size_t>(random.below(static_cast<int>(bytes.size())))] =
          static_cast<char>(random.below(256));
    try {
      load_mesh(folder.write("changed" + name, bytes));
    } catch (const Error&) {
      ++errors;
    }
  }
  EXPECT_GT(errors, 20);
}

TEST(BadMesh, NeverCrashesForChangedBytes) {
  const TempFolder folder;
  expect_no_crash(folder, "a.obj", 1);
  expect_no_crash(folder, "a.stl", 2);
  expect_no_crash(folder, "a.off", 3);
  expect_no_crash(folder, "a.glb", 4);
}

}  // namespace
}  // namespace taxel
