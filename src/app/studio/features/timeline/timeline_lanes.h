// Lanes of the timeline: curves of the recorded steps above each other, with events, range and cursor.
#pragma once

#include <imgui.h>

#include "app/studio/app/values/selection.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/timeline/timeline_state.h"
#include "ui/theme.h"

namespace taxel::ui {

/// Fills `size`. Notes app.simulate.timeline.lanes, which may then be clicked.
void draw_timeline_lanes(WindowUi& ui, const Selection& selection, const RunView& run, Timeline& timeline,
                         const ImVec2& size);

/// Colour of a step with events; of several events the one that says most about the method decides.
[[nodiscard]] ImVec4 event_color(const StepMark& mark, const Palette& colors);

/// Step under a pixel column of the lanes, within them.
[[nodiscard]] std::uint64_t step_at(const Timeline& timeline, float x);
/// Middle of a step's column [pixels].
[[nodiscard]] float x_of(const Timeline& timeline, double step);

}  // namespace taxel::ui
