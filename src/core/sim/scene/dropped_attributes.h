// Attributes of MJCF that MuJoCo has dropped since version 2.2: scenes that were written for it load unmodified.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace taxel {

/// Returns the MJCF text without the attributes that MuJoCo 4 no longer knows and whose meaning it kept elsewhere or
/// gave up: a renamed attribute gets its new name, any other is replaced by spaces. Lines keep their numbers, so that
/// MuJoCo's own errors still name them. Adds a note for each attribute, which begins with `file` and the line. Text
/// that is not well formed comes back as it is: MuJoCo says why.
///
/// What cannot be left out without changing the model (the element `composite`, global coordinates) stays: MuJoCo
/// refuses it.
std::string without_dropped_attributes(const std::string& xml, const std::string& file,
                                       std::vector<std::string>& notes);

/// A file of a scene with other text than on disk.
struct CurrentMjcf {
  std::filesystem::path file;  ///< path under which MuJoCo opens it
  std::string text;
};

/// The scene and the files that it includes, as far as they hold dropped attributes. The files are only read.
std::vector<CurrentMjcf> current_mjcf(const std::filesystem::path& scene, std::vector<std::string>& notes);

}  // namespace taxel
