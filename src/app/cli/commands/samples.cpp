// taxel samples: prints the samples of a layout and the receptive fields over them.
#include <fmt/format.h>

#include <memory>

#include "app/cli/command_layout.h"
#include "app/cli/report_writer.h"
#include "core/base/files.h"
#include "core/sensor/samples_csv.h"

namespace taxel::cli {
namespace {

struct SamplesOptions {
  std::string layout;
  std::string out;
  std::string fields;
  LayoutOptions over;
};

struct SamplesReport {
  std::string name;           ///< name of the layout
  int samples = 0, used = 0;  ///< numbers of samples: all, and those that a taxel uses
  int shared = 0;             ///< number of samples that several taxels use
  double area = 0;            ///< area of the sampled surface [m^2]
  double density = 0;         ///< requested density [1/m^2]
  std::uint64_t seed = 0;
  struct TaxelRow {
    int id = 0;
    std::string name;
    int samples = 0;
  };
  std::vector<TaxelRow> taxels;

  explicit SamplesReport(const SensorModel& model)
      : name(model.layout.name),
        samples(static_cast<int>(model.samples.size())),
        area(model.sampled_area),
        density(model.layout.sampling.density),
        seed(model.layout.sampling.seed) {
    for (const std::vector<int>& users : model.taxels_of_sample) {
      used += users.empty() ? 0 : 1;
      shared += users.size() > 1 ? 1 : 0;
    }
    for (std::size_t k = 0; k < model.layout.taxels.size(); ++k) {
      const Taxel& taxel = model.layout.taxels[k];
      taxels.push_back({taxel.id, taxel.name, model.fields.first[k + 1] - model.fields.first[k]});
    }
  }
  void visit(ReportWriter& w) const {
    w("layout", name);
    w("samples", samples);
    w("used", used);
    w("shared", shared);
    w("area", area);
    w("density", density);
    w("seed", seed);
    w.list("taxels", taxels, [](ReportWriter& one, const TaxelRow& taxel) {
      one("id", taxel.id);
      one("name", taxel.name);
      one("samples", taxel.samples);
    });
  }
  [[nodiscard]] std::string text() const {
    std::string text =
        fmt::format("{} samples on {} m^2 (density {} per m^2, seed {}), {} used, {} by several taxels\n", samples,
                    area, density, seed, used, shared);
    text += fmt::format("{:>6} {:<16} {:>8}\n", "taxel", "name", "samples");
    for (const TaxelRow& taxel : taxels)
      text += fmt::format("{:>6} {:<16} {:>8}\n", taxel.id, taxel.name, taxel.samples);
    return text;
  }
};

int run_samples_command(const SamplesOptions& options, Console& console) {
  std::vector<int> file_face_of;
  const SensorModelPtr model = load_model(options.layout, options.over, console, &file_face_of);
  if (!options.out.empty()) write_file_atomically(options.out, samples_to_csv(*model, file_face_of));
  if (!options.fields.empty()) write_file_atomically(options.fields, fields_to_csv(*model));
  if (!console.json() && options.out.empty() && options.fields.empty())
    console.result(samples_to_csv(*model, file_face_of));
  else
    print_report(console, SamplesReport(*model));
  return kDone;
}

}  // namespace

Run add_samples(OptionList& list) {
  const auto options = std::make_shared<SamplesOptions>();
  list.add("LAYOUT", &options->layout, "Layout file (*.taxels.json)", required());
  list.add("--out", &options->out,
           "Write x,y,z,nx,ny,nz,face,area,id,used: position [m] and normal in the frame of the mesh file, triangle "
           "of that file from 0 (-1: filled in by its repair), area of the sample [m^2], number, whether a "
           "taxel uses it (default: stdout)",
           {.unit = "FILE"});
  list.add("--fields", &options->fields,
           "Write sample,taxel,distance,weight: number of the sample, id of the taxel, distance [m], weight [m^2]",
           {.unit = "FILE"});
  add_skin(list, options->over.skin);
  add_sampling(list, options->over);
  list.add("--preview", &options->over.preview,
           "Quick samples, not polished: the same number, less even, each with the same area");
  return [options](Console& console) { return run_samples_command(*options, console); };
}

}  // namespace taxel::cli
