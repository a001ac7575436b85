#include "app/studio/shell/studio.h"

#include <fmt/format.h>
#include <imgui_impl_opengl3.h>
#include <imgui_internal.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/studio/nouns/demo/demo_state.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/export.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/files/files_state.h"
#include "app/studio/nouns/files/watched_files.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/menus/window_commands.h"
#include "app/studio/nouns/mesh/mesh_state.h"
#include "app/studio/nouns/messages/messages.h"
#include "app/studio/nouns/perturb/perturb_state.h"
#include "app/studio/nouns/present/present.h"
#include "app/studio/nouns/profiler/profiler_state.h"
#include "app/studio/nouns/real/real_commands.h"
#include "app/studio/nouns/real/real_state.h"
#include "app/studio/nouns/scenario/scenario_state.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "app/studio/nouns/scene/scene_layouts.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "app/studio/nouns/video/video_commands.h"
#include "app/studio/nouns/video/video_state.h"
#include "app/studio/nouns/view/view_state.h"
#include "app/studio/shell/interface/dock_layout.h"
#include "app/studio/shell/interface/interface.h"
#include "app/studio/shell/state/settings.h"
#include "app/version/version.h"
#include "core/base/files.h"
#include "core/base/os/process.h"
#include "core/document/scenario/scenario.h"
#include "core/mesh/mesh_io.h"
#include "ui/theme.h"
#include "ui/widgets/format.h"

namespace taxel::studio {

namespace {

using Clock = std::chrono::steady_clock;

std::atomic<int> recorded_signal{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may only use atomics without a lock");

extern "C" void record_end_signal(int number) {
  int none = 0;
  recorded_signal.compare_exchange_strong(none, number);
}

/// Longest waits for input [s]: while the simulation runs, while something is awaited, and while nothing happens.
constexpr double kBusyWait = 0.004, kAlertWait = 0.05, kQuietWait = 0.25;

double seconds_between(Clock::time_point a, Clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

/// Returns the hash of the open document's file. A worker has computed that of a mesh, which may be large.
std::string hash_of_document(const Host& host) {
  const OpenMeshPtr mesh = host.document.kind() == DocumentKind::mesh ? host.edits().mesh() : nullptr;
  const auto same = [](const std::string& a, const std::string& b) {
    return std::filesystem::absolute(a).lexically_normal() == std::filesystem::absolute(b).lexically_normal();
  };
  if (mesh && same(host.edits().project()->layout.mesh.file, host.document.file())) return mesh->loaded.sha256;
  return hash_of(host.document.file());
}

bool is_doubtful(const OpenMeshPtr& mesh) {
  return mesh && std::any_of(mesh->findings.begin(), mesh->findings.end(),
                             [](const MeshFinding& finding) { return finding.severity != Severity::note; });
}

/// Returns a reader of the shaders of a folder, or of the built-in shaders if `folder` is empty.
gl::ShaderReader shader_reader(const std::string& folder) {
  if (folder.empty()) return gl::read_embedded_shader;
  return [folder](const std::string& name) { return read_file(std::filesystem::path(folder) / name); };
}

/// Number of frames to draw after an event.
int pictures_after(const HostEvent& event) {
  if (std::holds_alternative<HostMessage>(event) || std::holds_alternative<Opened>(event) ||
      std::holds_alternative<ModelBuilt>(event))
    return FramePacing::kSettlingFrames;
  return 1;
}

/// The newest event of a kind, or null.
template <class Event>
const Event* newest(const HostEvents& events) {
  for (auto event = events.rbegin(); event != events.rend(); ++event)
    if (const auto* found = std::get_if<Event>(&*event)) return found;
  return nullptr;
}

/// Returns the last file that was dropped, or both files if they are a layout and its mesh.
ui::OpenFile dropped_file(const std::vector<std::string>& paths) {
  const auto layout =
      std::find_if(paths.begin(), paths.end(), [](const std::string& path) { return needs_mesh(path); });
  const auto mesh =
      std::find_if(paths.begin(), paths.end(), [](const std::string& path) { return is_mesh_file(path); });
  if (layout != paths.end() && mesh != paths.end()) return {*layout, *mesh};
  return {paths.back()};
}

/// Records the costs of a frame for the profiler.
void note_cost(ui::ProfileState& profile, double layout, double window) {
  if (profile.pictures.size() >= ui::ProfileState::kPictures) profile.pictures.pop_front();
  profile.pictures.push_back({layout - profile.scene_seconds, profile.scene_seconds, window});
}

/// Takes the messages from the line whose circumstance is over.
void end_expired_messages(ui::App& app, const Host& host, bool is_dialog_open) {
  const auto end = [&](bool is_over, ui::Holds holds) {
    if (is_over) ui::end_messages(app.get<ui::Messages>(), holds);
  };
  const SensorModelPtr& model = app.shown->document.model;
  const bool runs = model && model->taxel_count() > 0 && app.shown->document.editing.problem.empty();
  end(host.run.moves(), ui::Holds::while_paused);
  end(runs || !host.edits().is_open(), ui::Holds::while_unrunnable);
  end(!host.files.autosave.fails(), ui::Holds::while_unkept);
  end(app.get<ui::FilesState>().layout_without_mesh.empty(), ui::Holds::while_mesh_missing);
  end(!is_dialog_open, ui::Holds::while_dialog_is_open);
  end(!app.get<ui::FilesState>().pending_export, ui::Holds::while_export_waits);
}

/// Displays an opened document.
void show_opened(ui::App& app, Host& host, const Opened& opened) {
  if (opened.is_doubtful) app.get<ui::PanelsShown>()[ui::kMeshReport] = is_doubtful(host.edits().mesh());
  app.viewer->selection.body = -1;  // bodies may have other numbers now
  app.get<ui::PerturbState>() = {};
  host.rests_in_layout = false;
  ui::leave_followed(*app.viewer, app.get<ui::FollowState>());
  ui::enter_mode(app, opened.mode);
  ui::let_go_of_way_points(app.get<ui::PathState>());
  if (!opened.file.empty())
    ui::remember_recent(app.get<ui::FilesState>().recent, std::filesystem::absolute(opened.file).string());
  if (opened.turns_cameras) {
    app.get<ui::Framing>().turns = {opened.another_document || app.get<ui::Framing>().turns[0], true};
    if (opened.another_document) {
      app.get<ui::Framing>().first = {true, true};
      app.get<ui::Framing>().saved = {camera_of_project(host), camera_of_state(opened.state)};
    }
  }
  app.get<ui::Framing>().checks_view = true;
}

void update_title(ui::App& app, Window& window) {
  std::string title = app.shown->document.name.empty() ? "Taxel Studio" : app.shown->document.name + " - Taxel Studio";
  if (app.shown->document.editing.dirty) title = "*" + title;
  if (app.get<ui::VideoState>().progress.active)
    title = fmt::format("Video {} of {} (Esc cancels) - {}", app.get<ui::VideoState>().progress.done,
                        app.get<ui::VideoState>().progress.total, title);
  if (title == app.get<ui::WindowState>().title) return;
  app.get<ui::WindowState>().title = title;
  window.set_title(title);
}

}  // namespace

void record_end_signals() {
  os::record_end_signals(record_end_signal);
}

int end_signal() {
  return recorded_signal;
}

Studio::Studio(const Options& options, SensorCache& cache)
    : options_(options),
      timing_(make_timing(options)),
      host_(app_, {.simulation = std::move(timing_.simulation),
                   .executor = *timing_.executor,
                   .cache = cache,
                   .is_real_time = timing_.is_real_time,
                   .kept_in = options.state_dir.empty() ? state_folder() : std::filesystem::path(options.state_dir),
                   .autosave_every = options.autosave_every}) {
  timing_.executor->set_wake([this] { window_->wake(); });
  if (!options.script.empty()) script_ = std::make_unique<ScriptPlayer>(read_script(options.script));
  window_ = options.headless ? make_offscreen_window(options.width, options.height)
                             : make_glfw_window(options.width, options.height, "Taxel Studio");
  context_ = std::make_unique<InterfaceContext>(*window_);
  renderer_ = std::make_unique<ui::SceneRenderer>(shader_reader(options.shader_dir));
  host_.screen = {renderer_.get(), [this] { return window_picture(); }, [this] { return state(); }};
  example_pictures_ = std::make_unique<ExamplePictures>();
  app_.get<ui::FilesState>().examples = example_pictures_->tiles();
  renderer_->set_draws_on_request(options.draws_saved_only);
  painter_.emplace(renderer_->effort() == ui::RenderEffort::gpu);
  if (options.keeps_state()) {
    load_settings(options_, *window_, app_);
    start_autosave(host_);
  }
  app_.viewer->cameras = {ui::first_camera(ui::Mode::layout), ui::first_camera(ui::Mode::simulate)};
  app_.viewer->range.hi = ui::kLeastRange;
  app_.shown->version = versions().taxel;
  app_.shown->versions = version_line("Taxel Studio");
  if (options.may_use_desktop())
    app_.get<ui::FileDialog>().desktop =
        os::has_file_chooser() ? ui::DesktopChooser::found : ui::DesktopChooser::missing;
  if (options.tour) app_.get<ui::TourState>().step = 0;
  app_.get<ui::DemoState>().runs = app_.get<ui::DemoState>().invites = options.demo;
  app_.get<ui::WindowParts>().has_few = options.demo;
  if (options.demo) host_.run.scene.scenario = ui::demo_scenario();
  if (!options.scenario.empty()) host_.run.scene.scenario = read_scenario_with_files(options.scenario);
  host_.next_lead = options.lead;
  if (!options.empty) carry_out(ui::OpenFile{options.file}, host_);
  pacing_.rest();
  pacing_.skip();
}

Studio::~Studio() {
  app_.get<VideoJob>().maker.reset();  // its images are used on the workers, which end before the states
}

bool Studio::run() {
  if (!timing_.is_real_time) show_first_frames();
  const ScriptStage stage = script_stage();
  bool was_shown = false;
  for (int frame = 0; !is_over() && (options_.frames == 0 || frame < options_.frames);) {
    const std::vector<InputEvent> events = next_events(stage, was_shown && host_.run.playback.makes_steps());
    if (!events.empty()) pacing_.request(FramePacing::kSettlingFrames);
    take(events);
    if (!input_taken()) pacing_.request(FramePacing::kSettlingFrames);
    was_shown = pacing_.is_due();
    if (was_shown) {
      show_frame(stage);
      ++frame;
    } else {
      pacing_.rest();
    }
    const double passed = timing_.clock->duration(pacing_.advance());
    advance_run(host_.run, ui::is_modal_open() ? 0 : passed);
    if (options_.frames == 0 && options_.headless && script_ && script_->finished()) break;
  }
  if (options_.keeps_state()) save_settings(options_, *window_, app_);
  end_signal() != 0 ? keep_unsaved_at_end(host_) : host_.files.autosave.end();
  finish_outputs();
  return !(options_.headless && outcome_.refused_argument);
}

double Studio::waiting_time() const {
  if (pacing_.is_due()) return 0;
  if (host_.run.playback.makes_steps() || host_.run.cursor.replays() || app_.get<VideoJob>().maker) return kBusyWait;
  const double wait = is_waiting() || desktop_dialog_.is_open() ? kAlertWait : kQuietWait;
  return std::min(wait, host_.files.autosave.seconds_until_due(steady_seconds()).value_or(wait));
}

bool Studio::is_waiting() const {
  return !host_.is_idle() || timing_.executor->busy() || ui::toasts_will_change(app_.get<ui::Messages>());
}

/// Requests pictures if a job of any kind has ended, the window has become idle, or a message or a notice has come or
/// gone. `ended_jobs` is the number before the session took their results.
void Studio::draw_what_has_changed(std::uint64_t ended_jobs) {
  const ui::Messages& messages = app_.get<ui::Messages>();
  const auto shown = std::count_if(messages.begin(), messages.end(), [](const ui::Message& m) { return m.toast; });
  pacing_.request_if_changed({ended_jobs, is_waiting(), messages.size(), static_cast<std::size_t>(shown),
                              app_.get<ui::FilesState>().notices.size()});
}

bool Studio::is_over() const {
  return app_.get<ui::WindowState>().quits || end_signal() != 0;
}

void Studio::update_desktop_dialog() {
  const ui::DesktopDialogStage stage{*app_.ui, app_.get<ui::FileDialog>(), app_.get<ui::Messages>(),
                                     app_.get<ui::FilesState>().notices, ImGui::GetTime()};
  if (desktop_dialog_.update(stage, app_.get<ui::ControlsState>().geoms)) pacing_.request(FramePacing::kSettlingFrames);
}

void Studio::show_first_frames() {
  for (int i = 0; i <= FramePacing::kSettlingFrames; ++i) {
    handle_events(update(host_, true));
    draw_picture();
  }
  pacing_.reset(app_.get<ui::ViewShown>().draws);
}

/// Waits for input, unless a frame is likely to be ready, and updates the session meanwhile. The events of a script
/// replace those of the window.
std::vector<InputEvent> Studio::next_events(const ScriptStage& stage, bool is_frame_likely) {
  const bool is_scripted = script_ && !script_->rests();
  const double wait = is_frame_likely || is_scripted ? 0 : waiting_time();
  std::vector<InputEvent> events = window_->take_events(timing_.clock->wait(wait));
  if (!host_.run.cursor.replays()) pacing_.skip();  // a replay starts after the wait for its command
  const std::uint64_t ended_jobs = timing_.executor->ended();
  const HostEvents happened = update(host_);
  handle_events(happened);
  rest_in_layout(host_);
  rest_behind_dialog(host_.run, ui::is_modal_open(), host_.handover.will_change_samples());
  update_desktop_dialog();
  for (const HostEvent& event : happened) pacing_.request(pictures_after(event));
  end_expired_messages(app_, host_, desktop_dialog_.is_open());
  draw_what_has_changed(ended_jobs);
  const bool is_counted = options_.frames > 0 || is_scripted || app_.get<VideoJob>().maker || !timing_.is_real_time;
  if (is_waiting() || is_counted) pacing_.request(1);
  if (script_) return script_->before_frame(stage);
  return timing_.is_real_time ? events : std::vector<InputEvent>{};
}

void Studio::show_frame(const ScriptStage& stage) {
  draw_picture();
  if (script_) script_->after_frame(stage);
  window_->show();
}

void Studio::take(const std::vector<InputEvent>& events) {
  ImGuiIO& io = ImGui::GetIO();
  input_queue_.add(events);
  if (!ImGui::GetCurrentContext()->InputEventsQueue.empty()) return;  // ImGui still processes earlier events
  for (const InputEvent& event : input_queue_.take()) {
    if (is_deliberate(event)) ui::rest_demo_camera(app_);
    if (feed(event, io)) continue;
    if (const auto* drop = std::get_if<DropFiles>(&event); drop != nullptr && !drop->paths.empty()) {
      const ui::OpenFile file = dropped_file(drop->paths);
      const bool points = app_.get<ui::GenerateState>().open && holds_points(file.path);
      points ? app_.ui->post(ui::ReadPoints{file.path}) : app_.ui->post(file);
    }
    if (const auto* size = std::get_if<ResizeWindow>(&event); size != nullptr && options_.headless) {
      window_->resize(std::max(1, size->width), std::max(1, size->height));
    }
    if (std::holds_alternative<CloseWindow>(event)) app_.ui->post(ui::Quit{});
    if (std::holds_alternative<RenameKeys>(event)) app_.ui->key_names = window_->key_names();
  }
}

void Studio::handle_events(const HostEvents& events) {
  const double now = ImGui::GetTime();
  const Opened* const opened = newest<Opened>(events);
  if (opened != nullptr && opened->another_document)
    for (const ui::Holds holds :
         {ui::Holds::for_document, ui::Holds::until_edit, ui::Holds::for_run, ui::Holds::while_paused})
      ui::end_messages(app_.get<ui::Messages>(), holds);
  for (const HostEvent& event : events) {
    const auto* message = std::get_if<HostMessage>(&event);
    if (message == nullptr) continue;
    ui::add_message(app_.get<ui::Messages>(), message->severity, message->text, now, message->holds, message->is_shown);
    if (message->severity != Severity::error) continue;
    std::fprintf(stderr, "taxelstudio: %s\n", message->text.c_str());
    outcome_.refused_argument = outcome_.refused_argument || (!options_.file.empty() && !outcome_.has_opened);
  }
  const bool is_reloaded = newest<Reloaded>(events) != nullptr;
  outcome_.has_opened = outcome_.has_opened || opened != nullptr;
  fill(host_);
  if (opened != nullptr && opened->another_document) {
    ui::forget_document(app_);
    desktop_dialog_.leave_document();
    app_.get<RealOverlay>().remove();
    app_.get<VideoJob>().maker.reset();
    app_.get<ui::MeshState>().frame_is_guess = host_.document.frame_is_guess();
    app_.get<ui::ControlsState>().wants_focus = host_.document.kind() == DocumentKind::scene;
  }
  if (const auto* built = newest<ModelBuilt>(events); built != nullptr && built->is_resized)
    app_.get<ui::Framing>().turns = {true, true};
  if (is_reloaded) {
    after_edit(host_);
    app_.get<ui::FilesState>().notices.clear();  // the files of these notices were read again
    app_.viewer->selection.keep_only(host_.edits().project()->layout);
  }
  if (opened != nullptr) show_opened(app_, host_, *opened);
  if (opened != nullptr && opened->another_document) {
    ui::follow_opened_document(app_);
    if (host_.document.loader.file() == kJumpingTaxel) ui::explain_largest_step(app_);
  }
  if (const auto* read = newest<StudyRead>(events)) {
    outcome_.has_opened = true;
    ui::remember_recent(app_.get<ui::FilesState>().recent, read->folder);
  }
  ui::frame_cameras(app_);
  ui::update_range(app_, host_.run.peaks.largest_pressure());
  update_title(app_, *window_);
  keep_unsaved(host_);
  export_when_ready(host_);
  save_scene_when_ready(host_);
  if (const auto* missing = newest<MeshMissing>(events)) offer_to_locate(host_, missing->layout, missing->mesh);
  if (const auto* unwritten = newest<RecordingUnwritten>(events))
    ask_for_file(app_, ui::FileTask::keep_recording, unwritten->why);
  if (opened != nullptr || is_reloaded) {
    host_.files.hash = hash_of_document(host_);
    tell_other_mesh(host_);
  }
  watch_files(host_, timing_.clock->now());
}

void Studio::draw_picture() {
  const double since_last = pacing_.begin_frame();
  window_->set_full_screen(app_.get<ui::WindowState>().full_screen);
  float scale = app_.get<ui::Appearance>().scale * window_->content_scale();
  if (app_.get<ui::WindowParts>().is_presenting)
    scale = ui::presentation_scale(static_cast<float>(window_->width()), static_cast<float>(window_->height()), scale);
  app_.ui->pixel_scale = scale;
  if (app_.get<ui::Appearance>().dark != app_.ui->dark || scale != outcome_.themed_scale)
    ui::apply_theme(app_.get<ui::Appearance>().dark, scale);
  app_.ui->dark = app_.get<ui::Appearance>().dark;
  outcome_.themed_scale = scale;
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = ImVec2(static_cast<float>(window_->width()), static_cast<float>(window_->height()));
  io.DeltaTime = static_cast<float>(timing_.clock->duration(since_last));
  fill(host_);
  app_.get<ui::RealState>().shown = app_.get<RealOverlay>().shown();
  app_.get<ui::VideoState>().progress =
      app_.get<VideoJob>().maker ? app_.get<VideoJob>().maker->progress() : ui::VideoProgress{};
  if (const ui::FileDialog& dialog = app_.get<ui::FileDialog>();
      dialog.open && dialog.task == ui::FileTask::export_video)
    app_.get<ui::VideoState>().source = video_source(app_);
  app_.shown->run.performance.is_real_time = timing_.is_real_time;
  app_.shown->run.performance.is_resting = !host_.run.playback.makes_steps() && !host_.run.cursor.replays() &&
                                           !app_.get<VideoJob>().maker && host_.is_idle() && !ImGui::IsAnyMouseDown();
  app_.shown->run.performance.simulation_speed = app_.shown->run.frame ? app_.shown->run.frame->measured_speed : 0.0;
  app_.shown->run.performance.step_seconds = app_.shown->run.frame ? app_.shown->run.frame->step_seconds : 0.0;
  draw_contents();
  request_about_run(host_);
  timing_.executor->run_posted();
  timing_.clock->tick();
  if (const std::optional<double> rate = pacing_.end_frame()) app_.shown->run.performance.fps = *rate;
}

void Studio::draw_contents() {
  const Clock::time_point begin = Clock::now();
  app_.get<ui::ProfileState>().scene_seconds = 0;
  ImGui_ImplOpenGL3_NewFrame();
  ui::switch_arrangement(app_);
  ImGui::NewFrame();
  ui::draw_interface(app_, *renderer_);
  // Requests are posted before the frame is drawn: a worker replies in less time than a software renderer draws.
  host_.jobs.request_about_layout(app_, host_.document.model());
  carry_out_commands();
  window_->set_cursor(ImGui::GetMouseCursor());
  const Clock::time_point laid_out = Clock::now();
  ImGui::Render();
  options_.draws_saved_only ? WindowPainter::send_glyphs(*ImGui::GetDrawData()) : fill_window();
  note_cost(app_.get<ui::ProfileState>(), seconds_between(begin, laid_out), seconds_between(laid_out, Clock::now()));
  if (app_.get<VideoJob>().maker) pacing_.request(1);
  make_video(host_);
  if (std::exchange(app_.get<ui::WindowState>().saves_screenshot, false)) save_numbered_screenshot();
}

void Studio::fill_window() {
  painter_->paint(*window_, *ImGui::GetDrawData(), ImGui::GetStyle().Colors[ImGuiCol_WindowBg],
                  static_cast<ImTextureID>(renderer_->texture()), app_.get<ui::ViewShown>().draws);
}

bool Studio::input_taken() const {
  return input_queue_.empty() && ImGui::GetCurrentContext()->InputEventsQueue.empty();
}

}  // namespace taxel::studio
