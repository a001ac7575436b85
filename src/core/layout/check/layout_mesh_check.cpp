// Rules of a layout that need its mesh.
#include <fmt/format.h>

#include <algorithm>

#include "core/base/limits.h"
#include "core/base/math.h"
#include "core/layout/check/layout_check.h"
#include "core/layout/field/receptive_field.h"
#include "core/layout/sampling/poisson_disk.h"
#include "core/mesh/query/triangle.h"
#include "core/mesh/repair/repaired_mesh.h"
#include "core/mesh/surface_brush.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel {
namespace {

constexpr double kMillimetres = 1000.0;

Problem problem(const std::string& pointer, Severity severity, const char* code, std::string message, std::string fix) {
  return {"", pointer, severity, code, std::move(message), std::move(fix)};
}

/// Shells inside of others, in a closed mesh cavities and islands: whether they are sampled.
void check_shells(const Layout& layout, const TriMesh& mesh, const TriMesh& skin, Problems& out) {
  const bool all = layout.sampling.shells == Shells::all;
  int inner = mesh.face_count() - skin.face_count();
  if (all) {
    const std::vector<int> outer = outer_shells(mesh);
    for (const int shell : mesh.shell_of_face()) inner += std::binary_search(outer.begin(), outer.end(), shell) ? 0 : 1;
  }
  if (inner == 0) return;
  out.push_back(problem(
      "/mesh/file", Severity::note, "mesh_has_cavity",
      fmt::format("has enclosed shells ({} of {} faces): {}", inner, mesh.face_count(),
                  all ? "they are sampled as well, but only the outer ones can be touched" : "no sample lies on them"),
      all ? "" : "set /sampling/shells to \"all\" to sample them as well"));
}

/// The region was painted on another mesh where it names faces that this one has not.
void check_region(const std::vector<int>& region, const TriMesh& mesh, Problems& out) {
  if (region.empty() || region.back() < mesh.face_count()) return;
  const auto beyond = region.end() - std::lower_bound(region.begin(), region.end(), mesh.face_count());
  out.push_back(problem("/sampling/region", Severity::warning, "region_off_mesh",
                        fmt::format("names face {}, the mesh has {}: {} of {} painted faces are not there",
                                    region.back(), mesh.face_count(), beyond, region.size()),
                        "paint the region again"));
}

/// Checks the density of the samples for a sampled area.
void check_density(const Sampling& sampling, double area, Problems& out) {
  const double wanted = sampling.density * area;
  if (!(wanted <= kMaxSamples))
    out.push_back(problem(
        "/sampling/density", Severity::error, "density_too_high",
        fmt::format("{} per square metre gives {:.4g} samples, the limit is {}", sampling.density, wanted, kMaxSamples),
        fmt::format("at most {:.3g}", kMaxSamples / area)));
  else if (!(area > 0))
    out.push_back(problem("/sampling/region", Severity::warning, "region_empty",
                          "names no face that is sampled: no sample lies anywhere", "paint the region again"));
  else if (wanted < 0.5)
    out.push_back(problem("/sampling/density", Severity::warning, "density_too_low",
                          fmt::format("{} per square metre gives no sample at all", sampling.density),
                          fmt::format("at least {:.3g}", 1.0 / area)));
}

void check_own_mesh(const Layout& layout, const LayoutMesh& layout_mesh, const std::string& sha256, Problems& out) {
  const TriMesh& mesh = *layout_mesh.repaired.mesh;
  const TriMesh& skin = layout_mesh.skin.mesh();
  if (!layout.mesh.sha256.empty() && !sha256.empty() && layout.mesh.sha256 != sha256)
    out.push_back(problem("/mesh/sha256", Severity::warning, "mesh_changed",
                          fmt::format("is {}, but the file's is {}", layout.mesh.sha256, sha256),
                          "look whether the taxels still lie on the surface, then save the layout again"));
  if (!mesh.closed() && layout.material.compliant())
    out.push_back(problem("/mesh/file", Severity::error, "mesh_open",
                          "must be a closed mesh to be soft: " + openings(mesh),
                          layout.mesh.repair.level == RepairLevel::automatic
                              ? "repair the mesh there, or set /material/modulus to 0"
                              : "set /mesh/repair/level to \"auto\", or /material/modulus to 0"));
  check_shells(layout, mesh, skin, out);
  const std::vector<int>& region = *layout.sampling.region;
  check_region(region, layout_mesh.loaded, out);
  check_density(layout.sampling,
                region.empty() ? skin.area() : area_of_faces(mesh, repaired_faces(layout_mesh.repaired, region)), out);
}

/// Returns true if a face has a normal within the angle of the rule: its own, or that of `nearest` or of a corner if
/// the rule interpolates.
bool faces_along(const TriMesh& mesh, int face, const dvec3& nearest, const dvec3& n, const ReceptiveFieldRule& rule) {
  const double least = min_cosine(rule);
  const auto within = [&](const dvec3& point) {
    return glm::dot(field_normal(rule.normals, mesh, face, point), n) > least;
  };
  if (within(nearest)) return true;
  return rule.normals == FieldNormals::interpolated &&
         (within(mesh.vertex(face, 0)) || within(mesh.vertex(face, 1)) || within(mesh.vertex(face, 2)));
}

/// Returns true if any face has a point within the disc's radius of `center` and a normal within the angle of the rule.
template <class T>
bool reaches_surface(const T& disc, const dvec3& center, const ReceptiveFieldRule& rule, const MeshIndex& skin) {
  const TriMesh& mesh = skin.mesh();
  const dvec3 n = glm::normalize(disc.normal);
  bool found = false;
  skin.tree().visit_near(center, disc.radius, [&](int face) {
    if (found) return 0.0;
    const TrianglePoint nearest =
        nearest_on_triangle(center, mesh.vertex(face, 0), mesh.vertex(face, 1), mesh.vertex(face, 2));
    found = nearest.squared_distance < disc.radius * disc.radius && faces_along(mesh, face, nearest.position, n, rule);
    return found ? 0.0 : disc.radius;
  });
  return found;
}

/// Distance and direction of one disc against the nearest surface.
template <class T>
void check_disc_on_skin(const std::string& pointer, const T& disc, const ReceptiveFieldRule& rule,
                        const MeshIndex& skin, Problems& out) {
  const double far = 0.25;                    // of the radius
  const double skewed = 60.0, inward = 90.0;  // degrees
  const SurfacePoint nearest = skin.closest_point(disc.center);
  const dvec3 n = skin.mesh().face_normals()[static_cast<std::size_t>(nearest.face)];
  if (nearest.distance > far * disc.radius)
    out.push_back(problem(pointer + "/center", nearest.distance > disc.radius ? Severity::error : Severity::warning,
                          "center_off_surface",
                          fmt::format("is {:.3g} mm from the surface, the radius is {:.3g} mm",
                                      nearest.distance * kMillimetres, disc.radius * kMillimetres),
                          fmt::format("nearest point of the surface: [{:.7g}, {:.7g}, {:.7g}]", nearest.position.x,
                                      nearest.position.y, nearest.position.z)));
  const double angle = angle_deg(disc.normal, n);
  const std::string use = fmt::format("normal of the surface there: [{:.6g}, {:.6g}, {:.6g}]", n.x, n.y, n.z);
  if (angle > inward)
    out.push_back(problem(pointer + "/normal", Severity::warning, "normal_points_inward",
                          fmt::format("points inward: {:.0f} degrees from the surface's normal", angle), use));
  else if (angle > skewed)
    out.push_back(problem(pointer + "/normal", Severity::warning, "normal_off_surface",
                          fmt::format("is {:.0f} degrees from the surface's normal", angle), use));
  if (disc.radius > skin.mesh().bounds().diagonal())
    out.push_back(problem(
        pointer + "/radius", Severity::warning, "radius_exceeds_body",
        fmt::format("{} m is larger than the whole mesh, {:.3g} m", disc.radius, skin.mesh().bounds().diagonal()),
        "in metres: 6 mm is 0.006"));
  // A geodesic field lies around the nearest point; no path there is shorter than the straight way.
  const dvec3& center = rule.metric == Metric::geodesic ? nearest.position : disc.center;
  if (!reaches_surface(disc, center, rule, skin))
    out.push_back(problem(
        pointer, Severity::warning, "field_empty",
        fmt::format("no surface within {:.3g} mm has a normal within {:.4g} degrees of the taxel's: it will read 0",
                    disc.radius * kMillimetres, rule.max_angle_deg),
        "move the centre to the surface and turn the normal outward"));
}

template <class T>
bool placeable(const T& disc) {
  const dvec3 c = glm::abs(disc.center);
  return is_finite(disc.center) && std::max({c.x, c.y, c.z}) <= kFarthest && is_finite(disc.normal) &&
         glm::length(disc.normal) > 0.0 && disc.radius > 0.0;
}

/// Returns whether most centres are far from the mesh, and on the mesh if they are read in mm.
bool centers_look_like_mm(const Layout& layout, const MeshIndex& skin) {
  constexpr double kOnSkin = 0.02;  // distance from the skin, as a fraction of the mesh's diagonal
  constexpr double kMetresPerMillimetre = 0.001;
  const dvec3 middle = skin.mesh().bounds().center();
  const double size = skin.mesh().bounds().diagonal();
  std::size_t far = 0, on_skin = 0;
  for (const Taxel& taxel : layout.taxels) {
    if (!is_finite(taxel.center) || glm::length(taxel.center - middle) < 2 * size) continue;
    ++far;
    if (skin.closest_point(kMetresPerMillimetre * taxel.center).distance < kOnSkin * size) ++on_skin;
  }
  return 2 * far > layout.taxels.size() && 2 * on_skin > layout.taxels.size();
}

}  // namespace

Problems check_layout_mesh(const RepairedMesh& repaired, const std::string& file) {
  const TriMesh& mesh = *repaired.mesh;
  Problems out =
      check_cuts_and_size(mesh, repaired.crossings ? *repaired.crossings : find_self_intersections(mesh), file);
  for (Problem& p : out) p.pointer = p.code == "mesh_units" ? "/mesh/scale" : "/mesh/file";
  return out;
}

Problems check_layout_on_mesh(const Layout& layout, const MeshIndex& index, const std::string& sha256,
                              const std::string& file) {
  const TriMesh& mesh = index.mesh();
  const RepairedMeshPtr repaired = as_loaded(index.mesh_ptr());
  const std::vector<int> outer = outer_shells(mesh);
  if (layout.sampling.shells == Shells::all || static_cast<int>(outer.size()) == mesh.shell_count())
    return check_layout_on_skin(layout, {mesh, *repaired, index}, sha256, file);
  const MeshIndex skin(std::make_shared<TriMesh>(extract_shells(mesh, outer)));
  return check_layout_on_skin(layout, {mesh, *repaired, skin}, sha256, file);
}

Problems check_loaded_mesh(const TriMesh& loaded, const RepairedMesh& repaired, const std::string& file) {
  Problems out;
  if (repaired.mesh.get() == &loaded) return out;
  for (Problem& p : check_edges(loaded, file))
    out.push_back({file, "/mesh/file", Severity::note, p.code, "the file has " + p.message, ""});
  return out;
}

Problems check_layout_on_skin(const Layout& layout, const LayoutMesh& mesh, const std::string& sha256,
                              const std::string& file) {
  const MeshIndex& skin = mesh.skin;
  Problems out;
  check_own_mesh(layout, mesh, sha256, out);
  for (Problem& p : out) p.file = file;
  if (centers_look_like_mm(layout, skin)) {
    // The other findings about the taxels would be consequences.
    out.push_back({file, "/taxels", Severity::error, "centers_in_mm",
                   "the centres are far from the mesh, and on it if they are read in mm: are they in mm?",
                   "multiply the coordinates of the centres by 0.001: they are in metres"});
    return out;
  }
  const ReceptiveFieldRule& rule = layout.receptive_field;
  for (std::size_t k = 0; k < layout.taxels.size(); ++k) {
    const Taxel& taxel = layout.taxels[k];
    const std::string pointer = fmt::format("/taxels/{}", k);
    if (taxel.subtaxels.empty() && placeable(taxel)) check_disc_on_skin(pointer, taxel, rule, skin, out);
    for (std::size_t i = 0; i < taxel.subtaxels.size(); ++i)
      if (placeable(taxel.subtaxels[i]))
        check_disc_on_skin(fmt::format("{}/subtaxels/{}", pointer, i), taxel.subtaxels[i], rule, skin, out);
  }
  name_taxels(layout, out);
  for (Problem& p : out) p.file = file;
  return out;
}

}  // namespace taxel
