// The one door for layouts in files of any format: our own, and those of other programs, a file each in this folder.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// A layout as read, notes on values that are not from the file, and the values that a skin must add (imported_skin.h).
struct ImportedLayout {
  Layout layout;
  std::vector<std::string> notes;  ///< "holds no mesh", a sentence each
  std::string geom = {};           ///< name of the geom that the file puts the sensor on; empty if it names none
  std::string geom_place = {};     ///< place of that name in the file, for messages: "line 8, key geomName"
  std::vector<std::string> other_geoms = {};  ///< geoms of the sensors of the file that are left out
  bool has_normals = true;                    ///< otherwise the skin gives the normals of the taxels
  /// Edge length of a square cell of an array that lists no taxels: they cover the top of the skin [m]. 0 if listed.
  double cell = 0;
  bool has_density = true;   ///< the file gives layout.sampling.density
  bool has_material = true;  ///< the file gives layout.material
  bool has_frame = true;     ///< the file gives layout.frame
};

struct LayoutFormat {
  std::string_view name;  ///< for menus: "Table of taxels"
  std::vector<std::string_view>
      extensions;  ///< lower case, with the dot; of several that fit a file the longest counts
  /// `sensor`: which one of a file that holds several, by its name or that of its geom; empty: the first.
  /// Throws Error that names the file and the place.
  ImportedLayout (*read)(const std::filesystem::path& path, const std::string& sensor);
  /// Writes atomically; returns what the format cannot hold, a sentence each. Null where it is only read.
  std::vector<std::string> (*write)(const std::filesystem::path& path, const Layout& layout);
};

/// All formats, our own first.
const std::vector<LayoutFormat>& layout_formats();

/// The format of a file by its name, any case; null where none fits.
const LayoutFormat* layout_format_of(const std::filesystem::path& path);

/// Whether the name is that of a layout of another program.
bool is_foreign_layout(const std::filesystem::path& path);

/// Reads with the format of the name. Throws Error listing the extensions there are where none fits.
ImportedLayout import_layout(const std::filesystem::path& path, const std::string& sensor = "");

}  // namespace taxel
