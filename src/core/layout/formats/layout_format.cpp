// Sentences on lost values, the table of formats, and reading and writing by it.

#include "core/layout/formats/layout_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text/table.h"
#include "core/layout/file/imported_layout.h"

namespace taxel {
namespace {

bool any_taxel(const std::vector<ImportedLayout>& layouts, bool (*has)(const Taxel&)) {
  return std::any_of(layouts.begin(), layouts.end(), [&](const ImportedLayout& one) {
    return std::any_of(one.layout.taxels.begin(), one.layout.taxels.end(), has);
  });
}

bool any_layout(const std::vector<ImportedLayout>& layouts, bool (*has)(const ImportedLayout&)) {
  return std::any_of(layouts.begin(), layouts.end(), has);
}

/// Returns true if a setting other than the density differs from its default, or is known.
bool has_settings(const ImportedLayout& one) {
  const Layout &layout = one.layout, defaults;
  Sampling sampling = layout.sampling;
  sampling.density = defaults.sampling.density;
  return one.has_frame || one.has_material || !layout.mesh.file.empty() || sampling != defaults.sampling ||
         layout.receptive_field != defaults.receptive_field || layout.readout != defaults.readout;
}

}  // namespace

bool are_ids_row_numbers(const std::vector<Taxel>& taxels) {
  for (std::size_t i = 0; i < taxels.size(); ++i)
    if (taxels[i].id != static_cast<int>(i)) return false;
  return true;
}

std::vector<std::string> losses_in(const std::vector<ImportedLayout>& layouts, const HeldValues& holds,
                                   const std::string& noun) {
  std::vector<std::string> lost;
  const auto lose = [&](bool is_lost, const std::string& values) {
    if (is_lost) lost.push_back(fmt::format("{} holds no {}", noun, values));
  };
  lose(!holds.settings && any_layout(layouts, has_settings),
       holds.density ? "mesh, receptive field rule, readout and material"
                     : "mesh, sampling, receptive field rule, readout and material");
  lose(!holds.settings && !holds.density && !any_layout(layouts, has_settings) &&
           any_layout(layouts, [](const ImportedLayout& one) { return one.has_density; }),
       "density of samples");
  lose(!holds.settings &&
           any_layout(layouts, [](const ImportedLayout& one) { return one.layout.calibration.has_value(); }),
       "calibration");
  lose(!holds.settings && any_layout(layouts, [](const ImportedLayout& one) { return !one.layout.unknown.empty(); }),
       "keys of other programs");
  lose(!holds.geom && any_layout(layouts, [](const ImportedLayout& one) { return !one.geom.empty(); }),
       "geom or link of the sensor");
  lose(!holds.ids &&
           any_layout(layouts, [](const ImportedLayout& one) { return !are_ids_row_numbers(one.layout.taxels); }),
       "ids: taxels are numbered by their order");
  lose(!holds.names && any_taxel(layouts, [](const Taxel& taxel) { return !taxel.name.empty(); }), "names of taxels");
  lose(!holds.normals && any_layout(layouts, [](const ImportedLayout& one) { return one.has_normals; }),
       "normals of taxels");
  lose(!holds.radii && any_layout(layouts, [](const ImportedLayout& one) { return one.has_radii(); }),
       "radii of taxels");
  lose(!holds.subtaxels && any_taxel(layouts, [](const Taxel& taxel) { return !taxel.subtaxels.empty(); }),
       "subtaxels");
  lose(!holds.settings && any_taxel(layouts, [](const Taxel& taxel) { return taxel.density > 0; }),
       "densities of taxels");
  return lost;
}

void check_taxels_to_write(const std::vector<ImportedLayout>& layouts) {
  for (const ImportedLayout& one : layouts) {
    if (one.cell > 0)
      throw Error(
          "", one.layout.name,
          fmt::format("lists no taxels but cells of {} m over a mesh: name the mesh with --mesh FILE", one.cell));
    if (one.layout.taxels.empty()) throw Error("", one.layout.name, "has no taxels to write");
    for (const Taxel& taxel : one.layout.taxels)
      if (!is_finite(taxel.center) || !is_finite(taxel.normal) || !std::isfinite(taxel.radius))
        throw Error("", fmt::format("taxel {}", taxel.id), "must be finite to be written");
  }
}

void require_normals(const std::vector<ImportedLayout>& layouts, const std::string& noun) {
  for (const ImportedLayout& one : layouts) {
    if (!one.has_normals)
      throw Error("", one.layout.name,
                  fmt::format("has no normals, which {} needs: name the mesh that gives them with --mesh FILE", noun));
    for (const Taxel& taxel : one.layout.taxels)
      if (!(glm::dot(taxel.normal, taxel.normal) > 0))
        throw Error("", fmt::format("taxel {}", taxel.id), "has a normal of length 0");
  }
}

namespace {

constexpr std::size_t kStartBytes = 64 << 10;         ///< bytes that tell formats with the same extension apart
constexpr std::uint64_t kMaxLayoutBytes = 256 << 20;  ///< a million taxels take about 200 MB as a layout

/// Returns the formats whose extension of greatest length fits the name.
std::vector<const LayoutFormat*> formats_by_name(const std::string& name) {
  std::vector<const LayoutFormat*> best;
  std::size_t longest = 1;
  for (const LayoutFormat& format : layout_formats()) {
    for (const std::string_view extension : format.extensions) {
      if (!name.ends_with(extension) || extension.size() < longest) continue;
      if (extension.size() > longest) best.clear();
      longest = extension.size();
      best.push_back(&format);
    }
  }
  return best;
}

std::string shown_sensor(const ImportedLayout& imported) {
  const std::string on = imported.geom.empty() || imported.geom == imported.layout.name
                             ? ""
                             : fmt::format(" on geom \"{}\"", imported.geom);
  return fmt::format("\"{}\"{}", imported.layout.name, on);
}

std::size_t index_of_sensor(const std::vector<ImportedLayout>& layouts, const std::string& sensor,
                            const std::string& file) {
  if (sensor.empty()) return 0;
  std::string sensors;
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    if (layouts[i].layout.name == sensor) return i;
    sensors += (i == 0 ? "" : ", ") + shown_sensor(layouts[i]);
  }
  for (std::size_t i = 0; i < layouts.size(); ++i)
    if (layouts[i].geom == sensor) return i;
  throw Error(file, fmt::format("has no sensor \"{}\", but {}", sensor, sensors));
}

/// Returns true if both lists have the same centres, and the same ids if the format holds them.
bool has_same_taxels(std::vector<Taxel> a, std::vector<Taxel> b, bool holds_ids) {
  const auto by_id = [](const Taxel& x, const Taxel& y) { return x.id < y.id; };
  if (holds_ids) std::stable_sort(a.begin(), a.end(), by_id), std::stable_sort(b.begin(), b.end(), by_id);
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const Taxel& x, const Taxel& y) {
    return x.center == y.center && (!holds_ids || x.id == y.id);
  });
}

}  // namespace

const std::vector<LayoutFormat>& layout_formats() {
  static const std::vector<LayoutFormat> formats = {
      own_format(), csv_format(),  sensor_yaml_format(), icub_format(), genesis_format(),
      npz_format(), mjcf_format(), mjcf_sites_format(),  urdf_format(), tactile_state_format()};
  return formats;
}

const LayoutFormat* find_layout_format(std::string_view word) {
  for (const LayoutFormat& format : layout_formats())
    if (format.word == word) return &format;
  return nullptr;
}

const LayoutFormat* layout_format_of(const std::filesystem::path& path) {
  const std::vector<const LayoutFormat*> candidates = formats_by_name(lower_case(path.filename().string()));
  if (candidates.empty()) return nullptr;
  if (candidates.size() == 1) return candidates.front();
  const std::string start = read_start(path, kStartBytes);
  for (const LayoutFormat* format : candidates)
    if (format->is_start != nullptr && format->is_start(start)) return format;
  return candidates.front();
}

bool is_own_layout(const std::filesystem::path& path) {
  const LayoutFormat* format = layout_format_of(path);
  return format == nullptr || format == &layout_formats().front();
}

bool is_foreign_layout(const std::filesystem::path& path) {
  return !is_own_layout(path) && !layout_format_of(path)->is_scene;
}

bool looks_like_foreign_layout(const std::filesystem::path& path) {
  if (!is_foreign_layout(path)) return false;
  const LayoutFormat* format = layout_format_of(path);
  if (format->is_refused) return false;
  return format->is_start == nullptr || format->is_start(read_start(path, kStartBytes));
}

std::vector<ImportedLayout> read_layouts(const LayoutFormat& format, const std::filesystem::path& path,
                                         std::optional<double> unit) {
  std::vector<ImportedLayout> layouts = format.parse(read_file(path, kMaxLayoutBytes), path.string());
  if (&format == &layout_formats().front()) {
    if (unit) throw Error(path.string(), "has its lengths in m: leave --unit out");
    return layouts;
  }
  for (ImportedLayout& imported : layouts) {
    if (imported.layout.name.empty()) imported.layout.name = path.stem().string();
    if (unit) apply_unit(imported, *unit, path.string());
    check_lengths(imported, path.string());
  }
  return layouts;
}

ImportedLayout choose_sensor(std::vector<ImportedLayout> layouts, const std::string& sensor, const std::string& file) {
  const std::size_t chosen = index_of_sensor(layouts, sensor, file);
  ImportedLayout imported = std::move(layouts[chosen]);
  std::string left;
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    if (i == chosen) continue;
    left += (left.empty() ? "" : ", ") + shown_sensor(layouts[i]);
    imported.other_geoms.push_back(layouts[i].geom);
  }
  if (!left.empty())
    imported.notes.push_back(fmt::format("the sensor {} is read; left out: {}", shown_sensor(imported), left));
  return imported;
}

std::vector<std::string> notes_of(const std::vector<ImportedLayout>& layouts) {
  constexpr std::size_t kShownNames = 3;
  std::vector<std::string> order;
  std::map<std::string, std::vector<std::string>> names;  // of the layouts of each note
  for (const ImportedLayout& one : layouts) {
    for (const std::string& note : one.notes) {
      if (!names.contains(note)) order.push_back(note);
      std::vector<std::string>& with = names[note];
      if (with.empty() || with.back() != one.layout.name) with.push_back(one.layout.name);
    }
  }
  std::vector<std::string> notes;
  for (const std::string& note : order) {
    const std::vector<std::string>& with = names[note];
    std::string prefix;
    for (std::size_t i = 0; with.size() < layouts.size() && i < std::min(kShownNames, with.size()); ++i)
      prefix += (i == 0 ? "" : ", ") + with[i];
    if (!prefix.empty() && with.size() > kShownNames) prefix += fmt::format(" and {} more", with.size() - kShownNames);
    notes.push_back(prefix.empty() ? note : prefix + ": " + note);
  }
  return notes;
}

ImportedLayout import_layout(const std::filesystem::path& path, const std::string& sensor, std::optional<double> unit) {
  if (const LayoutFormat* format = layout_format_of(path)) {
    if (!format->reads_several && !sensor.empty())
      throw Error(path.string(), fmt::format("holds one layout: it has no sensor \"{}\" to choose", sensor));
    return choose_sensor(read_layouts(*format, path, unit), sensor, path.string());
  }
  std::vector<std::string_view> listed;
  std::string extensions;
  for (const LayoutFormat& format : layout_formats()) {
    for (const std::string_view extension : format.extensions) {
      if (std::find(listed.begin(), listed.end(), extension) != listed.end()) continue;
      listed.push_back(extension);
      extensions += (extensions.empty() ? "" : ", ") + std::string(extension);
    }
  }
  throw Error(path.string(), "is no layout by its name; known are " + extensions);
}

WrittenLayouts checked_layouts(const LayoutFormat& format, const std::vector<ImportedLayout>& layouts,
                               const std::string& file) {
  if (format.write == nullptr) throw Error(file, fmt::format("is not written: {} holds no layout", format.name));
  try {
    WrittenLayouts written = format.write(layouts);
    const std::vector<ImportedLayout> read = format.parse(written.bytes, file);
    const bool is_same = std::equal(read.begin(), read.end(), layouts.begin(), layouts.end(),
                                    [&](const ImportedLayout& a, const ImportedLayout& b) {
                                      return has_same_taxels(a.layout.taxels, b.layout.taxels, format.holds.ids);
                                    });
    if (!is_same)
      throw Error(file, fmt::format("is not written: {} would not hold all taxels with their ids", format.name));
    return written;
  } catch (const Error& e) {
    if (!e.file().empty()) throw;
    throw Error(file, e.where(), e.message());
  }
}

std::vector<std::string> write_layout_as(const LayoutFormat& format, const std::filesystem::path& path,
                                         const Layout& layout) {
  ImportedLayout imported;
  imported.layout = layout;
  const WrittenLayouts written = checked_layouts(format, {imported}, path.string());
  write_file_atomically(path, written.bytes);
  return written.notes;
}

std::string layout_format_words(bool writable) {
  std::string words;
  for (const LayoutFormat& format : layout_formats())
    if (!writable || format.write != nullptr) words += (words.empty() ? "" : ", ") + std::string(format.word);
  return words;
}

}  // namespace taxel
