// How the repair of the document's mesh is shown.
#pragma once

namespace taxel::ui {

struct MeshState {
  bool shows_changes = false;  ///< draws over the skin what its repair changed
  int step = -1;               ///< index in RepairReport::steps of the one that was framed last, or -1
};

}  // namespace taxel::ui
