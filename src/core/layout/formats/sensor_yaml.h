// Reads and writes sensor descriptions of the predecessor's code (mujoco_contact_surfaces), in YAML.
#pragma once

#include <string>
#include <vector>

#include "core/layout/file/imported_layout.h"

namespace taxel {

/// Reads the sensors of the list under `MujocoPlugins`; only some of its entries have `SurfacePlugins`. There are three
/// types: CurvedSensor (`taxels` and `normals`), TaxelSensor (`taxels` alone; the skin gives the normals) and
/// FlatTactileSensor (no taxels: square cells of `resolution` metres over the top of the skin). `include_margin` is the
/// receptive radius [m], `sample_resolution` the density of the samples [1/m^2]. A value below 1 is a length on the
/// contact surface in that code, and is ignored. Positions are in the frame of the mesh file after scaling. `file` is
/// the file's name in messages. Throws Error that names file, line and key.
std::vector<ImportedLayout> parse_sensors_yaml(const std::string& text, const std::string& file);

/// Reads the sensor with this `sensorName` or `geomName`, or the first one if `sensor` is empty. The others are named
/// in a note. Throws as parse_sensors_yaml() does, or if there is no such sensor.
ImportedLayout parse_sensor_yaml(const std::string& text, const std::string& file, const std::string& sensor = "");

}  // namespace taxel
