// Opens an episode of a data set as a document: the layout of its job, and the scenario that repeats its run.
#pragma once

#include <filesystem>
#include <optional>

#include "app/studio/host/document/documents.h"
#include "app/studio/host/episodes/replayed_episode.h"

namespace taxel::studio {

/// Returns the folder of a data set if a path names one: a folder, or the file meta/info.json or meta/taxel.json in it.
/// The result is absolute, without a slash at its end. Does not look into the folder.
std::optional<std::filesystem::path> data_set_folder(const std::filesystem::path& path);

/// Reads and compiles the layout of an episode. LoadedDocument::episode has the rows and the scenario. Throws Error
/// naming the file and the remedy: the data set is damaged, or its mesh or a file of its scenario is missing or was
/// changed; throws Cancelled.
LoadedDocument load_episode(const EpisodeChoice& choice, const SensorBuild& how);

}  // namespace taxel::studio
