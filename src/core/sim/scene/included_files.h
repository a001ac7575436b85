// The MJCF files that an MJCF file includes or takes models from.
#pragma once

#include <filesystem>
#include <vector>

namespace taxel {

/// Returns the files named by `<include file="...">` and `<model file="...">`, and by these files in turn, sorted, each
/// once. As in MuJoCo, a name is searched next to the scene first, then next to the file that names it. A missing file
/// is omitted. (mju_getXMLDependencies() ends the program if a file is missing.) Throws Error naming the file if a name
/// belongs to a pipe, a device or a folder.
std::vector<std::filesystem::path> included_files(const std::filesystem::path& scene);

}  // namespace taxel
