#include "app/studio/host/run/run.h"

#include <fmt/format.h>

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

namespace {

void pause_requested(Run& run, CommandId command) {
  run.cursor.replay.stop();
  run.playback.plays = run.playback.is_held = run.playback.rests = false;
  run.playback.command = command;
}

void send_playing(Run& run) {
  run.playback.command =
      run.playback.plays ? run.simulation->send(PlayCommand{}) : run.simulation->send(PauseCommand{});
}

void show_step(Run& run, std::uint64_t step) {
  run.cursor.requested = step;
  run.cursor.command = run.simulation->send(ScrubCommand{step});
}

void step_once(Run& run, bool holds) {
  if (run.frame->finished && !run.frame->recorded) return;
  const int waiting = run.playback.held_steps;
  set_playing(run, false, false);
  run.playback.is_held = holds;
  if (holds) {
    run.playback.held_steps = waiting + 1;
  } else {
    run.simulation->send(StepCommand{1});
  }
}

/// Recorded steps are displayed at the speed of the simulation.
void advance_replay(Run& run, double seconds) {
  if (!run.cursor.replays() || !run.frame || run.frame->history.steps == 0) return;
  const double steps = seconds * run.playback.speed / run.frame->scene->timestep;
  show_step(run,
            run.cursor.replay.advance(steps, run.cursor.range_in(run.frame->history), run.cursor.loop.has_value()));
}

}  // namespace

void build_scene(Run& run, PendingScene pending) {
  run.pending = std::move(pending);
  if (run.pending->is_scenario) {
    run.pending->command =
        run.simulation->send(LoadScenarioCommand{run.pending->document.model, run.pending->scenario});
  } else {
    run.pending->command = run.simulation->send(LoadSceneCommand{run.pending->document.file, run.pending->attachments,
                                                                 run.pending->lead, run.pending->keeps_controls});
  }
}

PendingScene accept_pending(Run& run) {
  PendingScene loaded = *std::exchange(run.pending, std::nullopt);
  run.scene.attached = std::move(loaded.attachments);
  run.scene.lead = std::move(loaded.lead);
  run.scene.is_loaded = run.scene.is_of_document = true;
  run.scene.is_scenario = loaded.is_scenario;
  run.scene.is_still = false;
  if (loaded.is_scenario) run.scene.scenario = loaded.scenario;
  run.cursor.replay.stop();
  run.cursor.loop.reset();
  run.playback.plays = loaded.plays;
  run.playback.rests = false;
  run.playback.is_held = true;
  run.playback.held_steps = 0;
  return loaded;
}

void drop_scene(Run& run) {
  run.simulation->send(PauseCommand{});
  run.pending.reset();
  run.frame.reset();
  Scenario last = std::move(run.scene.scenario);
  run.scene = {};
  run.scene.scenario = std::move(last);
  run.playback.plays = run.playback.is_held = run.playback.rests = false;
  run.cursor.replay.stop();
  run.cursor.loop.reset();
}

void show_saved_step(Run& run, SimFramePtr frame) {
  run.frame = std::move(frame);
  run.scene.is_still = true;
  run.peaks.add(*run.frame);
}

void set_playing(Run& run, bool plays, bool holds) {
  run.cursor.replay.stop();
  if (plays && run.frame->finished) reset_run(run);
  run.playback.plays = plays;
  run.playback.rests = false;
  run.playback.held_steps = 0;
  run.playback.is_held = plays && holds;
  if (!run.playback.is_held) send_playing(run);
}

void rest_behind_dialog(Run& run, bool is_dialog_open, bool holds) {
  if (!run.can_play() || run.frame->finished) return;
  if (is_dialog_open && run.playback.plays) {
    set_playing(run, false, false);
    run.playback.rests = true;
  } else if (!is_dialog_open && run.playback.rests) {
    set_playing(run, true, holds);
  }
}

void release_hold(Run& run) {
  if (!run.playback.is_held) return;
  run.playback.is_held = false;
  send_playing(run);
  if (const int steps = std::exchange(run.playback.held_steps, 0); steps > 0) run.simulation->send(StepCommand{steps});
}

void reset_run(Run& run) {
  pause_requested(run, run.simulation->send(ResetCommand{}));
}

void load_keyframe(Run& run, const LoadKeyframeCommand& command) {
  pause_requested(run, run.simulation->send(command));
}

void step_ahead(Run& run, int steps) {
  run.simulation->send(PauseCommand{});
  pause_requested(run, run.simulation->send(StepCommand{steps}));
}

void set_speed(Run& run, double factor) {
  run.playback.speed = factor;
  run.simulation->send(SpeedCommand{factor});
}

void scrub(Run& run, std::uint64_t step) {
  show_step(run, step);
  pause_requested(run, run.cursor.command);
}

/// Steps through the recorded steps; the step after the newest one is simulated.
void step_by(Run& run, int steps, bool holds) {
  const auto first = static_cast<std::int64_t>(run.frame->history.first),
             last = static_cast<std::int64_t>(run.frame->history.last);
  const auto to = static_cast<std::int64_t>(run.cursor.step(run.carried_out, *run.frame)) + steps;
  const bool moves = run.playback.plays || run.cursor.replays();
  if (steps > 0 && (moves ? !run.cursor.replays() : to > last)) return step_once(run, holds);
  scrub(run, static_cast<std::uint64_t>(std::max(to, first)));
}

void replay(Run& run, int direction) {
  const StepRange range = run.cursor.loop.value_or(StepRange{run.frame->history.first, run.frame->history.last});
  std::uint64_t from = run.cursor.step(run.carried_out, *run.frame);
  if (!run.cursor.loop && direction > 0 && from >= range.last) from = range.first;
  scrub(run, from);
  run.cursor.replay.start(from, direction);
}

void advance_run(Run& run, double seconds) {
  advance_replay(run, seconds);
  run.simulation->advance(seconds);
}

/// A simulation that stopped by itself does not play any more, unless it has not carried out the latest command yet.
void accept_reply(Run& run, const SimEvent& event) {
  run.carried_out = std::max(run.carried_out, event.reply_to);
  const bool stopped = std::holds_alternative<Stopped>(event.what) || std::holds_alternative<Finished>(event.what) ||
                       std::holds_alternative<Failed>(event.what);
  if (stopped && !run.playback.is_held && run.carried_out >= run.playback.command) run.playback.plays = false;
}

bool accept_frame(Run& run, SimFramePtr frame) {
  if (!frame || !run.scene.is_loaded) return false;
  if (!frame->recorded) run.peaks.add(*frame);
  run.frame = std::move(frame);
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

bool is_declared(const Run& run, const std::string& geom) {
  if (!run.frame || !run.frame->simulated) return false;
  const int sensor = ui::sensor_on(*run.frame->simulated, geom);
  if (sensor < 0 || run.frame->simulated->sensors[at(sensor)]->taxel_count() == 0) return false;
  return std::none_of(run.scene.attached.begin(), run.scene.attached.end(),
                      [&](const SceneAttachment& one) { return one.geom == geom && !one.is_declared; });
}

std::vector<SceneAttachment> attachments_with_edits(const Run& run, const Document& document) {
  std::vector<SceneAttachment> all = run.scene.attached;
  const std::optional<ui::SceneLayout>& edited = document.scene_layout;
  const SensorModelPtr model = document.model();
  if (!edited || !model || !document.edits.problem().empty()) return all;
  for (const std::string& geom : edited->geoms) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const SceneAttachment& one) { return one.geom == geom; });
    const bool declared = is_declared(run, geom);
    if (declared && found == all.end() && (model->taxel_count() == 0 || !document.edits.dirty())) continue;
    if (model->taxel_count() == 0) {
      if (declared) continue;
      if (found != all.end()) all.erase(found);
      continue;
    }
    SceneAttachment& one = found != all.end() ? *found : all.emplace_back();
    one.geom = geom;
    one.layout = edited->file;
    one.skin = {};
    one.model = model;
    one.is_declared = declared;
  }
  return all;
}

void build_scene_again(Run& run, const Document& document, std::vector<SceneAttachment> attachments, bool is_shown) {
  if (!document.opened() || document.kind() != DocumentKind::scene || run.pending) return;
  build_scene(run, {.document = *document.opened(),
                    .attachments = std::move(attachments),
                    .lead = run.scene.lead,
                    .plays = run.playback.goes_on(),
                    .turns_cameras = false,
                    .is_shown = is_shown,
                    .keeps_controls = true});
}

void Handover::update(HostEvents& events) {
  send_newest(events);
  send_replacement(events);
}

/// With the same taxels the run continues with new readings. Otherwise the rows of the run would not fit, and another
/// run begins.
void Handover::send_newest(HostEvents& events) {
  const SensorModelPtr model = document_.model();
  if (!is_wanted_ || !model || document_.edits.models().busy() || replacement_ || run_.pending) return;
  is_wanted_ = false;
  if (document_.scene_layout) return send_newest_of_scene(model, events);
  const SimFramePtr& frame = run_.frame;
  if (!run_.scene.is_of_document || !frame || frame->simulated->sensors.empty()) return;
  const SensorModelPtr& simulated = frame->simulated->sensors.front();
  if (simulated == model) return;
  if (same_taxels(simulated->layout, model->layout) && same_bristles(simulated->layout, model->layout) &&
      same_mesh(simulated->mesh, model->mesh)) {
    begin({simulated, model});
  } else if (model->taxel_count() > 0 && document_.edits.problem().empty()) {
    build_scene(run_, {.document = *document_.opened(),
                       .is_scenario = true,
                       .scenario = run_.scene.scenario,
                       .plays = run_.playback.goes_on(),
                       .turns_cameras = false,
                       .is_shown = false});
  }
}

/// With the same taxels the sensors with the layout read by its new model. Otherwise the scene is compiled again.
void Handover::send_newest_of_scene(const SensorModelPtr& model, HostEvents& events) {
  if (!run_.scene.is_of_document || !run_.frame) return;
  const std::vector<std::string>& geoms = document_.scene_layout->geoms;
  const SimScene& scene = *run_.frame->simulated;
  const auto model_on = [&](const std::string& geom) {
    const int sensor = ui::sensor_on(scene, geom);
    return sensor >= 0 ? scene.sensors[at(sensor)] : nullptr;
  };
  const auto reads = [&](const std::string& geom) { return model_on(geom) == model; };
  if (std::all_of(geoms.begin(), geoms.end(), reads)) return;
  const std::string name = model->layout.name;
  if (!document_.edits.problem().empty()) {
    events.emplace_back(
        HostMessage{Severity::error, name + ": " + document_.edits.problem(), ui::Holds::while_unrunnable});
    return;
  }
  const SensorModelPtr simulated = model_on(geoms.front());
  const bool is_same_on_all =
      std::all_of(geoms.begin(), geoms.end(), [&](const std::string& geom) { return model_on(geom) == simulated; });
  if (is_same_on_all && simulated && same_taxels(simulated->layout, model->layout) &&
      same_bristles(simulated->layout, model->layout) && same_mesh(simulated->mesh, model->mesh))
    return begin({simulated, model});
  std::vector<SceneAttachment> attachments = attachments_with_edits(run_, document_);
  if (attachments != run_.scene.attached) build_scene_again(run_, document_, std::move(attachments), false);
}

/// Sends samples to the simulation, or displays them if no simulation reads by their preview.
void Handover::send_replacement(HostEvents& events) {
  if (!replacement_ || replacement_->command > 0 || run_.pending) return;
  const Polished& models = replacement_->models;
  if (!run_.scene.is_of_document || !run_.frame || !reads_by(*run_.frame, models.preview)) {
    document_.accept_polished(std::exchange(replacement_, std::nullopt)->models, events);
  } else {
    replacement_->command = run_.simulation->send(ReplaceModelCommand{models.preview, models.model});
  }
}

void Handover::accept(const SimEvent& event, HostEvents& events) {
  if (!replacement_ || replacement_->command == 0 || event.reply_to != replacement_->command) return;
  if (std::holds_alternative<ModelReplaced>(event.what)) {
    if (document_.scene_layout) run_.scene.attached = attachments_with_edits(run_, document_);
    document_.accept_polished(std::exchange(replacement_, std::nullopt)->models, events);
  } else if (std::holds_alternative<Refused>(event.what) || std::holds_alternative<Done>(event.what)) {
    document_.retain_preview(std::exchange(replacement_, std::nullopt)->models.preview);
  }
}

bool Handover::will_change_samples() const {
  const SimFramePtr& frame = run_.frame;
  if (!run_.scene.is_of_document || !frame || !frame->simulated) return false;
  const auto is_preview = [](const SensorModelPtr& model) { return model && model->quality == SampleQuality::preview; };
  const std::vector<SensorModelPtr>& sensors = frame->simulated->sensors;
  if (std::none_of(sensors.begin(), sensors.end(), is_preview)) return false;
  return document_.loader.busy() || run_.pending || replacement_ || document_.edits.models().busy() || is_wanted_;
}

}  // namespace taxel::studio
