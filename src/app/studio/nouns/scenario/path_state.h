// The waypoint that the user edits, the running recording of a path, and values that the inspector retains.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/document/scenario/scenario.h"

namespace taxel::ui {

/// The recorded motion of the tool.
struct PathRecording {
  std::vector<WayPoint> points;
  double clock = 0;            ///< recorded time [s]: simulated, or real time while paused
  std::optional<double> time;  ///< simulated time of the previous frame [s], if known
  std::uint64_t runs = 0;      ///< value of SimFrame::runs for the recorded run
  bool over = false;           ///< whether the run was over in the previous frame
  WayPoint last;               ///< newest pose, whether it became a waypoint or not
};

/// The part of the state of paths that another document resets.
struct PathOfDocument {
  std::optional<PathRecording> recording;  ///< path that is recorded now, or nothing
  LastScenarios last;                      ///< values of kinds that the document had before
};

struct PathState : PathOfDocument {
  using PerDocument = PathOfDocument;
  int selected = -1;            ///< index of the selected waypoint, or -1
  bool held = false;            ///< whether the button is held on the waypoint
  bool moved = false;           ///< whether the waypoint was dragged since the press
  std::uint64_t gesture = 0;    ///< number of the drag in the history
  dvec2 start{0};               ///< pointer at the press [pixels of the view]
  dvec3 grabbed_W{0};           ///< position of the waypoint's glyph at the press
  std::optional<WayPoint> was;  ///< waypoint at the press
  /// Kind chosen in the inspector while the kind still lacks a required value, such as a recording. Until then it
  /// cannot become the document's kind.
  std::optional<ScenarioKind> chosen;

  double record_every = 0.05;  ///< time between recorded waypoints [s]
};

}  // namespace taxel::ui
