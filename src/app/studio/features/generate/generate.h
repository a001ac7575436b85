// Generating taxels: the frame of the pattern on the skin, its preview, and taking it over.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/generate/generate_state.h"
#include "app/studio/features/taxel/tool_state.h"

namespace taxel::ui {

/// Opens the panel with the frame at the middle of the view, and lengths that suit the mesh; once more closes it.
void toggle_generate(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool, GenerateState& generate);
/// The previewed taxels go, nothing of them is left.
void close_generate(WindowUi& ui, GenerateState& generate);
/// Adds the previewed taxels as one step, selected, and closes the panel. Nothing while there are none.
void accept_generate(WindowUi& ui, Viewer& viewer, const Shown& shown, GenerateState& generate);
[[nodiscard]] bool can_accept_generate(const Viewer& viewer, const Shown& shown, const GenerateState& generate);

/// Asks for a preview where what it depends on has changed; closes the panel where there is nothing to edit any more.
void keep_preview_current(WindowUi& ui, const Viewer& viewer, const Shown& shown, GenerateState& generate);

/// Makes the pattern one of another kind, an index of PatternShape. Values that kinds share are kept, the others are
/// the last ones of that kind.
void change_kind(GenerateState& generate, std::size_t kind);
template <class Kind>
void change_kind(GenerateState& generate) {
  change_kind(generate, PatternShape(Kind()).index());
}
/// Returns true if the frame places the pattern.
[[nodiscard]] bool has_frame(const Pattern& pattern);

/// While the panel is open and no tool is in the hand: a click on the skin puts the frame there, a drag that begins on
/// its centre moves it along. True: the mouse was the frame's. x, y: pointer in pixels of the view.
bool frame_mouse(WindowUi& ui, const Viewer& viewer, const Shown& shown, GenerateState& generate, double x, double y,
                 bool hovered);
/// Ctrl+wheel: by 5 degrees a notch.
void turn_pattern(GenerateState& generate, double notches);

}  // namespace taxel::ui
