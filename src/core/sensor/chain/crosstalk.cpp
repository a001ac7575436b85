// Crosstalk between taxels, by their distance or by a matrix. Sums go by ascending id, so that the order of the taxels
// does not change the bits. The cost is quadratic in the number of taxels.
#include <algorithm>
#include <numeric>

#include "core/sensor/chain/stage.h"

namespace taxel {
namespace {

/// A reading that is added to that of a taxel.
struct Leak {
  std::size_t from = 0;
  double factor = 0;
};

class CrosstalkStage : public Stage {
 public:
  /// `own` is the factor of a taxel's reading in its own value, if the leaks do not have that factor.
  CrosstalkStage(std::vector<std::vector<Leak>> leaks, double own) : leaks_(std::move(leaks)), own_(own) {}

  void apply(const Moment& /*now*/, std::span<double> /*state*/, std::span<double> values) const override {
    const std::vector<double> before(values.begin(), values.end());
    for (std::size_t k = 0; k < values.size(); ++k) {
      values[k] = own_ * before[k];
      for (const Leak& leak : leaks_[k]) values[k] += leak.factor * before[leak.from];  // x'_k + sum_j a_kj x'_j
    }
  }

 private:
  std::vector<std::vector<Leak>> leaks_;  // of each taxel, by ascending id
  double own_;
};

}  // namespace

StagePtr make_crosstalk(const ChainSettings& settings) {
  const auto& [layout, calibration, timestep] = settings;
  const CrosstalkMatrix& matrix = calibration.crosstalk_matrix;
  if (!calibration.crosstalk && matrix.empty()) return nullptr;
  const std::vector<Taxel>& taxels = layout.taxels;
  std::vector<std::size_t> by_id(taxels.size());
  std::iota(by_id.begin(), by_id.end(), 0U);
  std::sort(by_id.begin(), by_id.end(), [&](std::size_t a, std::size_t b) { return taxels[a].id < taxels[b].id; });
  std::vector<std::vector<Leak>> leaks(taxels.size());
  for (std::size_t k = 0; k < taxels.size(); ++k)
    for (const std::size_t j : by_id) {
      double factor = 0;
      if (!matrix.empty()) {
        factor = matrix[k][j];
      } else if (j != k) {
        const double distance = glm::distance(taxels[j].center, taxels[k].center);
        // a_kj = a (1 - |c_j - c_k| / reach), 0 from the reach on
        factor = std::max(calibration.crosstalk->fraction * (1.0 - distance / calibration.crosstalk->reach), 0.0);
      }
      if (factor != 0.0) leaks[k].push_back({j, factor});
    }
  return std::make_shared<CrosstalkStage>(std::move(leaks), matrix.empty() ? 1.0 : 0.0);
}

}  // namespace taxel
