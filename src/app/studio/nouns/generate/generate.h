// Generating taxels: the frame of the pattern on the skin, the preview, and adding the previewed taxels.
#pragma once

#include "app/studio/frame/command.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/taxel/tool_state.h"

namespace taxel::ui {

/// Opens the panel with the frame at the middle of the view and lengths that suit the mesh. Closes the panel if it is
/// open.
void toggle_generate(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool, GenerateState& generate);
/// Closes the panel and discards the previewed taxels.
void close_generate(GenerateState& generate);
/// Adds the previewed taxels as one step of the history, selects them, and closes the panel. Does nothing if there are
/// no previewed taxels.
void accept_generate(WindowUi& ui, Viewer& viewer, const Shown& shown, GenerateState& generate);
[[nodiscard]] bool can_accept_generate(const Viewer& viewer, const Shown& shown, const GenerateState& generate);

/// Requests a preview if one of its inputs has changed. Closes the panel if there is nothing to edit any more.
void keep_preview_current(const Viewer& viewer, const Shown& shown, GenerateState& generate);

/// Changes the kind of the pattern; `kind` is an index of PatternShape. Keeps the values that both kinds share. The
/// other values are the last ones of the new kind.
void change_kind(GenerateState& generate, std::size_t kind);
template <class Kind>
void change_kind(GenerateState& generate) {
  change_kind(generate, PatternShape(Kind()).index());
}
/// Returns true if the frame places the pattern.
[[nodiscard]] bool has_frame(const Pattern& pattern);

/// Places the frame while the panel is open and no tool is active. A click on the skin moves the frame there, and a
/// drag that begins on the frame's centre moves the frame. `x` and `y` are the pointer in pixels of the view. Returns
/// whether the frame used the mouse.
bool frame_mouse(WindowUi& ui, const Viewer& viewer, const Shown& shown, GenerateState& generate, double x, double y,
                 bool hovered);
/// Turns the pattern by 5 degrees per notch of Ctrl+wheel.
void turn_pattern(GenerateState& generate, double notches);

struct ReadPoints {  ///< a table or an image for the Generate panel
  std::string path;
};
struct ToggleGenerate {};
void carry_out(const ToggleGenerate& command, App& app);

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::ReadPoints& command, Host& host);

}  // namespace taxel::studio
