// A file format of layouts: the project's own or that of another program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/layout/file/imported_layout.h"

namespace taxel {

/// The text or bytes of a file, and one sentence for each value that the format cannot hold.
struct WrittenLayouts {
  std::string bytes;
  std::vector<std::string> notes;
};

/// The values of a layout that a format holds. Centres are in all formats.
struct HeldValues {
  bool ids = false, names = false, normals = false, radii = false, subtaxels = false;
  bool density = false;   ///< sampling.density
  bool settings = false;  ///< mesh, frame, and all other settings
  bool geom = false;      ///< geom or link that the sensor is on
};

/// A file format of layouts, one row of layout_formats() (format_table.h) and one file of this folder.
struct LayoutFormat {
  std::string_view word;  ///< word on the command line, such as "csv"
  std::string_view name;  ///< name in menus, such as "Table of taxels"
  /// File name extensions in lower case, with their dots. The longest one that fits a file decides.
  std::vector<std::string_view> extensions;
  HeldValues holds = {};
  bool reads_several = false, writes_several = false;  ///< true if a file can have several sensors
  bool is_refused = false;                             ///< true if `parse` only says what to do instead; not in dialogs
  bool is_scene = false;  ///< true if a file is also a MuJoCo scene, as which it is opened, checked and run
  /// Returns true if a file that begins with these bytes looks like one of this format. Decides between formats that
  /// have the same extension, and whether a dialog lists a file. Null if the extension is enough.
  bool (*is_start)(std::string_view bytes) = nullptr;
  /// Reads all sensors of a file, at least one. `file` is its path. Throws Error naming the file and the place.
  std::vector<ImportedLayout> (*parse)(const std::string& bytes, const std::string& file) = nullptr;
  /// Returns the file of these layouts: one, or at least one if writes_several. Throws Error if the format needs a
  /// value that a layout does not have, or would lose a taxel. Null if the format holds no layout: its reader refuses.
  WrittenLayouts (*write)(const std::vector<ImportedLayout>& layouts) = nullptr;
};

}  // namespace taxel
