// The pad field: an elastomer of thickness H over a rigid core, on any closed mesh. Every triangle of the skin is the
// outer face of a prism, whose inner vertices lie H below the skin; three tets fill a prism.
#include <fmt/format.h>

#include <atomic>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/hydro/pad_directions.h"
#include "core/hydro/pressure_field.h"
#include "core/mesh/closest_point.h"

namespace taxel {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// An inner vertex counts as beyond the medial axis, thus as owned by another part of the skin, where its distance to
/// the skin is less than this part of the depth that the faces around its own vertex promise.
constexpr double kOwnDepth = 0.95;
/// Where the body is thin, a pad takes this part of the way to the medial axis.
constexpr double kThinMargin = 0.9;
/// Offsets of neighbours differ at most by this part of their distance.
constexpr double kLargestSlope = 0.7;
/// A tet is well shaped when its volume is at least this part of a straight prism's third.
constexpr double kLeastVolume = 0.05;
constexpr double kShrink = 0.8;
constexpr int kShrinkRounds = 40;  // 0.8^40 = 1e-4

class Pad {
 public:
  Pad(const TriMeshPtr& mesh, double modulus, double thickness)
      : mesh_(*mesh), index_(mesh), modulus_(modulus), thickness_(thickness), inward_(pad_directions(*mesh)) {
    offset_.assign(mesh_.vertices().size(), 0.0);
    full_.assign(mesh_.vertices().size(), 0.0);
  }

  PressureFieldPtr make() {
    constexpr int kChunk = 64;
    parallel_chunks(mesh_.vertex_count(), kChunk, [&](int begin, int end) {
      for (int v = begin; v < end; ++v) set_offset(v);
    });
    smooth_offsets();
    for (int round = 0; round < kShrinkRounds && shrink_folded() > 0; ++round) smooth_offsets();
    return build();
  }

 private:
  using Prism = std::array<ivec4, 3>;

  [[nodiscard]] dvec3 inner(int v, double h) const { return mesh_.vertices()[at(v)] + h * inward_[at(v)].direction; }

  /// Depth at the offset h, or a negative number where it lies outside or belongs to another part of the skin.
  [[nodiscard]] double own_depth(int v, double h) const {
    const double depth = -index_.signed_distance(inner(v, h));
    return depth >= kOwnDepth * h * inward_[at(v)].least_cosine ? depth : -1.0;
  }

  /// The largest offset up to where the depth is H, that does not cross the medial axis.
  void set_offset(int v) {
    constexpr int kSteps = 4, kBisections = 10;
    // A ridge loses depth along its bisector: go as much farther as its faces' angles say (a mitre).
    double depth = own_depth(v, thickness_);
    double target = thickness_;
    if (depth > 0) target = thickness_ * std::clamp(thickness_ / depth, 1.0, kLongestMitre);
    full_[at(v)] = target;
    double good = 0, bad = -1;
    for (int i = 1; i <= kSteps && bad < 0; ++i) {
      const double h = target * i / kSteps;
      if (own_depth(v, h) > 0) {
        good = h;
      } else {
        bad = h;
      }
    }
    if (bad >= 0) {
      for (int i = 0; i < kBisections; ++i) {
        const double h = 0.5 * (good + bad);
        (own_depth(v, h) > 0 ? good : bad) = h;
      }
      good = kThinMargin * good;
    }
    offset_[at(v)] = good;
  }

  /// Lowers offsets until no edge is steeper than allowed.
  void smooth_offsets() {
    bool changed = true;
    while (changed) {
      changed = false;
      for (const ivec3& f : mesh_.faces()) {
        for (int c = 0; c < 3; ++c) {
          const int a = f[c], b = f[(c + 1) % 3];
          const double most = kLargestSlope * glm::distance(mesh_.vertices()[at(a)], mesh_.vertices()[at(b)]);
          // Each change moves at least by a part of the thickness: the loop ends.
          const double step = most + 1e-6 * thickness_;
          if (offset_[at(a)] > offset_[at(b)] + step) offset_[at(a)] = offset_[at(b)] + most, changed = true;
          if (offset_[at(b)] > offset_[at(a)] + step) offset_[at(b)] = offset_[at(a)] + most, changed = true;
        }
      }
    }
  }

  [[nodiscard]] dvec3 position(int v) const {
    const int n = mesh_.vertex_count();
    return v < n ? mesh_.vertices()[at(v)] : inner(v - n, offset_[at(v - n)]);
  }

  /// The tets of one face: corners in the order of their numbers, so that neighbours cut the quads between them along
  /// the same diagonal, from the lower number's skin vertex to the higher number's inner one.
  [[nodiscard]] Prism prism(const ivec3& face) const {
    int a = face.x, b = face.y, c = face.z;
    while (a > b || a > c) {  // turn the lowest number to the front: keeps the orientation
      const int first = a;
      a = b;
      b = c;
      c = first;
    }
    const int n = mesh_.vertex_count();
    if (b < c) return {ivec4(a, c, b, n + c), ivec4(a, b, n + b, n + c), ivec4(a, n + a, n + c, n + b)};
    return {ivec4(a, c, b, n + b), ivec4(a, n + c, c, n + b), ivec4(a, n + a, n + c, n + b)};
  }

  /// Volume of a tet over the third of the volume of a straight prism on the face, with the smallest offset around it.
  [[nodiscard]] double quality(int face, const ivec4& tet) const {
    const ivec3& f = mesh_.faces()[at(face)];
    const double h = std::min({offset_[at(f.x)], offset_[at(f.y)], offset_[at(f.z)]});
    const dvec3 o = position(tet[0]);
    const double six = glm::dot(glm::cross(position(tet[1]) - o, position(tet[2]) - o), position(tet[3]) - o);
    return h > 0 ? six / (2.0 * mesh_.face_areas()[at(face)] * h) : 0.0;
  }

  [[nodiscard]] bool well_shaped(int face) const {
    const Prism tets = prism(mesh_.faces()[at(face)]);
    return std::all_of(tets.begin(), tets.end(), [&](const ivec4& t) { return quality(face, t) >= kLeastVolume; });
  }

  /// Shortens the offsets of folded prisms; how many there were.
  int shrink_folded() {
    std::vector<char> folded(offset_.size(), 0);
    int count = 0;
    for (int f = 0; f < mesh_.face_count(); ++f) {
      if (well_shaped(f)) continue;
      ++count;
      for (int c = 0; c < 3; ++c) folded[at(mesh_.faces()[at(f)][c])] = 1;
    }
    for (std::size_t v = 0; v < offset_.size(); ++v) {
      if (folded[v]) offset_[v] *= kShrink;
    }
    return count;
  }

  PressureFieldPtr build() const {
    std::vector<dvec3> vertices = mesh_.vertices();
    std::vector<double> pressure(2 * vertices.size(), 0.0);
    for (int v = 0; v < mesh_.vertex_count(); ++v) {
      const dvec3 p = inner(v, offset_[at(v)]);
      vertices.push_back(p);
      const double depth = std::clamp(-index_.signed_distance(p), 0.0, thickness_);
      pressure[at(mesh_.vertex_count() + v)] = modulus_ * depth / thickness_;
    }
    std::vector<ivec4> tets;
    FieldReport report;
    int dropped = 0, first_dropped = -1;
    double limited_area = 0;
    for (int f = 0; f < mesh_.face_count(); ++f) {
      for (const ivec4& tet : prism(mesh_.faces()[at(f)])) {
        if (quality(f, tet) > 0) {
          tets.push_back(tet);
        } else if (dropped++ == 0) {
          first_dropped = f;
        }
      }
      for (int c = 0; c < 3; ++c) {
        const std::size_t v = at(mesh_.faces()[at(f)][c]);
        if (offset_[v] < 0.999 * full_[v]) limited_area += mesh_.face_areas()[at(f)] / 3.0;
      }
    }
    report.inverted = dropped;
    if (dropped > 0)
      report.notes.push_back(
          fmt::format("{} tets left out where the skin folds too sharply (first: face {})", dropped, first_dropped));
    report.thickness_limited_fraction = limited_area / mesh_.area();
    return std::make_shared<const PressureField>(std::move(vertices), std::move(tets), std::move(pressure),
                                                 std::move(report));
  }

  static constexpr double kLongestMitre = 2.0;
  const TriMesh& mesh_;
  MeshIndex index_;
  double modulus_, thickness_;
  std::vector<PadDirection> inward_;
  std::vector<double> offset_, full_;  ///< per vertex: length of the offset, and what it would be without limits [m]
};

}  // namespace

PressureFieldPtr make_pad_field(const TriMeshPtr& mesh, double modulus, double thickness) {
  const auto require_positive = [](double value, const char* what) {
    if (!(value > 0) || !std::isfinite(value)) throw Error(fmt::format("{} must be positive, not {}", what, value));
  };
  require_positive(modulus, "modulus of a pad");
  require_positive(thickness, "thickness of a pad");
  if (!mesh->closed()) throw Error("a pad needs a closed mesh; this one is open");
  if (!(mesh->volume() > 0)) throw Error("a pad needs a mesh whose triangles face outward; this one is inside out");
  return Pad(mesh, modulus, thickness).make();
}

}  // namespace taxel
