// Dead taxels report a constant value. They still leak into their neighbours: the skin is pressed, only a wire is
// broken.
#include <optional>
#include <utility>

#include "core/sensor/chain/random.h"
#include "core/sensor/chain/stage.h"

namespace taxel {
namespace {

class DeadTaxelsStage : public Stage {
 public:
  explicit DeadTaxelsStage(std::vector<std::pair<std::size_t, double>> dead) : dead_(std::move(dead)) {}

  void apply(const Moment& /*now*/, std::span<double> /*state*/, std::span<double> values) const override {
    for (const auto& [taxel, value] : dead_) values[taxel] = value;
  }

 private:
  std::vector<std::pair<std::size_t, double>> dead_;  // taxels with their values
};

/// Returns the value that a taxel always reports, or nothing for a working taxel.
std::optional<double> dead_value(const Calibration& settings, int id) {
  for (const TaxelCalibration& own : settings.taxels)
    if (own.id == id && own.dead) return own.dead;
  const bool is_dead =
      settings.dead && random_stream(settings.seed, RandomPart::dead, id).uniform(0) < settings.dead->fraction;
  return is_dead ? std::optional(settings.dead->value) : std::nullopt;
}

}  // namespace

StagePtr make_dead_taxels(const ChainSettings& settings) {
  std::vector<std::pair<std::size_t, double>> dead;
  for (std::size_t k = 0; k < settings.taxel_count(); ++k)
    if (const auto value = dead_value(settings.calibration, settings.layout.taxels[k].id)) dead.emplace_back(k, *value);
  return dead.empty() ? nullptr : std::make_shared<DeadTaxelsStage>(std::move(dead));
}

}  // namespace taxel
