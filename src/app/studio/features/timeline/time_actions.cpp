#include "app/studio/features/timeline/time_actions.h"

#include "app/studio/features/explain/explain_tool.h"
#include "app/studio/features/scenario/path_recorder.h"

namespace taxel::ui {

namespace {

void scrub_to_event(UiState& ui, const UiInput& input, int direction) {
  const std::uint64_t to = next_event(*input.frame->history.lanes, input.frame->step, direction);
  if (to != input.frame->step || input.playing) ui.ask(ScrubTo{to});
}

void toggle_loop(UiState& ui, const UiInput& input) {
  const HistoryState& history = input.frame->history;
  ui.ask(SetLoop{input.loop ? std::nullopt : std::optional(StepRange{history.first, history.last})});
}

}  // namespace

bool has_history(const UiInput& input) {
  return input.frame && input.frame->history.steps > 0;
}

bool perform_in_time(Action action, UiState& ui, const UiInput& input) {
  switch (action) {
    case Action::step_forward:
      ui.ask(StepOnce{});
      return true;
    case Action::step_back:
      ui.ask(StepBack{});
      return true;
    case Action::next_event:
    case Action::previous_event:
      scrub_to_event(ui, input, action == Action::next_event ? 1 : -1);
      return true;
    case Action::newest_step:
      ui.ask(ScrubTo{input.frame->history.last});
      return true;
    case Action::play_backwards:
      ui.ask(ReplayHistory{input.replay < 0 ? 0 : -1});
      return true;
    case Action::loop_range:
      toggle_loop(ui, input);
      return true;
    case Action::record:
      ui.ask(SetRecording{!input.frame->recording.on});
      return true;
    case Action::record_path:
      toggle_path_recording(ui, input);
      return true;
    case Action::explain:
      explain_reading(ui, input);
      return true;
    case Action::break_on_jump: {
      Breakpoints breakpoints = input.frame->breakpoints;
      breakpoints.on_jump = !breakpoints.on_jump;
      ui.ask(SetBreakpoints{breakpoints});
      return true;
    }
    default:
      return false;
  }
}

}  // namespace taxel::ui
