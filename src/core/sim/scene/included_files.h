// The files that an MJCF file or a URDF names, found in the text: MuJoCo opens them by their names, some of them while
// it parses, and waits for ever for the writer of a pipe.
#pragma once

#include <filesystem>
#include <vector>

namespace taxel {

/// Returns the files named by `<include file="...">` and `<model file="...">`, and by these files in turn, sorted, each
/// once. As in MuJoCo, a name is searched next to the scene first, then next to the file that names it. A missing file
/// is omitted. (mju_getXMLDependencies() ends the program if a file is missing.) Throws Error naming the file if a name
/// belongs to a pipe, a device or a folder.
std::vector<std::filesystem::path> included_files(const std::filesystem::path& scene);

/// Throws Error naming the file and the name if a mesh, texture, height field, skin or flex of the scene or of an
/// included file is a pipe, a device or a folder. MuJoCo's versions search a name in different folders, so the name is
/// checked in all of them: next to each file, in each folder of a `compiler`, with and without its own folders.
void expect_regular_files(const std::filesystem::path& scene);

/// Returns true if the scene or an included file has a `<replicate>`. MuJoCo 3 and 4 read freed memory if such a scene
/// has an `<instance>` of a plugin to which a sensor refers. Throws Error naming the file if an instance is one of this
/// program's plugins.
bool has_replicates(const std::filesystem::path& scene);

}  // namespace taxel
