#include "app/studio/host/episodes/episode_document.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/document/scenario/scenario_json.h"
#include "core/layout/file/layout_json.h"
#include "core/mesh/mesh_io.h"
#include "core/run/batch/data_set.h"
#include "core/run/data_set/data_set_head.h"

namespace taxel::studio {
namespace {

namespace fs = std::filesystem;

/// Reads the mesh of a layout of the data set, whose text has the hash of the mesh.
LoadedMesh mesh_of(const Layout& layout, const fs::path& path, const EpisodeChoice& choice) {
  std::error_code ignored;
  if (!fs::exists(path, ignored))
    throw Error(path.string(), fmt::format("no such file: the layout of episode {} has this mesh; copy it from where "
                                           "the data set was written, with the whole folder meta",
                                           choice.episode));
  LoadedMesh mesh = load_mesh(path, layout.mesh.scale);
  if (!layout.mesh.sha256.empty() && mesh.sha256 != layout.mesh.sha256)
    throw Error(path.string(),
                fmt::format("was changed since the data set was written (its SHA-256 is {}, not {}), so that no run "
                            "repeats episode {}: restore the file",
                            mesh.sha256, layout.mesh.sha256, choice.episode));
  return mesh;
}

Scenario scenario_of(const EpisodeEntry& entry, const EpisodeChoice& choice) {
  const std::string name = fmt::format("{}: scenario of episode {}", choice.folder, choice.episode);
  Scenario scenario = parse_scenario(entry.scenario, name);
  std::error_code ignored;
  for (const auto& [key, file] : files_of(scenario))
    if (!file->empty() && !fs::exists(*file, ignored))
      throw Error(name, "/" + key, fmt::format("{}: no such file; put the file there to play the episode", *file));
  return scenario;
}

}  // namespace

std::optional<fs::path> data_set_folder(const fs::path& path) {
  if (path.empty()) return std::nullopt;
  std::error_code ignored;
  const fs::path absolute = fs::absolute(path, ignored).lexically_normal();
  if (fs::is_directory(absolute, ignored)) return absolute.has_filename() ? absolute : absolute.parent_path();
  const bool is_described = absolute.filename() == "info.json" || absolute.filename() == "taxel.json";
  if (!is_described || absolute.parent_path().filename() != "meta") return std::nullopt;
  return absolute.parent_path().parent_path();
}

LoadedDocument load_episode(const EpisodeChoice& choice, const SensorBuild& how) {
  const fs::path folder(choice.folder);
  const DataSetHead head = read_data_set_head(folder);
  const DataSet set(folder);
  const auto index = static_cast<std::size_t>(choice.episode);
  if (choice.episode < 0 || index >= set.episodes().size())
    throw Error(choice.folder,
                fmt::format("has no episode {}: it has {} episodes", choice.episode, set.episodes().size()));
  const EpisodeEntry& entry = set.episodes()[index];
  auto episode = std::make_shared<ReplayedEpisode>(
      ReplayedEpisode{choice, head.program, head.bits, scenario_of(entry, choice), set.read_episode(index)});
  const std::string layouts = fmt::format("{}: layout {}", (folder / "meta/layouts.parquet").string(), entry.layout);
  Layout layout = parse_layout(set.layouts()[entry.layout].layout_json, layouts);
  const fs::path mesh_file = fs::absolute(folder / "meta" / layout.mesh.file).lexically_normal();
  LoadedMesh mesh = mesh_of(layout, mesh_file, choice);
  layout.mesh.file = mesh_file.string();
  LoadedDocument document = document_in_memory(std::move(layout), std::move(mesh), how);
  document.name = fmt::format("{}, episode {}", folder.filename().string(), choice.episode);
  document.episode = std::move(episode);
  return document;
}

}  // namespace taxel::studio
