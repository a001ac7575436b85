// Receptive fields: the samples that each taxel gathers and their weights, as sparse rows.
#pragma once

#include <vector>

#include "core/layout/layout.h"
#include "core/layout/sampling/poisson_disk.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Rows = taxels in layout order. Row k is entries [first[k], first[k+1]), sorted by sample number.
struct ReceptiveFields {
  struct Entry {
    int sample = 0;
    double distance = 0.0;  ///< d, from the taxel's centre [m]
    double weight = 0.0;    ///< (r - d)^2 c [m^2], times the share or the Voronoi area ratio of the sample
  };
  std::vector<int> first{0};
  std::vector<Entry> entries;
  [[nodiscard]] int taxel_count() const { return static_cast<int>(first.size()) - 1; }
};

/// Returns the receptive fields. The field of a taxel has the samples within radius r of the centre whose normal is
/// less than max_angle_deg from the taxel's normal, and c is the factor of FieldAngle, which is 1 without a roll-off.
/// The normal is that of the face, or interpolated (FieldNormals). Fields may overlap. Distances are Euclidean from the
/// stored centre (Metric::euclidean, the paper), or lengths of shortest paths on `skin` from the point closest to the
/// centre (Metric::geodesic), up to rounding. With subtaxels, the field is the union of their fields, with r, d and c
/// of the nearest subtaxel. `samples` are on faces of `skin`. The result does not depend on the number of threads.
ReceptiveFields make_receptive_fields(const Layout& layout, const std::vector<SurfaceSample>& samples,
                                      const MeshIndex& skin);

}  // namespace taxel
