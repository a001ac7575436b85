// The text of a scene and of the files that it includes, as a tree of elements with their positions in the text, and
// changes of that text.
#pragma once

#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/sim/scene/current_mjcf.h"
#include "core/sim/scene/xml_tags.h"

namespace taxel {

struct MjcfFile {
  std::filesystem::path path;
  std::string text;
  bool is_changed = false;        ///< `text` is not that of the file on disk
  int include = -1;               ///< element that includes the file, or -1 for the scene itself
  std::size_t close_of_root = 0;  ///< position of the closing tag of the root element
};

struct MjcfElement {
  XmlTag tag;
  int parent = -1;  ///< element around it, across included files; -1 for the root of the scene
  int file = 0;     ///< index in MjcfSource::files()
};

/// The elements of a scene in the order in which MuJoCo reads them, with included files in the place of `<include>`.
class MjcfSource {
 public:
  /// Reads the scene and all included files; `replaced` has the text of files that is taken instead of that on disk.
  /// Throws Error naming a file that cannot be read or is not well formed. A missing include is left to MuJoCo.
  MjcfSource(const std::filesystem::path& scene, const std::vector<CurrentMjcf>& replaced);
  MjcfSource(const MjcfSource&) = delete;
  MjcfSource& operator=(const MjcfSource&) = delete;

  [[nodiscard]] const std::deque<MjcfFile>& files() const { return files_; }
  [[nodiscard]] const std::deque<MjcfElement>& elements() const { return elements_; }
  [[nodiscard]] std::string_view name(int element) const;
  [[nodiscard]] const XmlTagAttribute* find(int element, std::string_view attribute) const;
  /// Returns the value of an attribute without escapes, or nothing.
  [[nodiscard]] std::optional<std::string> value(int element, std::string_view attribute) const;
  /// Returns true for an element that is a body, a geom or the like of the world, not of defaults or other templates.
  [[nodiscard]] bool is_in_world(int element) const;
  /// Returns the path that MuJoCo opens for a name in a file: next to the scene, otherwise next to the file.
  [[nodiscard]] std::filesystem::path found(const std::string& name, int file) const;

 private:
  void read(const std::filesystem::path& path, int include, int parent);

  const std::vector<CurrentMjcf>& replaced_;
  std::deque<MjcfFile> files_;        // never moves, since tags refer to the texts
  std::deque<MjcfElement> elements_;  // in the order of the scene
};

/// Changes of the texts of a scene.
class MjcfChanges {
 public:
  explicit MjcfChanges(const MjcfSource& source) : source_(source), changes_(source.files().size()) {}

  /// Sets an attribute: replaces its value, or adds the attribute, a name behind the element's name and others at the
  /// end of the tag.
  void set(int element, const std::string& attribute, const std::string& value);
  /// Adds text directly before an element.
  void insert_before(int element, const std::string& text);
  /// Adds lines at the end of the scene, indented as its root's children are. Each line begins with two spaces for each
  /// further level. Throws Error if the root is an empty element.
  void append(const std::vector<std::string>& lines);
  [[nodiscard]] bool has_changes(int file) const { return !changes_[static_cast<std::size_t>(file)].empty(); }
  [[nodiscard]] std::string text(int file) const;

 private:
  const MjcfSource& source_;
  std::vector<std::vector<TextChange>> changes_;  // by file
};

}  // namespace taxel
