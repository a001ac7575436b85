// What a run leaves behind: rows of readings with the poses that belong to them. Plain values; csv.h and npz.h write
// it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/layout/tangent_frame.h"

namespace taxel {

/// One sensor of a recording: what its columns mean.
struct RecordedSensor {
  std::string geom;            ///< name of its geom in the scene
  std::vector<int> taxel_ids;  ///< order of its columns
  std::vector<std::string> taxel_names;
  std::string layout_json;   ///< the whole layout, as a layout file holds it
  std::string reading_unit;  ///< "Pa" or "N"
  std::uint64_t seed = 0;    ///< of its samples
  /// Of its calibrated values; none: its layout has no calibration.
  std::optional<std::string> calibrated_unit = std::nullopt;
  bool force = false;  ///< readings are forces: their Aggregate is force, and SensorRecord::uncovered_W counts
  bool shear = false;  ///< SensorRecord::shear is there
  std::vector<TangentFrame> tangents = {};  ///< of the shear, parallel to taxel_ids
};

/// One sensor's values in one row.
struct SensorRecord {
  dvec3 force_W{0};  ///< contact force on the sensor [N]
  double area = 0;   ///< of its contact surfaces [m^2]
  int polygons = 0;
  std::vector<double> readings;         ///< parallel to RecordedSensor::taxel_ids
  Pose X_WM;                            ///< of the frame of its mesh file
  std::vector<double> calibrated = {};  ///< parallel to `readings`; empty without a calibration
  std::vector<dvec2> shear = {};        ///< parallel to `readings`, in their unit, along e1 and e2; empty without shear
  dvec3 uncovered_W{0};                 ///< elastic normal force that no taxel reaches [N]; zero unless `force`
};

/// The state that was evaluated at `time`, before the step that follows it.
struct RecordedRow {
  std::int64_t step = 0;  ///< index into Recording::mocap: the step that evaluated this row
  double time = 0;        ///< [s]
  double travel = 0;      ///< of the mocap body [m]
  std::vector<SensorRecord> sensors;
  std::vector<Pose> objects;  ///< parallel to Recording::objects
};

struct Recording {
  std::vector<RecordedSensor> sensors;
  std::vector<std::string> objects;  ///< geoms that are no sensors
  std::vector<RecordedRow> rows;
  std::vector<Pose> mocap;  ///< per step: the mocap body's pose during it; replaying them repeats the run
  double timestep = 0;      ///< [s]
};

}  // namespace taxel
