// taxel play: any scenario around any layout.
#include <filesystem>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/played_scenario.h"
#include "core/document/scenario/scenario_json.h"

namespace taxel::cli {
namespace {

struct Options {
  std::string scenario, layout, out;
  LayoutOptions over;
  bool tactile_state = false;
};

}  // namespace

Command add_play(CLI::App& parent, CommonOptions& common) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(parent, common, "play",
                              "A scenario (sweep, press, roll, twist, slide, drop, path or replay) around a layout",
                              "taxel play press.json --layout finger.taxels.json --out result");
  app->add_option("scenario", options->scenario,
                  "Scenario file (docs/project_format.md), or a sweep.json or scenario.json; what it names is looked "
                  "for beside it")
      ->required()
      ->type_name("FILE");
  app->add_option("--layout", options->layout, "Layout file (*.taxels.json; default: the built-in fingertip)")
      ->type_name("FILE");
  app->add_option("--out", options->out,
                  "Folder for the files that `taxel sweep` writes, with scenario.json in place of sweep.json")
      ->type_name("DIR");
  add_tactile_state(*app, options->tactile_state);
  add_skin(*app, options->over.skin);
  add_sampling(*app, options->over);
  add_aggregate(*app, options->over.aggregate);
  return {app, [options](Console& console) {
            return play({"play", "scenario.json", read_scenario_with_files(options->scenario), options->layout,
                         options->over, options->out, options->tactile_state},
                        console);
          }};
}

}  // namespace taxel::cli
