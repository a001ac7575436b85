#include "core/layout/formats/format_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/layout/file/imported_lengths.h"
#include "core/layout/formats/format_rows.h"

namespace taxel {
namespace {

constexpr std::size_t kStartBytes = 64 << 10;         ///< bytes that tell formats with the same extension apart
constexpr std::uint64_t kMaxLayoutBytes = 256 << 20;  ///< a million taxels take about 200 MB as a layout

std::string lower_case_name(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

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
  std::string known;
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    if (layouts[i].layout.name == sensor) return i;
    known += (i == 0 ? "" : ", ") + shown_sensor(layouts[i]);
  }
  for (std::size_t i = 0; i < layouts.size(); ++i)
    if (layouts[i].geom == sensor) return i;
  throw Error(file, fmt::format("has no sensor \"{}\", but {}", sensor, known));
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
  const std::vector<const LayoutFormat*> candidates = formats_by_name(lower_case_name(path.filename().string()));
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
  std::string known;
  for (const LayoutFormat& format : layout_formats()) {
    for (const std::string_view extension : format.extensions) {
      if (std::find(listed.begin(), listed.end(), extension) != listed.end()) continue;
      listed.push_back(extension);
      known += (known.empty() ? "" : ", ") + std::string(extension);
    }
  }
  throw Error(path.string(), "is no layout by its name; known are " + known);
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
