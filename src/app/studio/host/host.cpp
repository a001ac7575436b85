// Results of the jobs and replies of the simulation, as the host accepts them.

#include "app/studio/host/host.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "core/base/math.h"
#include "core/run/event.h"
#include "ui/widgets/format.h"

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
  return !document.loader.busy() && !run.pending && files.scene_to_save.empty() && !handover.is_replacing() &&
         !edits().models().busy() && !jobs.busy();
}

const Scenario& Host::scenario() const {
  return edits().is_open() ? edits().project()->scenario : run.scene.scenario;
}

void drop_scene(Host& host) {
  drop_scene(host.run);
  host.jobs.drop_scene();
}

void polish(Host& host) {
  if (!host.handover.is_replacing()) host.document.polish();
}

void after_edit(Host& host) {
  host.jobs.note_edit();
  // The samples of the loaded layout are not needed any more; those of the edited layout are polished where it is
  // built.
  if (host.document.loader.polishing() && !host.run.pending) host.document.loader.close();
  if (ui::shows_run(host.app.viewer->mode) || host.run.playback.holds_run()) host.handover.request();
}

/// Breakpoints and the limits of the history hold for the next scene as well.
void carry_out(const SimCommand& command, Host& host) {
  const bool is_about_scene = !std::holds_alternative<BreakpointsCommand>(command) &&
                              !std::holds_alternative<StepHistoryLimitsCommand>(command);
  if (is_about_scene && !host.run.frame) return;
  if (const auto* keyframe = std::get_if<LoadKeyframeCommand>(&command)) {
    load_keyframe(host.run, *keyframe);
  } else {
    host.run.simulation->send(command);
  }
}

void fill(Host& host) {
  ui::App& app = host.app;
  const SimFramePtr& frame = host.run.frame;
  const std::optional<LoadedDocument>& document = host.document.opened();
  const RunningScene& scene = host.run.scene;
  const Loader& loader = host.document.loader;
  host.jobs.fill(app);
  ui::DocumentView& shown = app.shown->document;
  ui::RunView& run = app.shown->run;
  run.frame = host.run.frame;
  shown.model = host.document.model();
  shown.name = document ? document->name : "";
  shown.file = host.document.file();
  run.simulates_document = scene.is_of_document;
  run.scenario = scene.scenario;
  run.runs_scenario = scene.is_scenario;
  shown.is_scene = document && document->kind == DocumentKind::scene;
  shown.scene_layout = host.document.scene_layout;
  run.attached = scene.attached;
  run.playing = host.run.moves();
  run.replay = host.run.cursor.replay.direction();
  run.loop = host.run.cursor.loop;
  run.speed = host.run.playback.speed;
  run.peaks = frame ? host.run.peaks.of_sensor(*frame, app.viewer->selection.sensor) : std::vector<double>{};
  run.sensor_peaks.clear();
  for (std::size_t s = 0; frame && s < frame->sensors.size(); ++s) {
    const std::vector<double> peaks = host.run.peaks.of_sensor(*frame, static_cast<int>(s));
    run.sensor_peaks.push_back(peaks.empty() ? 0.0 : *std::max_element(peaks.begin(), peaks.end()));
  }
  run.all_peaks = frame ? host.run.peaks.all() : std::vector<double>{};
  shown.loading = {};
  shown.polishing = {};
  if (loader.polishing()) shown.polishing = {true, loader.fraction()};
  host.edits().fill(shown.editing, shown.polishing);
  // In LAYOUT the view shows the whole scene until one of its layouts is edited.
  if (shown.is_scene && !shown.editing.project && app.viewer->mode == ui::Mode::layout) shown.model = nullptr;
  if (shown.scene_layout) {
    const std::string& name = shown.editing.project->layout.name;
    shown.name = fmt::format("{} in {}", name.empty() ? shown.scene_layout->geoms.front() : name, document->name);
  }
  shown.polishing.holds_run = host.run.playback.holds_run();
  if (loader.loading()) {
    const std::string file = loader.file().empty() ? "the fingertip" : loader.file();
    shown.loading = {true, file, loader.fraction(), host.is_real_time ? loader.seconds() : 1, true, loader.step()};
  } else if (const std::optional<PendingScene>& pending = host.run.pending) {
    const auto since = std::chrono::steady_clock::now() - pending->requested_at;
    shown.loading = {true,  pending->document.name, 0, std::chrono::duration<double>(since).count(),
                     false, "Building the scene"};
  }
}

namespace {

std::string taxel_text(const Taxel& taxel) {
  return fmt::format("taxel {}{}", taxel.id, taxel.name.empty() ? "" : " (" + taxel.name + ")");
}

std::string text_of(const Jump& jump, const Taxel& taxel, const ui::ReadingUnit& unit, const char* whose) {
  const double force = jump.force_before > 0 ? 100 * (jump.force_after / jump.force_before - 1) : 0.0;
  constexpr int kForceDigits = 4;
  const NumberPair readings = ui::pair_in_unit(jump.before, jump.after, unit);
  const NumberPair forces = number_pair(jump.force_before, jump.force_after, kForceDigits);
  return fmt::format(
      "{} jumped from {} to {}, {:.1f} % of {} largest reading, while the force {} {} to {} N ({:+.2f} %)",
      taxel_text(taxel), readings.first, readings.second, 100 * jump.part, whose,
      jump.at_equal_force ? "stayed," : "went from", forces.first, forces.second, force);
}

std::string text_of(const Disagreement& gap, const Taxel& taxel, const ui::ReadingUnit& unit, const char* whose) {
  const NumberPair readings = ui::pair_in_unit(gap.sampled, gap.exact, unit);
  return fmt::format("{} reads {} by its samples and {} by the surface, {:.1f} % of {} largest reading apart",
                     taxel_text(taxel), readings.first, readings.second, 100 * gap.part, whose);
}

/// Returns a sentence with the step, the taxel and the compared values. `of_sensor` as in Breakpoints.
std::string stop_text(const Stopped& stopped, bool of_sensor) {
  return std::visit(
      [&](const auto& stop) {
        const Layout& layout = stopped.scene->sensors[at(stop.sensor)]->layout;
        const std::string text = text_of(stop, layout.taxels[at(stop.taxel)], ui::shown_unit(layout.readout.aggregate),
                                         of_sensor ? "the sensor's" : "its");
        return fmt::format("Paused at step {}, {:.6g} s: {}", stop.step, stop.time, text);
      },
      stopped.stop);
}

SendToSimulation sender(Host& host) {
  return [&host](SimCommand command) { host.run.simulation->send(std::move(command)); };
}

/// Another document was to be loaded while the samples of this one were polished, and was refused.
void resume_polishing(Host& host) {
  if (!host.handover.is_replacing()) host.document.resume_polishing();
}

void report_notes(Host& host, const LoadedDocument& document) {
  for (const std::string& note : document.notes) {
    const bool is_remark = document.kind == DocumentKind::mesh || !document.skin.mesh.empty();
    host.report(is_remark ? Severity::note : Severity::warning, note);
  }
  // What reading changed in a good file, such as welded vertices, is only listed: nothing is to be done about it.
  for (const std::string& remark : document.remarks)
    host.events.emplace_back(HostMessage{Severity::note, remark, ui::Holds::always, false});
  if (!document.repair.empty()) {
    const std::string name = std::filesystem::path(document.file).filename().string();
    host.report(Severity::note, name + ": " + document.repair);
  }
  if (!document.problem.empty())
    host.report(Severity::warning, document.file + ": " + document.problem, ui::Holds::while_unrunnable);
  if (document.model && !document.previewed()) report_sample_notes(*document.model, host.events);
}

void show_document(Host& host, LoadedDocument document) {
  host.handover.forget_request();
  const bool is_project = document.kind == DocumentKind::project;
  host.document.show(std::move(document), host.run.scene.scenario);
  if (is_project && host.document.opened()->project)
    host.run.scene.scenario = host.document.opened()->project->scenario;
}

void retain_preview(Host& host, Severity severity, const std::string& why) {
  SensorModelPtr preview = host.run.pending ? host.run.pending->document.model : host.document.model();
  host.document.retain_preview(std::move(preview), severity, why, host.events);
}

/// Lets the scene, which is read again, read its layouts from their files, except a layout with unsaved edits.
void forget_unchanged_layouts(Host& host) {
  if (host.document.scene_layout && !host.edits().dirty()) leave_layout_of_scene(host.document);
  std::error_code ignored;
  const std::optional<ui::SceneLayout>& edited = host.document.scene_layout;
  const auto is_edited_on = [&](const std::string& geom) {
    return edited && std::find(edited->geoms.begin(), edited->geoms.end(), geom) != edited->geoms.end();
  };
  std::erase_if(host.run.scene.attached,
                [&](const SceneAttachment& one) { return one.is_declared && !is_edited_on(one.geom); });
  for (SceneAttachment& one : host.run.scene.attached) {
    if (!is_edited_on(one.geom) && std::filesystem::exists(one.layout, ignored)) one.model = nullptr;
  }
}

/// Returns the scenario of a document that opens: its own, or the one that ran last, unless that was an example's own.
Scenario scenario_of(const Host& host, const LoadedDocument& document) {
  if (document.scenario) return *document.scenario;
  const std::optional<LoadedDocument>& open = host.document.opened();
  const bool is_of_example = open && open->scenario == host.run.scene.scenario;
  return is_of_example && !host.document.is_reloading() ? Scenario{} : host.run.scene.scenario;
}

void accept_document(Host& host, LoadedDocument document) {
  if (host.document.is_reload_of_edited(document)) return host.document.accept_reload(document, host.events);
  report_notes(host, document);
  const bool is_reload = host.document.is_reloading();
  const bool has_taxels = document.model && document.model->taxel_count() > 0 && !document.frame;
  // A project is opened for editing, and a layout that cannot be simulated to look at it.
  const bool is_to_edit = document.kind == DocumentKind::project || !document.problem.empty();
  if (document.kind == DocumentKind::scene || (has_taxels && !is_to_edit)) {
    const bool is_same = is_reload && host.document.opened() && document.file == host.document.file();
    Scenario scenario;
    if (has_taxels) scenario = scenario_of(host, document);
    if (is_same) forget_unchanged_layouts(host);
    LeadRequest lead = is_same ? host.run.scene.lead : std::exchange(host.next_lead, {});
    build_scene(host.run, {.document = std::move(document),
                           .is_scenario = has_taxels,
                           .scenario = std::move(scenario),
                           .attachments = is_same ? host.run.scene.attached : std::vector<SceneAttachment>{},
                           .lead = std::move(lead),
                           .plays = !is_reload || host.run.playback.goes_on(),
                           .turns_cameras = !is_reload,
                           .another_document = !is_same});
    return;
  }
  drop_scene(host);
  const bool is_doubtful = document.kind == DocumentKind::mesh || !document.problem.empty();
  show_document(host, std::move(document));
  const LoadedDocument& shown = *host.document.opened();
  if (shown.frame) show_saved_step(host.run, shown.frame);
  host.events.emplace_back(Opened{host.run.scene.is_still ? ui::Mode::simulate : ui::Mode::layout, true, !is_reload,
                                  is_doubtful, shown.file, shown.state});
}

void accept_result(Host& host, LoadResult result) {
  if (auto* document = std::get_if<LoadedDocument>(&result)) {
    accept_document(host, std::move(*document));
  } else if (auto* polished = std::get_if<Polished>(&result)) {
    host.handover.begin(std::move(*polished));
  } else if (const auto* failed = std::get_if<PolishFailed>(&result)) {
    retain_preview(host, Severity::error, "The samples could not be polished: " + failed->reason);
  } else if (std::holds_alternative<PolishCancelled>(result)) {
    retain_preview(host, Severity::note, "Polishing was cancelled: the preview's samples stay.");
  } else if (const auto* refused = std::get_if<LoadFailed>(&result)) {
    const bool is_about_mesh = !refused->layout.empty();
    host.report(Severity::error, refused->reason, is_about_mesh ? ui::Holds::while_mesh_missing : ui::Holds::always);
    if (is_about_mesh) host.events.emplace_back(MeshMissing{refused->layout, refused->mesh});
    resume_polishing(host);
  } else {
    host.report(Severity::note, "Loading was cancelled.");
    resume_polishing(host);
  }
}

void accept_scene(Host& host, const SimFrame& frame) {
  PendingScene loaded = accept_pending(host.run);
  if (loaded.another_document) show_document(host, std::move(loaded.document));
  if (const std::optional<ui::SceneLayout>& edited = host.document.scene_layout) {
    const int sensor = ui::sensor_on(*frame.scene, edited->geoms.front());
    if (sensor >= 0) host.app.viewer->selection.sensor = sensor;
  } else if (host.document.kind() == DocumentKind::scene) {  // the simulation compiles the sensors of a scene
    const std::vector<SensorModelPtr>& sensors = frame.scene->sensors;
    host.document.set_model(sensors.empty() ? nullptr : sensors.front());
  }
  if (!loaded.is_shown) return;
  const LoadedDocument& shown = *host.document.opened();
  host.events.emplace_back(
      Opened{ui::Mode::simulate, loaded.another_document, loaded.turns_cameras, false, shown.file, ""});
}

/// The open document stays, and its samples are polished.
void refuse_scene(Host& host) {
  const bool another_document = host.run.pending->another_document;
  host.run.pending.reset();
  if (!another_document) return;
  if (host.document.loader.polishing()) host.document.loader.close();
  resume_polishing(host);
}

void report_saved_scene(Host& host, const SceneSaved& saved) {
  if (!saved.error.empty()) return host.report(Severity::error, saved.error);
  const std::string note = saved.note.empty() ? "" : " as " + saved.note;
  host.report(note.empty() ? Severity::note : Severity::warning, "Saved " + saved.file + note);
  if (saved.file == host.document.file()) {  // its layout is a file now
    host.files.watch.accept(saved.file);
    return host.document.reload();
  }
  const std::optional<ui::SceneLayout>& edited = host.document.scene_layout;
  if (edited && host.edits().dirty())
    host.report(Severity::note, fmt::format("{} has the edited layout. The open scene has its layout of before until "
                                            "Ctrl+S saves it.",
                                            std::filesystem::path(saved.file).filename().string()));
}

void report_recording(Host& host, const RecordingWritten& written) {
  const std::string note = written.note.empty() ? "" : ": " + written.note;
  if (written.error.empty()) {
    const std::string file = std::filesystem::absolute(written.file).string();
    host.report(note.empty() ? Severity::note : Severity::warning,
                fmt::format("Recorded {} steps in {}{}", written.rows, file, note));
  } else {
    host.report(Severity::error, written.error + note);
    if (written.kept) host.events.emplace_back(RecordingUnwritten{written.error});
  }
}

/// `frame` includes the effect of the event.
void accept_event(Host& host, SimEvent event, const SimFrame& frame) {
  const bool is_of_pending = host.run.pending && event.reply_to == host.run.pending->command;
  if (std::holds_alternative<SceneLoaded>(event.what)) {
    if (is_of_pending) accept_scene(host, frame);
  } else if (const auto* refused = std::get_if<Refused>(&event.what)) {
    host.report(Severity::error, refused->why);
    if (is_of_pending) refuse_scene(host);
  } else if (const auto* saved = std::get_if<SceneSaved>(&event.what)) {
    report_saved_scene(host, *saved);
  } else if (const auto* written = std::get_if<RecordingWritten>(&event.what)) {
    report_recording(host, *written);
  } else if (auto* recalled = std::get_if<StepsRecalled>(&event.what)) {
    host.jobs.accept(*recalled);
  } else if (const auto* failed = std::get_if<Failed>(&event.what)) {
    host.report(Severity::error, failed->why);
  } else if (!host.run.scene.is_loaded) {
    return;  // the scene is not displayed any more
  } else if (const auto* stopped = std::get_if<Stopped>(&event.what)) {
    host.report(Severity::warning, stop_text(*stopped, frame.breakpoints.of_sensor), ui::Holds::while_paused);
  } else if (const auto* warned = std::get_if<Warned>(&event.what)) {
    host.report(Severity::warning, warned->text, ui::Holds::for_document);
  }
}

void accept_replies(Host& host) {
  SimReplies replies = host.run.simulation->take();
  for (SimEvent& event : replies.events) {
    accept_reply(host.run, event);
    host.handover.accept(event, host.events);
    accept_event(host, std::move(event), *replies.frame);
  }
  if (accept_frame(host.run, std::move(replies.frame))) host.events.emplace_back(FrameArrived{});
}

void update_results(Host& host) {
  const bool plays = host.run.frame && host.run.frame->playing;
  const bool runs =
      host.run.frame && (host.is_real_time ? plays : host.run.playback.plays && !host.run.frame->finished);
  const FollowedRun run{.frame = host.run.frame, .runs = runs, .keeps_explanation = host.is_real_time && plays};
  if (host.jobs.take_about_run(host.document.model(), run, sender(host))) host.events.emplace_back(ResultArrived{});
}

}  // namespace

HostEvents update(Host& host, bool without_delay) {
  host.executor.begin_frame(without_delay);
  host.executor.run_posted();
  if (std::optional<LoadResult> result = host.document.loader.take()) accept_result(host, std::move(*result));
  host.executor.run_posted();
  host.document.accept_built(host.events);
  host.handover.update(host.events);
  if (host.jobs.take_about_layout(host.document.model(), host.edits().compiled()))
    host.events.emplace_back(ResultArrived{});
  accept_replies(host);
  if (!host.handover.will_change_samples()) release_hold(host.run);
  update_results(host);
  host.jobs.report(host.events);
  return std::exchange(host.events, {});
}

void request_about_run(Host& host) {
  host.jobs.request_about_run(host.app, host.document.model(), sender(host));
}

}  // namespace taxel::studio
