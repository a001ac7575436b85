// Legacy VTK files as skins: surfaces, boundaries of volumes, text and binary, both layouts of cells.
#include <gtest/gtest.h>

#include <bit>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/mesh/mesh_io.h"
#include "fixtures/vtk_files.h"

namespace taxel {
namespace {

using test::vtk_bytes;
using test::VtkCell;
using test::VtkForm;

const std::string kAsciiHead = "# vtk DataFile Version 3.0\nsome title\nASCII\n";
const std::string kTriangle =
    kAsciiHead + "DATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n";

LoadedMesh read(const std::string& bytes) {
  return read_mesh(bytes, "a.vtk");
}

std::string refusal(const std::string& bytes) {
  try {
    read(bytes);
  } catch (const Error& error) {
    EXPECT_EQ(error.file(), "a.vtk");
    return error.what();
  }
  return "";
}

bool has_note(const LoadedMesh& loaded, const std::string& note) {
  return std::find(loaded.notes.begin(), loaded.notes.end(), note) != loaded.notes.end();
}

/// The corners of [0, 2] x [0, 1]^2, and of its halves: (x, y, z) has the number x + 3 (y + 2 z).
std::vector<dvec3> two_cubes() {
  std::vector<dvec3> points;
  for (int i = 0; i < 12; ++i) points.emplace_back(i % 3, i / 3 % 2, i / 6);
  return points;
}

void expect_two_cubes(const LoadedMesh& loaded) {
  EXPECT_TRUE(loaded.mesh->closed());
  EXPECT_EQ(loaded.mesh->face_count(), 20) << "two cubes without the face between them";
  EXPECT_NEAR(loaded.mesh->volume(), 2, 1e-12) << "outward";
}

const std::vector<VtkCell> kHexahedra{{12, {0, 1, 4, 3, 6, 7, 10, 9}}, {12, {1, 2, 5, 4, 7, 8, 11, 10}}};

TEST(Vtk, ReadsAllFormsOfAFileAlike) {
  int forms = 0;
  for (const bool binary : {false, true}) {
    for (const bool offsets : {false, true}) {
      for (const char* number : {"float", "double", "int", "short", "unsigned_char", "long"}) {
        const LoadedMesh loaded = read(vtk_bytes(two_cubes(), kHexahedra, VtkForm{binary, offsets, number}));
        SCOPED_TRACE(testing::Message() << binary << offsets << number);
        expect_two_cubes(loaded);
        EXPECT_TRUE(has_note(loaded, "took the boundary of 2 volume cells: 20 triangles"));
        ++forms;
      }
    }
  }
  EXPECT_EQ(forms, 24);
}

TEST(Vtk, ReadsNumbersOfBinaryFilesToTheLastBit) {
  const std::vector<dvec3> points{{0.1, -1e-30, 3e5}, {1.0 / 3, 2, 0}, {0, 1, 1e-3}};
  const std::vector<VtkCell> triangle{{5, {0, 1, 2}}};
  for (const bool binary : {false, true}) {
    const TriMesh mesh = *read(vtk_bytes(points, triangle, VtkForm{binary, true, "double"})).mesh;
    EXPECT_EQ(mesh.vertices(), points);
  }
  const TriMesh rounded = *read(vtk_bytes(points, triangle, VtkForm{true, true, "float"})).mesh;
  for (int v = 0; v < 3; ++v) EXPECT_EQ(rounded.vertices()[at(v)], dvec3(glm::vec3(points[at(v)])));
}

TEST(Vtk, ReadsEachTypeOfVolumeOutward) {
  const std::vector<dvec3> points = two_cubes();
  const struct {
    const char* name;
    std::vector<VtkCell> cells;
    double volume;
    int faces;
  } kinds[] = {{"tet", {{10, {0, 1, 3, 6}}}, 1.0 / 6, 4},
               {"turned tet", {{10, {1, 0, 3, 6}}}, 1.0 / 6, 4},
               {"voxels", {{11, {0, 1, 3, 4, 6, 7, 9, 10}}, {11, {1, 2, 4, 5, 7, 8, 10, 11}}}, 2, 20},
               {"hexahedra", kHexahedra, 2, 20},
               {"hexahedron upside down", {{12, {6, 7, 10, 9, 0, 1, 4, 3}}}, 1, 12},
               {"wedge", {{13, {0, 1, 3, 6, 7, 9}}}, 0.5, 8},
               {"wedge of the other order", {{13, {0, 3, 1, 6, 9, 7}}}, 0.5, 8},
               {"pyramid", {{14, {0, 1, 4, 3, 6}}}, 1.0 / 3, 6},
               {"hexahedron with a wedge", {kHexahedra[0], {13, {1, 2, 4, 7, 8, 10}}}, 1.5, 16},
               {"hexahedron folded to a wedge", {{12, {0, 1, 3, 3, 6, 7, 9, 9}}}, 0.5, 8}};
  for (const auto& kind : kinds) {
    SCOPED_TRACE(kind.name);
    const TriMesh mesh = *read(vtk_bytes(points, kind.cells, {})).mesh;
    EXPECT_TRUE(mesh.closed());
    EXPECT_EQ(mesh.face_count(), kind.faces);
    EXPECT_NEAR(mesh.volume(), kind.volume, 1e-12);
  }
}

TEST(Vtk, DropsFacesBetweenCellsThatShareOnlyPlaces) {
  std::vector<dvec3> points = two_cubes();
  std::vector<VtkCell> cells = kHexahedra;
  for (int& corner : cells[1].corners) {
    points.push_back(points[at(corner)]);
    corner = static_cast<int>(points.size()) - 1;
  }
  expect_two_cubes(read(vtk_bytes(points, cells, {})));
}

TEST(Vtk, TakesTheCornersOfCurvedCells) {
  std::vector<dvec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  VtkCell cell{24, {0, 1, 2, 3}};
  for (const auto& [a, b] : {std::pair(0, 1), {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}) {
    points.push_back(0.6 * (points[at(a)] + points[at(b)]));
    cell.corners.push_back(static_cast<int>(points.size()) - 1);
  }
  const LoadedMesh loaded = read(vtk_bytes(points, {cell}, {}));
  EXPECT_NEAR(loaded.mesh->volume(), 1.0 / 6, 1e-15);
  EXPECT_TRUE(has_note(loaded, "took only the corners of 1 curved cells: their edges are straight"));
  cell.type = 71;  // a Lagrange tet may have any number of points from four
  EXPECT_EQ(read(vtk_bytes(points, {cell}, {})).mesh->face_count(), 4);
  cell.corners.pop_back();
  cell.type = 24;
  EXPECT_EQ(refusal(vtk_bytes(points, {cell}, {})), "a.vtk: cell 0: has 9 points, a quadratic tet has 10");
}

TEST(Vtk, IgnoresSurfaceCellsThatAreFacesOfVolumes) {
  std::vector<VtkCell> cells = kHexahedra;
  cells.push_back({9, {0, 3, 4, 1}});   // a face of the boundary
  cells.push_back({9, {1, 4, 10, 7}});  // the face between both cubes
  cells.push_back({3, {0, 1}});
  cells.push_back({1, {5}});
  const LoadedMesh loaded = read(vtk_bytes(two_cubes(), cells, {}));
  expect_two_cubes(loaded);
  EXPECT_TRUE(has_note(loaded, "ignored 2 surface cells that are faces of volume cells"));
  EXPECT_TRUE(has_note(loaded, "ignored 2 cells of lines or vertices"));
}

TEST(Vtk, ReadsSurfaceCellsOfAGrid) {
  const std::vector<VtkCell> cells{{5, {0, 3, 4}},         {8, {0, 1, 6, 7}},  {9, {1, 2, 8, 7}},
                                   {7, {6, 8, 11, 10, 9}}, {6, {3, 4, 9, 10}}, {22, {0, 4, 1, 5, 5, 5}}};
  const LoadedMesh loaded = read(vtk_bytes(two_cubes(), cells, {}));
  EXPECT_EQ(loaded.mesh->face_count(), 1 + 2 + 2 + 3 + 2 + 1);
  const auto normal = [&](int face) { return loaded.mesh->face_normals()[at(face)]; };
  for (int f = 1; f < 5; ++f) EXPECT_NEAR(normal(f).y, -1, 1e-12) << "pixel and quad " << f;
  for (int f = 5; f < 8; ++f) EXPECT_NEAR(normal(f).z, 1, 1e-12) << "polygon " << f;
  EXPECT_NEAR(normal(8).y, normal(9).y, 1e-12) << "both triangles of a strip";
}

TEST(Vtk, ReadsPolygonsAndStripsOfPolyData) {
  const LoadedMesh loaded = read(kAsciiHead + R"(DATASET POLYDATA
FIELD FieldData 2
TIME 1 1 double
0.5
cycle 2 1 int 3 4
POINTS 8 float
0 0 0  1 0 0  1 1 0  0 1 0
0 0 1  1 0 1  1 1 1  0 1 1
METADATA
INFORMATION 1
NAME L2_NORM_RANGE LOCATION vtkDataArray
DATA 2 0 1.73

VERTICES 1 2
1 0
LINES 1 3
2 0 1
POLYGONS 2 10
4 0 3 2 1
4 4 5 6 7
TRIANGLE_STRIPS 1 11
10 0 4 3 7 2 6 1 5 0 4
CELL_DATA 5
SCALARS anything float
LOOKUP_TABLE default
not read
)");
  EXPECT_TRUE(loaded.mesh->closed());
  EXPECT_EQ(loaded.mesh->face_count(), 12);
  EXPECT_NEAR(loaded.mesh->volume(), 1, 1e-12);
  EXPECT_TRUE(has_note(loaded, "ignored 2 cells of lines or vertices"));
}

TEST(Vtk, ReadsFilesWithoutATitleAndWithWindowsLines) {
  EXPECT_EQ(read("# vtk DataFile Version 2.0\n\nASCII\n" + kTriangle.substr(kAsciiHead.size())).mesh->face_count(), 1);
  EXPECT_EQ(
      read("# vtk DataFile Version 2.0\nBINARY\nASCII\n" + kTriangle.substr(kAsciiHead.size())).mesh->face_count(), 1)
      << "a title that is a word of the third line";
  std::string windows;
  for (const char c : kTriangle) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(read(windows).mesh->face_count(), 1);
}

TEST(Vtk, RefusesAnnouncedSizesBeforeTakingMemory) {
  const auto expect = [](const std::string& bytes, const std::string& message) {
    EXPECT_EQ(refusal(bytes), "a.vtk: " + message);
  };
  const std::string points = kAsciiHead + "DATASET POLYDATA\nPOINTS ";
  expect(points + "4000000000 float\n0 0 0\n",
         "line 5: is cut off: 4000000000 points need at least 23999999999 bytes, the file has 91");
  expect(points + "9223372036854775807 float\n0 0 0\n",
         "line 5: is cut off: 9223372036854775807 points need at least 55340232221128654848 bytes, the file has 100");
  expect(points + "1 float\n0 0 0\nPOLYGONS 4000000000 8000000000\n1 0\n",
         "line 7: is cut off: 8000000000 numbers of cells need at least 15999999999 bytes, the file has 117");
  expect(points + "1 float\n0 0 0\nPOLYGONS 4000000000 1\nOFFSETS vtktypeint64\n0 1\n",
         "line 8: is cut off: 4000000000 offsets need at least 7999999999 bytes, the file has 129");
  const std::string binary = "# vtk DataFile Version 5.1\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 2 double\n";
  expect(binary + std::string(47, '\0'),
         "byte 78: is cut off: 2 points need at least 48 bytes, the rest of the file has 47");
  const std::string cells =
      binary + std::string(48, '\0') + "\nCELLS 3 4000000000\nOFFSETS vtktypeint64\n" + std::string(24, '\0');
  expect(cells, "byte 191: the last offset is 0, must be 4000000000");
}

TEST(Vtk, RefusesOtherFilesWithTheRemedy) {
  const auto expect = [](const std::string& bytes, const std::string& message) {
    EXPECT_EQ(refusal(bytes), "a.vtk: " + message);
  };
  expect(kAsciiHead + "DATASET STRUCTURED_GRID\n",
         "line 4: is a data set 'STRUCTURED_GRID'; only POLYDATA and UNSTRUCTURED_GRID are read: save its surface as "
         "POLYDATA (Extract Surface in ParaView)");
  expect("# vtk DataFile Version 6.0\nt\nASCII\n",
         "line 1: is of version 6.0; versions up to 5.1 are read: save it in an older one");
  expect("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\">\n",
         "is a VTK XML file; only legacy VTK files are read: save it as legacy VTK (.vtk), with ParaView or PyVista");
  expect(vtk_bytes(two_cubes(), {{42, {0, 1, 2, 3}}}, {}),
         "cell 0: is of type 42, which is not read: cut the cells into tets or triangles (Tetrahedralize in ParaView)");
  expect(vtk_bytes(two_cubes(), {{3, {0, 1}}, {1, {0}}}, {}), "has no triangles: its 2 cells are lines or vertices");
  expect(vtk_bytes(two_cubes(), {kHexahedra[0], kHexahedra[0], kHexahedra[0]}, {}),
         "cell 2: has a face that cells 0 and 1 have too: two cells at most can share a face");
  expect(vtk_bytes(two_cubes(), {{5, {0, 1}}}, {}), "cell 0: has 2 points, a triangle has 3");
  for (const char* name : {"a.vtp", "B.VTU"}) {
    try {
      read_mesh("<VTKFile>", name);
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_NE(error.message().find("save it as legacy VTK (.vtk)"), std::string::npos) << error.what();
    }
  }
}

TEST(Vtk, NamesThePlaceOfDamage) {
  const auto expect = [](const std::string& bytes, const std::string& message) {
    EXPECT_EQ(refusal(bytes), "a.vtk: " + message);
  };
  const std::string points = kAsciiHead + "DATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n";
  expect(points + "POLYGONS 1 4\n3 0 1 3\n", "line 8: polygon 0: no point 3 (there are 3)");
  expect(points + "POLYGONS 1 4\n3 0 1 -1\n", "line 8: polygon 0: no point -1 (there are 3)");
  expect(points + "POLYGONS 1 4\n4 0 1 2 0\n",
         "line 8: polygon 0 has 4 corners, but 1 polygons are announced to be 4 numbers");
  expect(points + "POLYGONS 1 5\n3 0 1 2\n", "line 8: 1 polygons are announced to be 5 numbers, but are 4");
  expect(points + "POLYGONS 2 1\n3 0 1 2\n", "line 7: 2 polygons cannot be in 1 numbers");
  expect(points + "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 4\n", "line 9: offset 1 is 4, must be 0 to 3");
  expect(points + "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 3\nPOLYGONS\n", "line 10: CONNECTIVITY must follow OFFSETS");
  expect(points + "POLYGONS 2 3\nOFFSETS int96\n0 3\n", "line 8: unknown type of number 'int96'");
  expect(points + "CELLS 1 4\n3 0 1 2\n", "line 7: 'CELLS' is not expected here");
  expect(points, "line 6: has no POLYGONS");
  expect(kAsciiHead + "DATASET POLYDATA\nPOLYGONS 1 4\n3 0 1 2\n", "line 6: polygon 0: no point 0 (there are 0)");
  const auto number = [](double x) {
    std::string bytes(8, '\0');
    const auto bits = std::bit_cast<std::uint64_t>(x);
    for (int i = 0; i < 8; ++i) bytes[at(i)] = static_cast<char>(bits >> (56 - 8 * i));
    return bytes;
  };
  expect("# vtk DataFile Version 5.1\nt\nBINARY\nDATASET POLYDATA\nPOINTS 1 double\n" + number(0) + number(NAN) +
             number(1),
         "byte 85: nan is not finite");
}

}  // namespace
}  // namespace taxel
