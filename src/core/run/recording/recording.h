// The result of a run: rows of readings and poses. Plain values; recording_files.h writes them to files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/layout/sensor_frame.h"

namespace taxel {

/// Description of one sensor: the meaning of its values in the rows.
struct RecordedSensor {
  std::string geom;            ///< name of the sensor's geom in the scene
  std::vector<int> taxel_ids;  ///< ids of the taxels, in the order of the readings
  std::vector<std::string> taxel_names;
  std::string layout_json;   ///< the whole layout, in the format of a layout file
  std::string reading_unit;  ///< "Pa" or "N"
  std::uint64_t seed = 0;    ///< seed of the samples
  /// Unit of the calibrated values; not set if the layout has no calibration.
  std::optional<std::string> calibrated_unit = std::nullopt;
  bool force = false;   ///< readings are forces (Aggregate::force), and SensorRecord::uncovered_W is set
  bool shear = false;   ///< SensorRecord::shear is set
  bool errors = false;  ///< SensorRecord::errors is set
  bool slip = false;    ///< SensorRecord::slip is set
  std::vector<TangentFrame> tangents = {};  ///< tangent frames of the shear, parallel to taxel_ids
};

/// Values of one sensor in one row.
struct SensorRecord {
  dvec3 force_W{0};  ///< contact force on the sensor [N]
  double area = 0;   ///< area of the contact surfaces [m^2]
  int polygons = 0;
  std::vector<double> readings;         ///< parallel to RecordedSensor::taxel_ids
  Pose X_WM;                            ///< pose of the frame of the mesh file
  std::vector<double> calibrated = {};  ///< parallel to `readings`; empty without a calibration
  std::vector<dvec2> shear = {};        ///< along e1 and e2, in the unit of `readings`; empty without shear
  std::vector<double> errors = {};      ///< error bars of `readings`, in their unit; empty without error bars
  std::vector<double> slip = {};        ///< share of each taxel's field that slips; empty unless friction sticks
  dvec3 uncovered_W{0};                 ///< elastic normal force that no taxel reaches [N]; zero unless `force`
  /// Force of the elastic pressure alone [N]; old recordings do not have it.
  std::optional<dvec3> elastic_force_W = std::nullopt;
};

/// The state at `time`, evaluated before the next step.
struct RecordedRow {
  std::int64_t step = 0;  ///< index into Recording::mocap of the step that evaluated this row
  double time = 0;        ///< [s]
  double travel = 0;      ///< distance that the mocap body has moved [m]
  std::vector<SensorRecord> sensors;
  std::vector<Pose> objects;  ///< parallel to Recording::objects
};

/// A whole run.
struct Recording {
  std::vector<RecordedSensor> sensors;
  std::vector<std::string> objects;  ///< names of the geoms that are not sensors
  std::vector<RecordedRow> rows;
  std::vector<Pose> mocap;  ///< pose of the mocap body in each step; replaying the poses repeats the run
  double timestep = 0;      ///< [s]
};

/// Summary of one taxel: whether it responds, how strongly, and how smoothly.
struct TaxelSummary {
  int id = 0;
  std::string name;
  double peak = 0;         ///< largest reading [Pa], or [N] for Aggregate::force
  double mean = 0;         ///< mean reading over the rows, in the unit of `peak`
  double peak_travel = 0;  ///< travel of the mocap body at the peak [m]
  /// Largest change between two successive rows, as a fraction of `peak`; 0 if the taxel never responds.
  double largest_step = 0;
  double largest_error = 0;  ///< largest error bar of a reading, in the unit of `peak`; 0 without error bars
  bool responds = false;     ///< true if the peak is above kResponds of the largest peak of the sensor
};

/// Summary of one sensor.
struct RecordedSensorSummary {
  std::string geom;
  std::vector<TaxelSummary> taxels;
  double largest_force = 0;  ///< largest length of the contact force [N]
  double largest_area = 0;   ///< largest area of the contact surfaces [m^2]
  /// Largest length of the elastic normal force that no taxel reaches [N]; 0 unless RecordedSensor::force.
  double largest_uncovered = 0;
  /// Largest displacement of the sensor's frame relative to the mocap body since the first row [m].
  double deflection = 0;
  double deflection_deg = 0;  ///< largest rotation of the frame relative to the mocap body since the first row
};

/// Smallest peak of a taxel that responds, as a fraction of the sensor's largest peak.
inline constexpr double kResponds = 0.05;

/// Returns the summary of each sensor of a recording.
std::vector<RecordedSensorSummary> summarize(const Recording& recording);

}  // namespace taxel
