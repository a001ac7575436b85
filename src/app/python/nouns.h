// The parts of the module, one function for each file of this folder.
#pragma once

#include <nanobind/nanobind.h>

namespace taxel::python {

void add_problem(nanobind::module_& m);        ///< Error and Problem
void add_layout(nanobind::module_& m);         ///< Layout
void add_pose_readings(nanobind::module_& m);  ///< Object, PoseReadings, SensorModel.read()
void add_sensor_model(nanobind::module_& m);   ///< SensorModel
void add_calibrator(nanobind::module_& m);     ///< Calibrator
void add_contact(nanobind::module_& m);        ///< Contact, contact()
void add_generate(nanobind::module_& m);       ///< generate()
void add_material(nanobind::module_& m);       ///< material(), elastomers()
void add_recording(nanobind::module_& m);      ///< Recording, SensorRecording
void add_skin_cover(nanobind::module_& m);     ///< share_within_skin(), primitive()
void add_names(nanobind::module_& m);          ///< geom_labels(), sensor_name()
void add_scenario(nanobind::module_& m);       ///< scenario_text()

}  // namespace taxel::python
