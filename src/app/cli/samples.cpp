// taxel samples: the samples of a layout and the receptive fields over them.
#include <fmt/format.h>

#include <iterator>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/default_layout.h"
#include "app/cli/samples_report.h"
#include "core/base/files.h"

namespace taxel::cli {
namespace {

struct Options {
  std::string layout;
  std::string out;
  std::string fields;
  LayoutOptions over;
};

/// `file_face_of`: for each face of the model's mesh its number in the file.
std::string samples_csv(const SensorModel& model, const std::vector<int>& file_face_of) {
  std::string text = "x,y,z,nx,ny,nz,face,area,id,used\n";
  auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < model.samples.size(); ++i) {
    const SurfaceSample& s = model.samples[i];
    const auto face = static_cast<std::size_t>(model.skin_face_of[static_cast<std::size_t>(s.face)]);
    fmt::format_to(out, "{},{},{},{},{},{},{},{},{},{}\n", s.position.x, s.position.y, s.position.z, s.normal.x,
                   s.normal.y, s.normal.z, file_face_of[face], s.area, i, model.taxels_of_sample[i].empty() ? 0 : 1);
  }
  return text;
}

std::string fields_csv(const SensorModel& model) {
  std::string text = "sample,taxel,distance,weight\n";
  auto out = std::back_inserter(text);
  for (std::size_t k = 0; k < model.layout.taxels.size(); ++k) {
    for (int e = model.fields.first[k]; e < model.fields.first[k + 1]; ++e) {
      const ReceptiveFields::Entry& entry = model.fields.entries[static_cast<std::size_t>(e)];
      fmt::format_to(out, "{},{},{},{}\n", entry.sample, model.layout.taxels[k].id, entry.distance, entry.weight);
    }
  }
  return text;
}

int run(const Options& options, Console& console) {
  std::vector<int> file_face_of;
  const SensorModelPtr model = load_model(options.layout, options.over, console, &file_face_of);
  if (!options.out.empty()) write_file_atomically(options.out, samples_csv(*model, file_face_of));
  if (!options.fields.empty()) write_file_atomically(options.fields, fields_csv(*model));
  const SamplesReport report = report_samples(*model);
  if (console.json()) {
    console.result(samples_json(report));
  } else if (options.out.empty() && options.fields.empty()) {
    console.result(samples_csv(*model, file_face_of));
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
         "of that file from 0, area the sample stands for [m^2], number, whether a taxel uses it (default: stdout)")
      ->type_name("FILE");
  app->add_option(
         "--fields", options->fields,
         "Write sample,taxel,distance,weight: number of the sample, id of the taxel, distance [m], weight [m^2]")
      ->type_name("FILE");
  add_sampling(*app, options->over);
  app->add_flag("--preview", options->over.preview,
                "Quick samples, not polished: the same number, less even, each standing for the same area");
  return {app, [options](Console& console) { return run(*options, console); }};
}

}  // namespace taxel::cli
