// The program with a window: the loop that wires host, interface, renderer, window and script together, and the signals
// that end it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/files/desktop_dialog.h"
#include "app/studio/nouns/files/files_state.h"
#include "app/studio/shell/options.h"
#include "app/studio/shell/script/script.h"
#include "app/studio/shell/timing.h"
#include "app/studio/shell/window/input_event.h"
#include "app/studio/shell/window/window.h"
#include "app/studio/shell/window/window_painter.h"
#include "ui/gl/framebuffer.h"
#include "ui/scene/scene_renderer.h"

namespace taxel::studio {

/// From now on the first signal that asks the program to end (SIGTERM, SIGINT, SIGHUP) is only recorded, so that the
/// program can end in order; a second signal of the same kind ends the program at once.
void record_end_signals();

/// The number of the first recorded signal, or 0.
[[nodiscard]] int end_signal();

/// Applies the settings and arrangements that an earlier program kept. Files that cannot be read are set aside, with a
/// message.
void load_settings(const Options& options, Window& window, ui::App& app);
/// Keeps the settings, the place of the window and the arrangements for the next program. Prints why if that fails.
void save_settings(const Options& options, Window& window, ui::App& app);

/// Pictures of the examples as textures, for the card that invites to open something.
class ExamplePictures {
 public:
  /// Decodes the embedded pictures. Needs the context of OpenGL, and must be destroyed before that.
  ExamplePictures();
  /// Returns a tile for each example that has a picture. The textures live as long as this object.
  [[nodiscard]] const std::vector<ui::ExampleTile>& tiles() const { return tiles_; }

 private:
  std::vector<std::unique_ptr<gl::Texture>> textures_;
  std::vector<ui::ExampleTile> tiles_;
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
  /// Results that last beyond a frame.
  struct Outcome {
    bool has_opened = false, refused_argument = false;
    float themed_scale = 0;  ///< scale of the interface for which the theme was applied
  };

  /// Displays a script's first frames, so that its first line finds the window complete and the samples polished.
  void show_first_frames();
  [[nodiscard]] std::vector<InputEvent> next_events(const ScriptStage& stage, bool is_frame_likely);
  void show_frame(const ScriptStage& stage);
  void take(const std::vector<InputEvent>& events);
  void handle_events(const HostEvents& events);
  void draw_picture();
  void draw_contents();
  void fill_window();  ///< draws the interface that was laid out last
  /// Carries out the commands that were posted in this frame, in order.
  void carry_out_commands();
  /// Opens the desktop's file dialog if it is requested, and acts on its reply.
  void update_desktop_dialog();
  void finish_outputs();
  void save_screenshot(const std::string& file);
  void save_numbered_screenshot();
  void save_state(const std::string& file);
  [[nodiscard]] std::string state() const;
  [[nodiscard]] gl::RgbImage window_picture();  ///< draws the window as it was laid out last
  [[nodiscard]] bool input_taken() const;
  [[nodiscard]] double waiting_time() const;
  /// Whether something is under way that ends without an input.
  [[nodiscard]] bool is_waiting() const;
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
  Host host_;
  std::unique_ptr<ScriptPlayer> script_;
  InputQueue input_queue_;
  FramePacing pacing_;
  ui::DesktopDialog desktop_dialog_{os::make_file_chooser()};
  Outcome outcome_;
};

}  // namespace taxel::studio
