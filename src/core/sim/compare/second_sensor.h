// The readings of a second layout in the steps of a run. They have no influence on the simulation.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/run/step.h"
#include "core/sensor/compare/second_contact.h"
#include "core/sim/compare/second_layout.h"

namespace taxel {

/// A second layout in the place of a sensor. May be used by one thread at a time.
class SecondSensor {
 public:
  /// Compiles `second` on the mesh of `first`. With SecondContact::recorded, or if both have an equal contact, it reads
  /// the recorded surfaces. `file` names the layout in messages; `cache` may be null. Throws Error as
  /// build_sensor_model() does, or if `first` or `second` is rigid and their contacts differ; throws Cancelled.
  SecondSensor(SensorModelPtr first, const Layout& second, SecondContact contact, const std::string& file,
               SensorCache* cache = nullptr, Progress* progress = nullptr);

  [[nodiscard]] const SensorModelPtr& first() const { return first_; }
  [[nodiscard]] const SensorModelPtr& model() const { return second_; }
  /// Returns whether the readings are those of the recorded surfaces.
  [[nodiscard]] bool reads_recorded() const { return reads_recorded_; }

  /// Returns one reading per taxel of the second layout, of sensor number `sensor` of the step. The result depends on
  /// these arguments only. Throws Error if a contact cannot be computed again.
  [[nodiscard]] std::vector<double> read(const Step& step, std::size_t sensor) const;

 private:
  SensorModelPtr first_, second_;
  bool reads_recorded_ = true;
};

}  // namespace taxel
