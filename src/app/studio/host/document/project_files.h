// Suggests files for documents, and writes their meshes so that they can be found from there.
#pragma once

#include <filesystem>
#include <string>

#include "app/studio/host/document/open_meshes.h"
#include "core/document/project_json.h"

namespace taxel::studio {

/// Returns the project as it can be written to `file`. First writes the mesh into the folder of `file` if the mesh is
/// built into the program, or if the mesh's file is gone and `mesh` was read from it. Throws Error if writing fails.
Project with_mesh_on_disk(Project project, const std::filesystem::path& file, const OpenMeshPtr& mesh = nullptr);

/// Folder and name that the file dialog offers.
struct SuggestedFile {
  std::string folder;  ///< absolute path, or empty for the folder in which the dialog was
  std::string name;
};
/// Returns a suggestion for saving a document. `file` is the file from which it was opened, or empty if it is built in;
/// `name` is the document's name.
SuggestedFile suggested_file(const std::string& file, const std::string& name, const std::string& extension);

}  // namespace taxel::studio
