// Mesh files: reading, Welding, writing and round trips.
#include "core/mesh/mesh_io.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <map>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/mesh/formats/mesh_format.h"
#include "fixtures/temp_folder.h"
#include "unit/mesh/random_mesh.h"

namespace taxel {
namespace {

using test::TempFolder;

TriMesh odd_numbers() {
  const TriMesh sphere = make_icosphere(0.1, 2);
  std::vector<dvec3> vertices = sphere.vertices();
  for (dvec3& v : vertices) v = v * 1.0e-2 + dvec3(1.0 / 3.0, -1e-17, 12345.678901234567);
  return {std::move(vertices), sphere.faces()};
}

TEST(MeshIo, KeepsObjAndOffToTheLastDigit) {
  const TempFolder folder;
  const TriMesh mesh = odd_numbers();
  for (const char* name : {"a.obj", "b.off"}) {
    save_mesh(folder / name, mesh);
    const LoadedMesh loaded = load_mesh(folder / name);
    EXPECT_TRUE(loaded.mesh->vertices() == mesh.vertices()) << name;
    EXPECT_TRUE(loaded.mesh->faces() == mesh.faces()) << name;
    EXPECT_TRUE(loaded.notes.empty()) << name;
    EXPECT_EQ(loaded.sha256, sha256_hex(read_file(folder / name)));
  }
}

TEST(MeshIo, KeepsStlAndGlbInSinglePrecision) {
  const TempFolder folder;
  const TriMesh mesh = make_icosphere(0.1, 2);
  for (const char* name : {"a.stl", "b.glb"}) {
    save_mesh(folder / name, mesh);
    const TriMesh loaded = *load_mesh(folder / name).mesh;
    ASSERT_EQ(loaded.vertex_count(), mesh.vertex_count()) << name;
    ASSERT_EQ(loaded.face_count(), mesh.face_count()) << name;
    EXPECT_TRUE(loaded.closed());
    for (int f = 0; f < mesh.face_count(); ++f) {
      for (int c = 0; c < 3; ++c) EXPECT_EQ(glm::vec3(loaded.vertex(f, c)), glm::vec3(mesh.vertex(f, c)));
    }
  }
}

TEST(MeshFormat, ListsExtensionsForReadingAndWriting) {
  EXPECT_EQ(extensions(can_read), ".obj .stl .ply .off .gltf .glb .vtk");
  EXPECT_EQ(extensions(can_write), ".obj .stl .off .glb");
}

TEST(MeshFormat, HasOneRowPerExtension) {
  for (const MeshFormat& format : kMeshFormats) {
    EXPECT_EQ(find_mesh_format("folder.x/mesh" + std::string(format.extension)), &format) << format.extension;
    EXPECT_TRUE(can_read(format) || can_write(format)) << format.extension;
    EXPECT_FALSE(format.name.empty()) << format.extension;
  }
}

TEST(MeshIo, AcceptsExtensionsInAnyCase) {
  const TempFolder folder;
  save_mesh(folder / "A.OBJ", make_box(dvec3(1)));
  EXPECT_EQ(load_mesh(folder / "A.OBJ").mesh->face_count(), 12);
  for (const char* name : {"a.obj", "a.STL", "a.ply", "a.Off", "a.gltf", "a.glb"})
    EXPECT_TRUE(is_mesh_file(name)) << name;
  for (const char* name : {"a.txt", "obj", "a.obj.zip", "a"}) EXPECT_FALSE(is_mesh_file(name)) << name;
  EXPECT_THROW(save_mesh(folder / "a.ply", make_box(dvec3(1))), Error);
}

TEST(MeshIo, ReportsProgressWithinItsPart) {
  const TempFolder folder;
  save_mesh(folder / "a.stl", make_box(dvec3(1)));
  Progress progress;
  load_mesh(folder / "a.stl", dvec3(1), &progress);
  EXPECT_EQ(progress.fraction(), 1);
  EXPECT_STREQ(progress.step(), "Welding vertices");
  {
    const ProgressPart part(&progress, 0.25, 0.75);
    load_mesh(folder / "a.stl", dvec3(1), &progress);
    EXPECT_EQ(progress.fraction(), 0.75);
  }
  progress.cancel();
  EXPECT_THROW(load_mesh(folder / "a.stl", dvec3(1), &progress), Cancelled);
}

TEST(MeshIo, KnowsHowLongLoadingTakesByTheSizeOfTheFile) {
  const TempFolder folder;
  EXPECT_EQ(fraction_of_loading(folder / "gone.stl"), 0.1);
  save_mesh(folder / "a.stl", make_box(dvec3(1)));
  EXPECT_EQ(fraction_of_loading(folder / "a.stl"), 0.1);
  std::filesystem::resize_file(folder / "a.stl", 40'000'000);
  EXPECT_NEAR(fraction_of_loading(folder / "a.stl"), 0.4, 1e-12);
  std::filesystem::resize_file(folder / "a.stl", 900'000'000);  // without data on the disk
  EXPECT_EQ(fraction_of_loading(folder / "a.stl"), 0.8);
}

constexpr const char* kTetPoints = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

TEST(MeshIo, ReadsEveryFormOfAFaceInObj) {
  const TempFolder folder;
  const auto path =
      folder.write("a.obj",
                   "# a comment\r\nmtllib x.mtl\no part\nv 0 0 0 # behind\r\nv 1 0 0 0.5 0.5 0.5\nvt 0 0\n"
                   "vn 0 0 1\nv 0 1 0\nusemtl skin\ns off\nf 1/1/1 3/1/1 2/1/1\nf 1//1 2//1 4//1\n"
                   "v 0 0 1e+0\nf 2/1 3/1 -1/1\nf -4 \\\n -1 -2\n");
  const LoadedMesh loaded = load_mesh(path);
  EXPECT_EQ(loaded.mesh->face_count(), 4);
  EXPECT_TRUE(loaded.mesh->closed());
  EXPECT_NEAR(loaded.mesh->volume(), 1.0 / 6.0, 1e-15);
}

TEST(MeshIo, CountsNegativeIndicesFromThePrecedingVertices) {
  const TempFolder folder;
  const auto path =
      folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 9 9 9\nv 9 8 9\nv 8 9 9\nf -3 -2 -1\n");
  const TriMesh mesh = *load_mesh(path).mesh;
  EXPECT_EQ(mesh.face_count(), 2);
  EXPECT_EQ(mesh.vertex(0, 1), dvec3(1, 0, 0));
  EXPECT_EQ(mesh.vertex(1, 0), dvec3(9, 9, 9));
}

TEST(MeshIo, ReadsCommentsColoursAndPolygonsInOff) {
  const TempFolder folder;
  const auto path =
      folder.write("a.off",
                   "COFF # header\n# counts\n8 6 12\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n1 1 0\n0 1 0\n\n0 0 1\n"
                   "1 0 1\n1 1 1\n0 1 1\n4 3 2 1 0\n4 4 5 6 7 255 0 0\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  const LoadedMesh loaded = load_mesh(path);
  EXPECT_EQ(loaded.mesh->face_count(), 12);
  EXPECT_TRUE(loaded.mesh->closed());
  EXPECT_NEAR(loaded.mesh->volume(), 1, 1e-15);
  EXPECT_EQ(loaded.notes, std::vector<std::string>{"cut 6 polygons into triangles"});
}

TEST(MeshIo, MergesVerticesOfAsciiStl) {
  const TempFolder folder;
  std::string text = "solid tet\n";
  const TriMesh tet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  for (int f = 0; f < 4; ++f) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (int c = 0; c < 3; ++c) {
      const dvec3 p = tet.vertex(f, c);
      text += "  vertex " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    }
    text += " endloop\nendfacet\n";
  }
  const LoadedMesh loaded = load_mesh(folder.write("a.stl", text + "endsolid tet\n"));
  EXPECT_EQ(loaded.mesh->vertex_count(), 4);
  EXPECT_TRUE(loaded.mesh->closed());
  EXPECT_EQ(loaded.notes, std::vector<std::string>{"welded 8 duplicate vertices"});
}

TEST(MeshIo, ReadsBinaryStlThatBeginsWithSolid) {
  const TempFolder folder;
  save_mesh(folder / "a.stl", make_box(dvec3(1)));
  std::string bytes = read_file(folder / "a.stl");
  bytes.replace(0, 5, "solid");
  EXPECT_EQ(load_mesh(folder.write("b.stl", bytes)).mesh->face_count(), 12);
}

/// Returns a tetrahedron as PLY with numbers of these types, and with properties that the reader skips.
template <class Real, class Count, class Index>
std::string ply(const char* format, const std::string& types, bool big_endian) {
  std::string bytes = std::string("ply\nformat ") + format + " 1.0\ncomment end_header is not here\nelement junk 2\n" +
                      "property uchar a\nelement vertex 4\n" + types + "end_header\n";
  const auto put = [&](auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (big_endian) std::reverse(raw, raw + sizeof value);
    bytes.append(raw, sizeof value);
  };
  put(std::uint8_t{1});
  put(std::uint8_t{2});
  for (const dvec3& p : {dvec3(0, 0, 0), dvec3(0.1, 0, 0), dvec3(0, 0.1, 0), dvec3(0, 0, 0.1)}) {
    put(std::int16_t{-1});
    for (int i = 0; i < 3; ++i) put(static_cast<Real>(p[i]));
  }
  for (const ivec3& f : {ivec3(0, 2, 1), ivec3(0, 1, 3), ivec3(1, 2, 3), ivec3(0, 3, 2)}) {
    put(static_cast<Count>(3));
    for (int i = 0; i < 3; ++i) put(static_cast<Index>(f[i]));
    put(1.5F);
  }
  return bytes;
}

TEST(MeshIo, ReadsPlyInBothByteOrdersAndKeepsDoubles) {
  const TempFolder folder;
  const std::string doubles =
      "property short s\nproperty double x\nproperty double y\nproperty double z\n"
      "element face 4\nproperty list uchar int vertex_indices\nproperty float quality\n";
  const std::string floats =
      "property int16 s\nproperty float32 x\nproperty float32 y\nproperty float32 z\n"
      "element face 4\nproperty list ushort uint16 vertex_index\nproperty float quality\n";
  const auto little =
      folder.write("a.ply", ply<double, std::uint8_t, std::int32_t>("binary_little_endian", doubles, false));
  const auto big = folder.write("b.ply", ply<double, std::uint8_t, std::int32_t>("binary_big_endian", doubles, true));
  const auto single =
      folder.write("c.ply", ply<float, std::uint16_t, std::uint16_t>("binary_big_endian", floats, true));
  for (const auto& path : {little, big}) {
    const TriMesh mesh = *load_mesh(path).mesh;
    EXPECT_TRUE(mesh.closed());
    EXPECT_EQ(mesh.vertices()[1].x, 0.1);
  }
  EXPECT_EQ(load_mesh(single).mesh->vertices()[1].x, static_cast<double>(0.1F));
  EXPECT_TRUE(load_mesh(single).mesh->closed());
}

TEST(MeshIo, ReadsPlyStripsAsTheFacesThatTheyAre) {
  const TempFolder folder;
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  const LoadedMesh one = load_mesh(folder.write("one.ply", head + "6 0 2 1 3 0 2\n"));
  EXPECT_EQ(one.mesh->face_count(), 4);
  EXPECT_NEAR(one.mesh->volume(), 1.0 / 6.0, 1e-15);
  const LoadedMesh two = load_mesh(folder.write("two.ply", head + "9 0 2 1 3 -1 2 0 3 1\n"));
  EXPECT_EQ(two.mesh->face_count(), 4);
  EXPECT_TRUE(two.mesh->closed());
  EXPECT_THROW(load_mesh(folder.write("bad.ply", head + "4 0 2 1 4\n")), Error);
  EXPECT_THROW(load_mesh(folder.write("worse.ply", head + "4 0 2 1 -2\n")), Error);
}

TEST(MeshIo, ReadsKeywordsInCapitalsAndTextsAfterAByteOrderMark) {
  const TempFolder folder;
  const TriMesh box = make_box({1, 2, 3});
  std::string stl = "solid box\n";
  for (int f = 0; f < box.face_count(); ++f) {
    stl += "facet normal 0 0 0\nouter loop\n";
    for (int c = 0; c < 3; ++c)
      stl += fmt::format("vertex {} {} {}\n", box.vertex(f, c).x, box.vertex(f, c).y, box.vertex(f, c).z);
    stl += "endloop\nendfacet\n";
  }
  stl += "endsolid box\n";
  std::string capitals = stl;
  for (char& c : capitals) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  const std::string mark = "\xEF\xBB\xBF";
  const std::map<std::string, std::string> files{{"capitals.stl", capitals},
                                                 {"mark.stl", mark + stl},
                                                 {"both.stl", mark + capitals},
                                                 {"mark.obj", mark + write_obj(box)},
                                                 {"mark.off", mark + write_off(box)}};
  for (const auto& [name, bytes] : files) {
    const LoadedMesh read = load_mesh(folder.write(name, bytes));
    EXPECT_EQ(read.mesh->face_count(), 12) << name;
    EXPECT_NEAR(read.mesh->volume(), 48, 1e-12) << name;
  }
}

TEST(MeshIo, ReadsPolygonsInAsciiPly) {
  const TempFolder folder;
  const auto path =
      folder.write("a.ply",
                   "ply\nformat ascii 1.0\nelement vertex 4\nproperty float z\nproperty float x\nproperty float y\n"
                   "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                   "0 0 0\n0 1 0\n0 1 1\n0 0 1\n4 0 1 2 3\n");
  const LoadedMesh loaded = load_mesh(path);
  EXPECT_NEAR(loaded.mesh->area(), 1, 1e-15);
  EXPECT_EQ(loaded.mesh->face_normals()[0], dvec3(0, 0, 1));
}

TEST(MeshIo, AppliesTheScaleAndKeepsNormalsOutwardIfMirrored) {
  const TempFolder folder;
  save_mesh(folder / "a.off", make_box({1, 2, 3}));
  const TriMesh scaled = *load_mesh(folder / "a.off", dvec3(0.001)).mesh;
  EXPECT_NEAR(scaled.volume(), 48e-9, 1e-20);
  const TriMesh mirrored = *load_mesh(folder / "a.off", {-1, 1, 2}).mesh;
  EXPECT_NEAR(mirrored.volume(), 96, 1e-12);
  const TriMesh turned = *load_mesh(folder / "a.off", {-1, -1, 1}).mesh;
  EXPECT_NEAR(turned.volume(), 48, 1e-12);
}

TEST(MeshIo, ReadsZerosWithoutASign) {
  const TempFolder folder;
  const auto path = folder.write("a.obj", "v 0 0 0\nv 1 -0 0\nv 0 1 0\nf 1 2 3\n");
  const TriMesh mirrored = *load_mesh(path, {-1, -1, -1}).mesh;
  for (const dvec3& v : mirrored.vertices()) {
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(v[i] != 0 || !std::signbit(v[i]));
  }
}

TEST(MeshIo, RecordsRepairsAsNotes) {
  const TempFolder folder;
  const auto path = folder.write("a.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n") +
                                              "v -0 0 0\nv 7 7 7\nv 0.5 0 0\n"
                                              // A tetrahedron; vertex 5 equals vertex 1.
                                              "f 1 3 2\nf 5 2 4\nf 2 3 4\nf 1 4 3\n"
                                              "f 3 2 5\n"           // the first face again
                                              "f 1 5 2\nf 1 7 2\n"  // faces without area
                                              "f 1 2\n");
  const LoadedMesh loaded = load_mesh(path);
  EXPECT_TRUE(loaded.mesh->closed());
  EXPECT_EQ(loaded.mesh->vertex_count(), 4);
  EXPECT_EQ(loaded.notes,
            (std::vector<std::string>{"welded 1 duplicate vertices", "dropped 1 polygons of fewer than three corners",
                                      "dropped 2 triangles without area (first: triangle 5)",
                                      "dropped 1 repeated triangles (first: triangle 4)",
                                      "dropped 2 vertices that no triangle uses"}));
}

TEST(MeshIo, KeepsTinyTrianglesAndDropsOnlyRounding) {
  const TempFolder folder;
  const auto path = folder.write("a.obj",
                                 // A nanometre: a real triangle.
                                 "v 0 0 0\nv 1e-9 0 0\nv 0 1e-9 0\nf 1 2 3\n"
                                 "v 0.1 0.2 0.3\nv 0.2 0.4 0.6\nv 0.3 0.6 0.9\nf 4 5 6\n");  // a line up to rounding
  EXPECT_EQ(load_mesh(path).mesh->face_count(), 1);
}

TEST(MeshIo, KeepsFacesOnBothSidesOfASheet) {
  const TempFolder folder;
  const auto path = folder.write("a.off", std::string("OFF 4 2 0\n") + kTetPoints + "3 0 1 2\n3 0 2 1\n");
  EXPECT_EQ(load_mesh(path).mesh->face_count(), 2);
}

TEST(MeshIo, SavesAtomicallyAndNamesTheFileInErrors) {
  const TempFolder folder;
  try {
    save_mesh(folder / "missing/a.obj", make_box(dvec3(1)));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("missing/a.obj"), std::string::npos);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace taxel
