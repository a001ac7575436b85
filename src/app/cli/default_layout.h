// The sensor a command works on: a layout file, or the project's own fingertip that travels inside the program.
#pragma once

#include <string>
#include <vector>

#include "app/cli/command.h"
#include "core/sensor/sensor_model.h"

namespace taxel::cli {

/// Compiles `layout_file`, or the built-in fingertip where it is empty; density and seed are taken from `sampling`
/// where given. Notes and warnings of the layout go to the console. Throws Error.
/// `file_face_of` (optional) gets, for each face of the model's mesh, the number of its triangle in the mesh file.
SensorModelPtr load_model(const std::string& layout_file, const SamplingOptions& sampling, Console& console,
                          std::vector<int>* file_face_of = nullptr);

}  // namespace taxel::cli
