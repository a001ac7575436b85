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
  if (held_) return;
  if (!by_clock_ && playing && frame_->failed) tell(PlayCommand{});  // from an earlier step, or the start
  if (!by_clock_) return;
  send_playing();
}

void Session::send_playing() {
  play_command_ = playing_ ? simulation_.send(PlayCommand{}) : simulation_.send(PauseCommand{});
}

void Session::reset() {
  if (!runs_or_refuses()) return;
  replay_.stop();
  playing_ = held_ = false;
  unspent_ = 0;
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
  if (by_clock_) send_playing();
  if (const int steps = std::exchange(held_steps_, 0); steps > 0) tell(StepCommand{steps});
}

void Session::set_speed(double factor) {
  speed_ = factor;
  simulation_.send(SpeedCommand{factor});
}

void Session::advance(double seconds) {
  advance_replay(seconds);
  if (!playing_ || held_ || !frame_ || !frame_->scene || frame_->finished || settled_) return;
  const double timestep = frame_->scene->timestep;
  unspent_ += seconds * speed_;
  const auto steps = static_cast<int>(std::floor(unspent_ / timestep * (1 + 1e-12)));  // 20 ms are twenty steps of 1 ms
  if (steps < 1) return;
  unspent_ -= steps * timestep;
  tell(StepCommand{steps});
}

/// The step shown when what was asked for last is done.
std::uint64_t Session::shown_step() const {
  const SimFramePtr& now = settled_ ? settled_ : frame_;
  return now->commands < scrub_command_ ? scrubbed_to_ : now->step;
}

void Session::show_step(std::uint64_t step) {
  scrubbed_to_ = step;
  scrub_command_ = tell(ScrubCommand{step});
}

void Session::scrub(std::uint64_t step) {
  if (!runs_or_refuses()) return;
  replay_.stop();
  playing_ = held_ = false;
  unspent_ = 0;
  show_step(step);
  play_command_ = scrub_command_;
}

void Session::step_by(int steps) {
  if (!runs_or_refuses()) return;
  const SimFramePtr now = settled_ ? settled_ : frame_;
  const auto to = static_cast<std::int64_t>(shown_step()) + steps;
  const bool moves = playing() || replaying();
  if (steps > 0 && (moves ? !replaying() : to > static_cast<std::int64_t>(now->history.last))) return step_once();
  scrub(static_cast<std::uint64_t>(std::max<std::int64_t>(to, static_cast<std::int64_t>(now->history.first))));
}

void Session::step_once() {
  const SimFramePtr now = settled_ ? settled_ : frame_;
  if (!now || (now->finished && !now->recorded)) return;
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

std::uint64_t step_of(const Stop& stop) {
  return std::visit([](const auto& at) { return at.step; }, stop);
}

}  // namespace

/// Once for each breakpoint that was met: taxel and numbers.
void Session::tell_stop(const SimFrame& frame, SessionNews& news) {
  const bool told = told_stop_ && frame.stop && step_of(*told_stop_) == step_of(*frame.stop) && stop_run_ == frame.runs;
  told_stop_ = frame.stop;
  stop_run_ = frame.runs;
  if (!frame.stop || told) return;
  const std::string text = std::visit(
      [&](const auto& at) {
        const Layout& layout = frame.simulated->sensors[static_cast<std::size_t>(at.sensor)]->layout;
        const std::string what =
            stop_text(at, layout.taxels[static_cast<std::size_t>(at.taxel)], ui::shown_unit(layout.readout.aggregate),
                      frame.breakpoints.of_sensor ? "the sensor's" : "its");
        return fmt::format("Paused at step {}, {:.6g} s: {}", at.step, at.time, what);
      },
      *frame.stop);
  news.messages.emplace_back(Severity::warning, text);
}

}  // namespace taxel::studio
