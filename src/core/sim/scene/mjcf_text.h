// The text of MJCF files and URDFs: changes of attribute values, and the files that the text names. MuJoCo opens these
// by their names, some of them while it parses, and waits for ever for the writer of a pipe.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace taxel {

struct XmlAttribute {
  std::string tag;       ///< element name
  std::string name;      ///< attribute name
  std::string value;     ///< value without escapes
  std::string previous;  ///< value of the previous attribute in the same tag, or empty
};

/// Calls `change` for each attribute of the text, and returns the text with the values that `change` returns. If
/// `change` returns nothing, the attribute keeps its value. The text must be in the form that MuJoCo writes: no
/// comments, double quotes.
std::string change_attributes(const std::string& xml,
                              const std::function<std::optional<std::string>(const XmlAttribute&)>& change);

/// Escape a text for use as an XML attribute value, and undo this.
std::string xml_escaped(const std::string& text);
std::string xml_unescaped(const std::string& text);

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
