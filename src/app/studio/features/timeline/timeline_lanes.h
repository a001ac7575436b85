// Lanes of the timeline: curves of the recorded steps above each other, with events, range and cursor.
#pragma once

#include <imgui.h>

#include "app/studio/app/ui_state.h"
#include "ui/theme.h"

namespace taxel::ui {

/// Fills `size`. Notes ui.timeline.lanes, which may then be clicked.
void draw_timeline_lanes(UiState& ui, const UiInput& input, const ImVec2& size);

/// Colour of a step with events; of several events the one that says most about the method decides.
[[nodiscard]] ImVec4 event_color(const StepMark& mark, const Palette& colors);

/// Step under a pixel column of the lanes, within them.
[[nodiscard]] std::uint64_t step_at(const Timeline& timeline, float x);
/// Middle of a step's column [pixels].
[[nodiscard]] float x_of(const Timeline& timeline, double step);

}  // namespace taxel::ui
