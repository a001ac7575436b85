#include "app/studio/host/session.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"

namespace taxel::studio {

Session::Session(SessionHosts hosts)
    : is_real_time_(hosts.is_real_time),
      executor_(hosts.executor),
      jobs_(hosts.executor),
      document_(hosts.executor, hosts.cache, [this](const SensorModelPtr& model) { jobs_.model_built(model); }),
      run_(std::move(hosts.simulation)),
      handover_(document_, run_) {}

void Session::report(Severity severity, std::string text, ui::Holds holds) {
  events_.emplace_back(SessionMessage{severity, std::move(text), holds});
}

void Session::close() {
  document_.close();
  handover_.clear();
  drop_scene();
}

void Session::drop_scene() {
  run_.drop_scene();
  jobs_.drop_scene();
}

void Session::polish() {
  if (!handover_.is_replacing()) document_.polish();
}

/// Another document was to be loaded while the samples of this one were polished, and was refused.
void Session::resume_polishing() {
  if (!handover_.is_replacing()) document_.resume_polishing();
}

void Session::after_edit(bool is_simulated) {
  jobs_.note_edit();
  // The samples of the loaded layout are not needed any more; those of the edited layout are polished where it is
  // built.
  if (document_.loader().polishing() && !run_.pending()) document_.loader().close();
  if (is_simulated || run_.holds_run()) handover_.request();
}

bool Session::run_scenario(const Scenario& scenario) {
  const std::optional<LoadedDocument>& document = document_.opened();
  if (!document || !document->model || document->model->taxel_count() == 0) return false;
  if (!edits().problem().empty()) {
    report(Severity::error, document->name + ": " + edits().problem(), ui::Holds::while_unrunnable);
    return false;
  }
  if (edits().is_open()) edits().edit(SetScenario{scenario});
  if (document->previewed()) handover_.request();
  const auto place_of = [](const Scenario& s) { return find_number(s, "place") ? *find_number(s, "place") : 0.0; };
  const RunningScene& scene = run_.scene();
  const bool elsewhere = !scene.is_of_document || scenario.kind() != scene.scenario.kind() ||
                         place_of(scenario) != place_of(scene.scenario);
  run_.build(
      {.document = *document, .is_scenario = true, .scenario = scenario, .plays = true, .turns_cameras = elsewhere});
  return true;
}

/// Reports why nothing plays if a saved step is displayed.
bool Session::can_play_or_report() {
  if (run_.scene().is_still)
    report(Severity::error, document_.opened()->name + " is a single step: there is nothing to run.",
           ui::Holds::for_document);
  return run_.can_play();
}

void Session::set_playing(bool plays) {
  if (can_play_or_report()) run_.set_playing(plays, handover_.will_change_samples());
}

void Session::step_by(int steps) {
  if (can_play_or_report()) run_.step_by(steps, handover_.will_change_samples());
}

void Session::scrub(std::uint64_t step) {
  if (can_play_or_report()) run_.scrub(step);
}

void Session::replay(int direction) {
  if (can_play_or_report()) run_.replay(direction);
}

void Session::reset() {
  if (can_play_or_report()) run_.reset();
}

void Session::send(SimCommand command) {
  if (!run_.frame()) return;
  if (const auto* keyframe = std::get_if<LoadKeyframeCommand>(&command)) {
    run_.load_keyframe(*keyframe);
  } else {
    run_.send(std::move(command));
  }
}

/// The document, the cameras and pause stay, and another run begins.
void Session::build_with(std::vector<SceneAttachment> attachments) {
  run_.build({.document = *document_.opened(),
              .attachments = std::move(attachments),
              .lead = run_.scene().lead,
              .plays = playing(),
              .turns_cameras = false});
}

void Session::attach(const std::vector<std::string>& geoms, const std::string& layout) {
  if (!document_.opened() || kind() != DocumentKind::scene || run_.pending()) return;
  std::vector<SceneAttachment> attachments = run_.scene().attached;
  for (const std::string& geom : geoms) attachments.push_back({geom, layout});
  build_with(std::move(attachments));
}

void Session::detach(const std::string& geom) {
  if (!document_.opened() || kind() != DocumentKind::scene || run_.pending()) return;
  std::vector<SceneAttachment> attachments = run_.scene().attached;
  std::erase_if(attachments, [&](const SceneAttachment& attached) { return attached.geom == geom; });
  build_with(std::move(attachments));
}

void Session::record(bool on, const std::string& file, bool error_bars) {
  if (!can_play_or_report()) return;
  on ? run_.send(RecordCommand{file, error_bars}) : run_.send(EndRecordingCommand{});
}

void Session::export_recording(const std::string& file, bool error_bars) {
  if (can_play_or_report()) run_.send(ExportHistoryCommand{file, run_.cursor().loop, error_bars});
}

bool Session::idle() const {
  return !document_.loader().busy() && !run_.pending() && !handover_.is_replacing() && !edits().building() &&
         !jobs_.busy();
}

void Session::fill(ui::App& app, int selected_sensor) const {
  const std::optional<LoadedDocument>& document = document_.opened();
  const RunningScene& scene = run_.scene();
  const Loader& loader = document_.loader();
  jobs_.fill(app);
  ui::DocumentView& shown = app.shown->document;
  ui::RunView& run = app.shown->run;
  run.frame = run_.frame();
  shown.model = document_.model();
  shown.name = document ? document->name : "";
  shown.file = file();
  shown.episode = document ? document->episode : nullptr;
  run.simulates_document = scene.is_of_document;
  run.scenario = scene.scenario;
  run.runs_scenario = scene.is_scenario;
  shown.is_scene = document && document->kind == DocumentKind::scene;
  run.attached = scene.attached;
  run.playing = moves();
  run.replay = run_.cursor().replay.direction();
  run.loop = run_.cursor().loop;
  run.speed = run_.playback().speed;
  run.peaks = frame() ? run_.peaks().of_sensor(*frame(), selected_sensor) : std::vector<double>{};
  run.sensor_peaks.clear();
  for (std::size_t s = 0; frame() && s < frame()->sensors.size(); ++s) {
    const std::vector<double> peaks = run_.peaks().of_sensor(*frame(), static_cast<int>(s));
    run.sensor_peaks.push_back(peaks.empty() ? 0.0 : *std::max_element(peaks.begin(), peaks.end()));
  }
  run.all_peaks = frame() ? run_.peaks().all() : std::vector<double>{};
  shown.loading = {};
  shown.polishing = {};
  if (loader.polishing()) shown.polishing = {true, loader.fraction()};
  edits().fill(shown.editing, shown.polishing);
  shown.polishing.holds_run = run_.holds_run();
  if (loader.loading()) {
    const std::string file = loader.file().empty() ? "the fingertip" : loader.file();
    shown.loading = {true, file, loader.fraction(), is_real_time_ ? loader.seconds() : 1, true};
  } else if (const std::optional<PendingScene>& pending = run_.pending()) {
    const auto since = std::chrono::steady_clock::now() - pending->requested_at;
    shown.loading = {true, pending->document.name, 0, std::chrono::duration<double>(since).count(), false};
  }
}

}  // namespace taxel::studio
