#include <nlohmann/json.hpp>

#include <charconv>

#include "core/base/files.h"
#include "core/base/text/json.h"
#include "core/document/batch/job_sources.h"
#include "core/layout/file/layout_json.h"
#include "core/sensor/layout_source.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;

/// Returns the keys of a JSON pointer (RFC 6901). Throws Error if the text is not a pointer.
std::vector<std::string> keys_of_pointer(const std::string& pointer) {
  std::vector<std::string> keys;
  try {
    for (Json::json_pointer rest(pointer); !rest.empty(); rest.pop_back()) keys.insert(keys.begin(), rest.back());
  } catch (const Json::exception&) {
    throw Error("", pointer, "is not a JSON pointer, such as /scenario/depth");
  }
  return keys;
}

Json& item_of(Json& array, const std::string& key, const std::string& pointer) {
  std::size_t index = 0;
  const char* const last = key.data() + key.size();
  const auto [end, error] = std::from_chars(key.data(), last, index);
  if (error != std::errc() || end != last || index >= array.size())
    throw Error("", pointer, fmt::format("\"{}\" is not an index of an array of {}", short_quote(key), array.size()));
  return array[index];
}

void apply_change(Json& document, const JobChange& change) {
  Json* at = &document;
  for (const std::string& key : keys_of_pointer(change.pointer)) {
    if (at->is_array()) {
      at = &item_of(*at, key, change.pointer);
    } else if (at->is_object() || at->is_null()) {
      at = &(*at)[key];
    } else {
      throw Error("", change.pointer, fmt::format("\"{}\" is below a value without keys", short_quote(key)));
    }
  }
  *at = Json::parse(change.value);
}

std::string mesh_name(const std::string& sha256, const std::string& file) {
  return sha256 + std::filesystem::path(file).extension().string();
}

bool is_at_or_below(const std::string& pointer, const std::string& place) {
  return pointer.starts_with(place) && (pointer.size() == place.size() || pointer[place.size()] == '/');
}

/// Throws Error if a change is of a value that layouts do not have. The reader keeps such values as unknown.
void refuse_unknown(const Layout& layout, const std::vector<JobChange>& changes) {
  for (const JobChange& change : changes)
    for (const auto& [place, value] : layout.unknown)
      if (is_at_or_below(change.pointer, place) || is_at_or_below(place, change.pointer))
        throw Error("", change.pointer, "is not a parameter of a layout (docs/layout_format.md lists them)");
}

}  // namespace

std::string with_changes(const std::string& json, const std::vector<JobChange>& changes) {
  if (changes.empty()) return json;
  Json document = Json::parse(json);
  for (const JobChange& change : changes) apply_change(document, change);
  return json_line(document);
}

std::vector<JobChange> changes_below(const std::string& root, const std::vector<JobChange>& changes) {
  std::vector<JobChange> below;
  for (const JobChange& change : changes)
    if (is_at_or_below(change.pointer, root)) below.push_back({change.pointer.substr(root.size()), change.value});
  return below;
}

JobSources::JobSources(DefaultSource default_source, SceneReader scene_reader)
    : default_source_(std::move(default_source)), scene_reader_(std::move(scene_reader)) {}

SceneFacts JobSources::scene_facts(const SceneJob& scene) {
  if (!scene_reader_) throw Error("", "/file", "names a scene, which this program does not run");
  return scene_reader_(scene);
}

const JobSources::Read& JobSources::read(const std::string& path) {
  const std::scoped_lock lock(mutex_);
  const auto [entry, is_new] = sources_.try_emplace(path);
  Read& read = entry->second;
  if (is_new) {
    try {
      if (path.empty() && !default_source_) throw Error("", "/layout", "is missing");
      DefaultLayout found = path.empty() ? default_source_() : DefaultLayout{read_any_source(path, {}).source};
      read.json = layout_to_json(found.source.layout);
      read.source = std::make_shared<const SensorSource>(std::move(found.source));
      read.mesh_bytes = std::move(found.mesh_bytes);
    } catch (const Error& e) {
      read.error = std::make_shared<const Error>(e);
    }
  }
  if (read.error) throw Error(*read.error);
  return read;
}

const SensorSource& JobSources::source(const std::string& path) {
  return *read(path).source;
}

const std::string& JobSources::layout_json(const std::string& path) {
  return read(path).json;
}

Layout JobSources::changed_layout(const std::string& path, const std::vector<JobChange>& changes) {
  const Read& from = read(path);
  const std::vector<JobChange> below = changes_below("/layout", changes);
  if (below.empty()) return from.source->layout;
  try {
    Layout changed = parse_layout(with_changes(from.json, below));
    refuse_unknown(changed, below);
    throw_first_error(check_layout_values(changed, ""));
    return changed;
  } catch (const Error& e) {
    throw Error("", "/layout" + e.where(), e.message());
  }
}

SensorSource JobSources::changed_source(const std::string& path, const std::vector<JobChange>& changes) {
  SensorSource changed = source(path);
  const MeshRef before = changed.layout.mesh;
  changed.layout = changed_layout(path, changes);
  if (changed.layout.mesh.file != before.file || changed.layout.mesh.scale != before.scale)
    changed.mesh = load_mesh(copy_of(mesh_path(changed.layout, changed.file)), changed.layout.mesh.scale);
  return changed;
}

std::string JobSources::portable_json(const SensorSource& source) {
  Layout layout = source.layout;
  layout.mesh.file = "meshes/" + mesh_name(source.mesh.sha256, layout.mesh.file);
  layout.mesh.sha256 = source.mesh.sha256;
  return layout_to_json(layout);
}

MeshFile JobSources::mesh_file(const std::string& path, const std::vector<JobChange>& changes) {
  const Layout layout = changed_layout(path, changes);
  const Read& from = read(path);
  const bool is_default = path.empty() && layout.mesh.file == from.source->layout.mesh.file;
  std::string bytes = is_default ? from.mesh_bytes : read_file(mesh_path(layout, from.source->file));
  return {mesh_name(sha256_hex(bytes), layout.mesh.file), std::move(bytes)};
}

const std::string& JobSources::file_sha256(const std::string& path) {
  {
    const std::scoped_lock lock(mutex_);
    if (const auto found = hashes_.find(path); found != hashes_.end()) return found->second;
  }
  std::string hash = sha256_hex(read_file(path));
  const std::scoped_lock lock(mutex_);
  return hashes_.try_emplace(path, std::move(hash)).first->second;
}

void JobSources::put_source(const std::string& path, SensorSource source) {
  const std::scoped_lock lock(mutex_);
  Read& read = sources_[path];
  read.json = layout_to_json(source.layout);
  read.source = std::make_shared<const SensorSource>(std::move(source));
}

bool JobSources::has_source(const std::string& path) {
  const std::scoped_lock lock(mutex_);
  return sources_.contains(path);
}

void JobSources::put_copy(const std::string& original, const std::string& copy) {
  const std::scoped_lock lock(mutex_);
  copies_[original] = copy;
}

std::filesystem::path JobSources::copy_of(const std::filesystem::path& file) {
  const std::scoped_lock lock(mutex_);
  const auto found = copies_.find(file.string());
  return found != copies_.end() ? std::filesystem::path(found->second) : file;
}

}  // namespace taxel
