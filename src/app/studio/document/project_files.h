// Where documents are written to, and that their mesh can be found from there.
#pragma once

#include <filesystem>
#include <string>

#include "app/studio/document/open_meshes.h"
#include "core/document/project_json.h"

namespace taxel::studio {

/// The project as it can be written to `file`: where its mesh is the one that travels inside the program, or its file
/// is gone and `mesh` is what was read from it, the mesh is written beside the file first. Throws Error where that
/// fails.
Project with_mesh_on_disk(Project project, const std::filesystem::path& file, const OpenMeshPtr& mesh = nullptr);

/// What the dialog offers.
struct SuggestedFile {
  std::string folder;  ///< absolute; empty: wherever the dialog was
  std::string name;
};
/// `file`: where the document came from, empty: built in; `name`: its own.
SuggestedFile suggested_file(const std::string& file, const std::string& name, const std::string& extension);

}  // namespace taxel::studio
