// Commands about the run and its recorded steps.
#pragma once

#include <cstdint>
#include <optional>

#include "app/studio/frame/app.h"
#include "app/studio/frame/command.h"
#include "app/studio/host/run/host_event.h"
#include "core/document/scenario/scenario.h"
#include "core/run/scene.h"

namespace taxel::ui {

/// Displays the next or the previous recorded event.
struct GoToEvent {
  int direction = 1;  ///< 1 or -1
  bool operator==(const GoToEvent&) const = default;
};
/// Displays a recorded step with an event. The taxel that jumps in it is selected.
struct ShowEvent {
  std::uint64_t step = 0;
};
struct GoToNewestStep {};
struct TogglePlayBackwards {};
struct ToggleLoop {};
struct ToggleBreakOnJump {};
struct ToggleRecording {};
/// Changes the speed of the simulation by a factor of 2.
struct ChangeSpeed {
  bool faster = false;
  bool operator==(const ChangeSpeed&) const = default;
};
struct RunScenario {
  Scenario scenario;
};
/// Plays if the simulation pauses when the command is carried out, otherwise pauses: earlier commands count.
struct PlayOrPause {};
struct StepOnce {};
struct StepBack {};
/// Pauses, and makes steps at once, up to the end of the run. Only the last one is displayed.
struct StepAhead {
  int steps = 1;
};
/// Displays a recorded step; the simulation pauses.
struct ScrubTo {
  std::uint64_t step = 0;
};
/// Plays recorded steps, from the displayed one: 1 forwards, -1 backwards.
struct ReplayHistory {
  int direction = -1;
};
struct SetLoop {
  std::optional<StepRange> range;  ///< empty if nothing is looped
};
/// Records every simulated step until recording ends; then the recording is written.
struct SetRecording {
  bool on = false;
};
struct ResetSimulation {};
struct SetSpeed {
  double factor = 1;
};
struct SetMode {
  Mode mode = Mode::simulate;
  bool pauses = true;  ///< whether ANALYSE pauses the run
  bool operator==(const SetMode&) const = default;
};

void carry_out(const GoToEvent& command, App& app);
void carry_out(const ShowEvent& command, App& app);
void carry_out(const GoToNewestStep& command, App& app);
void carry_out(const TogglePlayBackwards& command, App& app);
void carry_out(const ToggleLoop& command, App& app);
void carry_out(const ToggleBreakOnJump& command, App& app);
void carry_out(const ToggleRecording& command, App& app);
void carry_out(const ChangeSpeed& command, App& app);

/// Returns the next speed above or below, along 1/16 ... 1/2, 1, 2 ... 16.
[[nodiscard]] double next_speed(double speed, bool faster);

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::RunScenario& command, Host& host);
void carry_out(const ui::PlayOrPause& command, Host& host);
void carry_out(const ui::StepOnce& command, Host& host);
void carry_out(const ui::StepBack& command, Host& host);
void carry_out(const ui::StepAhead& command, Host& host);
void carry_out(const ui::ScrubTo& command, Host& host);
void carry_out(const ui::ReplayHistory& command, Host& host);
void carry_out(const ui::SetLoop& command, Host& host);
void carry_out(const ui::SetRecording& command, Host& host);
void carry_out(const ui::ResetSimulation& command, Host& host);
void carry_out(const ui::SetSpeed& command, Host& host);
void carry_out(const ui::SetMode& command, Host& host);

/// Returns whether there is a simulation to play. Reports why not if a saved step is displayed.
[[nodiscard]] bool can_play_or_report(Host& host);
void set_playing(Host& host, bool plays);
void scrub(Host& host, std::uint64_t step);
/// Pauses a run while LAYOUT is displayed. Back in SIMULATE the run that was paused so goes on.
void rest_in_layout(Host& host);

}  // namespace taxel::studio
