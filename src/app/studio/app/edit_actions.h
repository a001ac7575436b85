// The actions of the keymap that edit the layout or change what is selected.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

/// False: it is none of these.
bool perform_edit(Action action, UiState& ui, const UiInput& input);
[[nodiscard]] bool is_edit_enabled(Action action, const UiState& ui, const UiInput& input);

/// The plane across which a sensor is mirrored: between its sides, by its frame, through the origin where that lies in
/// the middle. Frame M.
[[nodiscard]] MirrorPlane mirror_plane_of(const Layout& layout, const Aabb& bounds);

}  // namespace taxel::ui
