// The display of the document's mesh: the changes of the repair and the directions of the finger.
#pragma once

namespace taxel::ui {

/// The direction of the finger that the next click on a face sets.
enum class FramePick { none, tip, pad };

struct MeshState {
  using PerDocument = MeshState;  ///< another document resets all of it
  bool shows_changes = false;     ///< whether the changes of the repair are drawn over the skin
  int step = -1;                  ///< index in RepairReport::steps of the step last framed, or -1
  /// Tip and pad of the document are a guess: arrows show both until the user confirms or sets them.
  bool frame_is_guess = false;
  FramePick pick = FramePick::none;
};

}  // namespace taxel::ui
