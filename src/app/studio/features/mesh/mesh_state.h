// How the document's mesh is shown: what its repair changed, and where the finger points.
#pragma once

namespace taxel::ui {

/// What the next click on a face says about the finger.
enum class FramePick { none, tip, pad };

struct MeshState {
  using PerDocument = MeshState;  ///< another document resets all of it
  bool shows_changes = false;     ///< draws over the skin what its repair changed
  int step = -1;                  ///< index in RepairReport::steps of the one that was framed last, or -1
  /// Tip and pad of the document are a guess: arrows show both until the user confirms or sets them.
  bool frame_is_guess = false;
  FramePick pick = FramePick::none;
};

}  // namespace taxel::ui
