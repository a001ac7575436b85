// Scene files as MJCF that the present MuJoCo reads: old scenes without the attributes that MuJoCo has dropped since
// version 2.2, and URDF, of which MuJoCo's own converter makes MJCF, to which sensors can be added.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace taxel {

/// Returns the MJCF text without the attributes that MuJoCo 4 no longer accepts. A renamed attribute gets its new name;
/// all others are replaced by spaces. Lines keep their numbers, so the line numbers in MuJoCo's own errors remain
/// correct. Adds a note for each attribute, which begins with `file` and the line. A text that is not well formed is
/// returned unchanged; MuJoCo then reports the reason.
///
/// Parts that cannot be removed without changing the model (the element `composite`, global coordinates) remain, and
/// MuJoCo refuses them.
std::string without_dropped_attributes(const std::string& xml, const std::string& file,
                                       std::vector<std::string>& notes);

/// A file of a scene whose text is replaced in memory.
struct CurrentMjcf {
  std::filesystem::path file;  ///< path under which MuJoCo opens it
  std::string text;
};

/// Returns the scene and its included files without dropped attributes; files that have none are omitted. The files on
/// disk are only read.
std::vector<CurrentMjcf> current_mjcf(const std::filesystem::path& scene, std::vector<std::string>& notes);

/// Returns true if the file's root element is <robot>.
bool is_urdf(const std::filesystem::path& file);

/// Returns the scene that MuJoCo reads from a URDF, as MJCF next to the file. Throws Error naming the file with
/// MuJoCo's reason.
CurrentMjcf mjcf_of_urdf(const std::filesystem::path& file);

}  // namespace taxel
