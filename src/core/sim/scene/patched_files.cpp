#include "core/sim/scene/patched_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/base/files.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/formats/layout_format.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/sim/scene/mjcf_text.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

fs::path real_path(const fs::path& path) {
  std::error_code ignored;
  const fs::path real = fs::weakly_canonical(fs::absolute(path, ignored), ignored);
  return real.empty() ? path : real;
}

bool is_same_folder(const fs::path& a, const fs::path& b) {
  return real_path(a.parent_path().empty() ? "." : a.parent_path()) ==
         real_path(b.parent_path().empty() ? "." : b.parent_path());
}

fs::path folder_of(const fs::path& file) {
  return file.parent_path().empty() ? fs::path(".") : file.parent_path();
}

/// Returns true if an element names a file that MuJoCo reads as MJCF.
bool names_mjcf(std::string_view element) {
  return element == "include" || element == "model";
}

/// Returns the included file of an element, or -1.
int file_of_include(const MjcfSource& source, int element) {
  for (std::size_t f = 1; f < source.files().size(); ++f)
    if (source.files()[f].include == element) return static_cast<int>(f);
  return -1;
}

/// Returns true if a name that stays as it is would be found in another place, or not at all, by a scene `output`.
bool is_lost(const MjcfSource& source, int file, const std::string& name, const fs::path& output) {
  std::error_code ignored;
  if (fs::path(name).is_absolute()) return false;
  const fs::path target = source.found(name, file), here = folder_of(output) / name;
  if (fs::exists(here, ignored)) return real_path(here) != real_path(target);
  return real_path(folder_of(source.files()[static_cast<std::size_t>(file)].path) / name) != real_path(target);
}

/// Returns the files that need a copy: the scene, those with changes, those whose names would be lost, and all files
/// that include one of these.
std::set<int> copied_files(const MjcfSource& source, const MjcfChanges& changes, const fs::path& output) {
  std::set<int> copied{0};
  const auto add = [&](int file) {
    while (copied.insert(file).second)
      file = source.elements()[static_cast<std::size_t>(source.files()[static_cast<std::size_t>(file)].include)].file;
  };
  for (int f = 1; f < static_cast<int>(source.files().size()); ++f)
    if (changes.has_changes(f) || source.files()[static_cast<std::size_t>(f)].is_changed) add(f);
  for (int e = 0; e < static_cast<int>(source.elements().size()); ++e) {
    const int file = source.elements()[static_cast<std::size_t>(e)].file;
    if (names_mjcf(source.name(e)) && is_lost(source, file, source.value(e, "file").value_or(""), output)) add(file);
  }
  return copied;
}

/// Returns names of copies next to `output` that no file of the scene has.
std::map<int, std::string> names_of_copies(const MjcfSource& source, const std::set<int>& copied,
                                           const fs::path& output) {
  std::map<int, std::string> names;
  std::set<fs::path> taken{real_path(output)};
  for (const MjcfFile& file : source.files()) taken.insert(real_path(file.path));
  for (const int f : copied) {
    if (f == 0) continue;
    const fs::path& path = source.files()[static_cast<std::size_t>(f)].path;
    const std::string start = output.stem().string() + "_" + path.stem().string();
    std::string name = start + path.extension().string();
    for (int i = 2; !taken.insert(real_path(folder_of(output) / name)).second; ++i)
      name = fmt::format("{}_{}{}", start, i, path.extension().string());
    names[f] = name;
  }
  return names;
}

/// Calls `act` with each element that names a file of an asset, and that name.
void for_each_asset(const MjcfSource& source, const std::function<void(int, const std::string&)>& act) {
  for (int e = 0; e < static_cast<int>(source.elements().size()); ++e) {
    if (names_mjcf(source.name(e))) continue;
    for (const char* attribute : {"file", "fileright", "fileleft", "fileup", "filedown", "filefront", "fileback"})
      if (const auto name = source.value(e, attribute); name && !name->empty()) act(e, *name);
  }
}

}  // namespace

std::string path_from(const fs::path& folder, const fs::path& file) {
  const fs::path from = real_path(folder), to = real_path(file);
  const fs::path relative = to.lexically_relative(from);
  return (relative.empty() ? to : relative).generic_string();
}

std::map<std::string, std::string> texts_next_to(const MjcfSource& source, MjcfChanges& changes,
                                                 const fs::path& output) {
  const std::set<int> copied = copied_files(source, changes, output);
  const std::map<int, std::string> names = names_of_copies(source, copied, output);
  for (int e = 0; e < static_cast<int>(source.elements().size()); ++e) {
    const int file = source.elements()[static_cast<std::size_t>(e)].file;
    if (!names_mjcf(source.name(e)) || !copied.contains(file)) continue;
    const std::string name = source.value(e, "file").value_or("");
    if (const auto copy = names.find(file_of_include(source, e)); copy != names.end())
      changes.set(e, "file", copy->second);
    else if (!fs::path(name).is_absolute() &&
             real_path(folder_of(output) / name) != real_path(source.found(name, file)))
      changes.set(e, "file", path_from(folder_of(output), source.found(name, file)));
  }
  std::map<std::string, std::string> texts;
  for (const int f : copied) texts[f == 0 ? output.filename().string() : names.at(f)] = changes.text(f);
  return texts;
}

std::vector<std::string> compiler_lines(const MjcfSource& source, const fs::path& output, const std::string& meshdir,
                                        const std::string& texturedir) {
  const fs::path& scene = source.files().front().path;
  if (is_same_folder(scene, output)) return {};
  bool has_meshes = false, has_textures = false;
  for_each_asset(source, [&](int element, const std::string& name) {
    if (fs::path(name).is_absolute()) return;
    (source.name(element) == "texture" ? has_textures : has_meshes) = true;
  });
  std::string attributes;
  const auto add = [&](const char* key, bool is_used, const std::string& folder) {
    if (!is_used || fs::path(folder).is_absolute()) return;
    attributes +=
        fmt::format(" {}=\"{}\"", key, xml_escaped(path_from(folder_of(output), scene.parent_path() / folder)));
  };
  add("meshdir", has_meshes, meshdir);
  add("texturedir", has_textures, texturedir);
  if (attributes.empty()) return {};
  return {"<compiler" + attributes + "/>"};
}

std::string LayoutFiles::put(const std::string& name, const std::string& bytes) {
  std::error_code ignored;
  const std::string own = output_.stem().string() + "_" + name;
  for (int i = 0;; ++i) {
    const std::string candidate = i == 0   ? name
                                  : i == 1 ? own
                                           : fmt::format("{}_{}_{}", output_.stem().string(), i, name);
    const auto put_before = std::ranges::find(files_, candidate, &SceneFile::name);
    if (put_before != files_.end()) {
      if (put_before->bytes == bytes) return candidate;
      continue;
    }
    const fs::path path = folder_of(output_) / candidate;
    const bool is_there = fs::is_regular_file(path, ignored);
    if (is_there && read_file(path) == bytes) return candidate;
    if (is_there && i == 0) continue;  // names that begin with the scene's belong to it
    files_.push_back({candidate, bytes});
    return candidate;
  }
}

std::string LayoutFiles::add(const SceneAttachment& attachment, const SensorModel& model, const std::string& geom) {
  std::error_code ignored;
  const fs::path file = attachment.layout;
  const bool is_foreign = is_foreign_layout(attachment.layout);
  Layout layout = model.layout;
  mesh_ = mesh_path(layout, file);
  if (!fs::is_regular_file(mesh_, ignored)) {  // the surface of a primitive
    const std::string bytes = write_obj(*model.loaded);
    const std::string name = put(geom + ".obj", bytes);
    layout.mesh = {name, dvec3(1), sha256_hex(bytes), layout.mesh.repair};
    mesh_ = folder_of(output_) / name;
  } else {
    if (attachment.model != nullptr)  // the paths of an edited layout are absolute, and those of its file relative
      layout.mesh.file = path_from(folder_of(file), mesh_);
    const bool is_unchanged = !is_foreign && fs::is_regular_file(file, ignored) && read_layout(file) == layout;
    if (is_unchanged && is_same_folder(file, output_)) return file.filename().string();
    if (is_unchanged && fs::path(layout.mesh.file).is_absolute()) return put(file.filename().string(), read_file(file));
    if (!fs::path(layout.mesh.file).is_absolute() || is_foreign)
      layout.mesh.file = path_from(folder_of(output_), mesh_);
  }
  const std::string name = is_foreign ? file.stem().string() + ".taxels.json" : file.filename().string();
  return put(name, layout_to_json(layout));
}

}  // namespace taxel
