// The sensor of a command: a layout file, or the fingertip that is built into the program.
#pragma once

#include <string>
#include <vector>

#include "app/cli/layout_options.h"
#include "core/document/batch/job_sources.h"
#include "core/sensor/sensor_model.h"

namespace taxel::cli {

/// Returns the built-in fingertip with its mesh.
DefaultLayout default_source();

/// Compiles the model of `layout_file`, or of the built-in fingertip if it is empty. Values of `over` replace those of
/// the layout. Prints notes and warnings of the layout. Throws Error, or Cancelled after a signal.
/// `file_face_of` (optional) receives, for each face of the model's loaded mesh, the number of its triangle in the mesh
/// file. `cache` (optional) retains the parts of the model.
SensorModelPtr load_model(const std::string& layout_file, const LayoutOptions& over, Console& console,
                          std::vector<int>* file_face_of = nullptr, SensorCache* cache = nullptr);

}  // namespace taxel::cli
