#include "core/layout/file/layout_format.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/file/sensor_yaml.h"
#include "core/layout/file/taxels_csv.h"

namespace taxel {
namespace {

/// Throws Error if a sensor is chosen: files of this format have one sensor without a name.
void refuse_choice(const std::filesystem::path& path, const std::string& sensor) {
  if (!sensor.empty())
    throw Error(path.string(), fmt::format("holds one layout: it has no sensor \"{}\" to choose", sensor));
}

ImportedLayout read_own(const std::filesystem::path& path, const std::string& sensor) {
  refuse_choice(path, sensor);
  ImportedLayout imported;
  LayoutOfFile read = read_layout_of_file(path);
  imported.layout = std::move(read.layout);
  imported.has_frame = read.has_frame;
  return imported;
}
std::vector<std::string> write_own(const std::filesystem::path& path, const Layout& layout) {
  write_layout(path, layout);
  return {};
}

ImportedLayout read_table(const std::filesystem::path& path, const std::string& sensor) {
  refuse_choice(path, sensor);
  CsvTaxels table = parse_taxels_csv(read_file(path), path.string());
  ImportedLayout imported;
  imported.layout.name = path.stem().string();
  imported.layout.taxels = std::move(table.taxels);
  imported.has_normals = table.normals;
  imported.has_density = imported.has_material = imported.has_frame = false;
  imported.notes = {"a table holds taxels only: mesh and settings are to be chosen"};
  if (!table.normals) imported.notes.emplace_back("the table has no normals: those of the mesh are taken");
  if (!table.radii) imported.notes.push_back(fmt::format("the table has no radii: they are {} m", Taxel().radius));
  return imported;
}
std::vector<std::string> write_table(const std::filesystem::path& path, const Layout& layout) {
  write_file_atomically(path, taxels_to_csv(layout.taxels));
  std::vector<std::string> lost = {"a table holds no mesh, sampling, receptive field rule, readout and material"};
  if (layout.calibration) lost.emplace_back("a table holds no calibration");
  return lost;
}

std::string lower_case_name(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

}  // namespace

const std::vector<LayoutFormat>& layout_formats() {
  static const std::vector<LayoutFormat> formats = {
      {"Taxel layout", {".taxels.json", ".json"}, read_own, write_own},
      {"Table of taxels", {".csv"}, read_table, write_table},
      {"Sensor description of mujoco_contact_surfaces", {".yaml", ".yml"}, read_sensor_yaml, nullptr},
  };
  return formats;
}

const LayoutFormat* layout_format_of(const std::filesystem::path& path) {
  const std::string name = lower_case_name(path.filename().string());
  const LayoutFormat* best = nullptr;
  std::size_t longest = 0;
  for (const LayoutFormat& format : layout_formats()) {
    for (const std::string_view extension : format.extensions) {
      if (!name.ends_with(extension) || extension.size() <= longest) continue;
      longest = extension.size();
      best = &format;
    }
  }
  return best;
}

bool is_foreign_layout(const std::filesystem::path& path) {
  const LayoutFormat* format = layout_format_of(path);
  return format != nullptr && format != &layout_formats().front();
}

ImportedLayout import_layout(const std::filesystem::path& path, const std::string& sensor) {
  if (const LayoutFormat* format = layout_format_of(path)) return format->read(path, sensor);
  std::string known;
  for (const LayoutFormat& format : layout_formats())
    for (const std::string_view extension : format.extensions)
      known += (known.empty() ? "" : ", ") + std::string(extension);
  throw Error(path.string(), "is no layout by its name; known are " + known);
}

}  // namespace taxel
