// An episode of a data set that is opened as a document, to be played again.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/document/scenario/scenario.h"
#include "core/run/batch/episode.h"

namespace taxel::studio {

/// An episode of the data set in a folder.
struct EpisodeChoice {
  std::string folder;        ///< absolute path
  std::int64_t episode = 0;  ///< EpisodeEntry::index
  bool operator==(const EpisodeChoice&) const = default;
};

/// The episode, and the job that gave it.
struct ReplayedEpisode {
  EpisodeChoice from;
  std::string program;  ///< versions of the program and of MuJoCo that wrote the data set
  int bits = 32;        ///< bits of the numbers of the rows: 32 or 64
  Scenario scenario;    ///< with all changes
  Episode rows;
};
using ReplayedEpisodePtr = std::shared_ptr<const ReplayedEpisode>;

}  // namespace taxel::studio
