#include "app/studio/shell/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/help/help_options.h"
#include "app/help/option_values.h"
#include "app/version/version.h"
#include "core/base/error.h"
#include "core/base/text/message.h"
#include "core/mesh/formats/mesh_format.h"

namespace taxel::studio {

namespace {

/// Parses "1280x800" into two numbers. Returns the reason if that fails, otherwise an empty text.
std::string parse_size(const std::string& text, int& width_out, int& height_out) {
  const std::size_t x = text.find('x');
  const auto number = [](const std::string& digits) {
    const bool good =
        !digits.empty() && digits.size() <= 5 && digits.find_first_not_of("0123456789") == std::string::npos;
    return good ? std::stoi(digits) : 0;
  };
  const int width = number(text.substr(0, x)), height = x == std::string::npos ? 0 : number(text.substr(x + 1));
  constexpr int kLeast = 320, kMost = 16384;
  if (std::min(width, height) < kLeast || std::max(width, height) > kMost) {
    return "must be WIDTHxHEIGHT with 320 to 16384 pixels each, is " + text;
  }
  width_out = width;
  height_out = height;
  return {};
}

/// Prints why an option is refused. Returns the exit status.
int refuse(const char* option, const std::string& reason) {
  std::fprintf(stderr, "taxelstudio: %s: %s\n", option, reason.c_str());
  return 2;
}

/// An option that contradicts others, and why; null if none does.
struct Contradiction {
  const char* option = nullptr;
  std::string reason;
};

Contradiction contradiction(const Options& o) {
  if (o.demo && o.empty)
    return {"--demo", "plays the fingertip sweep, but --empty opens nothing: leave out one of them"};
  if (o.file.empty() || !(o.demo || o.empty)) return {};
  const char* const option = o.demo ? "--demo" : "--empty";
  return {option, fmt::format("{}, but FILE is {}: leave out {} to open the file",
                              o.demo ? "plays the fingertip sweep" : "opens nothing", o.file, option)};
}

std::string refuse_frames(const std::string& text) {
  const std::optional<int> frames = small_number(text);
  return frames && *frames >= 0 ? "" : fmt::format("must be a whole number of at least 0, is {}", text);
}

std::string refuse_folder(const std::string& text) {
  std::error_code ignored;
  return std::filesystem::is_directory(text, ignored) ? "" : fmt::format("must be a folder, is {}", text);
}

std::string refuse_interval(const std::string& text) {
  const std::optional<double> seconds = finite_number(text);
  return seconds && *seconds >= 0.01 && *seconds <= 30 ? "" : fmt::format("must be from 0.01 to 30, is {}", text);
}

/// Adds the options that lead a scene, as those of `taxel run`.
void add_lead(CLI::App& app, LeadRequest& lead) {
  app.add_option("--keyframe", lead.keyframe, "Start the scene at this keyframe: its name, or its number from 0")
      ->type_name("NAME|NUMBER")
      ->needs("FILE");
  app.add_option("--ctrl", lead.files.controls, "Lead actuators of the scene by a table, as `taxel run` does")
      ->type_name("TABLE")
      ->needs("FILE");
  CLI::Option* const mocap =
      app.add_option("--mocap", lead.files.mocaps, "Lead mocap bodies of the scene by a table, as `taxel run` does")
          ->type_name("TABLE")
          ->needs("FILE");
  app.add_option("--replay", lead.files.run, "Lead the first mocap body of the scene by a recorded run")
      ->type_name("RUN")
      ->needs("FILE")
      ->excludes(mocap);
}

/// Adds all options. Sizes are parsed later.
void add_options(CLI::App& app, Options& o, std::string& size, std::string& cut_out_size) {
  app.add_option("FILE", o.file,
                 "Project (.taxelproj), layout (.taxels.json, or of another program next to its mesh), mesh (" +
                     extensions(can_read) +
                     "), MuJoCo scene (.xml), saved step (.taxelframe), or batch.json of a study or its folder; "
                     "without one the fingertip sweep");
  app.add_option("--scenario", o.scenario,
                 "Begin with the scenario of this file (docs/project_format.md, a sweep.json or a scenario.json); a "
                 "project has its own");
  CLI::Option* const headless =
      app.add_flag("--headless", o.headless, "Draw offscreen; needs no display. Frames of 20 ms, not by the clock");
  app.add_flag(
         "--draw-saved", o.draws_saved_only,
         "With --headless: draw only frames that are saved as pictures, so that a script ends sooner; the state's "
         "frame rates are then those of the layout")
      ->needs(headless);
  CLI::Option* const script =
      app.add_option("--script", o.script, "Play input events and commands from a JSON-lines file");
  app.add_flag("--live", o.live, "The simulation follows the clock while the script plays: no two runs are the same")
      ->needs(script);
  app.add_flag("--desktop-dialog", o.desktop_dialog,
               "Use the desktop's own file dialog under a script too, if there is one")
      ->needs(script);
  app.add_option("--screenshot", o.screenshot, "Write the last picture as PNG");
  app.add_option("--cut-out", o.cut_out, "Write the last 3-D view alone as PNG with a transparent background");
  app.add_option("--cut-out-size", cut_out_size, "Its size in pixels")->default_str("2400x1800");
  app.add_option("--dump-state", o.dump_state, "Write the last state as JSON");
  app.add_option("--size", size, "Size of the window in pixels")->default_str("1280x800");
  add_rule(*add_number(app, "--frames", o.frames, "Stop after this number of frames (headless without a script: 60)"),
           app, refuse_frames, "NONNEGATIVE");
  add_rule(
      *app.add_option("--shader-dir", o.shader_dir, "Read the shaders from this folder instead of the built-in ones"),
      app, refuse_folder, "DIR");
  app.add_option("--plugins", o.plugins, "Load the plugin libraries of this folder first, for scenes that need them")
      ->type_name("DIR");
  add_lead(app, o.lead);
  app.add_flag("--empty", o.empty, "Open nothing, so without FILE");
  app.add_flag(
      "--demo", o.demo,
      "Play the contact of the fingertip sweep in a loop under a moving camera until the user pauses; a window "
      "without FILE and --empty does");
  app.add_flag("--tour", o.tour, "Begin with the tour of the window");
  app.add_option("--state-dir", o.state_dir, "Keep settings and unsaved edits in this folder");
  CLI::Option* const autosave =
      add_number(app, "--autosave-every", o.autosave_every, "Keep unsaved edits for recovery at least this often [s]");
  autosave->default_str("30");
  add_rule(*autosave, app, refuse_interval, "FLOAT in [0.01 - 30]");
  app.add_flag("--list-bindings", o.list_bindings, "Print all keys and mouse gestures");
  app.add_flag("--version", o.version, "Print the version, the commit and the libraries' versions");
}

}  // namespace

ParsedOptions parse_options(int argc, char** argv) {
  ParsedOptions parsed;
  Options& o = parsed.options;
  std::string size, cut_out_size;
  CLI::App app(
      "Taxel Studio: place taxels on a mesh, drive MuJoCo live, watch pressures and readings.\n"
      "Example: taxelstudio --headless --frames 60 --screenshot sweep.png",
      "taxelstudio");
  use_help_formatter(app);
  add_options(app, o, size, cut_out_size);
  add_help_options(app, versions().taxel);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    parsed.exit_status = app.exit(help);
    return parsed;
  } catch (const HelpText& help) {
    std::fputs(help.text.c_str(), stdout);
    parsed.exit_status = 0;
    return parsed;
  } catch (const CLI::ParseError& error) {
    const std::string message = usage_message(app, error, {argv + 1, argv + argc});
    std::fprintf(stderr, "taxelstudio: %s\n", message.c_str());
    parsed.exit_status = 2;
    return parsed;
  } catch (const Error& error) {
    std::fprintf(stderr, "taxelstudio: %s\n", shown_message(error).c_str());
    parsed.exit_status = 2;
    return parsed;
  }
  if (const auto [option, reason] = contradiction(o); option != nullptr) parsed.exit_status = refuse(option, reason);
  const auto take_size = [&](const char* option, const std::string& text, int& width, int& height) {
    const std::string reason = text.empty() ? "" : parse_size(text, width, height);
    if (!reason.empty()) parsed.exit_status = refuse(option, reason);
  };
  take_size("--size", size, o.width, o.height);
  o.has_size = !size.empty();
  take_size("--cut-out-size", cut_out_size, o.cut_out_width, o.cut_out_height);
  if (o.headless && o.script.empty() && o.frames == 0) o.frames = 60;
  const bool is_plain_start = o.file.empty() && o.scenario.empty() && !o.empty && o.script.empty() && !o.headless;
  o.demo = o.demo || is_plain_start;
  return parsed;
}

}  // namespace taxel::studio
