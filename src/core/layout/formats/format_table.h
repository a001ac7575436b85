// The table of all file formats of layouts, and reading and writing by it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/layout/formats/layout_format.h"

namespace taxel {

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
