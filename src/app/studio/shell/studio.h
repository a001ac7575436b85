// The program with a window: wires session, interface, renderer, window and script together.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/host/session.h"
#include "app/studio/nouns/real/real_overlay.h"
#include "app/studio/nouns/video/film_camera.h"
#include "app/studio/nouns/video/video_maker.h"
#include "app/studio/shell/document_files.h"
#include "app/studio/shell/example_pictures.h"
#include "app/studio/shell/frame_pacing.h"
#include "app/studio/shell/options.h"
#include "app/studio/shell/script/script_player.h"
#include "app/studio/shell/timing.h"
#include "app/studio/shell/window/input_queue.h"
#include "app/studio/shell/window/window.h"
#include "app/studio/shell/window/window_painter.h"
#include "ui/scene/scene_renderer.h"

namespace taxel::studio {

/// Contexts of ImGui, ImPlot and their OpenGL backend, which are created and destroyed together.
class InterfaceContext {
 public:
  explicit InterfaceContext(Window& window);
  ~InterfaceContext();
  InterfaceContext(const InterfaceContext&) = delete;
  InterfaceContext& operator=(const InterfaceContext&) = delete;
};

class Studio {
 public:
  /// `cache` has the parts of compiled sensors, and must live longer than this object.
  Studio(const Options& options, SensorCache& cache);
  ~Studio();
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;

  /// Runs until the window is closed, the script ends or the requested frames are drawn. Returns false if the program
  /// drew offscreen and the file of the command line was refused. Throws Error if a script fails.
  bool run();

 private:
  /// Cameras, one per mode, that turn to the displayed scene.
  struct Framing {
    std::array<bool, 2> turns{};  ///< the camera turns as soon as its mode has something to display
    bool checks_view = false;     ///< the mode has changed: a sensor outside of the view is to be framed
    /// Cameras saved with the project (LAYOUT) or the step (SIMULATE) that was opened.
    std::array<std::optional<ui::Camera>, 2> saved;
  };
  /// Requests and results that last beyond a frame.
  struct Outcome {
    bool quits = false, saves_screenshot = false;
    bool discards_edits = false;  ///< the user agreed to lose the unsaved edits
    bool has_opened = false, refused_argument = false;
    bool rests_in_layout = false;  ///< the run was paused because LAYOUT is displayed
    float themed_scale = 0;        ///< scale of the interface for which the theme was applied
  };

  /// Displays a script's first frames, so that its first line finds the window complete and the samples polished.
  void show_first_frames();
  [[nodiscard]] std::vector<InputEvent> next_events(const ScriptStage& stage, bool is_frame_likely);
  void show_frame(const ScriptStage& stage);
  void take(const std::vector<InputEvent>& events);
  void act_on(const SessionEvents& events);
  void show_opened(const Opened& opened);
  /// Frames each camera that waits for it, and the present camera if it does not show the sensor after a change of
  /// mode.
  void frame_cameras();
  void draw_picture();
  void draw_contents();
  void note_cost(double layout, double window);
  void fill_window();  ///< draws the interface that was laid out last
  /// Carries out the commands that were posted in this frame, in order.
  void carry_out_commands();
  /// Asks whether to save if the command leaves a document with unsaved edits. Returns whether the command has to wait.
  bool hold_if_unsaved(const ui::Command& command);

  // One overload per command to the program; ui::CarryOut has the overloads for commands about the interface alone.
  void carry_out(const ui::OpenFile& file);
  void carry_out(const ui::OpenEpisode& episode);
  void carry_out(const ui::SaveStudy& command);
  void carry_out(const ui::OpenStudy& command);
  void carry_out(const ui::OpenExample& example);
  void carry_out(const ui::NewLayout&);
  void carry_out(const ui::OpenExamples&);
  std::optional<std::filesystem::path> written_examples();
  void carry_out(const ui::CloseDocument&);
  void carry_out(const ui::ListFolder& command);
  void carry_out(const ui::CancelLoading&) { session_.cancel_loading(); }
  void carry_out(const ui::PolishSamples&) { session_.polish(); }
  void carry_out(const ui::SendCommand& command) { session_.send(command.command); }
  void carry_out(const ui::RunScenario& command) { session_.run_scenario(command.scenario); }
  void carry_out(const ui::PlayOrPause&);
  void carry_out(const ui::StepOnce&) { session_.step_by(1); }
  void carry_out(const ui::StepBack&) { session_.step_by(-1); }
  void carry_out(const ui::ScrubTo& command) { session_.scrub(command.step); }
  void carry_out(const ui::ReplayHistory& command) { session_.replay(command.direction); }
  void carry_out(const ui::SetLoop& command) { session_.set_loop(command.range); }
  void carry_out(const ui::SetBreakpoints& command) { session_.set_breakpoints(command.breakpoints); }
  void carry_out(const ui::SetHistoryLimits& command) { session_.set_history_limits(command.limits); }
  void carry_out(const ui::SetRecording& command);
  void carry_out(const ui::ReadRealRecording& command);
  void carry_out(const ui::ActOnReal& command);
  void carry_out(const ui::ShiftReal& command);
  void carry_out(const ui::CompareLayout& command);
  void carry_out(const ui::CancelVideo&) { video_.reset(); }
  void carry_out(const ui::MakeFilm&);
  void carry_out(const ui::ResetSimulation&) { session_.reset(); }
  void carry_out(const ui::SetSpeed& command) { session_.set_speed(command.factor); }
  void carry_out(const ui::SetMode& command);
  void rest_in_layout();
  void carry_out(const ui::ReloadFile&) { session_.reload(); }
  void carry_out(const ui::SetMeshUnit& command);
  void carry_out(const ui::EditProject& command);
  void carry_out(const ui::CancelGesture& command);
  void carry_out(const ui::EndGesture&) { session_.edits().end_gesture(); }
  void carry_out(const ui::UndoStep&);
  void carry_out(const ui::RedoStep&);
  void carry_out(const ui::GoToEdit& command);
  void carry_out(const ui::CopyTaxels&);
  void carry_out(const ui::PasteTaxels&);
  void carry_out(const ui::SaveProject& command) { save_project(command.path, command.replace); }
  void carry_out(const ui::SaveAs&);
  void carry_out(const ui::ExportFile& wanted);
  void carry_out(const ui::AttachLayout& command);
  void carry_out(const ui::DetachLayout& command) { session_.detach(command.geom); }
  void carry_out(const ui::SaveScene& wanted);
  void carry_out(const ui::DialogClosed&);
  void carry_out(const ui::AnswerUnsaved& command);
  void carry_out(const ui::AnswerRecovery& command);
  void carry_out(const ui::AnswerNotice& answer);
  void carry_out(const ui::ReadPoints& command);
  void carry_out(const ui::TakeScreenshot&) { outcome_.saves_screenshot = true; }
  void carry_out(const ui::Quit&) { outcome_.quits = true; }

  void read_data_set(const std::string& folder);
  void show_data_set(const DataSetRead& read);
  void read_real(const std::string& path);
  void act_on_real(ui::RealTask task);
  void apply_gains();
  /// Returns the recorded steps that a video shows: the loop, or all.
  [[nodiscard]] StepRange steps_for_video() const;
  void begin_video(VideoPlan plan);
  void make_video();  ///< writes one image of the video, if one is ready
  [[nodiscard]] gl::RgbImage video_image();
  /// Runs the document's scenario and returns true. Otherwise shows a message in the view about the missing parts and
  /// returns false.
  bool run_or_say_why_not();
  void edit_document(const std::function<void(EditSession&)>& body, bool in_gesture = false,
                     const std::optional<ui::FieldInput>& from = std::nullopt);
  void watch_files();
  void tell_change(const std::string& file, FileChange change);
  void tell_second_layout(FileChange change);
  void tell_mesh(ComparedMesh compared);
  void tell_other_mesh();
  void add_notice(ui::FileNotice notice);
  void drop_notice(const std::string& file);
  [[nodiscard]] bool has_notice(const std::string& file) const;
  void wrote(const std::string& file, const Project& written);
  void save_project(const std::string& path, bool replace);
  [[nodiscard]] bool can_export(ui::FileTask task) const;
  void export_when_ready();
  [[nodiscard]] bool samples_are_final() const;
  std::vector<std::string> write_export(const ui::ExportFile& wanted);
  [[nodiscard]] gl::RgbaImage cut_out(int width, int height);
  [[nodiscard]] bool may_write(const std::string& path, ui::FileTask task, bool replace);
  void ask_for_file(ui::FileTask task, const std::string& problem);
  /// Opens the desktop's file dialog if it is requested, and acts on its reply.
  void update_desktop_dialog();
  void start_autosave();
  void keep_unsaved();
  /// Writes unsaved edits for the next start when a signal ends the program.
  void keep_unsaved_at_end();
  void offer_recovery();
  void offer_recording();
  void answer_left_recording(bool recover);
  [[nodiscard]] std::filesystem::path kept_file(const char* name) const;  ///< path of a file in the settings folder
  [[nodiscard]] Project project_to_save() const;
  [[nodiscard]] std::optional<ui::Camera> camera_of_project() const;  ///< saved camera, or empty
  void update_title();
  void load_settings();
  void save_settings();
  void finish_outputs();
  void save_screenshot(const std::string& file);
  void save_numbered_screenshot();
  void save_state(const std::string& file);
  [[nodiscard]] ImVec2 locate(const Target& target) const;
  [[nodiscard]] bool input_taken() const;
  [[nodiscard]] double waiting_time() const;
  /// Whether something is under way that ends without an input.
  [[nodiscard]] bool is_waiting() const;
  void end_messages();
  void draw_what_has_changed(std::uint64_t ended_jobs);
  /// Returns whether the user, the script or a signal has ended the program.
  [[nodiscard]] bool is_over() const;
  ScriptStage script_stage();

  Options options_;
  std::unique_ptr<Window> window_;
  std::unique_ptr<InterfaceContext> context_;
  std::unique_ptr<ui::SceneRenderer> renderer_;
  std::unique_ptr<ExamplePictures> example_pictures_;
  std::optional<WindowPainter> painter_;
  ui::App app_;
  Timing timing_;
  Session session_;
  std::unique_ptr<ScriptPlayer> script_;
  InputQueue input_queue_;
  FramePacing pacing_;
  Framing framing_;
  DocumentFiles files_;
  std::optional<ui::Command> held_;  ///< command that waits until unsaved edits are saved or discarded
  RealOverlay real_;
  std::optional<VideoMaker> video_;
  std::optional<ui::FilmCamera> film_camera_;  ///< camera of `video_` if it turns around the contact
  Outcome outcome_;
};

}  // namespace taxel::studio
