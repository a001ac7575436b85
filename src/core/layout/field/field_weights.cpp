#include "core/layout/field/field_weights.h"

#include <algorithm>
#include <numeric>

#include "core/base/index.h"
#include "core/base/parallel.h"
#include "core/base/per_thread.h"
#include "core/mesh/query/skin_normal.h"

namespace taxel {
namespace {

std::vector<int> by_id(const Layout& layout) {
  std::vector<int> order(layout.taxels.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return layout.taxels[taxel::at(a)].id < layout.taxels[taxel::at(b)].id; });
  return order;
}

}  // namespace

FieldWeights::FieldWeights(const Layout& layout, const MeshIndex& skin)
    : skin_(skin.mesh_ptr()), angle_(layout.receptive_field), normals_(layout.receptive_field.normals) {
  const bool geodesic = layout.receptive_field.metric == Metric::geodesic;
  std::vector<SurfacePoint> starts;
  std::vector<dvec3> origins;
  for (const int taxel : by_id(layout)) {
    for (const FieldDisc& disc : discs_of(layout.taxels[taxel::at(taxel)])) {
      if (geodesic) starts.push_back(skin.closest_point(disc.center));
      discs_.push_back({disc, taxel, geodesic ? starts.back().position : disc.center});
      origins.push_back(discs_.back().origin);
      largest_radius_ = std::max(largest_radius_, disc.radius);
    }
  }
  grid_ = PointGrid(origins, largest_radius_ > 0 ? largest_radius_ : 1.0);
  if (!geodesic) return;
  const auto unfolded = std::make_shared<const UnfoldedMesh>(skin_);
  PerThread<GeodesicDistance> distances([&] { return GeodesicDistance(unfolded); });
  paths_.resize(discs_.size());
  parallel_chunks(static_cast<int>(discs_.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const SurfacePoint& from = starts[taxel::at(i)];
      GeodesicDistance& distance = distances.local();
      distance.propagate(from.face, from.position, discs_[taxel::at(i)].disc.radius);
      paths_[taxel::at(i)] = GeodesicMap(unfolded, distance, from.position);
    }
  });
}

void FieldWeights::near(const dvec3& p, double reach, std::vector<int>& discs) const {
  discs.clear();
  grid_.visit_near(p, reach + largest_radius_, [&](int i) {
    const Disc& d = discs_[taxel::at(i)];
    if (glm::distance(d.origin, p) <= d.disc.radius + reach) discs.push_back(i);
  });
  std::sort(discs.begin(), discs.end());
}

double FieldWeights::smallest_radius(std::span<const int> discs) const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const int i : discs) smallest = std::min(smallest, discs_[taxel::at(i)].disc.radius);
  return smallest;
}

double FieldWeights::distance(int disc, int face, const dvec3& point) const {
  return paths_.empty() ? glm::distance(discs_[taxel::at(disc)].origin, point)
                        : paths_[taxel::at(disc)].to(face, point);
}

void FieldWeights::at(int face, const dvec3& point, std::span<const int> discs, AtPoint& out) const {
  at(face, point, skin_->face_normals()[taxel::at(face)], discs, out);
}

void FieldWeights::at(int face, const dvec3& point, const dvec3& normal, std::span<const int> discs,
                      AtPoint& out) const {
  const dvec3 n = normals_ == FieldNormals::interpolated ? skin_normal(*skin_, face, point) : normal;
  out.weights.clear();
  out.margin = -std::numeric_limits<double>::infinity();
  double nearest = 0;  // subtaxel of the last taxel so far
  for (const int i : discs) {
    const Disc& d = discs_[taxel::at(i)];
    const double facing = d.disc.facing(n, angle_);
    if (!(facing > 0)) continue;
    const double r = d.disc.radius, away = distance(i, face, point);
    if (!(away <= r)) {  // no path is shorter than the straight way
      out.margin = std::max(out.margin, std::min(0.0, r - glm::distance(d.origin, point)));
      continue;
    }
    out.margin = std::max(out.margin, r - away);
    const bool same = !out.weights.empty() && out.weights.back().taxel == d.taxel;
    if (same && !(away < nearest)) continue;
    if (!same) out.weights.emplace_back();
    nearest = away;
    out.weights.back() = {d.taxel, d.disc.weight(away) * facing, facing};
  }
  out.cover = 0;
  for (const Weight& w : out.weights)
    if (w.value > 0) out.cover = std::max(out.cover, w.facing);
}

}  // namespace taxel
