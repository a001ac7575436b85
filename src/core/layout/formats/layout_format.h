// The file formats of layouts, the project's own and those of other programs: one row each, the table of all rows,
// reading and writing by it, and the sentences on values that a format cannot hold.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/layout/file/imported_layout.h"

namespace taxel {

class NpzReader;

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

/// A file format of layouts, one row of layout_formats() and one file of this folder.
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

// The rows of layout_formats(), each defined in the file of its format.

LayoutFormat own_format();            ///< `*.taxels.json` (docs/layout_format.md)
LayoutFormat csv_format();            ///< tables of taxels, GenTact's among them
LayoutFormat sensor_yaml_format();    ///< sensor descriptions of mujoco_contact_surfaces
LayoutFormat icub_format();           ///< iCub's positions of taxels
LayoutFormat genesis_format();        ///< Genesis' probes
LayoutFormat npz_format();            ///< NumPy poses
LayoutFormat urdf_format();           ///< URDF with the tactile sensors of tactile_toolbox
LayoutFormat mjcf_format();           ///< MuJoCo scenes with the plugin or touch sites
LayoutFormat mjcf_sites_format();     ///< the same, written with a site and a touch sensor for each taxel
LayoutFormat tactile_state_format();  ///< readings of ROS, which are refused

// Readers of single formats, which have options or take another input than LayoutFormat::parse.

/// Reads poses of a NumPy archive: the array `poses` (taxels, 3, 4) or (taxels, 4, 4), whose third column is the normal
/// and whose fourth is the centre [m], and the arrays `ids`, `radii` and `names`, which may be missing. Throws Error
/// naming file and array.
ImportedLayout layout_of_poses(const NpzReader& npz);

/// Reads the sensors of a description in YAML for the predecessor's code (mujoco_contact_surfaces): the list under
/// `MujocoPlugins`, of which only some entries have `SurfacePlugins`. There are three types: CurvedSensor (`taxels` and
/// `normals`), TaxelSensor (`taxels` alone; the skin gives the normals) and FlatTactileSensor (no taxels: square cells
/// of `resolution` metres over the top of the skin). `include_margin` is the receptive radius [m], `sample_resolution`
/// the density of the samples [1/m^2]. A value below 1 is a length on the contact surface in that code, and is ignored.
/// Positions are in the frame of the mesh file after scaling. `file` is the file's name in messages. Throws Error that
/// names file, line and key.
std::vector<ImportedLayout> parse_sensors_yaml(const std::string& text, const std::string& file);

/// Reads the sensor with this `sensorName` or `geomName`, or the first one if `sensor` is empty. The others are named
/// in a note. Throws as parse_sensors_yaml() does, or if there is no such sensor.
ImportedLayout parse_sensor_yaml(const std::string& text, const std::string& file, const std::string& sensor = "");

/// Returns one sentence for each kind of value that the layouts have and the format does not hold. `noun` names the
/// format: "a table".
std::vector<std::string> losses_in(const std::vector<ImportedLayout>& layouts, const HeldValues& holds,
                                   const std::string& noun);

/// Throws Error if a layout has no taxels, or a number is not finite.
void check_taxels_to_write(const std::vector<ImportedLayout>& layouts);

/// Throws Error if a layout does not have the normals of its taxels. `noun` is as in losses_in().
void require_normals(const std::vector<ImportedLayout>& layouts, const std::string& noun);

/// Returns true if the ids of the taxels are 0, 1, 2 and so on.
bool are_ids_row_numbers(const std::vector<Taxel>& taxels);

/// Returns all formats, the project's own first.
const std::vector<LayoutFormat>& layout_formats();

/// Returns the format of a word such as "csv", or null.
const LayoutFormat* find_layout_format(std::string_view word);

/// Returns the format of a file by its name, in any case, and by its first bytes if several formats have the extension;
/// null if no extension fits. The first of these formats decides if there is no such file.
const LayoutFormat* layout_format_of(const std::filesystem::path& path);

/// Returns true if the file has our own format, or none that is known by its name.
bool is_own_layout(const std::filesystem::path& path);

/// Returns true if the file is a layout of another program, and no MuJoCo scene.
bool is_foreign_layout(const std::filesystem::path& path);

/// Returns true if the file's name and beginning are those of a layout of another program. Other files of the name,
/// such as notes in a .txt file, are refused when they are read.
bool looks_like_foreign_layout(const std::filesystem::path& path);

/// Reads all sensors of a file. `unit` is the length of the file's unit [m], for files that name none. Throws Error:
/// the file cannot be read, or as LayoutFormat::parse and check_lengths() do.
std::vector<ImportedLayout> read_layouts(const LayoutFormat& format, const std::filesystem::path& path,
                                         std::optional<double> unit = {});

/// Returns the sensor with this name, or else on this geom or link, or the first one for an empty name. Names the
/// others in a note. Throws Error naming the file and all sensors if there is no such sensor.
ImportedLayout choose_sensor(std::vector<ImportedLayout> layouts, const std::string& sensor, const std::string& file);

/// Returns the notes of all layouts, each once. A note that is not of all layouts begins with the names of its layouts.
std::vector<std::string> notes_of(const std::vector<ImportedLayout>& layouts);

/// Reads a file in the format of its name and chooses one of its sensors. Throws Error: no extension fits, the file
/// cannot be read, or there is no such sensor.
ImportedLayout import_layout(const std::filesystem::path& path, const std::string& sensor = "",
                             std::optional<double> unit = {});

/// Returns the file of these layouts, as LayoutFormat::write() does, once it has been read back with the same taxels:
/// none is lost or moved silently. Throws Error naming `file`: as LayoutFormat::write() does, or if the format would
/// not hold all taxels.
WrittenLayouts checked_layouts(const LayoutFormat& format, const std::vector<ImportedLayout>& layouts,
                               const std::string& file);

/// Writes one layout atomically, as checked_layouts() returns it. Returns one sentence for each value that the format
/// cannot hold. Throws Error naming the file.
std::vector<std::string> write_layout_as(const LayoutFormat& format, const std::filesystem::path& path,
                                         const Layout& layout);

/// Returns the words of all formats, or of those that can be written: "taxels, csv, ...".
std::string layout_format_words(bool writable);

}  // namespace taxel
