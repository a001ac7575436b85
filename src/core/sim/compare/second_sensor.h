// The readings of a second layout in the steps of a run: another layout file, or the paper's released model. They have
// no influence on the simulation.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/run/step.h"
#include "core/sensor/compare.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// Returns the paper's released model for the taxels of a layout: as_in_the_paper(), Euclidean fields, and the mean
/// with the weights of the field.
[[nodiscard]] Layout released_model_of(const Layout& layout);

/// Reads a layout of any format, or the layout of a project, for the mesh of `first`. A layout without a mesh is put on
/// the mesh file of `first`. Throws Error: the file cannot be read, has no taxels, or is made for another mesh.
[[nodiscard]] Layout read_second_layout(const std::filesystem::path& file, const SensorModel& first);

/// Returns whether both layouts have the same contact surfaces in the same poses: the same pressure field on the same
/// repaired mesh. Friction and dissipation change no surface.
[[nodiscard]] bool has_equal_contact(const Layout& first, const Layout& second);

/// Returns `second` with the pressure field of `first`, so that it reads the surfaces of `first`.
[[nodiscard]] Layout on_contact_of(const Layout& first, Layout second);

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

  /// Returns the readings of sensor number `sensor` of a step (ReadingModel::reading) and those of the second layout
  /// (ReadingModel::second). The result depends on these arguments only. Throws Error if a contact cannot be computed
  /// again.
  [[nodiscard]] ModelReadings read(const StepView& step, std::size_t sensor) const;

 private:
  SensorModelPtr first_, second_;
  bool reads_recorded_ = true;
};

}  // namespace taxel
