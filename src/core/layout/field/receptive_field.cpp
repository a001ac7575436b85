#include "core/layout/field/receptive_field.h"

#include "core/base/parallel.h"
#include "core/base/per_thread.h"
#include "core/layout/field/dense_fields.h"
#include "core/layout/field/field_disc.h"
#include "core/layout/field/point_grid.h"
#include "core/mesh/geodesic/geodesic_distance.h"
#include "core/mesh/query/skin_normal.h"

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

}  // namespace taxel
