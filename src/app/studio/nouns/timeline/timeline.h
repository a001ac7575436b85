// The timeline of the latest steps at the bottom of the window: one line with the displayed step and markers of events,
// which unfolds to tracks, which are curves of the recorded steps above each other, and to the conditions that pause a
// run.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <optional>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "core/run/history/lanes.h"
#include "ui/theme.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {

/// The place of the tracks as they were drawn, and the effect of a drag in them.
struct Timeline {
  bool unfolded = false;                    ///< whether all tracks are drawn, not just one line; a setting
  Rect lanes;                               ///< all tracks, without their names, or the line of play
  StepRange steps;                          ///< steps at the left and the right edge of the tracks
  int marks = 0;                            ///< number of drawn events
  float events_y0 = 0, events_y1 = 0;       ///< upper and lower end of the markers of events [pixels]
  std::string tip;                          ///< names of the events under the pointer
  bool scrubs = false;                      ///< whether a drag moves the cursor
  std::optional<std::uint64_t> loops_from;  ///< step at which the dragged range begins or ends
};

/// The timeline of recorded steps. It is no movable panel.
extern const Feature kTimeline;
/// Sets "timeline", and "history" of the simulation.
void dump_timeline(const App& app, nlohmann::ordered_json& state);

/// Draws the tracks with events, range and cursor into an area of `size`. Records the area of the tracks in
/// `timeline.lanes`, where clicks are handled.
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
