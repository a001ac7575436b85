// The pad field: an elastomer of thickness H over a rigid core, on any closed mesh. Every triangle of the skin is the
// outer face of a prism, whose inner vertices are H below the skin. Three tets fill a prism, or each of its two layers.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/base/parallel.h"
#include "core/base/rng.h"
#include "core/hydro/fields/pressure_field.h"
#include "core/hydro/fields/prism.h"
#include "core/hydro/pad/pad_press.h"
#include "core/hydro/pad/pad_pressures.h"
#include "core/hydro/pad/pad_refine.h"
#include "core/hydro/pad/pad_tents.h"
#include "core/mesh/query/closest_point.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel {

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
      const int leg = shape.leg(f, c);
      if (!shape.limited(leg)) continue;
      limited_area += mesh.face_areas()[at(f)] / 3.0;
      least = std::min(least, shape.part_left(leg));
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

std::vector<char> legs_with_two_layers(PadLayering layering, const PadDepths& depths, double thickness) {
  if (layering == PadLayering::automatic) return diverging_legs(depths, thickness);
  return std::vector<char>(depths.planes.size(), layering == PadLayering::two ? 1 : 0);
}

/// The tets of a pad and the offsets and depths that they were built from.
struct RawPad {
  PadTets tets;
  std::vector<char> bare;  ///< flag for each face without a tet
  int two_layer_faces = 0, tents = 0;
};

RawPad fill(const MeshIndex& index, const PadShape& shape, double modulus, double thickness, PadLayering layering) {
  const TriMesh& mesh = index.mesh();
  const PadDepths depths = pad_depths(mesh, shape, thickness);
  const PadLayers layers(shape, index, legs_with_two_layers(layering, depths, thickness));
  RawPad pad;
  pad.tets = {mesh.vertices(), layers.tets(), pad_pressures(index, shape, layers, depths, modulus, thickness)};
  for (int leg = 0; leg < shape.leg_count(); ++leg) pad.tets.vertices.push_back(shape.inner_position(leg));
  for (const int leg : layers.legs()) pad.tets.vertices.push_back(shape.moved(leg, layers.height(leg)));
  for (int f = 0; f < mesh.face_count(); ++f) pad.bare.push_back(layers.bare(f) ? 1 : 0);
  pad.two_layer_faces = layers.two_layer_faces();
  pad.tents = split_by_tents(index, pad.tets, modulus, thickness);
  return pad;
}

PressureFieldPtr finish(const MeshIndex& index, const PadShape& shape, RawPad pad, double modulus, double thickness,
                        const std::vector<int>& face_numbers, int refined_faces) {
  pad.tents += add_own_tents(index, pad.tets, pad.bare, modulus, thickness);
  FieldReport report = report_of(index.mesh(), shape, pad.bare, thickness, face_numbers);
  report.two_layer_faces = pad.two_layer_faces;
  report.tents = pad.tents;
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
  if (refined.mesh == nullptr) return finish(index, shape, std::move(pad), modulus, thickness, face_numbers, 0);
  if (!face_numbers.empty()) {
    for (int& f : refined.face_of) f = face_numbers[at(f)];
  }
  const MeshIndex fine(refined.mesh);
  const PadShape fine_shape(fine, thickness, &shape);
  pad = fill(fine, fine_shape, modulus, thickness, layering);
  return finish(fine, fine_shape, std::move(pad), modulus, thickness, refined.face_of,
                refined.mesh->face_count() - mesh->face_count());
}

}  // namespace taxel
