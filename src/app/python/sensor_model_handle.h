// The compiled model of a Python object.
#pragma once

#include <string>

#include "app/python/layout_handle.h"
#include "core/sensor/sensor_model.h"

namespace taxel::python {

struct SensorModelHandle {
  SensorModelPtr model;
  std::string file;  ///< file of the layout, or empty
};

/// Compiles a layout in another thread, while this thread handles Python's signals without holding Python's lock in
/// between. Throws Error, or the Python exception of a signal, such as KeyboardInterrupt.
SensorModelPtr build_interruptibly(LayoutHandle layout, SampleQuality quality);

}  // namespace taxel::python
