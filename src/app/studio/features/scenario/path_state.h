// A scenario's way points in the hand, and what the inspector remembers of the scenario.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/document/scenario/scenario.h"

namespace taxel::ui {

/// Where the tool was, kept while it moves.
struct PathRecording {
  std::vector<WayPoint> points;
  double clock = 0;            ///< since it began [s]: simulated, and of the hand while the simulation stands
  std::optional<double> time;  ///< simulated, in the picture before [s]; none: not known
  std::uint64_t runs = 0;      ///< as SimFrame counts them
  bool over = false;           ///< the run was over in the picture before
  WayPoint last;               ///< newest, kept or not
};

/// The part of the state of paths that another document resets.
struct PathOfDocument {
  std::optional<PathRecording> recording;  ///< path that is recorded now, or nothing
  LastScenarios last;                      ///< values of kinds that the document had before
};

struct PathState : PathOfDocument {
  using PerDocument = PathOfDocument;
  int selected = -1;            ///< way point; -1: none
  bool held = false;            ///< the button is down on it
  bool moved = false;           ///< and it was dragged
  std::uint64_t gesture = 0;    ///< of that drag, as the history numbers them
  dvec2 start{0};               ///< of the pointer [pixels of the view]
  dvec3 grabbed_W{0};           ///< the mark then
  std::optional<WayPoint> was;  ///< the way point then
  /// The kind chosen in the inspector, while it lacks a value without which it cannot be the document's: a recording.
  std::optional<ScenarioKind> chosen;

  double record_every = 0.05;  ///< [s]
};

}  // namespace taxel::ui
