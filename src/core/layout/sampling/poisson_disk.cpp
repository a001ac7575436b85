// Samples of a whole surface, and of its denser parts.
//
// Constrained Poisson-disk samples (Corsini, Cignoni, Scopigno 2012) of an exact number, in stages: a pool of 5 points
// per sample (surface_sample.cpp), from which the most crowded points are removed until the number is right (Yuksel
// 2015), sweeps that move each sample to the largest empty circle next to it, and a last one that closes gaps
// (even_samples.cpp), and the areas of the Voronoi cells (voronoi_area.cpp). A preview ends after the second stage,
// with a pool of 3.
//
// Taxels with a density of their own get a denser part, which is described below. Pitfalls: the area of a large face
// says little about a small part, so faces near a part are first cut into small triangles; samples crowd at the edge of
// a patch, where nothing pushes them back, so a patch gets a quarter of a sample more per spacing of its edge. Theory:
// docs/theory/layout.md, "Samples".
#include "core/layout/sampling/poisson_disk.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/layout/field/point_grid.h"
#include "core/layout/sampling/even_samples.h"
#include "core/layout/sampling/surface_sample.h"
#include "core/layout/sampling/voronoi_area.h"

namespace taxel {

int sample_count(double density, double area) {
  const double count = std::round(density * area);
  if (!(count >= 0.0 && count <= kMaxSamples))
    throw Error(fmt::format("density {} per square metre on {} square metres gives {} samples, the limit is {}",
                            density, area, count, kMaxSamples));
  return static_cast<int>(count);
}

std::vector<SurfaceSample> sample_surface(const TriMesh& mesh, int count, std::uint64_t seed, Progress* progress,
                                          SampleQuality quality) {
  if (count < 0 || count > kMaxSamples)
    throw Error(fmt::format("{} samples asked for, the limits are 0 and {}", count, kMaxSamples));
  if (count == 0) return {};
  const bool polished = quality == SampleQuality::polished;
  const SurfacePool pool = make_surface_pool(mesh, pool_factor(quality) * count, seed);
  const SurfaceGraph surface(mesh);
  constexpr double kBegin = 0.1, kPolish = 0.3, kEnd = 0.9;                            // about their parts of the time
  const double reach = 2.0 * std::sqrt(mesh.area() / (2.0 * std::sqrt(3.0) * count));  // of the hexagonal packing
  const std::vector<int> kept = [&] {
    const ProgressPart part(progress, kBegin, polished ? kPolish : kEnd);
    return eliminate_samples(surface, pool, count, reach, progress);
  }();

  std::vector<SurfaceSample> samples;
  samples.reserve(kept.size());
  for (const int k : kept) {
    const auto i = static_cast<std::size_t>(k);
    samples.push_back({pool.positions[i], pool.normals[i], pool.faces[i], mesh.area() / count});
  }
  if (polished) {
    const double spacing = std::sqrt(2.0 * mesh.area() / (std::sqrt(3.0) * count));  // spacing of the hexagonal packing
    const ProgressPart part(progress, kPolish, kEnd);
    spread_samples(surface, spacing, kSpreadSweeps, samples, progress);
    assign_voronoi_areas(mesh, samples);
  }
  return samples;
}

// Denser parts. Each part is sampled in turn, the least dense first: a patch that is larger than the part is sampled
// densely, and replaces samples cell by cell.
//
//     |  o  |  o  |       o  usual samples and their Voronoi cells: these two keep place and area
//   --+-----+-----+--
//     |. . .|. . .|       .  samples of the patch that are in the cells of usual samples of the part: they take their
//     | . . | . . |          place, and share their area
//     |. . .|. . .|
//   --+-----+-----+--
//
// Samples of the patch in the other cells, its border, are thrown away: with them, those at the edge of the part are as
// evenly spread as those inside.

namespace {

/// The faces of a surface near a part, cut into triangles of about the size of the part.
struct PartSurface {
  TriMesh mesh;
  std::vector<int> face_of;  ///< face of the whole surface, of each triangle
};

/// The union of discs of one density. Immutable, so threads can share it.
class DensePart {
 public:
  /// `usual_density` is that of the samples around the part [1/m^2].
  DensePart(std::vector<DenseDisc> discs, double usual_density);

  [[nodiscard]] double density() const { return discs_.front().density; }
  [[nodiscard]] double spacing() const { return spacing_; }  ///< spacing of the densest packing [m]

  /// Returns true if the cell of a usual sample, on a face with this normal, can reach into a disc.
  [[nodiscard]] bool has(const dvec3& point, const dvec3& normal) const;
  /// Returns true if a point is within a distance of the patch: the cells of the samples that has() accepts, and a
  /// border of 3 spacings.
  [[nodiscard]] bool is_within(const dvec3& point, double distance) const;
  /// Returns the distance from a disc at which the patch ends [m].
  [[nodiscard]] double patch_reach() const;

  /// Returns the faces of `mesh` in the patch, and some around it.
  [[nodiscard]] PartSurface surface(const TriMesh& mesh) const;
  /// Returns `per_sample` times `density` points per area of the patch, each in its own piece of equal area
  /// (make_surface_pool()). Throws Error if they are too many.
  [[nodiscard]] SurfacePool pool(const TriMesh& mesh, const PartSurface& near, int per_sample,
                                 std::uint64_t seed) const;

 private:
  template <class Accept>
  [[nodiscard]] bool any_disc(const dvec3& point, double reach, const Accept& accept) const;

  std::vector<DenseDisc> discs_;
  double spacing_ = 0, usual_spacing_ = 0, largest_radius_ = 0;
  PointGrid centers_;
};

double spacing_of(double density) {
  return std::sqrt(2.0 / (std::sqrt(3.0) * density));
}

std::vector<dvec3> centers_of(const std::vector<DenseDisc>& discs) {
  std::vector<dvec3> centers;
  for (const DenseDisc& disc : discs) centers.push_back(disc.center);
  return centers;
}

double largest_radius_of(const std::vector<DenseDisc>& discs) {
  double largest = 0;
  for (const DenseDisc& disc : discs) largest = std::max(largest, disc.radius);
  return largest;
}

/// Cuts faces near a part into small triangles: the areas of large faces would need a pool of far too many points.
class FaceHalving {
 public:
  /// Triangles have no corner farther than `size` from their centroid.
  FaceHalving(const DensePart& part, double size) : part_(part), size_(size) {}

  /// Adds the parts of a triangle of a face.
  void add(int face, const std::array<dvec3, 3>& t) {
    const dvec3 center = (t[0] + t[1] + t[2]) / 3.0;
    double radius = 0;
    for (const dvec3& corner : t) radius = std::max(radius, glm::distance(center, corner));
    if (!part_.is_within(center, radius)) return;
    if (radius <= size_) {
      if (!part_.is_within(center, 0)) return;
      const auto first = static_cast<int>(vertices_.size());
      vertices_.insert(vertices_.end(), t.begin(), t.end());
      faces_.emplace_back(first, first + 1, first + 2);
      face_of_.push_back(face);
      return;
    }
    const std::array<double, 3> edge{glm::distance(t[0], t[1]), glm::distance(t[1], t[2]), glm::distance(t[2], t[0])};
    const auto k = static_cast<std::size_t>(std::max_element(edge.begin(), edge.end()) - edge.begin());
    const dvec3 &from = t[k], &to = t[(k + 1) % 3], &apex = t[(k + 2) % 3], middle = 0.5 * (from + to);
    add(face, {from, middle, apex});
    add(face, {middle, to, apex});
  }
  [[nodiscard]] PartSurface surface() && { return {{vertices_, faces_}, std::move(face_of_)}; }

 private:
  const DensePart& part_;
  double size_;
  std::vector<dvec3> vertices_;
  std::vector<ivec3> faces_;
  std::vector<int> face_of_;
};

/// Distance from a sample to which its Voronoi cell reaches, in spacings; spread_samples() moves those with wider ones.
constexpr double kCell = 0.75;
constexpr double kBorder = 3.0;        // width of the border of a patch, in spacings of the part
constexpr double kFinest = 1.0 / 200;  // smallest triangles, as a fraction of the patch: limits their number

DensePart::DensePart(std::vector<DenseDisc> discs, double usual_density)
    : discs_(std::move(discs)),
      spacing_(spacing_of(discs_.front().density)),
      usual_spacing_(spacing_of(usual_density)),
      largest_radius_(largest_radius_of(discs_)),
      centers_(centers_of(discs_), largest_radius_) {}

template <class Accept>
bool DensePart::any_disc(const dvec3& point, double reach, const Accept& accept) const {
  bool found = false;
  centers_.visit_near(point, largest_radius_ + reach, [&](int i) {
    const DenseDisc& disc = discs_[at(i)];
    found = found || (glm::distance(point, disc.center) <= disc.radius + reach && accept(disc));
  });
  return found;
}

bool DensePart::has(const dvec3& point, const dvec3& normal) const {
  return any_disc(point, kCell * usual_spacing_,
                  [&](const DenseDisc& disc) { return glm::dot(normal, disc.normal) >= disc.least_cosine; });
}

double DensePart::patch_reach() const {
  return 2 * kCell * usual_spacing_ + kBorder * spacing_;
}

bool DensePart::is_within(const dvec3& point, double distance) const {
  return any_disc(point, patch_reach() + distance, [](const DenseDisc&) { return true; });
}

PartSurface DensePart::surface(const TriMesh& mesh) const {
  FaceHalving halving(*this, std::max(spacing_, kFinest * (largest_radius_ + patch_reach())));
  for (int f = 0; f < mesh.face_count(); ++f) halving.add(f, {mesh.vertex(f, 0), mesh.vertex(f, 1), mesh.vertex(f, 2)});
  return std::move(halving).surface();
}

SurfacePool DensePart::pool(const TriMesh& mesh, const PartSurface& near, int per_sample, std::uint64_t seed) const {
  SurfacePool pool;
  if (near.face_of.empty()) return pool;
  const double count = std::round(per_sample * density() * near.mesh.area());
  if (!(count <= double(per_sample) * kMaxSamples))
    throw Error(fmt::format("a density of {} per square metre gives {:.4g} samples, the limit is {}", density(),
                            count / per_sample, kMaxSamples));
  const SurfacePool all = make_surface_pool(near.mesh, static_cast<int>(count), seed);
  for (int i = 0; i < all.size(); ++i) {
    if (!is_within(all.positions[at(i)], 0)) continue;
    const int face = near.face_of[at(all.faces[at(i)])];
    pool.positions.push_back(all.positions[at(i)]);
    pool.normals.push_back(mesh.face_normals()[at(face)]);
    pool.faces.push_back(face);
  }
  return pool;
}

/// Returns the parts of discs denser than `density`, by ascending density, then in the order of their first discs.
/// Discs of one density whose patches overlap make one part.
std::vector<DensePart> dense_parts(std::vector<DenseDisc> discs, double density) {
  std::erase_if(discs, [&](const DenseDisc& disc) { return !(disc.density > density) || !(disc.radius > 0); });
  std::stable_sort(discs.begin(), discs.end(),
                   [](const DenseDisc& a, const DenseDisc& b) { return a.density < b.density; });
  std::vector<DensePart> parts;
  for (std::size_t begin = 0, end = 0; begin < discs.size(); begin = end) {
    while (end < discs.size() && discs[end].density == discs[begin].density) ++end;
    std::vector<bool> used(end - begin, false);
    const double reach = 2 * DensePart({discs[begin]}, density).patch_reach();
    for (std::size_t i = begin; i < end; ++i) {
      if (used[i - begin]) continue;
      used[i - begin] = true;
      std::vector<DenseDisc> part{discs[i]};
      for (std::size_t k = 0; k < part.size(); ++k) {  // the list grows by the discs that overlap with its discs
        for (std::size_t j = i + 1; j < end; ++j) {
          const bool apart = glm::distance(part[k].center, discs[j].center) > part[k].radius + discs[j].radius + reach;
          if (used[j - begin] || apart) continue;
          used[j - begin] = true;
          part.push_back(discs[j]);
        }
      }
      parts.emplace_back(std::move(part), density);
    }
  }
  return parts;
}

/// Returns the number of samples that gives the inside of a patch the density of the part. Samples crowd at the edge of
/// a patch, where nothing pushes them back: measured, a quarter of a sample more per spacing of the edge.
int sample_count_of(const SurfacePool& pool, const DensePart& part, int per_sample) {
  constexpr double kAtEdge = 0.25;
  const double spacing = part.spacing(), per_area = part.density() * spacing * spacing;  // samples per spacing squared
  const auto in_strip = std::count_if(pool.positions.begin(), pool.positions.end(),
                                      [&](const dvec3& p) { return !part.is_within(p, -spacing); });
  const double edge = static_cast<double>(in_strip) / (per_sample * per_area);  // length of the edge, in spacings
  return static_cast<int>(std::round(pool.size() / double(per_sample) + kAtEdge * edge));
}

/// Samples a patch.
std::vector<SurfaceSample> sample_patch(const SurfaceGraph& surface, const PartSurface& near, const DensePart& part,
                                        const DenseSampling& how, Progress* progress) {
  const int per_sample = pool_factor(how.quality);
  const SurfacePool pool = part.pool(surface.mesh(), near, per_sample, how.seed);
  const int count = sample_count_of(pool, part, per_sample);
  std::vector<SurfaceSample> patch;
  if (count == 0) return patch;
  for (const int k : eliminate_samples(surface, pool, count, part.spacing(), progress))
    patch.push_back({pool.positions[at(k)], pool.normals[at(k)], pool.faces[at(k)]});
  if (how.quality == SampleQuality::polished)
    spread_samples(surface, part.spacing(), kSpreadSweeps, patch, progress,
                   [&](const dvec3& place) { return part.is_within(place, 0); });
  return patch;
}

/// Replaces the samples of one part by those of its patch.
void sample_part(const SurfaceGraph& surface, const DensePart& part, const DenseSampling& how,
                 std::vector<SurfaceSample>& samples, Progress* progress) {
  const double usual_spacing = 1 / std::sqrt(how.density);
  const PartSurface near = part.surface(surface.mesh());
  const std::vector<SurfaceSample> patch = sample_patch(surface, near, part, how, progress);
  const std::vector<int> cells = cells_of(patch, samples, usual_spacing);
  std::vector<bool> is_replaced;
  std::vector<SurfaceSample> dense, others;
  double area = 0;
  for (const SurfaceSample& s : samples) {
    is_replaced.push_back(part.has(s.position, s.normal));
    if (!is_replaced.back())
      others.push_back(s);
    else
      area += s.area;
  }
  for (std::size_t i = 0; i < patch.size(); ++i)
    if (is_replaced[at(cells[i])]) dense.push_back(patch[i]);
  if (dense.empty()) return;
  for (SurfaceSample& s : dense) s.area = area / static_cast<double>(dense.size());
  if (how.quality == SampleQuality::polished) {
    const TriMesh own = surface_of_cells(near.mesh, samples, is_replaced, usual_spacing);
    assign_voronoi_areas(own, dense);
    for (SurfaceSample& s : dense) s.area *= area / own.area();  // removes rounding errors
  }
  for (SurfaceSample& s : dense) s.share = how.density * s.area;
  samples = std::move(others);
  samples.insert(samples.end(), dense.begin(), dense.end());
}

}  // namespace

std::vector<SurfaceSample> add_dense_samples(const TriMesh& mesh, std::vector<SurfaceSample> samples,
                                             const DenseSampling& how, Progress* progress) {
  const std::vector<DensePart> parts = dense_parts(how.discs, how.density);
  if (parts.empty() || samples.empty()) return samples;
  const SurfaceGraph surface(mesh);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const DensePart& part = parts[p];
    const auto fraction = [&](std::size_t done) {
      return static_cast<double>(done) / static_cast<double>(parts.size());
    };
    const ProgressPart range(progress, fraction(p), fraction(p + 1));
    sample_part(surface, part, how, samples, progress);
    if (samples.size() > static_cast<std::size_t>(kMaxSamples))
      throw Error(fmt::format("the densities of taxels give more than {} samples", kMaxSamples));
  }
  return samples;
}

}  // namespace taxel
