// Results of the jobs and replies of the simulation, as the session accepts them.
#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "app/studio/host/run/stop_text.h"
#include "app/studio/host/session.h"

namespace taxel::studio {

SessionEvents Session::update(bool without_delay) {
  executor_.begin_frame(without_delay);
  executor_.run_posted();
  if (std::optional<LoadResult> result = document_.loader().take()) accept_result(std::move(*result));
  executor_.run_posted();
  document_.accept_built(events_);
  handover_.update(events_);
  if (jobs_.take_about_layout(document_.model(), edits().compiled())) events_.emplace_back(ResultArrived{});
  accept_replies();
  if (!handover_.will_change_samples()) run_.release_hold();
  update_results();
  jobs_.report(events_);
  return std::exchange(events_, {});
}

void Session::update_results() {
  const bool plays = frame() && frame()->playing;
  const bool runs = frame() && (is_real_time_ ? plays : playing() && !frame()->finished);
  const FollowedRun run{.frame = frame(), .runs = runs, .keeps_explanation = is_real_time_ && plays};
  if (jobs_.take_about_run(document_.model(), run, sender())) events_.emplace_back(ResultArrived{});
}

void Session::accept_result(LoadResult result) {
  if (auto* document = std::get_if<LoadedDocument>(&result)) {
    accept_document(std::move(*document));
  } else if (auto* polished = std::get_if<Polished>(&result)) {
    handover_.begin(std::move(*polished));
  } else if (const auto* failed = std::get_if<PolishFailed>(&result)) {
    retain_preview(Severity::error, "The samples could not be polished: " + failed->reason);
  } else if (std::holds_alternative<PolishCancelled>(result)) {
    retain_preview(Severity::note, "Polishing was cancelled: the preview's samples stay.");
  } else if (const auto* refused = std::get_if<LoadFailed>(&result)) {
    report(Severity::error, refused->reason);
    resume_polishing();
  } else {
    report(Severity::note, "Loading was cancelled.");
    resume_polishing();
  }
}

void Session::retain_preview(Severity severity, const std::string& why) {
  SensorModelPtr preview = run_.pending() ? run_.pending()->document.model : document_.model();
  document_.retain_preview(std::move(preview), severity, why, events_);
}

void Session::report_notes(const LoadedDocument& document) {
  for (const std::string& note : document.notes) {
    const bool is_remark = document.kind == DocumentKind::mesh || !document.skin.mesh.empty();
    report(is_remark ? Severity::note : Severity::warning, note);
  }
  // What reading changed in a good file, such as welded vertices, is only listed: nothing is to be done about it.
  for (const std::string& remark : document.remarks)
    events_.emplace_back(SessionMessage{Severity::note, remark, ui::Holds::always, false});
  if (!document.repair.empty()) {
    const std::string name = std::filesystem::path(document.file).filename().string();
    report(Severity::note, name + ": " + document.repair);
  }
  if (!document.problem.empty())
    report(Severity::warning, document.file + ": " + document.problem, ui::Holds::while_unrunnable);
  if (document.model && !document.previewed()) report_sample_notes(*document.model, events_);
}

void Session::accept_document(LoadedDocument document) {
  if (document_.is_reload_of_edited(document)) return document_.accept_reload(document, events_);
  report_notes(document);
  const bool is_reload = document_.is_reloading();
  const bool has_taxels = document.model && document.model->taxel_count() > 0 && !document.frame;
  // A project is opened for editing, and a layout that cannot be simulated to look at it.
  const bool is_to_edit = document.kind == DocumentKind::project || !document.problem.empty();
  if (document.kind == DocumentKind::scene || (has_taxels && !is_to_edit)) {
    const bool is_same = is_reload && document_.opened() && document.file == file();
    Scenario scenario;
    if (has_taxels) scenario = document.episode ? document.episode->scenario : run_.scene().scenario;
    LeadRequest lead = is_same ? run_.scene().lead : std::exchange(first_lead_, {});
    run_.build({.document = std::move(document),
                .is_scenario = has_taxels,
                .scenario = std::move(scenario),
                .attachments = is_same ? run_.scene().attached : std::vector<SceneAttachment>{},
                .lead = std::move(lead),
                .plays = !is_reload || playing(),
                .turns_cameras = !is_reload,
                .another_document = !is_same});
    return;
  }
  drop_scene();
  const bool is_doubtful = document.kind == DocumentKind::mesh || !document.problem.empty();
  show_document(std::move(document));
  const LoadedDocument& shown = *document_.opened();
  if (shown.frame) run_.show_saved_step(shown.frame);
  events_.emplace_back(Opened{run_.scene().is_still ? ui::Mode::simulate : ui::Mode::layout, true, !is_reload,
                              is_doubtful, shown.file, shown.state});
}

void Session::show_document(LoadedDocument document) {
  handover_.forget_request();
  const bool is_project = document.kind == DocumentKind::project;
  document_.show(std::move(document), run_.scene().scenario);
  if (is_project && document_.opened()->project) run_.set_scenario(document_.opened()->project->scenario);
}

void Session::accept_replies() {
  SimReplies replies = run_.take();
  for (SimEvent& event : replies.events) {
    run_.accept(event);
    handover_.accept(event, events_);
    accept_event(std::move(event), *replies.frame);
  }
  if (run_.accept_frame(std::move(replies.frame))) events_.emplace_back(FrameArrived{});
}

/// `frame` includes the effect of the event.
void Session::accept_event(SimEvent event, const SimFrame& frame) {
  const bool is_of_pending = run_.pending() && event.reply_to == run_.pending()->command;
  if (std::holds_alternative<SceneLoaded>(event.what)) {
    if (is_of_pending) accept_scene(frame);
  } else if (const auto* refused = std::get_if<Refused>(&event.what)) {
    report(Severity::error, refused->why);
    if (is_of_pending) refuse_scene();
  } else if (const auto* saved = std::get_if<SceneSaved>(&event.what)) {
    report_saved_scene(*saved);
  } else if (const auto* written = std::get_if<RecordingWritten>(&event.what)) {
    report_recording(*written);
  } else if (auto* recalled = std::get_if<StepsRecalled>(&event.what)) {
    jobs_.accept(*recalled);
  } else if (const auto* failed = std::get_if<Failed>(&event.what)) {
    report(Severity::error, failed->why);
  } else if (!run_.scene().is_loaded) {
    return;  // the scene is not displayed any more
  } else if (const auto* stopped = std::get_if<Stopped>(&event.what)) {
    report(Severity::warning, stop_text(*stopped, frame.breakpoints.of_sensor), ui::Holds::while_paused);
  } else if (const auto* warned = std::get_if<Warned>(&event.what)) {
    report(Severity::warning, warned->text, ui::Holds::for_document);
  }
}

void Session::accept_scene(const SimFrame& frame) {
  PendingScene loaded = run_.accept_pending();
  if (loaded.another_document) show_document(std::move(loaded.document));
  if (kind() == DocumentKind::scene) {  // the sensors of a scene are compiled by the simulation
    const std::vector<SensorModelPtr>& sensors = frame.scene->sensors;
    document_.set_model(sensors.empty() ? nullptr : sensors.front());
  }
  if (!loaded.is_shown) return;
  const LoadedDocument& shown = *document_.opened();
  events_.emplace_back(
      Opened{ui::Mode::simulate, loaded.another_document, loaded.turns_cameras, false, shown.file, ""});
}

/// The open document stays, and its samples are polished.
void Session::refuse_scene() {
  const bool another_document = run_.pending()->another_document;
  run_.refuse_pending();
  if (!another_document) return;
  if (document_.loader().polishing()) document_.loader().close();
  resume_polishing();
}

void Session::report_saved_scene(const SceneSaved& saved) {
  saved.error.empty() ? report(Severity::note, "Saved " + saved.file) : report(Severity::error, saved.error);
}

void Session::report_recording(const RecordingWritten& written) {
  const std::string note = written.note.empty() ? "" : ": " + written.note;
  if (written.error.empty()) {
    const std::string file = std::filesystem::absolute(written.file).string();
    report(note.empty() ? Severity::note : Severity::warning,
           fmt::format("Recorded {} steps in {}{}", written.rows, file, note));
  } else {
    report(Severity::error, written.error + note);
    if (written.kept) events_.emplace_back(RecordingUnwritten{written.error});
  }
}

}  // namespace taxel::studio
