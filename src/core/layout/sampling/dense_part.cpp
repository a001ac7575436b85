#include "core/layout/sampling/dense_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/layout/sampling/poisson_disk.h"

namespace taxel {
namespace {

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

}  // namespace

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

}  // namespace taxel
