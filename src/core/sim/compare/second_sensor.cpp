#include "core/sim/compare/second_sensor.h"

#include <utility>

#include "core/base/error.h"
#include "core/sensor/readout/reading.h"
#include "core/sim/compare/contact_again.h"

namespace taxel {

SecondSensor::SecondSensor(SensorModelPtr first, const Layout& second, SecondContact contact, const std::string& file,
                           SensorCache* cache, Progress* progress)
    : first_(std::move(first)) {
  const Layout& ours = first_->layout;
  reads_recorded_ = contact == SecondContact::recorded || has_equal_contact(ours, second);
  if (!reads_recorded_ && !(ours.material.compliant() && second.material.compliant()))
    throw Error(file, "/material/modulus",
                "a rigid layout has no pressure field: its contact cannot be computed again, only the recorded "
                "contact can be read");
  SensorBuild how(progress);
  how.cache = cache;
  second_ = build_sensor_model(reads_recorded_ ? on_contact_of(ours, second) : second, first_->loaded, "", file, how);
}

std::vector<double> SecondSensor::read(const Step& step, std::size_t sensor) const {
  const SensorStep& state = step.sensors[sensor];
  if (reads_recorded_) {
    SensorReading reading;
    read_sensor(*second_, surface_pointers(state), reading);
    return std::move(reading.values);
  }
  if (step.scene->touched.size() != step.scene->sensors.size())
    throw Error("the step was read from a file of a version that left out the bodies that are touched");
  const TouchedPoses poses = touched_poses(*step.scene, sensor, step.sensors, step.geom_poses);
  if (!poses.unknown.empty()) throw Error(poses.unknown);
  return read_own_contact(*second_, step.scene->touched[sensor], state.X_WM, poses.X_WB);
}

}  // namespace taxel
