// taxel samples: the samples of a layout and the receptive fields over them.
#include <memory>

#include "app/cli/command.h"
#include "app/cli/default_layout.h"
#include "app/cli/samples_report.h"
#include "core/base/files.h"
#include "core/sensor/samples_csv.h"

namespace taxel::cli {
namespace {

struct Options {
  std::string layout;
  std::string out;
  std::string fields;
  LayoutOptions over;
};

int run(const Options& options, Console& console) {
  std::vector<int> file_face_of;
  const SensorModelPtr model = load_model(options.layout, options.over, console, &file_face_of);
  if (!options.out.empty()) write_file_atomically(options.out, samples_to_csv(*model, file_face_of));
  if (!options.fields.empty()) write_file_atomically(options.fields, fields_to_csv(*model));
  const SamplesReport report = report_samples(*model);
  if (console.json()) {
    console.result(samples_json(report));
  } else if (options.out.empty() && options.fields.empty()) {
    console.result(samples_to_csv(*model, file_face_of));
  } else {
    console.result(samples_text(report));
  }
  return kDone;
}

}  // namespace

Command add_samples(CLI::App& parent, CommonOptions& common) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(parent, common, "samples", "Samples and receptive fields of a layout",
                              "taxel samples finger.taxels.json --out samples.csv --fields fields.csv");
  app->add_option("LAYOUT", options->layout, "Layout file (*.taxels.json)")->required()->option_text("(required)");
  app->add_option(
         "--out", options->out,
         "Write x,y,z,nx,ny,nz,face,area,id,used: position [m] and normal in the frame of the mesh file, triangle "
         "of that file from 0 (-1: filled in by its repair), area the sample stands for [m^2], number, whether a taxel "
         "uses it (default: stdout)")
      ->type_name("FILE");
  app->add_option(
         "--fields", options->fields,
         "Write sample,taxel,distance,weight: number of the sample, id of the taxel, distance [m], weight [m^2]")
      ->type_name("FILE");
  add_skin(*app, options->over.skin);
  add_sampling(*app, options->over);
  app->add_flag("--preview", options->over.preview,
                "Quick samples, not polished: the same number, less even, each standing for the same area");
  return {app, [options](Console& console) { return run(*options, console); }};
}

}  // namespace taxel::cli
