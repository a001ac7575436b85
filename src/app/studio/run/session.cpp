#include "app/studio/run/session.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "core/sim/host/inline_sim.h"
#include "core/sim/host/sim_thread.h"

#include "app/studio/app/app.h"

namespace taxel::studio {

namespace {

/// Pictures of a preview in a script, so that it may see it, aim at what it shows, and press and release a button.
constexpr int kPreviewPictures = 4;

/// The same of a load that takes seconds.
constexpr int kLoadPictures = 8;
constexpr std::uintmax_t kLargeFile = 32'000'000;  // bytes

/// Readings of a frame, all sensors one after the other, as trace rows have them.
std::vector<double> all_readings(const SimFrame& frame) {
  std::vector<double> all;
  for (const SensorStep& sensor : frame.sensors) {
    all.insert(all.end(), sensor.readings.begin(), sensor.readings.end());
  }
  return all;
}

bool reads_by(const SimFrame& frame, const SensorModelPtr& model) {
  const auto& sensors = frame.simulated->sensors;
  return std::find(sensors.begin(), sensors.end(), model) != sensors.end();
}

void raise(std::vector<double>& peaks, const std::vector<double>& readings) {
  peaks.resize(std::max(peaks.size(), readings.size()));
  for (std::size_t i = 0; i < readings.size(); ++i) peaks[i] = std::max(peaks[i], readings[i]);
}

}  // namespace

Session::Session(JobPool& pool, bool by_clock, std::function<void()> wake)
    : by_clock_(by_clock),
      loader_(pool, cache_, wake),
      jobs_(pool, wake),
      edits_(pool, cache_, wake, [this](const SensorModelPtr& model) { jobs_.model_built(model); }) {
  if (by_clock) {
    simulation_ = std::make_unique<SimThread>();
  } else {
    simulation_ = std::make_unique<InlineSim>();
  }
}

void Session::open(const std::string& file, const SkinChoice& skin) {
  reloading_ = false;
  recovered_.reset();
  std::error_code missing;
  const std::uintmax_t size = std::filesystem::file_size(file, missing);
  load_pictures_ = 0;
  load_pictures_due_ = !missing && size > kLargeFile ? kLoadPictures : 0;
  loader_.start(file, skin);
}

void Session::reload() {
  if (!document_ || document_->file.empty()) return;
  reloading_ = true;
  loader_.start(document_->file, document_->skin);
}

void Session::close() {
  loader_.close();
  pending_.reset();
  polished_.reset();
  document_.reset();
  edits_.close();
  drop_scene();
}

void Session::drop_scene() {
  tell(PauseCommand{});
  pending_.reset();
  has_scene_ = false;
  frame_.reset();
  explain_request_.reset();
  playing_ = runs_scenario_ = simulates_document_ = still_ = held_ = false;
  attached_.clear();
  replay_.stop();
  loop_.reset();
}

bool Session::run_scenario(const Scenario& scenario) {
  if (!document_ || !document_->model || document_->model->taxel_count() == 0) return false;
  if (!edits_.problem().empty()) {
    refusal_ = document_->name + ": " + edits_.problem();
    return false;
  }
  if (edits_.is_open()) edits_.edit(SetScenario{scenario});
  hand_over_wanted_ = hand_over_wanted_ || document_->previewed();
  const auto place_of = [](const Scenario& s) { return find_number(s, "place") ? *find_number(s, "place") : 0.0; };
  const bool elsewhere =
      !simulates_document_ || scenario.kind() != scenario_.kind() || place_of(scenario) != place_of(scenario_);
  build_scene({.document = *document_, .in_scenario = true, .scenario = scenario, .play = true, .framed = elsewhere});
  return true;
}

void Session::build_scene(Pending pending) {
  pending_ = std::move(pending);
  if (pending_->in_scenario) {
    pending_->load = tell(LoadScenarioCommand{pending_->document.model, pending_->scenario});
  } else {
    pending_->load = tell(LoadSceneCommand{pending_->document.file, pending_->attachments});
  }
}

/// Not by clock: whether the picture to come still shows the preview.
bool Session::preview_is_due() const {
  return loader_.polishing() && preview_pictures_ < kPreviewPictures;
}

SessionNews Session::update(bool hurry) {
  SessionNews news;
  if (!refusal_.empty()) news.messages.emplace_back(Severity::error, std::exchange(refusal_, ""));
  const bool loads = !by_clock_ && !hurry && load_is_shown();
  if (loads) ++load_pictures_;
  const bool keep = loads || (!by_clock_ && !hurry && preview_is_due());
  if (keep && !loads) ++preview_pictures_;
  if (!by_clock_ && !keep) loader_.wait();
  if (!keep || loader_.cancelled()) {
    if (std::optional<LoadResult> result = loader_.take()) accept_result(std::move(*result), news);
  }
  take_edited(news);
  hand_over_newest();
  show_polished(news);
  take_reading(news);
  replay_by_clock();
  accept_replies(simulation_->take(), news);
  start_held_run();
  take_fields(news);
  take_explanation(news);
  take_models(news);
  return news;
}

void Session::accept_result(LoadResult result, SessionNews& news) {
  if (auto* document = std::get_if<Document>(&result)) {
    preview_pictures_ = 1;
    return accept_document(std::move(*document), news);
  }
  if (auto* polished = std::get_if<Polished>(&result)) {
    polished_ = Replacement{std::move(*polished)};
  } else if (const auto* failed = std::get_if<PolishFailed>(&result)) {
    keep_preview(Severity::error, "The samples could not be polished: " + failed->reason, news);
  } else if (std::holds_alternative<PolishCancelled>(result)) {
    keep_preview(Severity::note, "Polishing was cancelled: the preview's samples stay.", news);
  } else if (const auto* refused = std::get_if<LoadFailed>(&result)) {
    news.messages.emplace_back(Severity::error, refused->reason);
    resume_polishing();
  } else {
    news.messages.emplace_back(Severity::note, "Loading was cancelled.");
    resume_polishing();
  }
}

/// Hands polished samples to the simulation, or shows them where none runs.
void Session::show_polished(SessionNews& news) {
  if (!polished_ || polished_->command > 0 || pending_) return;
  if (!simulates_document_ || !frame_ || !reads_by(*frame_, polished_->models.preview)) {
    finish_polished(news);
  } else {
    polished_->command = tell(ReplaceModelCommand{polished_->models.preview, polished_->models.model});
  }
}

void Session::accept_document(Document document, SessionNews& news) {
  if (reloading_ && edits_.is_open() && document.project && document_ && document.file == document_->file)
    return accept_reload(document, news);
  for (const std::string& note : document.notes) {
    const bool only_told = document.kind == DocumentKind::mesh || !document.skin.mesh.empty();
    news.messages.emplace_back(only_told ? Severity::note : Severity::warning, note);
  }
  if (!document.repair.empty()) {
    const std::string name = std::filesystem::path(document.file).filename().string();
    news.messages.emplace_back(Severity::note, name + ": " + document.repair);
  }
  if (!document.problem.empty()) news.messages.emplace_back(Severity::warning, document.file + ": " + document.problem);
  if (document.model && !document.previewed()) {
    for (const std::string& note : notes_of_samples(*document.model))
      news.messages.emplace_back(Severity::warning, note);
  }
  const bool play = !reloading_ || playing();
  const bool framed = !reloading_;
  const bool layout_with_taxels = document.model && document.model->taxel_count() > 0 && !document.frame;
  // What one saves, one goes on with; what cannot be simulated can be looked at.
  const bool to_edit = document.kind == DocumentKind::project || !document.problem.empty();
  if (document.kind == DocumentKind::scene || (layout_with_taxels && !to_edit)) {
    const bool in_scenario = layout_with_taxels;
    const Scenario scenario = in_scenario ? scenario_ : Scenario{};
    const bool again = reloading_ && document_ && document.file == document_->file;
    build_scene({.document = std::move(document),
                 .in_scenario = in_scenario,
                 .scenario = scenario,
                 .attachments = again ? attached_ : std::vector<SceneAttachment>{},
                 .play = play,
                 .framed = framed,
                 .another = !again});
    return;
  }
  drop_scene();
  news.doubtful_mesh = document.kind == DocumentKind::mesh || !document.problem.empty();
  show_document(std::move(document));
  if (document_->frame) show_saved_step();
  news.another_document = true;
  news.opened = still_ ? ui::Mode::simulate : ui::Mode::layout;
  news.opened_file = document_->file;
  news.saved_state = document_->state;
  news.framed = framed;
}

void Session::accept_replies(SimReplies replies, SessionNews& news) {
  for (SimEvent& event : replies.events) {
    executed_ = std::max(executed_, event.reply_to);
    accept_event(std::move(event), *replies.frame, news);
  }
  if (!replies.frame || !has_scene_) return;
  if (!replies.frame->recorded) note_pressures(*replies.frame);
  frame_ = std::move(replies.frame);
  news.new_frame = true;
}

/// `frame` includes the effect of the event.
void Session::accept_event(SimEvent event, const SimFrame& frame, SessionNews& news) {
  const bool loads = pending_ && event.reply_to == pending_->load;
  const bool replaces = polished_ && polished_->command > 0 && event.reply_to == polished_->command;
  if (std::holds_alternative<SceneLoaded>(event.what)) {
    if (loads) accept_pending(frame, news);
  } else if (std::holds_alternative<ModelReplaced>(event.what)) {
    if (replaces) finish_polished(news);
  } else if (const auto* refused = std::get_if<Refused>(&event.what)) {
    accept_refusal(event.reply_to, refused->why, news);
  } else if (std::holds_alternative<Done>(event.what)) {
    if (replaces) left_preview_ = std::exchange(polished_, std::nullopt)->models.preview;
  } else if (const auto* saved = std::get_if<SceneSaved>(&event.what)) {
    tell_saved(*saved, news);
  } else if (const auto* written = std::get_if<RecordingWritten>(&event.what)) {
    tell_written(*written, news);
  } else if (auto* recalled = std::get_if<StepsRecalled>(&event.what)) {
    jobs_.models.accept(std::move(*recalled));
  } else if (const auto* stopped = std::get_if<Stopped>(&event.what)) {
    note_stop();
    if (has_scene_) tell_stop(*stopped, frame.breakpoints, news);
  } else if (std::holds_alternative<Finished>(event.what)) {
    note_stop();
  } else if (const auto* failed = std::get_if<Failed>(&event.what)) {
    note_stop();
    news.messages.emplace_back(Severity::error, failed->why);
  } else if (const auto* warned = std::get_if<Warned>(&event.what)) {
    if (has_scene_) news.messages.emplace_back(Severity::warning, warned->text);
  }
}

void Session::accept_refusal(CommandId command, const std::string& why, SessionNews& news) {
  news.messages.emplace_back(Severity::error, why);
  if (pending_ && command == pending_->load) {
    refuse_pending();
  } else if (polished_ && command == polished_->command) {
    left_preview_ = std::exchange(polished_, std::nullopt)->models.preview;
  }
}

/// What was to be opened could not be simulated: what is open stays, and so does the work on its samples.
void Session::refuse_pending() {
  const bool another = pending_->another;
  pending_.reset();
  if (!another) return;
  if (loader_.polishing()) loader_.close();
  resume_polishing();
}

void Session::accept_pending(const SimFrame& frame, SessionNews& news) {
  Pending pending = std::move(*pending_);
  pending_.reset();
  attached_ = std::move(pending.attachments);
  if (pending.another) show_document(std::move(pending.document));
  take_sensors(frame);
  runs_scenario_ = pending.in_scenario;
  scenario_ = pending.in_scenario ? pending.scenario : scenario_;
  simulates_document_ = has_scene_ = true;
  still_ = false;
  replay_.stop();
  loop_.reset();
  news.another_document = pending.another;
  if (pending.shown) news.opened = ui::Mode::simulate;
  news.opened_file = document_->file;
  news.framed = pending.framed;
  playing_ = pending.play;
  held_ = true;  // until the end of update(), or longer
  held_steps_ = 0;
}

void Session::note_pressures(const SimFrame& frame) {
  const Trace& trace = *frame.trace;
  if (std::exchange(noted_trace_, trace.edition) != trace.edition) {
    peaks_.clear();
    rows_seen_ = 0;
    largest_pressure_ = 0;
  }
  for (; rows_seen_ < trace.rows.size(); ++rows_seen_) raise(peaks_, trace.rows[rows_seen_].readings);
  raise(peaks_, all_readings(frame));
  for (const SensorStep& sensor : frame.sensors) {
    for (const ContactSurface& surface : sensor.surfaces) {
      largest_pressure_ = std::max(largest_pressure_, surface.max_pressure());
    }
  }
}

void Session::fill(ui::App& app, int selected_sensor) const {
  app.shown.run.frame = frame_;
  app.shown.document.model = document_ ? document_->model : nullptr;
  app.shown.document.probe = pressed_;
  app.shown.document.measured = measured_;
  app.shown.document.fields = shown_fields_;
  app.simulate.explain.explained = explained_;
  app.simulate.models.compared = compared_;
  app.simulate.study.shown = {jobs_.study.newest(), jobs_.study.busy(), jobs_.study.fraction()};
  app.shown.document.name = document_ ? document_->name : "";
  app.shown.document.file = document_ ? document_->file : "";
  app.shown.run.simulates_document = simulates_document_;
  app.shown.run.scenario = scenario_;
  app.shown.run.runs_scenario = runs_scenario_;
  app.shown.document.is_scene = document_ && document_->kind == DocumentKind::scene;
  app.shown.run.attached = attached_;
  app.shown.run.playing = moves();
  app.shown.run.replay = replay_.direction();
  app.shown.run.loop = loop_;
  app.shown.run.speed = speed_;
  app.shown.run.peaks.clear();
  if (frame_ && selected_sensor >= 0 && selected_sensor < static_cast<int>(frame_->sensors.size())) {
    std::size_t first = 0;
    const auto selected = static_cast<std::size_t>(selected_sensor);
    for (std::size_t s = 0; s < selected; ++s) first += frame_->sensors[s].readings.size();
    const std::size_t last = std::min(peaks_.size(), first + frame_->sensors[selected].readings.size());
    for (std::size_t i = first; i < last; ++i) app.shown.run.peaks.push_back(peaks_[i]);
  }
  app.shown.document.loading = {};
  app.shown.document.polishing = {};
  if (loader_.polishing()) {
    app.shown.document.polishing = {true, by_clock_ ? loader_.fraction() : 0};
  }
  edits_.fill(app.shown.document.editing, app.shown.document.polishing, by_clock_);
  app.shown.document.polishing.holds_run = holds_run();
  if (loader_.loading()) {
    const std::string what = loader_.file().empty() ? "the fingertip" : loader_.file();
    const bool timed = by_clock_;  // pictures that follow a script are the same every time
    app.shown.document.loading = {true, what, timed ? loader_.fraction() : 0, timed ? loader_.seconds() : 1, true};
  } else if (pending_) {
    const auto since = std::chrono::steady_clock::now() - pending_->asked;
    app.shown.document.loading = {true, pending_->document.name, 0, std::chrono::duration<double>(since).count(),
                                  false};
  }
}

}  // namespace taxel::studio
