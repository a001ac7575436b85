// How even samples are: an oracle that compares everything with everything and shares nothing with the sampler.
#pragma once

#include <algorithm>
#include <vector>

#include "core/layout/poisson_disk.h"

namespace taxel {

struct SampleScore {
  double rho_min = 0, rho_5_percent = 0, rho_mean = 0;  ///< nearest-neighbour distance over that of the densest packing
  double area_cv = 0;                                   ///< standard deviation of the Voronoi areas over their mean
  double area_sum = 0;                                  ///< [m^2]
};

/// Neighbours count on the same wall: normals at most 90 degrees apart (with rounding).
inline SampleScore score_samples(const TriMesh& mesh, const std::vector<SurfaceSample>& samples) {
  const auto n = static_cast<double>(samples.size());
  const double densest = std::sqrt(2.0 * mesh.area() / (std::sqrt(3.0) * n));
  std::vector<double> rho;
  for (const SurfaceSample& a : samples) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const SurfaceSample& b : samples)
      if (&a != &b && glm::dot(a.normal, b.normal) > -1e-9)
        nearest = std::min(nearest, glm::distance(a.position, b.position));
    rho.push_back(nearest / densest);
  }
  std::sort(rho.begin(), rho.end());
  SampleScore score;
  score.rho_min = rho.front();
  score.rho_5_percent = rho[rho.size() / 20];
  for (const double r : rho) score.rho_mean += r / n;
  double squares = 0.0;
  for (const SurfaceSample& s : samples) {
    score.area_sum += s.area;
    const double relative = s.area * n / mesh.area() - 1.0;
    squares += relative * relative;
  }
  score.area_cv = std::sqrt(squares / n);
  return score;
}

}  // namespace taxel
