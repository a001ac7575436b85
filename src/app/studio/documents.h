// What can be opened, and how it becomes a compiled layout: layout files, bare meshes, MuJoCo scenes, and the project's
// own fingertip that travels inside the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/sensor/sensor_model.h"

namespace taxel::studio {

enum class DocumentKind { layout, mesh, scene };

/// By the file's extension. Throws Error naming the file where it cannot be opened.
DocumentKind document_kind(const std::filesystem::path& file);

struct Document {
  DocumentKind kind = DocumentKind::layout;
  std::string file;                ///< empty: built in
  std::string name;                ///< for titles
  SensorModelPtr model;            ///< null for a scene: the simulation compiles its sensors
  std::vector<std::string> notes;  ///< what the user should know: repairs, guessed units, warnings
};

/// Reads and compiles. Throws Error naming file and field, or Cancelled.
Document load_document(const std::filesystem::path& file, Progress& progress);
Document built_in_fingertip(Progress& progress);

/// Metres per unit of a mesh whose file does not say: 1 for sizes that a sensor can have in metres, else 0.001.
double guessed_unit(const Aabb& bounds);

}  // namespace taxel::studio
