// The example layouts, meshes and scenes, which are built into the program, as files to open.
#pragma once

#include <filesystem>

namespace taxel::studio {

/// Writes the examples into a folder, in the folders `layouts`, `meshes` and `scenes`. Files that exist stay as they
/// are: the user may have changed them. Throws Error naming a file that cannot be written.
void write_examples(const std::filesystem::path& folder);

}  // namespace taxel::studio
