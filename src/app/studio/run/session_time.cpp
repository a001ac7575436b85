// The simulation run and paused, recorded steps shown again, and where it stops by itself.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/studio/run/session.h"
#include "ui/widgets/format.h"

namespace taxel::studio {

/// Of a step that was saved it says why nothing does.
bool Session::runs_or_refuses() {
  if (still_) refusal_ = document_->name + " is a single step: there is nothing to run.";
  return frame_ && !still_;
}

void Session::show_saved_step() {
  frame_ = document_->frame;
  still_ = true;
  note_pressures(*frame_);
}

void Session::set_playing(bool playing) {
  if (!runs_or_refuses()) return;
  replay_.stop();
  if (playing && frame_->finished) reset();
  playing_ = playing;
  held_steps_ = 0;
  held_ = playing && samples_will_change();
  if (!held_) send_playing();
}

void Session::send_playing() {
  play_command_ = playing_ ? tell(PlayCommand{}) : tell(PauseCommand{});
}

/// Registers that the simulation stopped by itself, unless it has not executed the latest command to play yet.
void Session::note_stop() {
  if (!held_ && executed_ >= play_command_) playing_ = false;
}

void Session::reset() {
  if (!runs_or_refuses()) return;
  replay_.stop();
  playing_ = held_ = false;
  play_command_ = tell(ResetCommand{});  // which pauses
}

/// Whether the simulation reads by a preview's samples that are about to be replaced. When they are depends on the load
/// of the machine, so a step that is made before reads differently from one start to the next.
bool Session::samples_will_change() const {
  if (!simulates_document_ || !frame_ || !frame_->simulated) return false;
  const auto is_preview = [](const SensorModelPtr& model) { return model && model->quality == SampleQuality::preview; };
  const std::vector<SensorModelPtr>& sensors = frame_->simulated->sensors;
  if (std::none_of(sensors.begin(), sensors.end(), is_preview)) return false;
  return loader_.busy() || pending_ || polished_ || edits_.building() || hand_over_wanted_;
}

/// Starts the run, or makes the single steps, that waited for polished samples.
void Session::start_held_run() {
  if (!held_ || samples_will_change()) return;
  held_ = false;
  send_playing();
  if (const int steps = std::exchange(held_steps_, 0); steps > 0) tell(StepCommand{steps});
}

void Session::set_speed(double factor) {
  speed_ = factor;
  tell(SpeedCommand{factor});
}

void Session::advance(double seconds) {
  advance_replay(seconds);
  simulation_->advance(seconds);
}

/// The step shown when what was asked for last is done.
std::uint64_t Session::shown_step() const {
  return executed_ < scrub_command_ ? scrubbed_to_ : frame_->step;
}

void Session::show_step(std::uint64_t step) {
  scrubbed_to_ = step;
  scrub_command_ = tell(ScrubCommand{step});
}

void Session::scrub(std::uint64_t step) {
  if (!runs_or_refuses()) return;
  replay_.stop();
  playing_ = held_ = false;
  show_step(step);
  play_command_ = scrub_command_;
}

void Session::step_by(int steps) {
  if (!runs_or_refuses()) return;
  const auto to = static_cast<std::int64_t>(shown_step()) + steps;
  const bool moves = playing() || replaying();
  if (steps > 0 && (moves ? !replaying() : to > static_cast<std::int64_t>(frame_->history.last))) return step_once();
  scrub(static_cast<std::uint64_t>(std::max<std::int64_t>(to, static_cast<std::int64_t>(frame_->history.first))));
}

void Session::step_once() {
  if (!frame_ || (frame_->finished && !frame_->recorded)) return;
  const int waiting = held_steps_;
  set_playing(false);
  held_ = samples_will_change();
  if (held_) {
    held_steps_ = waiting + 1;
  } else {
    tell(StepCommand{1});
  }
}

void Session::replay(int direction) {
  if (!runs_or_refuses()) return;
  const StepRange all = loop_.value_or(StepRange{frame_->history.first, frame_->history.last});
  std::uint64_t from = shown_step();
  if (!loop_ && direction > 0 && from >= all.last) from = all.first;  // once more from the start
  scrub(from);
  replay_.start(from, direction);
  replayed_at_ = std::chrono::steady_clock::now();
}

void Session::set_loop(std::optional<StepRange> range) {
  loop_ = range;
}

/// As fast as the simulation is to run.
void Session::advance_replay(double seconds) {
  if (!replaying() || !frame_ || frame_->history.steps == 0) return;
  StepRange range{frame_->history.first, frame_->history.last};
  if (loop_) {
    range.first = std::clamp(loop_->first, range.first, range.last);
    range.last = std::clamp(loop_->last, range.first, range.last);
  }
  show_step(replay_.advance(seconds * speed_ / frame_->scene->timestep, range, loop_.has_value()));
}

void Session::replay_by_clock() {
  if (!by_clock_ || !replaying()) return;
  const auto now = std::chrono::steady_clock::now();
  advance_replay(std::chrono::duration<double>(now - replayed_at_).count());
  replayed_at_ = now;
}

void Session::set_breakpoints(const Breakpoints& breakpoints) {
  tell(BreakpointsCommand{breakpoints});
}

void Session::set_history_limits(const StepHistoryLimits& limits) {
  tell(StepHistoryLimitsCommand{limits});
}

namespace {

std::string taxel_text(const Taxel& taxel) {
  return fmt::format("taxel {}{}", taxel.id, taxel.name.empty() ? "" : " (" + taxel.name + ")");
}

std::string stop_text(const Jump& jump, const Taxel& taxel, const ui::ReadingUnit& unit, const char* whose) {
  const double force = jump.force_before > 0 ? 100 * (jump.force_after / jump.force_before - 1) : 0.0;
  constexpr int kForceDigits = 4;
  const NumberPair readings = ui::pair_in_unit(jump.before, jump.after, unit);
  const NumberPair forces = number_pair(jump.force_before, jump.force_after, kForceDigits);
  return fmt::format(
      "{} jumped from {} to {}, {:.1f} % of {} largest reading, while the force {} {} to {} N ({:+.2f} %)",
      taxel_text(taxel), readings.first, readings.second, 100 * jump.part, whose,
      jump.at_equal_force ? "stayed," : "went from", forces.first, forces.second, force);
}

std::string stop_text(const Disagreement& gap, const Taxel& taxel, const ui::ReadingUnit& unit, const char* whose) {
  const NumberPair readings = ui::pair_in_unit(gap.sampled, gap.exact, unit);
  return fmt::format("{} reads {} by its samples and {} by the surface, {:.1f} % of {} largest reading apart",
                     taxel_text(taxel), readings.first, readings.second, 100 * gap.part, whose);
}

}  // namespace

/// Reports the taxel and the numbers of a breakpoint.
void Session::tell_stop(const Stopped& stopped, const Breakpoints& breakpoints, SessionNews& news) {
  const std::string text = std::visit(
      [&](const auto& at) {
        const Layout& layout = stopped.scene->sensors[static_cast<std::size_t>(at.sensor)]->layout;
        const std::string what =
            stop_text(at, layout.taxels[static_cast<std::size_t>(at.taxel)], ui::shown_unit(layout.readout.aggregate),
                      breakpoints.of_sensor ? "the sensor's" : "its");
        return fmt::format("Paused at step {}, {:.6g} s: {}", at.step, at.time, what);
      },
      stopped.stop);
  news.messages.emplace_back(Severity::warning, text);
}

}  // namespace taxel::studio
