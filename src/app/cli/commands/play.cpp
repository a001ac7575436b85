// taxel play: runs any scenario around any layout.
#include <memory>

#include "app/cli/played_scenario.h"
#include "core/document/scenario/scenario.h"

namespace taxel::cli {
namespace {

struct PlayOptions {
  std::string scenario, layout, out;
  LayoutOptions over;
  ExtraFiles extra;
  bool error_bars = false;
};

}  // namespace

Run add_play(OptionList& list) {
  const auto options = std::make_shared<PlayOptions>();
  list.add("scenario", &options->scenario,
           "Scenario file (docs/project_format.md), or a sweep.json or scenario.json; relative file names in it are "
           "relative to its folder",
           {.unit = "FILE", .is_required = true});
  list.add("--layout", &options->layout, "Layout file (*.taxels.json; default: the built-in fingertip)",
           {.unit = "FILE"});
  list.add("--out", &options->out,
           "Folder for the files that `taxel sweep` writes, with scenario.json in place of sweep.json",
           {.unit = "DIR"});
  add_extra_files(list, options->extra);
  add_error_bars(list, options->error_bars);
  add_skin(list, options->over.skin);
  add_sampling(list, options->over);
  add_readout(list, options->over.readout);
  return [options](Console& console) {
    return play({"play", "scenario.json", read_scenario_with_files(options->scenario), options->layout, options->over,
                 options->out, options->extra, options->error_bars},
                console);
  };
}

}  // namespace taxel::cli
