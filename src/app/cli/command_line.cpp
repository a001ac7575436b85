// The table of all commands, and the parser of their options: the only file that includes CLI11, whose header takes
// longer to compile than any command.
#include "app/cli/command_line.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/help/help_options.h"
#include "app/help/option_values.h"
#include "app/version/version.h"
#include "core/base/error.h"

namespace taxel::cli {

// A new command is a file in commands/ and, here, its declaration and its row.

Run add_align(OptionList& list);
Run add_attach(OptionList& list);
Run add_batch(OptionList& list);
Run add_cache(OptionList& list);
Run add_check(OptionList& list);
Run add_contact(OptionList& list);
Run add_convert(OptionList& list);
Run add_explain(OptionList& list);
Run add_fit(OptionList& list);
Run add_generate(OptionList& list);
Run add_material(OptionList& list);
Run add_mesh(OptionList& list);
Run add_models(OptionList& list);
Run add_play(OptionList& list);
Run add_plot(OptionList& list);
Run add_presets(OptionList& list);
Run add_read(OptionList& list);
Run add_run(OptionList& list);
Run add_samples(OptionList& list);
Run add_study(OptionList& list);
Run add_sweep(OptionList& list);
Run add_validate(OptionList& list);

const std::vector<CommandSpec>& commands() {
  static const std::vector<CommandSpec> table{
      {"sweep", "The fingertip sweep of the paper: a finger slides over an edge that points up",
       "taxel sweep --layout finger.taxels.json --out result", add_sweep},
      {"play", "A scenario (sweep, press, roll, twist, slide, drop, path or replay) around a layout",
       "taxel play press.json --layout finger.taxels.json --out result", add_play},
      {"study", "A scenario with several values of one or two parameters, as many runs at a time as there are cores",
       "taxel study depths.json --layout finger.taxels.json --out result", add_study},
      {"batch", "A list of jobs (layout, scenario, changed parameters) on all cores; resumes if killed",
       "taxel batch jobs.jsonl --out data", add_batch},
      {"run", "Any MuJoCo scene, with the sensors it declares or a layout attached to a geom",
       "taxel run scene.xml --layout finger.taxels.json --geom fingertip --seconds 2 --out result", add_run},
      {"attach", "A MuJoCo scene with layouts on its geoms, as a patch: all else in the file keeps its bytes",
       "taxel attach hand.xml --body fingertip --layout finger.taxels.json --out sensed.xml", add_attach},
      {"contact", "One contact between two shapes at given poses",
       "taxel contact sphere_on_plane.json --polygons surface.csv --repeat 100", add_contact},
      {"read", "The readings of a layout in one contact, with every aggregate and its samples",
       "taxel read finger.taxels.json finger_on_box.json --json", add_read},
      {"explain",
       "Where a recorded reading comes from: its samples and polygons, the exact integral, the changes since the "
       "previous row, and whether the contact or the method caused them",
       "taxel explain result --taxel 3 --time 1.25", add_explain},
      {"align",
       "Aligns a recording of a real sensor with a run: finds the time shift, and gain and offset of each taxel by "
       "least squares",
       "taxel align result real.csv --map real.recmap.json --out aligned.csv", add_align},
      {"fit",
       "Fits radius, object, layer and gains to recorded presses of a real sensor, with errors, correlations and "
       "recordings that are held out",
       "taxel fit presses.csv --layout strip.taxels.json --case ball.json --free radius,x0,z0,gain --out fit", add_fit},
      {"models",
       "The contacts of a recording as other models of a taxel read them: a star field, the weighted sum, the exact "
       "integral, MuJoCo's <tactile> depth, one MuJoCo touch site for each taxel",
       "taxel models result --every 4 --out models.csv", add_models},
      {"plot", "Plots of a recorded run or study as SVG or PDF: readings over travel or time, heat map, forces",
       "taxel plot result --normalised --out figure_4.pdf", add_plot},
      {"samples", "Samples and receptive fields of a layout",
       "taxel samples finger.taxels.json --out samples.csv --fields fields.csv", add_samples},
      {"mesh", "Size, shells and problems of a mesh, and the changes by its repair",
       "taxel mesh finger.stl --scale 0.001 --out finger.obj", add_mesh},
      {"material",
       "The modulus of a pad from Young's modulus, Poisson's ratio and thickness, or from a known elastomer",
       "taxel material --preset ecoflex-00-30 --thickness 0.002 --bonded --contact-radius 0.003", add_material},
      {"presets", "Layouts of known sensors, with the sources of their numbers",
       "taxel presets biotac --out biotac.taxels.json", add_presets},
      {"generate", "A layout by a pattern of taxels on a mesh, or layouts on the meshes of a scene's bodies",
       "taxel generate finger.stl --pattern hexagonal --pitch 4mm --out finger.taxels.json", add_generate},
      {"check", "Every problem of layouts, contact cases, sweeps, meshes and scenes, with its JSON pointer",
       "taxel check finger.taxels.json", add_check},
      {"convert",
       "A layout of any format in another format, with a note on each value that is lost or assumed; a recorded run as "
       "messages",
       "taxel convert probes.json finger.taxels.json --link finger --mesh finger.stl", add_convert},
      {"cache", "The samples that this program keeps on disk, so that a layout compiles faster the next time",
       "taxel cache --clear", add_cache},
      {"validate", "Contact and sensing against closed forms: computed, exact, error, bound",
       "taxel validate --markdown > docs/validation.md", add_validate}};
  return table;
}

namespace {

/// A rule for finite numbers.
template <class Rule>
Check number(const char* expected, const Rule& rule) {
  return {[expected, rule](const std::string& text) {
            const std::optional<double> value = finite_number(text);
            return value && rule(*value) ? std::string() : fmt::format("must be {}, is {}", expected, text);
          },
          ""};
}

CLI::Option* add_value(CLI::App& app, const std::string& name, const OptionValue& value, const std::string& help) {
  return std::visit(
      [&](const auto& target) -> CLI::Option* {
        using Target = std::decay_t<decltype(target)>;
        if constexpr (std::is_same_v<Target, bool*>) {
          return app.add_flag(name, *target, help);
        } else if constexpr (std::is_same_v<Target, std::vector<std::string>*>) {
          CLI::Option* option = app.add_option(name, *target, help);
          return name.starts_with("-") ? option->expected(1)->take_all() : option;
        } else if constexpr (std::is_same_v<Target, std::string*>) {
          return app.add_option(name, *target, help);
        } else if constexpr (std::is_pointer_v<Target>) {
          return add_number(app, name, *target, help);
        } else {
          return app.add_option_function<std::string>(name, target, help);
        }
      },
      value);
}

}  // namespace

Check positive() {
  return number("greater than 0", [](double v) { return v > 0; });
}
Check not_negative() {
  return number("0 or more", [](double v) { return v >= 0; });
}
Check finite() {
  return number("a finite number", [](double) { return true; });
}

Check whole_number() {
  return {[](const std::string& text) {
            return natural_number(text) ? std::string()
                                        : fmt::format("must be a whole number from 0 to 2^64 - 1, is {}", text);
          },
          ""};
}

Check positive_number() {
  return {positive().problem, "POSITIVE"};
}

Check in_range(int low, int high) {
  return {[low, high](const std::string& text) {
            const std::optional<int> value = small_number(text);
            return value && *value >= low && *value <= high
                       ? std::string()
                       : fmt::format("must be a whole number from {} to {}, is {}", low, high, text);
          },
          fmt::format("INT in [{} - {}]", low, high)};
}

Check one_of(const std::vector<std::string>& words) {
  return {one_of_words(words), list_of_words(words)};
}

OptionRules required() {
  return {.text = "(required)", .is_required = true};
}

void OptionList::add(const std::string& name, const OptionValue& value, const std::string& help,
                     const OptionRules& rules) {
  CLI::Option* option = add_value(app_, name, value, help);
  if (!rules.unit.empty()) option->type_name(rules.unit);
  if (!rules.text.empty()) option->option_text(rules.text);
  if (!rules.default_text.empty()) option->default_str(rules.default_text);
  if (rules.check) add_rule(*option, app_, rules.check->problem, rules.check->text);
  option->required(rules.is_required);
  for (const std::string& other : rules.needs) option->needs(app_.get_option(other));
  for (const std::string& other : rules.excludes) option->excludes(app_.get_option(other));
}

std::string OptionList::command() const {
  return app_.get_name();
}

namespace {

/// A subcommand of `parent` with the options that every command has.
CLI::App* add_command(CLI::App& parent, CommonOptions& common, const CommandSpec& spec) {
  CLI::App* app = parent.add_subcommand(spec.name, spec.text);
  OptionList list(*app);
  list.add("--json", &common.json, "The result on stdout as one JSON object");
  list.add("--quiet", &common.quiet, "No messages and no progress bar on stderr");
  list.add("--threads", &common.threads, "At most this many threads (default: all cores); results do not depend on it",
           {.text = "N", .check = in_range(1, 4096)});
  app->footer(
      fmt::format("Lengths in metres, forces in newtons, pressures in pascals, angles in degrees if stated.\n"
                  "Example: {}",
                  spec.example));
  return app;
}

/// Throws Error for the first option or argument with an empty value. An unset shell variable leaves such a value, and
/// it must not mean the same as an option that is not given.
void refuse_empty_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    for (const std::string& value : option->results())
      if (value.empty())
        throw Error(command.get_name(), option->get_name(), "must not be empty; leave the option out for its default");
}

Run printed(const std::string& text) {
  return [text](Console& console) {
    console.result(text);
    return kDone;
  };
}

}  // namespace

ParsedCommandLine parse_command_line(int argc, char** argv) {
  CLI::App program("Tactile sensing with hydroelastic contact in MuJoCo: the core of Taxel Studio without a window.",
                   "taxel");
  use_help_formatter(program);
  program.set_version_flag("--version", version_line("taxel"), "Display program version information and exit");
  add_help_options(program, versions().taxel);
  program.require_subcommand(1);
  program.footer(
      "`taxel COMMAND --help` shows a command's options, units and an example.\n"
      "Exit status: 0 done; 1 done, and problems were found (check, validate) or some runs failed (batch, study); "
      "2 bad\nusage or bad input; 128 + N ended by signal N, after writing the results so far.");
  CommonOptions common;
  std::vector<CLI::App*> apps;
  std::vector<Run> runs;
  for (const CommandSpec& spec : commands()) {
    apps.push_back(add_command(program, common, spec));
    OptionList list(*apps.back());
    runs.push_back(spec.add(list));
  }
  const auto chosen = [&] { return std::find_if(apps.begin(), apps.end(), [](auto* app) { return app->parsed(); }); };
  try {
    program.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return {printed(chosen() == apps.end() ? program.help() : (*chosen())->help("taxel")), common};
  } catch (const CLI::CallForVersion&) {
    return {printed(version_line("taxel") + "\n"), common};
  } catch (const HelpText& help) {
    return {printed(help.text), common};
  } catch (const CLI::ParseError& e) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (chosen() == apps.end()) throw Error(usage_message(program, e, words));
    throw Error((*chosen())->get_name(), usage_message(**chosen(), e, words));
  }
  refuse_empty_values(**chosen());
  return {runs[static_cast<std::size_t>(chosen() - apps.begin())], common};
}

}  // namespace taxel::cli
