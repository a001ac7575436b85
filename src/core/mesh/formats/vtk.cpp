// Legacy VTK files as surfaces: polygons and strips, and the boundary of cells that enclose a volume. The table of the
// types of cells.

#include "core/mesh/formats/vtk.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/mesh/formats/mesh_format.h"

namespace taxel {
namespace {

constexpr std::array<VtkCellType, 45> kTypes{{{0, "empty cell", 3, 0},
                                              {1, "vertex", 3, 1},
                                              {2, "list of vertices", 3, 0},
                                              {3, "line", 3, 2},
                                              {4, "polyline", 3, 0},
                                              {5, "triangle", 5, 3},
                                              {6, "triangle strip", 6, 0},
                                              {7, "polygon", 7, 0},
                                              {8, "pixel", 8, 4},
                                              {9, "quad", 9, 4},
                                              {10, "tet", 10, 4},
                                              {11, "voxel", 11, 8},
                                              {12, "hexahedron", 12, 8},
                                              {13, "wedge", 13, 6},
                                              {14, "pyramid", 14, 5},
                                              {21, "quadratic edge", 3, 3},
                                              {22, "quadratic triangle", 5, 6},
                                              {23, "quadratic quad", 9, 8},
                                              {24, "quadratic tet", 10, 10},
                                              {25, "quadratic hexahedron", 12, 20},
                                              {26, "quadratic wedge", 13, 15},
                                              {27, "quadratic pyramid", 14, 13},
                                              {28, "biquadratic quad", 9, 9},
                                              {29, "triquadratic hexahedron", 12, 27},
                                              {30, "quadratic linear quad", 9, 6},
                                              {31, "quadratic linear wedge", 13, 12},
                                              {32, "biquadratic quadratic wedge", 13, 18},
                                              {33, "biquadratic quadratic hexahedron", 12, 24},
                                              {34, "biquadratic triangle", 5, 7},
                                              {35, "cubic line", 3, 4},
                                              {37, "triquadratic pyramid", 14, 19},
                                              {68, "Lagrange curve", 3, 0},
                                              {69, "Lagrange triangle", 5, 0},
                                              {70, "Lagrange quad", 9, 0},
                                              {71, "Lagrange tet", 10, 0},
                                              {72, "Lagrange hexahedron", 12, 0},
                                              {73, "Lagrange wedge", 13, 0},
                                              {74, "Lagrange pyramid", 14, 0},
                                              {75, "Bezier curve", 3, 0},
                                              {76, "Bezier triangle", 5, 0},
                                              {77, "Bezier quad", 9, 0},
                                              {78, "Bezier tet", 10, 0},
                                              {79, "Bezier hexahedron", 12, 0},
                                              {80, "Bezier wedge", 13, 0},
                                              {81, "Bezier pyramid", 14, 0}}};

constexpr std::array<VtkFace, 4> kTet{{{0, 1, 3, -1}, {1, 2, 3, -1}, {2, 0, 3, -1}, {0, 2, 1, -1}}};
constexpr std::array<VtkFace, 6> kHexahedron{
    {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}}};
/// A voxel is a hexahedron whose corners are in the order of x, then y, then z.
constexpr std::array<VtkFace, 6> kVoxel{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
constexpr std::array<VtkFace, 5> kWedge{{{0, 2, 1, -1}, {3, 4, 5, -1}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};
constexpr std::array<VtkFace, 5> kPyramid{{{0, 3, 2, 1}, {0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}}};

}  // namespace

const VtkCellType* find_vtk_cell_type(int type) {
  const auto found = std::lower_bound(kTypes.begin(), kTypes.end(), type,
                                      [](const VtkCellType& row, int number) { return row.type < number; });
  return found != kTypes.end() && found->type == type ? &*found : nullptr;
}

int vtk_corner_count(int straight) {
  const VtkCellType* row = find_vtk_cell_type(straight);
  return row == nullptr ? 0 : row->points;
}

std::span<const VtkFace> vtk_faces(int straight) {
  switch (straight) {
    case 10:
      return kTet;
    case 11:
      return kVoxel;
    case 12:
      return kHexahedron;
    case 13:
      return kWedge;
    case 14:
      return kPyramid;
    default:
      return {};
  }
}

namespace {

constexpr int kNoArea = 3, kTriangleStrip = 6, kPixel = 8;

/// A face of a volume cell. Faces of two cells are the same if they have the same places as corners.
struct CellFace {
  ivec4 key;  ///< the distinct corners in ascending order, filled up with the largest int
  int cell = 0, face = 0;
};

bool is_less(const ivec4& a, const ivec4& b) {
  for (int i = 0; i < 3; ++i) {
    if (a[i] != b[i]) return a[i] < b[i];
  }
  return a[3] < b[3];
}

/// Returns for each point the least number of a point at the same place.
std::vector<int> first_points(const std::vector<dvec3>& points) {
  std::vector<int> order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const dvec3 &p = points[at(a)], &q = points[at(b)];
    if (p.x != q.x) return p.x < q.x;
    if (p.y != q.y) return p.y < q.y;
    return p.z != q.z ? p.z < q.z : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && points[at(order[i])] == points[at(order[i - 1])];
    first[at(order[i])] = same ? first[at(order[i - 1])] : order[i];
  }
  return first;
}

class VtkSurface {
 public:
  VtkSurface(VtkData data, const std::string& file) : data_(std::move(data)), file_(file) {}

  PolygonSoup take() {
    for (std::size_t c = 0; c < data_.types.size(); ++c) check_cell(c);
    if (volumes_ > 0) find_faces();
    for (std::size_t c = 0; c < data_.types.size(); ++c) add_surface_cell(c);
    const std::size_t polygons = soup_.triangles.size();
    add_boundary();
    if (soup_.triangles.empty() && no_area_ > 0)
      throw Error(file_, fmt::format("has no triangles: its {} cells are lines or vertices", no_area_));
    add_notes(polygons);
    soup_.vertices = std::move(data_.points);
    return std::move(soup_);
  }

 private:
  [[nodiscard]] const VtkCellType& type_of(std::size_t c) const { return *find_vtk_cell_type(data_.types[c]); }

  /// Counts the cell. Throws Error if its type is not read or if it has another number of points than its type.
  void check_cell(std::size_t c) {
    const int number = data_.types[c];
    const VtkCellType* type = find_vtk_cell_type(number);
    if (type == nullptr)
      throw Error(file_, fmt::format("cell {}", c),
                  fmt::format("is of type {}, which is not read: cut the cells into tets or triangles (Tetrahedralize "
                              "in ParaView)",
                              number));
    const std::size_t points = data_.cell(c).size(), wanted = at(type->points);
    const std::size_t least = at(vtk_corner_count(type->straight));
    if (type->straight != kNoArea && (wanted != 0 ? points != wanted : points < least))
      throw Error(file_, fmt::format("cell {}", c),
                  fmt::format("has {} points, a {} has {}{}", points, type->name, wanted != 0 ? "" : "at least ",
                              wanted != 0 ? wanted : least));
    no_area_ += type->straight == kNoArea ? 1 : 0;
    curved_ += type->curved() ? 1 : 0;
    volumes_ += vtk_faces(type->straight).empty() ? 0 : 1;
  }

  ivec4 key_of(std::span<const int> corners) const {
    ivec4 key(std::numeric_limits<int>::max());
    for (const int corner : corners) {  // insertion into the sorted key; a place that is there already is left out
      int place = first_[at(corner)];
      for (int i = 0; i < 4 && place != key[i]; ++i) {
        if (place < key[i]) std::swap(place, key[i]);
      }
    }
    return key;
  }

  /// Returns the corners of a face of a volume cell, without those at the place of the corner before.
  std::vector<int> corners_of(std::size_t c, const VtkFace& face) const {
    const std::span<const int> cell = data_.cell(c);
    std::vector<int> corners;
    for (const int i : face) {
      if (i >= 0 && (corners.empty() || first_[at(corners.back())] != first_[at(cell[at(i)])]))
        corners.push_back(cell[at(i)]);
    }
    if (corners.size() > 1 && first_[at(corners.front())] == first_[at(corners.back())]) corners.pop_back();
    return corners;
  }

  /// Makes the sorted list of all faces of the volume cells. Throws Error if three cells share a face.
  void find_faces() {
    first_ = first_points(data_.points);
    for (std::size_t c = 0; c < data_.types.size(); ++c) {
      const std::span<const VtkFace> faces = vtk_faces(type_of(c).straight);
      for (std::size_t f = 0; f < faces.size(); ++f) {
        const std::vector<int> corners = corners_of(c, faces[f]);
        if (corners.size() >= 3) faces_.push_back({key_of(corners), static_cast<int>(c), static_cast<int>(f)});
      }
    }
    std::stable_sort(faces_.begin(), faces_.end(),
                     [](const CellFace& a, const CellFace& b) { return is_less(a.key, b.key); });
    for (std::size_t i = 2; i < faces_.size(); ++i) {
      if (faces_[i].key == faces_[i - 2].key)
        throw Error(file_, fmt::format("cell {}", faces_[i].cell),
                    fmt::format("has a face that cells {} and {} have too: two cells at most can share a face",
                                faces_[i - 2].cell, faces_[i - 1].cell));
    }
  }

  [[nodiscard]] bool is_face(std::span<const int> corners) const {
    if (faces_.empty() || corners.size() < 3 || corners.size() > 4) return false;
    const ivec4 key = key_of(corners);
    const auto found = std::lower_bound(faces_.begin(), faces_.end(), key,
                                        [](const CellFace& face, const ivec4& k) { return is_less(face.key, k); });
    return found != faces_.end() && found->key == key;
  }

  void add_surface_cell(std::size_t c) {
    const VtkCellType& type = type_of(c);
    if (type.straight == kNoArea || !vtk_faces(type.straight).empty()) return;
    std::span<const int> corners = data_.cell(c);
    if (const int count = vtk_corner_count(type.straight); count > 0) corners = corners.first(at(count));
    if (type.straight == kTriangleStrip) return add_strip(corners);
    if (is_face(corners)) {
      ++repeated_;
    } else if (type.straight == kPixel) {  // its corners are in the order of x, then y
      soup_.add_polygon(std::array{corners[0], corners[1], corners[3], corners[2]});
    } else {
      soup_.add_polygon(corners);
    }
  }

  void add_strip(std::span<const int> corners) {
    if (corners.size() < 3) ++soup_.skipped;
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const bool odd = i % 2 == 1;
      soup_.triangles.emplace_back(corners[i - 2], corners[odd ? i : i - 1], corners[odd ? i - 1 : i]);
    }
  }

  /// Returns six times the volume of a cell, negative if its faces point inward.
  [[nodiscard]] double volume_of(std::size_t c) const {
    const std::span<const int> cell = data_.cell(c);
    const dvec3 origin = data_.points[at(cell[0])];
    const auto corner = [&](int i) { return data_.points[at(cell[at(i)])] - origin; };
    double volume = 0;
    for (const VtkFace& face : vtk_faces(type_of(c).straight)) {
      volume += glm::dot(corner(face[0]), glm::cross(corner(face[1]), corner(face[2])));
      if (face[3] >= 0) volume += glm::dot(corner(face[0]), glm::cross(corner(face[2]), corner(face[3])));
    }
    return volume;
  }

  /// Adds the faces that belong to only one cell, outward, in the order of the cells.
  void add_boundary() {
    std::vector<CellFace> outer;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const bool shared = (i > 0 && faces_[i - 1].key == faces_[i].key) ||
                          (i + 1 < faces_.size() && faces_[i + 1].key == faces_[i].key);
      if (!shared) outer.push_back(faces_[i]);
    }
    std::sort(outer.begin(), outer.end(), [](const CellFace& a, const CellFace& b) {
      return a.cell != b.cell ? a.cell < b.cell : a.face < b.face;
    });
    for (const CellFace& face : outer) {
      const auto c = at(face.cell);
      std::vector<int> corners = corners_of(c, vtk_faces(type_of(c).straight)[at(face.face)]);
      if (volume_of(c) < 0) std::reverse(corners.begin(), corners.end());
      soup_.add_polygon(corners);
    }
  }

  void add_notes(std::size_t polygons) {
    const auto note = [this](std::string text) { soup_.notes.push_back(std::move(text)); };
    if (volumes_ > 0)
      note(fmt::format("took the boundary of {} volume cells: {} triangles", volumes_,
                       soup_.triangles.size() - polygons));
    if (repeated_ > 0) note(fmt::format("ignored {} surface cells that are faces of volume cells", repeated_));
    if (curved_ > 0) note(fmt::format("took only the corners of {} curved cells: their edges are straight", curved_));
    if (no_area_ > 0) note(fmt::format("ignored {} cells of lines or vertices", no_area_));
  }

  VtkData data_;
  const std::string& file_;
  PolygonSoup soup_;
  std::vector<int> first_;       ///< for each point the least number of a point at the same place
  std::vector<CellFace> faces_;  ///< the faces of all volume cells, sorted by key
  std::size_t no_area_ = 0, curved_ = 0, volumes_ = 0, repeated_ = 0;
};

}  // namespace

PolygonSoup read_vtk(std::string_view bytes, const std::string& file) {
  return VtkSurface(read_vtk_data(bytes, file, VtkAttributes::skip), file).take();
}

PolygonSoup refuse_vtk_xml(std::string_view, const std::string& file) {
  throw Error(file,
              "is a VTK XML file; only legacy VTK files are read: save it as legacy VTK (.vtk), with ParaView or "
              "PyVista");
}

}  // namespace taxel
