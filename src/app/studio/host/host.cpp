#include "app/studio/host/host.h"

#include <algorithm>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"

namespace taxel::studio {

Host::Host(ui::App& shown_in, HostParts parts)
    : app(shown_in),
      is_real_time(parts.is_real_time),
      executor(parts.executor),
      jobs(parts.executor),
      document(parts.executor, parts.cache, [this](const SensorModelPtr& model) { jobs.model_built(model); }),
      run(std::move(parts.simulation)),
      handover(document, run),
      files(parts.executor, std::move(parts.kept_in), parts.autosave_every) {}

void Host::report(Severity severity, std::string text, ui::Holds holds) {
  events.emplace_back(HostMessage{severity, std::move(text), holds});
}

bool Host::is_idle() const {
  return !document.loader().busy() && !run.pending() && !handover.is_replacing() && !edits().building() && !jobs.busy();
}

const Scenario& Host::scenario() const {
  return edits().is_open() ? edits().project()->scenario : run.scene().scenario;
}

void drop_scene(Host& host) {
  host.run.drop_scene();
  host.jobs.drop_scene();
}

void polish(Host& host) {
  if (!host.handover.is_replacing()) host.document.polish();
}

void after_edit(Host& host) {
  host.jobs.note_edit();
  // The samples of the loaded layout are not needed any more; those of the edited layout are polished where it is
  // built.
  if (host.document.loader().polishing() && !host.run.pending()) host.document.loader().close();
  if (host.app.viewer->mode == ui::Mode::simulate || host.run.holds_run()) host.handover.request();
}

/// Breakpoints and the limits of the history hold for the next scene as well.
void carry_out(const SimCommand& command, Host& host) {
  const bool is_about_scene = !std::holds_alternative<BreakpointsCommand>(command) &&
                              !std::holds_alternative<StepHistoryLimitsCommand>(command);
  if (is_about_scene && !host.run.frame()) return;
  if (const auto* keyframe = std::get_if<LoadKeyframeCommand>(&command)) {
    host.run.load_keyframe(*keyframe);
  } else {
    host.run.send(command);
  }
}

void fill(Host& host) {
  ui::App& app = host.app;
  const SimFramePtr& frame = host.run.frame();
  const std::optional<LoadedDocument>& document = host.document.opened();
  const RunningScene& scene = host.run.scene();
  const Loader& loader = host.document.loader();
  host.jobs.fill(app);
  ui::DocumentView& shown = app.shown->document;
  ui::RunView& run = app.shown->run;
  run.frame = host.run.frame();
  shown.model = host.document.model();
  shown.name = document ? document->name : "";
  shown.file = host.document.file();
  shown.episode = document ? document->episode : nullptr;
  run.simulates_document = scene.is_of_document;
  run.scenario = scene.scenario;
  run.runs_scenario = scene.is_scenario;
  shown.is_scene = document && document->kind == DocumentKind::scene;
  run.attached = scene.attached;
  run.playing = host.run.moves();
  run.replay = host.run.cursor().replay.direction();
  run.loop = host.run.cursor().loop;
  run.speed = host.run.playback().speed;
  run.peaks = frame ? host.run.peaks().of_sensor(*frame, app.viewer->selection.sensor) : std::vector<double>{};
  run.sensor_peaks.clear();
  for (std::size_t s = 0; frame && s < frame->sensors.size(); ++s) {
    const std::vector<double> peaks = host.run.peaks().of_sensor(*frame, static_cast<int>(s));
    run.sensor_peaks.push_back(peaks.empty() ? 0.0 : *std::max_element(peaks.begin(), peaks.end()));
  }
  run.all_peaks = frame ? host.run.peaks().all() : std::vector<double>{};
  shown.loading = {};
  shown.polishing = {};
  if (loader.polishing()) shown.polishing = {true, loader.fraction()};
  host.edits().fill(shown.editing, shown.polishing);
  shown.polishing.holds_run = host.run.holds_run();
  if (loader.loading()) {
    const std::string file = loader.file().empty() ? "the fingertip" : loader.file();
    shown.loading = {true, file, loader.fraction(), host.is_real_time ? loader.seconds() : 1, true, loader.step()};
  } else if (const std::optional<PendingScene>& pending = host.run.pending()) {
    const auto since = std::chrono::steady_clock::now() - pending->requested_at;
    shown.loading = {true,  pending->document.name, 0, std::chrono::duration<double>(since).count(),
                     false, "Building the scene"};
  }
}

}  // namespace taxel::studio
