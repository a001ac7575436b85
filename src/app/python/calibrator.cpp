// Calibrator: the chain of a sensor's taxels, from readings to the values that a device reports.
#include "core/sensor/calibration.h"

#include <fmt/format.h>

#include "app/python/arrays.h"
#include "app/python/handles.h"
#include "app/python/nouns.h"
#include "core/base/error.h"
#include "core/layout/check/layout_check.h"

namespace taxel::python {
namespace {

/// Makes the chain of a layout. Throws Error if the layout has no calibration, or one with errors.
Calibrator make_calibrator(const LayoutHandle& layout, double timestep) {
  if (!layout.value->calibration) throw Error(layout.file, "/calibration", "is missing: the layout has no calibration");
  Problems problems = check_layout_values(*layout.value, layout.file);
  std::erase_if(problems, [](const Problem& problem) { return !problem.pointer.starts_with("/calibration"); });
  throw_first_error(problems);
  if (!(timestep >= 0.0)) throw nb::value_error("timestep: must not be negative");
  return Calibrator(*layout.value, timestep);
}

}  // namespace

void add_calibrator(nb::module_& m) {
  nb::class_<Calibrator>(m, "Calibrator",
                         "The chain of a sensor's taxels, from readings to the values that a device with the layout's "
                         "calibration reports. The readings of SensorModel.read() are those before the chain.")
      .def(
          "__init__",
          [](Calibrator* place, const LayoutHandle& layout, double timestep) {
            new (place) Calibrator(make_calibrator(layout, timestep));
          },
          nb::arg("layout"), nb::arg("timestep") = 0.0,
          "`timestep` is the time between two readings [s], which only a latency needs. Raises Error for a layout "
          "without a calibration, or with a wrong one.")
      .def(
          "advance",
          [](Calibrator& calibrator, double time, nb::handle readings) {
            const std::vector<double> numbers = read_numbers(readings, "readings", {-1});
            return array_of(calibrator.advance(time, numbers));
          },
          nb::arg("time"), nb::arg("readings"), nb::rv_policy::automatic,
          "Returns the values that the device reports at `time` [s], shape (taxels,), in the layout's order. Call with "
          "all readings since the start, one per taxel, in their order. Raises Error if the time decreases, or for "
          "another number of readings.")
      .def("reset", &Calibrator::reset, "Returns to the state before the first reading.")
      .def_prop_rw(
          "state", [](const Calibrator& calibrator) { return array_of(calibrator.state()); },
          [](Calibrator& calibrator, nb::handle state) { calibrator.restore(read_numbers(state, "state", {-1})); },
          nb::rv_policy::automatic,
          nb::for_setter(nb::sig("def state(self, value: numpy.typing.ArrayLike, /) -> None")),
          "The state after the last reading, a copy. Setting it goes back to that reading: the same readings then give "
          "the same bits.");
}

}  // namespace taxel::python
