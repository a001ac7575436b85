// The samples of each field with their distances and weights, dense discs, and weights at any point of the skin.
//
// A field is gathered disc by disc: with straight distances from a hashed grid over the samples, whose cells are a
// third of the smallest radius; with distances along the surface by windows from the point of the skin closest to the
// centre, up to the radius (core/mesh/geodesic.h), for the samples on the faces reached. A sample in several discs of
// one taxel belongs to the nearest. Rows are sorted by sample, so the result does not depend on threads.
//
// At any point of the skin, the discs that may reach it come from a grid over the centres; with distances along the
// surface each disc keeps a compact copy of its windows. Discs are in the order of taxel ids, so that sums over them do
// not depend on the order of the taxels. Pitfall: the cosines that decide where samples are dense are constants,
// because computed ones differ between machines. Theory: docs/theory/layout.md, "Receptive fields".
#include "core/layout/field/receptive_field.h"

#include <algorithm>
#include <numeric>

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/layout/field/point_grid.h"
#include "core/mesh/geodesic.h"
#include "core/mesh/query/triangle.h"

namespace taxel {
namespace {

/// Straight distances from the stored centre.
class EuclideanReach {
 public:
  EuclideanReach(const Layout& layout, const std::vector<SurfaceSample>& samples)
      : samples_(samples), grid_(positions_of(samples), cell_size(layout)) {}

  /// Calls visit(sample, distance, facing) for every sample within the disc's radius where facing(sample) is positive.
  template <class Facing, class Visit>
  void operator()(const FieldDisc& disc, const Facing& facing, const Visit& visit) {
    grid_.visit_near(disc.center, disc.radius, [&](int i) {
      const double d = glm::distance(disc.center, samples_[static_cast<std::size_t>(i)].position);
      if (!(d <= disc.radius)) return;
      const double c = facing(i);
      if (c > 0) visit(i, d, c);
    });
  }

 private:
  static std::vector<dvec3> positions_of(const std::vector<SurfaceSample>& samples) {
    std::vector<dvec3> positions;
    positions.reserve(samples.size());
    for (const SurfaceSample& s : samples) positions.push_back(s.position);
    return positions;
  }
  /// Cells a third of the smallest radius: few points outside of the ball are looked at, few cells are empty.
  static double cell_size(const Layout& layout) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Taxel& taxel : layout.taxels)
      for (const FieldDisc& disc : discs_of(taxel)) smallest = std::min(smallest, disc.radius);
    return std::isfinite(smallest) && smallest > 0.0 ? smallest / 3.0 : 1.0;
  }

  const std::vector<SurfaceSample>& samples_;
  PointGrid grid_;
};

/// Lengths of shortest paths on the skin from the point closest to the centre.
class GeodesicReach {
 public:
  GeodesicReach(const std::vector<SurfaceSample>& samples, const MeshIndex& skin)
      : samples_(samples),
        skin_(skin),
        first_on_face_(skin.mesh().faces().size() + 1, 0),
        distances_(
            [unfolded = std::make_shared<const UnfoldedMesh>(skin.mesh_ptr())] { return GeodesicDistance(unfolded); }) {
    for (const SurfaceSample& s : samples) ++first_on_face_[static_cast<std::size_t>(s.face) + 1];
    for (std::size_t f = 1; f < first_on_face_.size(); ++f) first_on_face_[f] += first_on_face_[f - 1];
    std::vector<int> next(first_on_face_.begin(), first_on_face_.end() - 1);
    on_faces_.resize(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
      on_faces_[static_cast<std::size_t>(next[static_cast<std::size_t>(samples[i].face)]++)] = static_cast<int>(i);
  }

  template <class Facing, class Visit>
  void operator()(const FieldDisc& disc, const Facing& facing, const Visit& visit) {
    GeodesicDistance& distance = distances_.local();
    const SurfacePoint from = skin_.closest_point(disc.center);
    distance.propagate(from.face, from.position, disc.radius);
    for (const int face : distance.reached_faces()) {
      const auto f = static_cast<std::size_t>(face);
      for (int k = first_on_face_[f]; k < first_on_face_[f + 1]; ++k) {
        const int i = on_faces_[static_cast<std::size_t>(k)];
        const double c = facing(i);
        if (!(c > 0)) continue;
        const double d = distance.to(face, samples_[static_cast<std::size_t>(i)].position);
        if (d <= disc.radius) visit(i, d, c);
      }
    }
  }

 private:
  const std::vector<SurfaceSample>& samples_;
  const MeshIndex& skin_;
  std::vector<int> first_on_face_, on_faces_;  ///< samples by face
  PerThread<GeodesicDistance> distances_;
};

/// The normals of the skin at the samples that the angle of a field refers to.
class SampleNormals {
 public:
  SampleNormals(FieldNormals normals, const std::vector<SurfaceSample>& samples, const TriMesh& skin)
      : samples_(samples) {
    if (normals == FieldNormals::face) return;
    interpolated_.resize(samples.size());
    parallel_chunks(static_cast<int>(samples.size()), 1024, [&](int begin, int end) {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
        interpolated_[i] = skin_normal(skin, samples[i].face, samples[i].position);
    });
  }
  const dvec3& operator[](int sample) const {
    const auto i = static_cast<std::size_t>(sample);
    return interpolated_.empty() ? samples_[i].normal : interpolated_[i];
  }

 private:
  const std::vector<SurfaceSample>& samples_;
  std::vector<dvec3> interpolated_;
};

/// The union of the discs' fields; a sample in several belongs to the nearest of them.
template <class Reach>
std::vector<ReceptiveFields::Entry> gather(const Taxel& taxel, const FieldAngle& angle, const SampleNormals& normals,
                                           Reach& reach) {
  std::vector<ReceptiveFields::Entry> row;
  for (const FieldDisc& disc : discs_of(taxel)) {
    const auto facing = [&](int i) { return disc.facing(normals[i], angle); };
    reach(disc, facing, [&](int i, double d, double c) { row.push_back({i, d, disc.weight(d) * c}); });
  }
  std::sort(row.begin(), row.end(), [](const auto& a, const auto& b) {
    return a.sample != b.sample ? a.sample < b.sample : a.distance < b.distance;
  });
  row.erase(std::unique(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.sample == b.sample; }),
            row.end());
  return row;
}

template <class Reach>
std::vector<std::vector<ReceptiveFields::Entry>> gather_all(const Layout& layout, const SampleNormals& normals,
                                                            Reach reach) {
  const FieldAngle angle(layout.receptive_field);
  std::vector<std::vector<ReceptiveFields::Entry>> rows(layout.taxels.size());
  parallel_chunks(static_cast<int>(rows.size()), 1, [&](int begin, int end) {
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
      rows[k] = gather(layout.taxels[k], angle, normals, reach);
  });
  return rows;
}

}  // namespace

ReceptiveFields make_receptive_fields(const Layout& layout, const std::vector<SurfaceSample>& samples,
                                      const MeshIndex& skin) {
  const SampleNormals normals(layout.receptive_field.normals, samples, skin.mesh());
  const auto rows = layout.receptive_field.metric == Metric::geodesic
                        ? gather_all(layout, normals, GeodesicReach(samples, skin))
                        : gather_all(layout, normals, EuclideanReach(layout, samples));
  ReceptiveFields fields;
  std::size_t count = 0;
  for (const auto& row : rows) count += row.size();
  fields.entries.reserve(count);
  for (const auto& row : rows) {
    fields.entries.insert(fields.entries.end(), row.begin(), row.end());
    fields.first.push_back(static_cast<int>(fields.entries.size()));
  }
  if (layout.sampling.weights == SampleWeights::equal) {
    for (ReceptiveFields::Entry& e : fields.entries) e.weight *= samples[static_cast<std::size_t>(e.sample)].share;
  } else {
    double total_area = 0.0;
    for (const SurfaceSample& s : samples) total_area += s.area;
    const double per_area = total_area > 0.0 ? uniform_samples(layout, samples.size(), total_area) / total_area : 0.0;
    for (ReceptiveFields::Entry& e : fields.entries)
      e.weight *= samples[static_cast<std::size_t>(e.sample)].area * per_area;  // area over the mean area
  }
  return fields;
}

namespace {

/// Least cosine between the normals of a taxel and of a face with its density. Constants, because a computed cosine
/// differs between machines. The first one lets a field end at the angle limit without a change of the density there,
/// and leaves out the opposite wall.
constexpr double kFrontSide = -0.1, kAllSides = -2.0;
constexpr double kWideAngle = 70.0;  // limit of the angle up to which the front side is enough [degrees]

}  // namespace

double uniform_samples(const Layout& layout, std::size_t count, double area) {
  const bool any_dense = std::any_of(layout.taxels.begin(), layout.taxels.end(),
                                     [&](const Taxel& taxel) { return is_dense(taxel, layout.sampling); });
  return any_dense ? static_cast<double>(sample_count(layout.sampling.density, area)) : static_cast<double>(count);
}

std::vector<DenseDisc> dense_fields(const Layout& layout, const MeshIndex& skin) {
  std::vector<DenseDisc> dense;
  const ReceptiveFieldRule& rule = layout.receptive_field;
  for (const Taxel& taxel : layout.taxels) {
    if (!is_dense(taxel, layout.sampling)) continue;
    for (const FieldDisc& disc : discs_of(taxel)) {
      const dvec3 center = rule.metric == Metric::geodesic ? skin.closest_point(disc.center).position : disc.center;
      dense.push_back(
          {center, disc.normal, disc.radius, rule.max_angle_deg <= kWideAngle ? kFrontSide : kAllSides, taxel.density});
    }
  }
  return dense;
}

void multiply_densities(Layout& layout, double factor) {
  layout.sampling.density *= factor;
  for (Taxel& taxel : layout.taxels) taxel.density *= factor;
}

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
