// The sensor a command works on: a layout file, or the project's own fingertip that travels inside the program.
#pragma once

#include <string>
#include <vector>

#include "app/cli/command.h"
#include "core/sensor/sensor_model.h"

namespace taxel::cli {

/// Compiles `layout_file`, or the built-in fingertip where it is empty; what `over` gives goes over the layout's
/// values. Notes and warnings of the layout go to the console. Throws Error, or Cancelled after
/// a signal.
/// `file_face_of` (optional) gets, for each face of the model's loaded mesh, the number of its triangle in the mesh
/// file. `cache` (optional) keeps the parts of the model.
SensorModelPtr load_model(const std::string& layout_file, const LayoutOptions& over, Console& console,
                          std::vector<int>* file_face_of = nullptr, SensorCache* cache = nullptr);

}  // namespace taxel::cli
