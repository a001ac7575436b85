#include "app/studio/shell/studio.h"

#include <fmt/format.h>
#include <imgui_impl_opengl3.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "app/studio/app/interface.h"
#include "app/studio/app/pointing/shown_scene.h"
#include "app/studio/app/reset.h"
#include "app/studio/document/file_listing.h"
#include "app/studio/dump/settings.h"
#include "app/studio/features/camera/camera_follow.h"
#include "app/studio/features/explain/explain_tool.h"
#include "app/studio/features/measure/measure_tool.h"
#include "app/studio/features/messages/messages.h"
#include "app/studio/features/models/models_tool.h"
#include "app/studio/features/probe/probe_tool.h"
#include "app/studio/features/scenario/path_recorder.h"
#include "app/studio/shell/end_signal.h"
#include "app/version/version.h"
#include "core/base/files.h"
#include "core/document/scenario/scenario_json.h"
#include "core/mesh/mesh_io.h"
#include "ui/theme.h"
#include "ui/widgets/format.h"

namespace taxel::studio {

namespace {

using Clock = std::chrono::steady_clock;

/// Time of a frame that follows a script instead of the clock [s]: twenty steps of the sweep.
constexpr double kScriptFrame = 0.020;
/// Pictures after an input: widgets need a second look at what they changed.
constexpr int kSettlingPictures = 3;
/// How long a wait for input may last [s]: while the simulation runs, something is awaited, or nothing happens.
constexpr double kBusyWait = 0.004, kAlertWait = 0.05, kQuietWait = 0.25;
/// Over this much time rates are measured [s].
constexpr double kPaceWindow = 0.5;
/// The least upper end of the pressure range [Pa].
constexpr double kLeastRange = 1000;

double seconds_between(Clock::time_point a, Clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

bool is_doubtful(const OpenMeshPtr& mesh) {
  return mesh && std::any_of(mesh->findings.begin(), mesh->findings.end(),
                             [](const MeshFinding& finding) { return finding.severity != Severity::note; });
}

/// The shaders of a folder, or those built in.
gl::ShaderReader shader_reader(const std::string& folder) {
  if (folder.empty()) return gl::read_embedded_shader;
  return [folder](const std::string& name) { return read_file(std::filesystem::path(folder) / name); };
}

/// The last file that was dropped; of a layout and its mesh both.
ui::OpenFile dropped_file(const std::vector<std::string>& paths) {
  const auto layout =
      std::find_if(paths.begin(), paths.end(), [](const std::string& path) { return needs_mesh(path); });
  const auto mesh =
      std::find_if(paths.begin(), paths.end(), [](const std::string& path) { return is_mesh_file(path); });
  if (layout != paths.end() && mesh != paths.end()) return {*layout, *mesh};
  return {paths.back()};
}

}  // namespace

Studio::Studio(const Options& options)
    : options_(options),
      session_(pool_, options.by_clock(), [this] { window_->wake(); }),
      autosave_(pool_, options.autosave_every),
      comparison_(pool_, [this] { window_->wake(); }) {
  if (!options.script.empty()) script_ = std::make_unique<ScriptPlayer>(read_script(options.script));
  window_ = options.headless ? make_offscreen_window(options.width, options.height)
                             : make_glfw_window(options.width, options.height, "Taxel Studio");
  context_ = std::make_unique<InterfaceContext>(*window_);
  renderer_ = std::make_unique<ui::SceneRenderer>(shader_reader(options.shader_dir));
  painter_.emplace(!renderer_->software());
  if (options.keeps_state()) {
    load_settings();
    start_autosave();
  }
  app_.viewer.cameras = {ui::first_camera(ui::Mode::layout), ui::first_camera(ui::Mode::simulate)};
  app_.viewer.range.hi = kLeastRange;
  app_.shown.version = versions().taxel;
  // Scripts and pictures begin without it, unless it is asked for.
  if (options.tour || (options.by_clock() && !app_.window.tour.seen)) app_.window.tour.step = 0;
  if (!options.scenario.empty()) session_.begin_with(read_scenario_with_files(options.scenario));
  if (!options.empty) carry_out(ui::OpenFile{options.file});
  last_picture_at_ = pace_window_at_ = Clock::now();
}

Studio::~Studio() = default;

bool Studio::run() {
  options_.by_clock() ? run_by_clock() : run_by_frames();
  if (options_.keeps_state()) save_settings();
  end_signal() != 0 ? keep_unsaved_at_end() : autosave_.end();
  finish_outputs();
  return !(options_.headless && argument_refused_);
}

double Studio::waiting_time() const {
  if (pictures_due_ > 0) return 0;
  if (session_.steps() || session_.replaying() || video_) return kBusyWait;
  const double wait = !session_.idle() || ui::toasts_will_change(app_.window.messages) ? kAlertWait : kQuietWait;
  return std::min(wait, autosave_.seconds_until_due(steady_seconds()).value_or(wait));
}

bool Studio::is_over() const {
  return quit_ || end_signal() != 0;
}

void Studio::run_by_clock() {
  const ScriptStage stage = script_stage();
  bool drew = false;
  for (int frame = 0; !is_over() && (options_.frames == 0 || frame < options_.frames);) {
    const bool newer = std::exchange(drew, false) && session_.steps();  // a frame is likely to lie ready
    const bool scripted = script_ && !script_->rests();
    std::vector<InputEvent> events = window_->take_events(newer || scripted ? 0 : waiting_time());
    if (script_) events = script_->before_frame(stage);  // instead of the window's own
    if (!events.empty()) pictures_due_ = kSettlingPictures;
    take(events);
    if (!input_taken()) pictures_due_ = kSettlingPictures;
    const SessionNews news = session_.update();
    act_on(news);
    if (take_preview()) pictures_due_ = kSettlingPictures;
    const bool waited = !session_.idle() || ui::toasts_will_change(app_.window.messages);
    if (!news.messages.empty() || news.opened || news.new_model) pictures_due_ = kSettlingPictures;
    // Pictures were asked for, whether anything moves or not.
    const bool counted = options_.frames > 0 || scripted || video_;
    if (news.new_frame || news.new_reading || waited || counted) pictures_due_ = std::max(pictures_due_, 1);
    if (pictures_due_ == 0) {
      last_picture_at_ = Clock::now();  // a rest does not count as a slow picture
      continue;
    }
    --pictures_due_;
    draw_picture(std::max(1e-4, seconds_between(last_picture_at_, Clock::now())));
    if (script_) script_->after_frame(stage);
    window_->show();
    drew = true;
    ++frame;
    if (script_ && script_->finished() && options_.headless) break;
  }
}

void Studio::run_by_frames() {
  const ScriptStage stage = script_stage();
  // So that a script's first line finds the window complete, its samples polished.
  for (int i = 0; i <= kSettlingPictures; ++i) {
    act_on(session_.update(true));
    draw_picture(kScriptFrame);
  }
  pace_ = {};
  draws_at_dump_ = app_.window.view.draws;
  for (int frame = 0; !is_over(); ++frame) {
    window_->take_events(0);  // keeps a real window alive; its own input does not count here
    act_on(session_.update());
    take_preview();
    take(script_ ? script_->before_frame(stage) : std::vector<InputEvent>{});
    draw_picture(kScriptFrame);
    if (script_) script_->after_frame(stage);
    window_->show();
    session_.advance(kScriptFrame);
    const bool script_over = script_ && script_->finished() && options_.headless;
    if (options_.frames > 0 ? frame + 1 >= options_.frames : script_over) break;
  }
}

void Studio::take(const std::vector<InputEvent>& events) {
  ImGuiIO& io = ImGui::GetIO();
  input_queue_.add(events);
  if (!ImGui::GetCurrentContext()->InputEventsQueue.empty()) return;  // it is still at what came before
  for (const InputEvent& event : input_queue_.take()) {
    if (feed(event, io)) continue;
    if (const auto* drop = std::get_if<DropFiles>(&event); drop != nullptr && !drop->paths.empty()) {
      const ui::OpenFile file = dropped_file(drop->paths);
      const bool points = app_.layout.generate.open && holds_points(file.path);
      points ? app_.ui.post(ui::ReadPoints{file.path}) : app_.ui.post(file);
    }
    if (const auto* size = std::get_if<ResizeWindow>(&event); size != nullptr && options_.headless) {
      window_->resize(std::max(1, size->width), std::max(1, size->height));
    }
    if (std::holds_alternative<CloseWindow>(event)) app_.ui.post(ui::Quit{});
  }
}

void Studio::act_on(const SessionNews& news) {
  const double now = ImGui::GetTime();
  for (const auto& [severity, text] : news.messages) {
    ui::add_message(app_.window.messages, severity, text, now);
    if (severity != Severity::error) continue;
    std::fprintf(stderr, "taxelstudio: %s\n", text.c_str());
    argument_refused_ = argument_refused_ || (!options_.file.empty() && !anything_opened_);
  }
  anything_opened_ = anything_opened_ || news.opened;
  session_.fill(app_, app_.viewer.selection.sensor);
  if (news.another_document) {
    ui::forget_document(app_);
    real_.remove();
    video_.reset();
    app_.layout.mesh.frame_is_guess = session_.frame_is_guess();
    app_.simulate.controls.wants_focus = session_.kind() == DocumentKind::scene;
  }
  if (news.resized) turns_cameras_ = {true, true};
  if (news.reloaded) {
    session_.after_edit(app_.viewer.mode == ui::Mode::simulate);
    app_.window.notices.clear();  // what they were about was read again
    app_.viewer.selection.keep_only(session_.edits().project()->layout);
  }
  if (news.doubtful_mesh) app_.window.panels.mesh_report = is_doubtful(session_.edits().mesh());
  if (news.opened) {
    app_.viewer.selection.body = -1;  // bodies may have other numbers now
    app_.simulate.perturb = {};
    ui::leave_followed(app_.viewer, app_.simulate.follow);
    app_.viewer.mode = *news.opened;
    ui::let_go_of_way_points(app_.simulate.path);
    if (!news.opened_file.empty())
      remember_recent(app_.window.recent, std::filesystem::absolute(news.opened_file).string());
    if (news.framed) turns_cameras_ = {news.another_document || turns_cameras_[0], true};
    if (news.framed && news.another_document) saved_cameras_ = {camera_of_project(), camera_of_state(news.saved_state)};
    checks_view_ = true;
  }
  frame_cameras();
  update_range();
  update_title();
  keep_unsaved();
  export_when_ready();
  if (!news.unwritten.empty()) ask_for_file(ui::FileTask::keep_recording, news.unwritten);
  if (news.opened || news.reloaded) {
    document_hash_ = hash_of(session_.file());
    tell_other_mesh();
  }
  watch_files();
}

void Studio::update_range() {
  if (!app_.viewer.range.automatic) return;
  app_.viewer.range.lo = 0;
  if (app_.shown.document.probe)
    app_.layout.probe.largest = std::max(app_.layout.probe.largest, app_.shown.document.probe->largest);
  const double largest = app_.viewer.mode == ui::Mode::layout && app_.shown.document.probe
                             ? app_.layout.probe.largest
                             : session_.largest_pressure();
  app_.viewer.range.hi = std::max(kLeastRange, ui::nice_ceiling(largest));
}

void Studio::update_title() {
  std::string title = app_.shown.document.name.empty() ? "Taxel Studio" : app_.shown.document.name + " - Taxel Studio";
  if (app_.shown.document.editing.dirty) title = "*" + title;
  if (app_.simulate.video.progress.active)
    title = fmt::format("Video {} of {} (Esc cancels) - {}", app_.simulate.video.progress.done,
                        app_.simulate.video.progress.total, title);
  if (title == app_.window.title) return;
  app_.window.title = title;
  window_->set_title(title);
}

void Studio::draw_picture(double seconds) {
  const Clock::time_point began = Clock::now();
  window_->set_full_screen(app_.window.full_screen);
  const float scale = app_.window.appearance.scale * window_->content_scale();
  app_.ui.pixel_scale = scale;
  if (app_.window.appearance.dark != app_.ui.dark || scale != themed_scale_)
    ui::apply_theme(app_.window.appearance.dark, scale);
  app_.ui.dark = app_.window.appearance.dark;
  themed_scale_ = scale;
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = ImVec2(static_cast<float>(window_->width()), static_cast<float>(window_->height()));
  io.DeltaTime = static_cast<float>(seconds);
  session_.fill(app_, app_.viewer.selection.sensor);
  app_.simulate.real.shown = real_.shown();
  app_.simulate.video.progress = video_ ? video_->progress() : ui::VideoProgress{};
  app_.layout.probe.latency = session_.edit_latency();
  app_.shown.run.performance.by_clock = options_.by_clock();
  app_.shown.run.performance.simulation_speed = app_.shown.run.frame ? app_.shown.run.frame->measured_speed : 0.0;
  app_.shown.run.performance.step_seconds = app_.shown.run.frame ? app_.shown.run.frame->step_seconds : 0.0;
  draw_contents();
  session_.explain(ui::explain_request(app_.viewer, app_.shown, app_.window.panels.explain));
  session_.compare_models(ui::models_request(app_.viewer, app_.shown, app_.window.panels.models));
  session_.study(app_.simulate.study.request);
  const Clock::time_point now = Clock::now();
  const double since_last = seconds_between(last_picture_at_, now);
  last_picture_at_ = now;
  ++pace_.pictures;
  pace_.seconds += since_last;
  pace_.worst_seconds = std::max(pace_.worst_seconds, seconds_between(began, now));
  ++pace_window_pictures_;
  if (const double window = seconds_between(pace_window_at_, now); window > kPaceWindow) {
    app_.shown.run.performance.fps = pace_window_pictures_ / window;
    pace_window_at_ = now;
    pace_window_pictures_ = 0;
  }
}

void Studio::draw_contents() {
  const Clock::time_point begin = Clock::now();
  app_.window.profile.scene_seconds = 0;
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  ui::draw_interface(app_, *renderer_);
  // Before the picture is filled, which takes a software renderer longer than a worker needs to answer.
  session_.press(ui::probe_request(app_.viewer, app_.layout.probe));
  session_.measure(ui::measure_request(app_.viewer, app_.shown.document, app_.layout.measure));
  session_.show_fields(app_.viewer.mode, ui::field_map(app_.viewer.overlays), app_.viewer.overlays.readings_on_skin);
  carry_out_commands();
  window_->set_cursor(ImGui::GetMouseCursor());
  const Clock::time_point laid_out = Clock::now();
  ImGui::Render();
  fill_window();
  note_cost(seconds_between(begin, laid_out), seconds_between(laid_out, Clock::now()));
  make_video();
  if (std::exchange(screenshot_wanted_, false)) save_numbered_screenshot();
}

/// For the profiler.
void Studio::note_cost(double layout, double window) {
  ui::ProfileState& profile = app_.window.profile;
  if (profile.pictures.size() >= ui::ProfileState::kPictures) profile.pictures.pop_front();
  profile.pictures.push_back({layout - profile.scene_seconds, profile.scene_seconds, window});
}

void Studio::fill_window() {
  painter_->paint(*window_, *ImGui::GetDrawData(), ImGui::GetStyle().Colors[ImGuiCol_WindowBg],
                  static_cast<ImTextureID>(renderer_->texture()), app_.window.view.draws);
}

bool Studio::input_taken() const {
  return input_queue_.empty() && ImGui::GetCurrentContext()->InputEventsQueue.empty();
}

std::filesystem::path Studio::kept_file(const char* name) const {
  return (options_.state_dir.empty() ? settings_folder() : std::filesystem::path(options_.state_dir)) / name;
}

void Studio::load_settings() {
  const auto put_aside = [&](const std::filesystem::path& file, const std::string& problem) {
    const std::filesystem::path aside = file.string() + ".broken";
    std::error_code failed;
    std::filesystem::rename(file, aside, failed);
    ui::add_message(app_.window.messages, Severity::warning,
                    fmt::format("{}: what could not be read is as in a new installation{}", problem,
                                failed ? "" : fmt::format("; the file is kept as {}", aside.filename().string())),
                    ImGui::GetTime());
  };
  const ReadSettings settings = read_settings(kept_file("settings.json"));
  apply_saved(settings.saved, app_);
  if (!settings.problem.empty()) put_aside(kept_file("settings.json"), settings.problem);
  std::error_code ignored;
  const auto windows = kept_file("window.ini");
  if (!std::filesystem::exists(windows, ignored)) return;
  try {
    const std::string text = read_file(windows);
    ImGui::LoadIniSettingsFromMemory(text.data(), text.size());
  } catch (const Error& error) {
    put_aside(windows, error.what());
  }
}

void Studio::save_settings() {
  try {
    write_settings(kept_file("settings.json"), saved_state(app_));
    std::size_t size = 0;
    const char* text = ImGui::SaveIniSettingsToMemory(&size);
    write_file_atomically(kept_file("window.ini"), std::string_view(text, size));
  } catch (const Error& error) {
    std::fprintf(stderr, "taxelstudio: settings are not kept: %s\n", error.what());
  }
}

}  // namespace taxel::studio
