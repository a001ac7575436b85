// The pad field: an elastomer of thickness H over a rigid core, on any closed mesh, with p = (E/H) depth.
//
//    skin  a-----b-----c      Every triangle of the skin is the outer face of a prism whose inner vertices are H below
//           \    |    /       the skin, at the ends of offset vectors (pad_shape.h). Three tets fill a prism, or each
//            a'--b'--c'       of its two layers where the normals of the skin diverge (pad_layers.cpp).
//
// 1. Offset vectors, prisms, layers, pressures and caps give a pad (fill()).
// 2. Faces that are too coarse below sharp edges are found by the pressure at four points below each (uneven_faces()).
//    If they are more than 0.5 % of the skin, their longest edges are bisected (Rivara 1997), and the pad is built
//    again; the offset vectors that stay keep their lengths. The surface does not change, except for rounding.
// 3. Faces without any tet get caps of their own, and the report measures the result: error, stiffness, limits.
//
// Cost: a few closest-point queries per vertex and face; refinement builds the pad twice. Pitfall: a bisection follows
// the path of longest edges to its end first, or angles would become ever smaller. Theory: docs/theory/hydro.md,
// "Pads".
#include "core/hydro/pad/pad_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/base/rng.h"
#include "core/hydro/fields/pressure_field.h"
#include "core/hydro/fields/tet_geometry.h"
#include "core/mesh/query/closest_point.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel {
namespace {

/// Cosine to a face's normal above which all offset vectors must be for an even face.
constexpr double kStraight = 0.9;
/// Largest relative difference of the pressure of an even face from E depth/H.
constexpr double kEvenPressure = 0.03;
/// Depth of the points at which the pressure is tested, in thicknesses.
constexpr double kTried = 0.1;

/// An edge with its length and the indices of its ends. Edges are sorted, longest first.
struct FaceEdge {
  double squared_length;
  int low, high;
  int face, corner;  ///< one of its faces, and the corner from which the edge leads to the next
  bool operator<(const FaceEdge& other) const {
    return std::tie(other.squared_length, low, high) < std::tie(squared_length, other.low, other.high);
  }
  bool operator==(const FaceEdge& other) const { return low == other.low && high == other.high; }
};

/// Returns the faces across the edges from corner c to c + 1 of every face of a closed mesh.
std::vector<ivec3> faces_across(const EdgeTopology& topology) {
  std::vector<ivec3> across(topology.faces().size());
  for (int h = 0; h < topology.half_edge_count(); ++h) across[at(h / 3)][h % 3] = topology.face_across(h);
  return across;
}

class Bisection {
 public:
  Bisection(const TriMesh& mesh, std::vector<char> wanted)
      : vertices_(mesh.vertices()),
        faces_(mesh.faces()),
        across_(faces_across(mesh.topology())),
        face_of_(faces_.size()) {
    std::iota(face_of_.begin(), face_of_.end(), 0);
    for (int f = 0; f < mesh.face_count(); ++f) {
      if (wanted[at(f)] != 0) wanted_.push_back(f);
    }
    is_wanted_ = std::move(wanted);
  }

  RefinedSkin run(double longest, int most_faces) {
    while (bisect_once(longest, most_faces)) {
    }
    return {std::make_shared<const TriMesh>(std::move(vertices_), std::move(faces_)), std::move(face_of_)};
  }

 private:
  FaceEdge edge(int face, int corner) const {
    const int a = faces_[at(face)][corner], b = faces_[at(face)][(corner + 1) % 3];
    const auto [low, high] = std::minmax(a, b);
    const dvec3 along = vertices_[at(high)] - vertices_[at(low)];
    return {glm::dot(along, along), low, high, face, corner};
  }
  FaceEdge longest_edge(int face) const { return std::min({edge(face, 0), edge(face, 1), edge(face, 2)}); }

  /// Returns the edge at the end of the path of longest edges from a face, which is the longest edge of both its faces.
  FaceEdge terminal_edge(FaceEdge own) const {
    for (;;) {
      const FaceEdge next = longest_edge(across_[at(own.face)][own.corner]);
      if (next == own) return own;
      own = next;
    }
  }

  /// Bisects every edge at the end of a path once; no two of these edges share a face. Returns false if there is none.
  bool bisect_once(double longest, int most_faces) {
    std::set<FaceEdge> found;
    for (const int f : wanted_) {
      const FaceEdge own = longest_edge(f);
      if (own.squared_length > longest * longest) found.insert(terminal_edge(own));
    }
    for (const FaceEdge& e : found) {
      if (static_cast<int>(faces_.size()) + 2 > most_faces) return false;
      bisect(e);
    }
    return !found.empty();
  }

  /// Replaces the face (a, b, c) by (a, m, c) and the new face (m, b, c), and divides the face across the edge in the
  /// same way.
  void bisect(const FaceEdge& e) {
    const auto m = static_cast<int>(vertices_.size());
    vertices_.push_back(0.5 * (vertices_[at(e.low)] + vertices_[at(e.high)]));
    const std::array<int, 2> old{e.face, across_[at(e.face)][e.corner]};
    const auto first_new = static_cast<int>(faces_.size());
    for (int i = 0; i < 2; ++i) {
      const int f = old[at(i)];
      int corner = 0;
      while (!(edge(f, corner) == e)) ++corner;
      const int next = (corner + 1) % 3, last = (corner + 2) % 3, beyond = across_[at(f)][next];
      ivec3 half = faces_[at(f)], half_across = across_[at(f)];
      half[corner] = m;
      half_across[corner] = old[at(1 - i)];
      half_across[last] = f;
      ivec3& seen = across_[at(beyond)];
      for (int c = 0; c < 3; ++c) {
        if (faces_[at(beyond)][c] == faces_[at(f)][last] && faces_[at(beyond)][(c + 1) % 3] == faces_[at(f)][next])
          seen[c] = first_new + i;
      }
      faces_.push_back(half);
      across_.push_back(half_across);
      if (is_wanted_[at(f)] != 0) wanted_.push_back(first_new + i);
      is_wanted_.push_back(is_wanted_[at(f)]);
      face_of_.push_back(face_of_[at(f)]);
    }
    for (int i = 0; i < 2; ++i) {
      const int f = old[at(i)];
      int corner = 0;
      while (!(edge(f, corner) == e)) ++corner;
      const int next = (corner + 1) % 3;
      faces_[at(f)][next] = m;
      across_[at(f)][corner] = first_new + 1 - i;
      across_[at(f)][next] = first_new + i;
    }
  }

  std::vector<dvec3> vertices_;
  std::vector<ivec3> faces_, across_;
  std::vector<int> face_of_, wanted_;
  std::vector<char> is_wanted_;
};

/// Returns true if a face is coarse enough and has an offset vector that leads away from its normal.
bool can_be_uneven(const TriMesh& mesh, const PadShape& shape, int face, double longest) {
  double edge = 0, cosine = 1;
  for (int c = 0; c < 3; ++c) {
    edge = std::max(edge, glm::distance(mesh.vertex(face, c), mesh.vertex(face, (c + 1) % 3)));
    const dvec3& inward = shape.direction(shape.offset(face, c)).direction;
    cosine = std::min(cosine, -glm::dot(mesh.face_normals()[at(face)], inward));
  }
  return edge > longest && cosine < kStraight;
}

std::array<int, 3> sorted(const ivec3& v) {
  std::array<int, 3> s{v.x, v.y, v.z};
  std::sort(s.begin(), s.end());
  return s;
}

/// The field of the tets at the corners of some faces and of the faces next to them.
PressureField field_around(const TriMesh& mesh, const std::vector<int>& some, const PadTets& pad) {
  std::vector<char> corner(mesh.vertices().size(), 0), near(pad.vertices.size(), 0);
  for (const int f : some) {
    for (int c = 0; c < 3; ++c) corner[at(mesh.faces()[at(f)][c])] = 1;
  }
  for (const ivec3& face : mesh.faces()) {
    if (corner[at(face.x)] + corner[at(face.y)] + corner[at(face.z)] < 2) continue;
    for (int c = 0; c < 3; ++c) near[at(face[c])] = 1;
  }
  std::vector<ivec4> tets;
  std::copy_if(pad.tets.begin(), pad.tets.end(), std::back_inserter(tets),
               [&](const ivec4& t) { return near[at(t[0])] + near[at(t[1])] + near[at(t[2])] + near[at(t[3])] > 0; });
  return {pad.vertices, std::move(tets), pad.pressure, FieldReport{}};
}

}  // namespace

std::vector<char> uneven_faces(const MeshIndex& index, const PadShape& shape, const PadTets& pad, double modulus,
                               double thickness, double longest) {
  const TriMesh& mesh = index.mesh();
  std::vector<char> uneven(mesh.faces().size(), 0);
  std::vector<int> tried;
  std::map<std::array<int, 3>, SkinFace> skin;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (!can_be_uneven(mesh, shape, f, longest)) continue;
    tried.push_back(f);
    skin[sorted(mesh.faces()[at(f)])] = {-1, -1};
  }
  if (tried.empty()) return uneven;
  const PressureField field = field_around(mesh, tried, pad);
  for (const SkinFace& face : skin_faces(field)) {
    const ivec4& v = field.tets()[at(face.tet)].vertices;
    const auto entry =
        skin.find(sorted({v[(face.corner + 1) % 4], v[(face.corner + 2) % 4], v[(face.corner + 3) % 4]}));
    if (entry != skin.end()) entry->second = face;
  }
  const double depth = kTried * thickness;
  const auto is_uneven = [&](int f) {
    const SkinFace& face = skin.at(sorted(mesh.faces()[at(f)]));
    if (face.tet < 0) return true;
    // The centroid, and points near the middles of the edges.
    constexpr double kFar = 0.475, kNear = 0.05;
    for (const dvec3& w :
         {dvec3(1.0 / 3), dvec3(kNear, kFar, kFar), dvec3(kFar, kNear, kFar), dvec3(kFar, kFar, kNear)}) {
      const dvec3 x = w.x * mesh.vertex(f, 0) + w.y * mesh.vertex(f, 1) + w.z * mesh.vertex(f, 2);
      const dvec3 outward = mesh.face_normals()[at(f)];
      double pressure = -1;
      pressures_below(field, face, x, {&depth, 1}, {&pressure, 1});
      if (pressure < 0) {
        // In such a thin body, smaller faces would not have deeper prisms.
        if (is_nearest_skin(index, x - 2 * depth * outward, 2 * depth)) return true;
        continue;
      }
      const double exact = modulus / thickness * depth_inside(index, x - depth * outward, depth);
      if (std::abs(pressure - exact) > kEvenPressure * exact) return true;
    }
    return false;
  };
  constexpr int kChunk = 16;
  parallel_chunks(static_cast<int>(tried.size()), kChunk, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) uneven[at(tried[at(i)])] = is_uneven(tried[at(i)]) ? 1 : 0;
  });
  return uneven;
}

RefinedSkin refine_skin(const TriMesh& mesh, std::vector<char> wanted, double longest, int most_faces) {
  return Bisection(mesh, std::move(wanted)).run(longest, most_faces);
}

namespace {

/// Error p/E - min(depth, H)/H over the volume of the tets. The depth is the distance to the skin.
struct PadError {
  double mean = 0;  ///< mean of its magnitude
  double rms = 0;
};

constexpr int kErrorPoints = 1024;

/// Returns barycentric weights of a point uniformly distributed in a tet: three sorted random cuts of a unit length
/// give four weights.
std::array<double, 4> random_weights(const CounterRng& rng, int point) {
  const auto n = 4 * static_cast<std::uint64_t>(point);
  std::array<double, 3> cut{rng.uniform(n), rng.uniform(n + 1), rng.uniform(n + 2)};
  std::sort(cut.begin(), cut.end());
  return {cut[0], cut[1] - cut[0], cut[2] - cut[1], 1 - cut[2]};
}

/// Estimates the error from 1024 points, each at a random place in its own part of the volume. The result has two
/// correct digits if the error is spread, and one if it is concentrated in about a hundredth of the pad. Deterministic.
/// Cost: 1024 closest-point queries, 2 ms.
PadError pad_error(const MeshIndex& index, const std::vector<dvec3>& vertices, const std::vector<ivec4>& tets,
                   const std::vector<double>& vertex_pressure, double modulus, double thickness) {
  std::vector<double> volume_to;  // cumulative volume of the tets
  volume_to.reserve(tets.size());
  double volume = 0;
  for (const ivec4& t : tets) {
    volume += std::abs(six_volumes({vertices[at(t[0])], vertices[at(t[1])], vertices[at(t[2])], vertices[at(t[3])]}));
    volume_to.push_back(volume);
  }
  if (!(volume > 0)) return {};
  const CounterRng rng(1);
  std::array<double, kErrorPoints> errors{};
  constexpr int kChunk = 64;
  parallel_chunks(kErrorPoints, kChunk, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const double share = (i + rng.uniform(4 * static_cast<std::uint64_t>(i) + 3)) / kErrorPoints;
      const auto found = std::upper_bound(volume_to.begin(), volume_to.end() - 1, share * volume);
      const ivec4& t = tets[static_cast<std::size_t>(found - volume_to.begin())];
      const std::array<double, 4> weights = random_weights(rng, i);
      dvec3 x{0};
      double pressure = 0;
      for (int k = 0; k < 4; ++k) {
        x += weights[at(k)] * vertices[at(t[k])];
        pressure += weights[at(k)] * vertex_pressure[at(t[k])];
      }
      errors[at(i)] = pressure / modulus - depth_inside(index, x, thickness) / thickness;
    }
  });
  PadError error;
  for (const double e : errors) {
    error.mean += std::abs(e) / kErrorPoints;
    error.rms += e * e / kErrorPoints;
  }
  error.rms = std::sqrt(error.rms);
  return error;
}

/// Collects faces of one kind. The worst face is the one with the highest badness.
class SkinPartMaker {
 public:
  SkinPartMaker(const TriMesh& mesh, const std::vector<int>& face_numbers) : mesh_(mesh), numbers_(face_numbers) {}
  void add(int face, double badness) {
    ++part_.faces;
    part_.area += mesh_.face_areas()[at(face)];
    for (int c = 0; c < 3; ++c) part_.bounds.include(mesh_.vertex(face, c));
    if (!(badness > worst_)) return;
    worst_ = badness;
    part_.worst_face = numbers_.empty() ? face : numbers_[at(face)];
    part_.worst_place = (mesh_.vertex(face, 0) + mesh_.vertex(face, 1) + mesh_.vertex(face, 2)) / 3.0;
  }
  [[nodiscard]] const SkinPart& part() const { return part_; }

 private:
  const TriMesh& mesh_;
  const std::vector<int>& numbers_;
  SkinPart part_;
  double worst_ = -1;
};

/// Returns the report of a pad. `bare_faces` has a flag for each face without a tet.
FieldReport report_of(const TriMesh& mesh, const PadShape& shape, const std::vector<char>& bare_faces, double thickness,
                      const std::vector<int>& face_numbers) {
  FieldReport report;
  report.core = true;
  report.thickness = thickness;
  report.skin_area = mesh.area();
  SkinPartMaker limited(mesh, face_numbers), bare(mesh, face_numbers);
  double limited_area = 0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    double least = 1;
    for (int c = 0; c < 3; ++c) {
      const int offset = shape.offset(f, c);
      if (!shape.limited(offset)) continue;
      limited_area += mesh.face_areas()[at(f)] / 3.0;
      least = std::min(least, shape.part_left(offset));
    }
    if (bare_faces[at(f)] != 0) {
      bare.add(f, mesh.face_areas()[at(f)]);
    } else if (least < 1) {
      limited.add(f, 1 - least);
      report.least_part = std::min(report.least_part, least);
    }
  }
  report.thickness_limited_fraction = limited_area / mesh.area();
  const dvec3 extent = mesh.bounds().extent();
  report.deepest = 0.5 * std::min({extent.x, extent.y, extent.z});
  report.limited = limited.part();
  report.bare = bare.part();
  return report;
}

std::vector<char> offsets_with_two_layers(PadLayering layering, const PadDepths& depths, double thickness) {
  if (layering == PadLayering::automatic) return diverging_offsets(depths, thickness);
  return std::vector<char>(depths.planes.size(), layering == PadLayering::two ? 1 : 0);
}

/// The tets of a pad and the offsets and depths that they were built from.
struct RawPad {
  PadTets tets;
  std::vector<char> bare;  ///< flag for each face without a tet
  int two_layer_faces = 0, caps = 0;
};

RawPad fill(const MeshIndex& index, const PadShape& shape, double modulus, double thickness, PadLayering layering) {
  const TriMesh& mesh = index.mesh();
  const PadDepths depths = pad_depths(mesh, shape, thickness);
  const PadLayers layers(shape, index, offsets_with_two_layers(layering, depths, thickness));
  RawPad pad;
  pad.tets = {mesh.vertices(), layers.tets(), pad_pressures(index, shape, layers, depths, modulus, thickness)};
  for (int offset = 0; offset < shape.offset_count(); ++offset)
    pad.tets.vertices.push_back(shape.inner_position(offset));
  for (const int offset : layers.offsets()) pad.tets.vertices.push_back(shape.moved(offset, layers.height(offset)));
  for (int f = 0; f < mesh.face_count(); ++f) pad.bare.push_back(layers.bare(f) ? 1 : 0);
  pad.two_layer_faces = layers.two_layer_faces();
  pad.caps = split_by_caps(index, pad.tets, modulus, thickness);
  return pad;
}

PressureFieldPtr finished_field(const MeshIndex& index, const PadShape& shape, RawPad pad, double modulus,
                                double thickness, const std::vector<int>& face_numbers, int refined_faces) {
  pad.caps += add_own_caps(index, pad.tets, pad.bare, modulus, thickness);
  FieldReport report = report_of(index.mesh(), shape, pad.bare, thickness, face_numbers);
  report.two_layer_faces = pad.two_layer_faces;
  report.caps = pad.caps;
  report.refined_faces = refined_faces;
  const PadError error = pad_error(index, pad.tets.vertices, pad.tets.tets, pad.tets.pressure, modulus, thickness);
  report.depth_error_mean = error.mean;
  report.depth_error_rms = error.rms;
  const auto field = std::make_shared<PressureField>(std::move(pad.tets.vertices), std::move(pad.tets.tets),
                                                     std::move(pad.tets.pressure), std::move(report));
  field->set_press_errors(press_errors(index, *field, modulus, thickness));
  return field;
}

/// Largest number of faces of a refined skin: the first one or the second one times the faces of the mesh, whichever
/// is larger. Each face takes 3 to 5 tets.
constexpr int kMaxFaces = 2000, kMaxFactor = 3;
/// Fraction of the skin below which uneven faces are not refined, because refinement builds the pad twice.
constexpr double kMinUnevenPart = 0.005;

/// Returns the skin refined at uneven faces of its pad, or no mesh if refinement is not worth its cost.
RefinedSkin refined_where_uneven(const MeshIndex& index, const PadShape& shape, const RawPad& pad, double modulus,
                                 double thickness, double refine) {
  if (!(refine > 0)) return {};
  const TriMesh& mesh = index.mesh();
  std::vector<char> uneven = uneven_faces(index, shape, pad.tets, modulus, thickness, refine * thickness);
  double area = 0;
  for (int f = 0; f < mesh.face_count(); ++f) area += uneven[at(f)] != 0 ? mesh.face_areas()[at(f)] : 0.0;
  if (!(area > kMinUnevenPart * mesh.area())) return {};
  const int most = std::max(kMaxFaces, kMaxFactor * mesh.face_count());
  return refine_skin(mesh, std::move(uneven), refine * thickness, most);
}

}  // namespace

PressureFieldPtr make_pad_field(const TriMeshPtr& mesh, double modulus, double thickness,
                                const std::vector<int>& face_numbers, PadLayering layering, double refine) {
  const auto require_positive = [](double value, const char* what) {
    if (!(value > 0) || !std::isfinite(value)) throw Error(fmt::format("{} must be positive, not {}", what, value));
  };
  require_positive(modulus, "modulus of a pad");
  require_positive(thickness, "thickness of a pad");
  if (!(refine >= 0)) throw Error(fmt::format("refine of a pad must be 0 or greater, is {}", refine));
  if (!mesh->closed()) throw Error("a pad needs a closed mesh; this one is open: " + openings(*mesh));
  if (!(mesh->volume() > 0)) throw Error("a pad needs a mesh whose triangles face outward; this one is inside out");
  const MeshIndex index(mesh);
  const PadShape shape(index, thickness);
  RawPad pad = fill(index, shape, modulus, thickness, layering);
  RefinedSkin refined = refined_where_uneven(index, shape, pad, modulus, thickness, refine);
  if (refined.mesh == nullptr) return finished_field(index, shape, std::move(pad), modulus, thickness, face_numbers, 0);
  if (!face_numbers.empty()) {
    for (int& f : refined.face_of) f = face_numbers[at(f)];
  }
  const MeshIndex fine(refined.mesh);
  const PadShape fine_shape(fine, thickness, &shape);
  pad = fill(fine, fine_shape, modulus, thickness, layering);
  return finished_field(fine, fine_shape, std::move(pad), modulus, thickness, refined.face_of,
                        refined.mesh->face_count() - mesh->face_count());
}

}  // namespace taxel
