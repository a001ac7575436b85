#include "app/studio/host/run/run.h"

#include <algorithm>
#include <utility>

#include "core/base/math.h"

namespace taxel::studio {
namespace {

/// Readings of a frame, all sensors one after the other, as trace rows have them.
std::vector<double> all_readings(const SimFrame& frame) {
  std::vector<double> all;
  for (const SensorStep& sensor : frame.sensors) all.insert(all.end(), sensor.readings.begin(), sensor.readings.end());
  return all;
}

}  // namespace

void Peaks::raise(const std::vector<double>& readings) {
  peaks_.resize(std::max(peaks_.size(), readings.size()));
  for (std::size_t i = 0; i < readings.size(); ++i) peaks_[i] = std::max(peaks_[i], readings[i]);
}

void Peaks::add(const SimFrame& frame) {
  const Trace& trace = *frame.trace;
  if (std::exchange(edition_, trace.edition) != trace.edition) {
    peaks_.clear();
    rows_ = 0;
    largest_pressure_ = 0;
  }
  for (; rows_ < trace.rows.size(); ++rows_) raise(trace.rows[rows_].readings);
  raise(all_readings(frame));
  for (const SensorStep& sensor : frame.sensors)
    for (const ContactSurface& surface : sensor.surfaces)
      largest_pressure_ = std::max(largest_pressure_, surface.max_pressure());
}

std::vector<double> Peaks::of_sensor(const SimFrame& frame, int sensor) const {
  if (sensor < 0 || at(sensor) >= frame.sensors.size()) return {};
  const std::size_t first = frame.first_reading(at(sensor));
  const std::size_t last = std::min(peaks_.size(), first + frame.sensors[at(sensor)].readings.size());
  return first < last
             ? std::vector<double>(peaks_.begin() + std::ptrdiff_t(first), peaks_.begin() + std::ptrdiff_t(last))
             : std::vector<double>{};
}

void Run::build(PendingScene pending) {
  pending_ = std::move(pending);
  if (pending_->is_scenario) {
    pending_->command = send(LoadScenarioCommand{pending_->document.model, pending_->scenario});
  } else {
    pending_->command = send(LoadSceneCommand{pending_->document.file, pending_->attachments, pending_->lead});
  }
}

PendingScene Run::accept_pending() {
  PendingScene loaded = *std::exchange(pending_, std::nullopt);
  scene_.attached = std::move(loaded.attachments);
  scene_.lead = std::move(loaded.lead);
  scene_.is_loaded = scene_.is_of_document = true;
  scene_.is_scenario = loaded.is_scenario;
  scene_.is_still = false;
  if (loaded.is_scenario) scene_.scenario = loaded.scenario;
  cursor_.replay.stop();
  cursor_.loop.reset();
  playback_.plays = loaded.plays;
  playback_.is_held = true;
  playback_.held_steps = 0;
  return loaded;
}

void Run::drop_scene() {
  send(PauseCommand{});
  pending_.reset();
  frame_.reset();
  Scenario last = std::move(scene_.scenario);
  scene_ = {};
  scene_.scenario = std::move(last);
  playback_.plays = playback_.is_held = false;
  cursor_.replay.stop();
  cursor_.loop.reset();
}

void Run::show_saved_step(SimFramePtr frame) {
  frame_ = std::move(frame);
  scene_.is_still = true;
  peaks_.add(*frame_);
}

void Run::pause_requested(CommandId command) {
  cursor_.replay.stop();
  playback_.plays = playback_.is_held = false;
  playback_.command = command;
}

void Run::send_playing() {
  playback_.command = playback_.plays ? send(PlayCommand{}) : send(PauseCommand{});
}

void Run::set_playing(bool plays, bool holds) {
  cursor_.replay.stop();
  if (plays && frame_->finished) reset();
  playback_.plays = plays;
  playback_.held_steps = 0;
  playback_.is_held = plays && holds;
  if (!playback_.is_held) send_playing();
}

void Run::release_hold() {
  if (!playback_.is_held) return;
  playback_.is_held = false;
  send_playing();
  if (const int steps = std::exchange(playback_.held_steps, 0); steps > 0) send(StepCommand{steps});
}

void Run::reset() {
  pause_requested(send(ResetCommand{}));
}

void Run::load_keyframe(const LoadKeyframeCommand& command) {
  pause_requested(send(command));
}

void Run::set_speed(double factor) {
  playback_.speed = factor;
  send(SpeedCommand{factor});
}

void Run::show_step(std::uint64_t step) {
  cursor_.requested = step;
  cursor_.command = send(ScrubCommand{step});
}

void Run::scrub(std::uint64_t step) {
  show_step(step);
  pause_requested(cursor_.command);
}

/// Steps through the recorded steps; the step after the newest one is simulated.
void Run::step_by(int steps, bool holds) {
  const auto first = static_cast<std::int64_t>(frame_->history.first),
             last = static_cast<std::int64_t>(frame_->history.last);
  const auto to = static_cast<std::int64_t>(cursor_.step(carried_out_, *frame_)) + steps;
  const bool moves = playback_.plays || replays();
  if (steps > 0 && (moves ? !replays() : to > last)) return step_once(holds);
  scrub(static_cast<std::uint64_t>(std::max(to, first)));
}

void Run::step_once(bool holds) {
  if (frame_->finished && !frame_->recorded) return;
  const int waiting = playback_.held_steps;
  set_playing(false, false);
  playback_.is_held = holds;
  if (holds) {
    playback_.held_steps = waiting + 1;
  } else {
    send(StepCommand{1});
  }
}

void Run::replay(int direction) {
  const StepRange range = cursor_.loop.value_or(StepRange{frame_->history.first, frame_->history.last});
  std::uint64_t from = cursor_.step(carried_out_, *frame_);
  if (!cursor_.loop && direction > 0 && from >= range.last) from = range.first;
  scrub(from);
  cursor_.replay.start(from, direction);
}

/// Recorded steps are displayed at the speed of the simulation.
void Run::advance_replay(double seconds) {
  if (!replays() || !frame_ || frame_->history.steps == 0) return;
  const double steps = seconds * playback_.speed / frame_->scene->timestep;
  show_step(cursor_.replay.advance(steps, cursor_.range_in(frame_->history), cursor_.loop.has_value()));
}

void Run::advance(double seconds) {
  advance_replay(seconds);
  host_->advance(seconds);
}

/// A simulation that stopped by itself does not play any more, unless it has not carried out the latest command yet.
void Run::accept(const SimEvent& event) {
  carried_out_ = std::max(carried_out_, event.reply_to);
  const bool stopped = std::holds_alternative<Stopped>(event.what) || std::holds_alternative<Finished>(event.what) ||
                       std::holds_alternative<Failed>(event.what);
  if (stopped && !playback_.is_held && carried_out_ >= playback_.command) playback_.plays = false;
}

bool Run::accept_frame(SimFramePtr frame) {
  if (!frame || !scene_.is_loaded) return false;
  if (!frame->recorded) peaks_.add(*frame);
  frame_ = std::move(frame);
  return true;
}

namespace {

bool same_taxels(const Layout& a, const Layout& b) {
  return std::equal(a.taxels.begin(), a.taxels.end(), b.taxels.begin(), b.taxels.end(),
                    [](const Taxel& x, const Taxel& y) { return x.id == y.id; });
}

bool same_mesh(const TriMeshPtr& a, const TriMeshPtr& b) {
  return a == b || (a->faces() == b->faces() && a->vertices() == b->vertices());
}

/// Returns true if both layouts have friction with the same state.
bool same_bristles(const Layout& a, const Layout& b) {
  return a.material.tangential_stiffness == b.material.tangential_stiffness &&
         a.material.bristles == b.material.bristles;
}

bool reads_by(const SimFrame& frame, const SensorModelPtr& model) {
  const auto& sensors = frame.simulated->sensors;
  return std::find(sensors.begin(), sensors.end(), model) != sensors.end();
}

}  // namespace

void Handover::update(HostEvents& events) {
  send_newest();
  send_replacement(events);
}

/// With the same taxels the run continues with new readings. Otherwise the rows of the run would not fit, and another
/// run begins.
void Handover::send_newest() {
  const SensorModelPtr model = document_.model();
  if (!is_wanted_ || !model || document_.edits().building() || replacement_ || run_.pending()) return;
  is_wanted_ = false;
  const SimFramePtr& frame = run_.frame();
  if (!run_.scene().is_of_document || !frame || frame->simulated->sensors.empty()) return;
  const SensorModelPtr& simulated = frame->simulated->sensors.front();
  if (simulated == model) return;
  if (same_taxels(simulated->layout, model->layout) && same_bristles(simulated->layout, model->layout) &&
      same_mesh(simulated->mesh, model->mesh)) {
    begin({simulated, model});
  } else if (model->taxel_count() > 0 && document_.edits().problem().empty()) {
    run_.build({.document = *document_.opened(),
                .is_scenario = true,
                .scenario = run_.scene().scenario,
                .plays = run_.playback().plays,
                .turns_cameras = false,
                .is_shown = false});
  }
}

/// Sends samples to the simulation, or displays them if no simulation reads by their preview.
void Handover::send_replacement(HostEvents& events) {
  if (!replacement_ || replacement_->command > 0 || run_.pending()) return;
  const Polished& models = replacement_->models;
  if (!run_.scene().is_of_document || !run_.frame() || !reads_by(*run_.frame(), models.preview)) {
    document_.accept_polished(std::exchange(replacement_, std::nullopt)->models, events);
  } else {
    replacement_->command = run_.send(ReplaceModelCommand{models.preview, models.model});
  }
}

void Handover::accept(const SimEvent& event, HostEvents& events) {
  if (!replacement_ || replacement_->command == 0 || event.reply_to != replacement_->command) return;
  if (std::holds_alternative<ModelReplaced>(event.what)) {
    document_.accept_polished(std::exchange(replacement_, std::nullopt)->models, events);
  } else if (std::holds_alternative<Refused>(event.what) || std::holds_alternative<Done>(event.what)) {
    document_.retain_preview(std::exchange(replacement_, std::nullopt)->models.preview);
  }
}

bool Handover::will_change_samples() const {
  const SimFramePtr& frame = run_.frame();
  if (!run_.scene().is_of_document || !frame || !frame->simulated) return false;
  const auto is_preview = [](const SensorModelPtr& model) { return model && model->quality == SampleQuality::preview; };
  const std::vector<SensorModelPtr>& sensors = frame->simulated->sensors;
  if (std::none_of(sensors.begin(), sensors.end(), is_preview)) return false;
  return document_.loader().busy() || run_.pending() || replacement_ || document_.edits().building() || is_wanted_;
}

}  // namespace taxel::studio
