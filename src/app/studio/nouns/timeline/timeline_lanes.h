// Tracks of the timeline: curves of the recorded steps above each other, with events, range and cursor.
#pragma once

#include <imgui.h>

#include "app/studio/frame/selection.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/timeline/timeline_state.h"
#include "ui/theme.h"

namespace taxel::ui {

/// Draws the tracks into an area of `size`. Records the area of the tracks in `timeline.lanes`, where clicks are
/// handled.
void draw_timeline_lanes(WindowUi& ui, const Selection& selection, const RunView& run, Timeline& timeline,
                         const ImVec2& size);

/// Draws one line of play with the events, the looped range and the displayed step. Clicks are handled like those of
/// the tracks.
void draw_timeline_slider(WindowUi& ui, const Selection& selection, const RunView& run, Timeline& timeline,
                          const ImVec2& size);

/// Returns the colour of a step with events. Of several events, the one that says most about the method decides.
[[nodiscard]] ImVec4 event_color(const StepMark& mark, const Palette& colors);

/// Returns the step under a pixel column of the tracks. Columns outside of the tracks give the first or the last step.
[[nodiscard]] std::uint64_t step_at(const Timeline& timeline, float x);
/// Returns the middle of a step's column [pixels].
[[nodiscard]] float x_of(const Timeline& timeline, double step);

}  // namespace taxel::ui
