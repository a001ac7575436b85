#include "core/hydro/pad/pad_error.h"

#include <algorithm>
#include <array>

#include "core/base/index.h"
#include "core/base/parallel.h"
#include "core/base/rng.h"
#include "core/hydro/fields/prism.h"
#include "core/hydro/pad/pad_pressures.h"

namespace taxel {
namespace {

constexpr int kErrorPoints = 1024;

/// Returns barycentric weights of a point uniformly distributed in a tet: three sorted random cuts of a unit length
/// give four weights.
std::array<double, 4> random_weights(const CounterRng& rng, int point) {
  const auto n = 4 * static_cast<std::uint64_t>(point);
  std::array<double, 3> cut{rng.uniform(n), rng.uniform(n + 1), rng.uniform(n + 2)};
  std::sort(cut.begin(), cut.end());
  return {cut[0], cut[1] - cut[0], cut[2] - cut[1], 1 - cut[2]};
}

}  // namespace

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

}  // namespace taxel
