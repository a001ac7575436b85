// taxel._core: the layers below MuJoCo as a Python module. The package `taxel` (python/taxel) presents it.
#include "app/python/nouns.h"
#include "core/sensor/stored_samples.h"

NB_MODULE(_core, m) {
  m.doc() = "The computing core of taxel. Use the names of the package `taxel`, which documents them.";
  taxel::keep_samples_on_disk();
  m.attr("__version__") = TAXEL_VERSION;
  taxel::python::add_problem(m);
  taxel::python::add_layout(m);
  taxel::python::add_sensor_model(m);
  taxel::python::add_pose_readings(m);
  taxel::python::add_calibrator(m);
  taxel::python::add_contact(m);
  taxel::python::add_generate(m);
  taxel::python::add_material(m);
  taxel::python::add_recording(m);
  taxel::python::add_skin_cover(m);
  taxel::python::add_names(m);
  taxel::python::add_scenario(m);
}
