// A cache of results that are computed for each taxel alone. It is kept from one model of a layout to the next, so an
// edit of one taxel costs one computation.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "core/sensor/sensor_model.h"

namespace taxel::ui {

template <class Value>
class PerTaxel {
 public:
  /// Returns the values in layout order. `make(missing, values)` computes the values at the ascending indices
  /// `missing`: those of taxels that are new or have changed since the last call. If the skin, the rule or `variant`
  /// has changed, all values are computed.
  template <class Make>
  const std::vector<Value>& update(const SensorModel& model, int variant, const Make& make) {
    const std::vector<Taxel>& taxels = model.layout.taxels;
    const bool comparable = skin_ == model.skin && rule_ == model.layout.receptive_field && variant_ == variant;
    std::vector<Value> values(taxels.size());
    std::vector<int> missing;
    std::vector<char> taken(taxels_.size(), 0);
    const std::vector<std::size_t> order = comparable ? by_id() : std::vector<std::size_t>{};
    for (std::size_t k = 0; k < taxels.size(); ++k) {
      const auto known = std::lower_bound(order.begin(), order.end(), taxels[k].id,
                                          [this](std::size_t i, int id) { return taxels_[i].id < id; });
      if (known != order.end() && taxels_[*known] == taxels[k] && taken[*known] == 0) {
        taken[*known] = 1;
        values[k] = std::move(values_[*known]);
      } else {
        missing.push_back(static_cast<int>(k));
      }
    }
    made_ = static_cast<int>(missing.size());
    skin_.reset();  // if make() throws, nothing is kept
    if (!missing.empty()) make(missing, values);
    skin_ = model.skin;
    rule_ = model.layout.receptive_field;
    variant_ = variant;
    taxels_ = taxels;
    values_ = std::move(values);
    return values_;
  }
  /// Returns the number of values that the last update() computed.
  [[nodiscard]] int made() const { return made_; }

 private:
  [[nodiscard]] std::vector<std::size_t> by_id() const {
    std::vector<std::size_t> order(taxels_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [this](std::size_t a, std::size_t b) { return taxels_[a].id < taxels_[b].id; });
    return order;
  }

  std::shared_ptr<const MeshIndex> skin_;
  ReceptiveFieldRule rule_;
  int variant_ = 0, made_ = 0;
  std::vector<Taxel> taxels_;
  std::vector<Value> values_;
};

}  // namespace taxel::ui
