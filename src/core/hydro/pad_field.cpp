// The pad field: an elastomer of thickness H over a rigid core, on any closed mesh. Every triangle of the skin is the
// outer face of a prism, whose inner vertices lie H below the skin; three tets fill a prism.
#include <fmt/format.h>

#include "core/base/error.h"
#include "core/hydro/pad_shape.h"
#include "core/hydro/pressure_field.h"
#include "core/mesh/mesh_check.h"

namespace taxel {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Depth of each leg's inner vertex below the planes of its faces, area-weighted mean; H for a leg without faces.
std::vector<double> mean_plane_depths(const TriMesh& mesh, const PadShape& shape, double thickness) {
  std::vector<double> area(at(shape.leg_count()), 0.0), depth(at(shape.leg_count()), 0.0);
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int c = 0; c < 3; ++c) {
      const int leg = shape.leg(f, c);
      const double cosine = -glm::dot(mesh.face_normals()[at(f)], shape.direction(leg).direction);
      area[at(leg)] += mesh.face_areas()[at(f)];
      depth[at(leg)] += mesh.face_areas()[at(f)] * shape.offset(leg) * cosine;
    }
  }
  for (std::size_t i = 0; i < depth.size(); ++i) depth[i] = area[i] > 0 ? std::max(0.0, depth[i] / area[i]) : thickness;
  return depth;
}

/// E depth/H at the inner vertices. The depth is the distance to the skin, but where the skin is concave that exceeds
/// the depth below the planes of its faces, and would make these too stiff: there it is the mean of the latter.
std::vector<double> pressures(const TriMesh& mesh, const PadShape& shape, double modulus, double thickness) {
  const std::vector<double> plane_depth = mean_plane_depths(mesh, shape, thickness);
  std::vector<double> pressure(mesh.vertices().size(), 0.0);
  for (int leg = 0; leg < shape.leg_count(); ++leg) {
    const double depth = std::min({shape.depth(leg), plane_depth[at(leg)], thickness});
    pressure.push_back(shape.offset(leg) > 0 ? modulus * depth / thickness : 0.0);
  }
  return pressure;
}

/// Gathers faces of one kind; the worst is the one of the highest badness.
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

FieldReport report_of(const TriMesh& mesh, const PadShape& shape, double thickness,
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
    if (shape.tets(f).count == 0) {
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

PressureFieldPtr fill(const TriMeshPtr& mesh, double modulus, double thickness, const std::vector<int>& face_numbers) {
  const MeshIndex index(mesh);
  const PadShape shape(index, thickness);
  std::vector<dvec3> vertices = mesh->vertices();
  for (int leg = 0; leg < shape.leg_count(); ++leg) vertices.push_back(shape.inner_position(leg));
  std::vector<ivec4> tets;
  tets.reserve(3 * mesh->faces().size());
  for (int f = 0; f < mesh->face_count(); ++f) {
    const PrismTets face_tets = shape.tets(f);
    tets.insert(tets.end(), face_tets.tets.begin(), face_tets.tets.begin() + face_tets.count);
  }
  const std::vector<ivec4> gaps = shape.gap_tets();
  tets.insert(tets.end(), gaps.begin(), gaps.end());
  std::vector<double> pressure = pressures(*mesh, shape, modulus, thickness);
  return std::make_shared<const PressureField>(std::move(vertices), std::move(tets), std::move(pressure),
                                               report_of(*mesh, shape, thickness, face_numbers));
}

}  // namespace

PressureFieldPtr make_pad_field(const TriMeshPtr& mesh, double modulus, double thickness,
                                const std::vector<int>& face_numbers) {
  const auto require_positive = [](double value, const char* what) {
    if (!(value > 0) || !std::isfinite(value)) throw Error(fmt::format("{} must be positive, not {}", what, value));
  };
  require_positive(modulus, "modulus of a pad");
  require_positive(thickness, "thickness of a pad");
  if (!mesh->closed()) throw Error("a pad needs a closed mesh; this one is open: " + openings(*mesh));
  if (!(mesh->volume() > 0)) throw Error("a pad needs a mesh whose triangles face outward; this one is inside out");
  return fill(mesh, modulus, thickness, face_numbers);
}

}  // namespace taxel
