#include "app/cli/command_layout.h"

#include <fmt/format.h>

#include <sstream>
#include <string_view>

#include "app/cli/signals.h"
#include "core/base/error.h"
#include "core/base/limits.h"
#include "core/base/text/expression.h"
#include "core/document/paper_setting.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/sampling/poisson_disk.h"
#include "core/layout/words.h"
#include "core/mesh/mesh_io.h"
#include "core/sensor/layout_source.h"

namespace taxel::cli {
namespace {

/// Returns a check for one of the words of an enumeration.
template <class Enum>
Check one_word_of() {
  return {[](const std::string& text) {
            return from_word<Enum>(text) ? std::string()
                                         : fmt::format("must be one of {}, is {}", word_list<Enum>(), text);
          },
          ""};
}

}  // namespace

dvec3 parse_scale(const std::string& command, const std::string& text) {
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    const double number = finite_number(word).value_or(0);
    if (number == 0)
      throw Error(command, "--scale", fmt::format("must be one number or three, none of them 0, is {}", text));
    numbers.push_back(number);
  }
  if (numbers.size() != 1 && numbers.size() != 3)
    throw Error(command, "--scale", fmt::format("must be one number or three, is {}", text));
  return numbers.size() == 3 ? dvec3(numbers[0], numbers[1], numbers[2]) : dvec3(numbers[0]);
}

void add_skin(OptionList& list, SkinChoice& choice) {
  list.add("--mesh", &choice.mesh,
           "Mesh of a layout without one, as other programs write them; replaces the mesh of other layouts",
           {.unit = "FILE"});
  const auto read_scale = [command = list.command(), &choice](const std::string& text) {
    choice.scale = parse_scale(command, text);
  };
  list.add("--scale", read_scale,
           "Multiply coordinates of --mesh by one number, or by three: X,Y,Z (0.001 for mm; default: the unit in which "
           "the taxels are on the mesh)",
           {.unit = "X"});
  const auto read_unit = [&choice](const std::string& text) {
    choice.unit = number_in(*unit_named(text), Quantity{1, 1, 0, kLength});
  };
  list.add("--unit", read_unit, "Unit of the lengths in a layout file of another program that names none (default: m)",
           {.unit = "UNIT", .check = one_of({"m", "cm", "mm", "in"})});
  list.add("--sensor", &choice.sensor, "Sensor of a file that holds several: its name, or that of its geom or link",
           {.unit = "NAME"});
}

void add_sampling(OptionList& list, LayoutOptions& options) {
  list.add("--density", &options.density, "Samples per square metre (default: the layout's)",
           {.unit = "PER_M2", .check = positive()});
  list.add("--seed", &options.seed, "Seed of the samples (default: the layout's)",
           {.unit = "N", .check = whole_number()});
}

void add_extra_files(OptionList& list, ExtraFiles& extra) {
  list.add("--tactile-state", &extra.tactile_state,
           "Also tactile_state.jsonl in the folder of --out: a line for each row with the fields of ROS's "
           "tactile_msgs/TactileState; a channel for each sensor, calibrated if its layout has a calibration",
           {.needs = {"--out"}});
}

void add_error_bars(OptionList& list, bool& error_bars) {
  list.add("--error-bars", &error_bars,
           "Also measure an error bar of each reading: columns taxel_<id>_error of readings.csv and the array "
           "readings_error of readings.npz. Readings of samples are compared with their exact integral, exact readings "
           "with those of bodies whose edges are half as long (docs/theory.md)");
}

void add_readout(OptionList& list, ReadoutChoice& readout) {
  list.add("--aggregate", [&readout](const std::string& text) { readout.aggregate = from_word<Aggregate>(text); },
           "How a taxel's samples make its reading (default: the layout's): " + aggregate_help(),
           {.unit = "WORD", .check = one_word_of<Aggregate>()});
  list.add(
      "--method", [&readout](const std::string& text) { readout.method = from_word<ReadingMethod>(text); },
      "How the reading is computed (default: the layout's, or samples for an aggregate that has no integral): "
      "\"samples\" casts a ray from each sample, as in the paper, \"exact\" integrates weighted_mean, mean or force "
      "over the contact polygons",
      {.unit = "WORD", .check = one_word_of<ReadingMethod>()});
}

std::string_view embedded_file(std::string_view name);

namespace {

/// A layout with its mesh, from a file or from the program.
struct Source {
  Layout layout;
  LoadedMesh mesh;
  std::string name;
  std::vector<std::string> notes = {};  ///< losses in the import of another program's layout
};

Source read_source(const std::string& layout_file, const SkinChoice& skin) {
  if (layout_file.empty()) {
    if (skin != SkinChoice{}) throw Error("--mesh, --scale and --sensor go with --layout");
    const std::string name = "fingertip.taxels.json";
    return {parse_layout(std::string(embedded_file("assets/layouts/fingertip.taxels.json")), name),
            read_mesh(embedded_file("assets/meshes/fingertip.obj"), "fingertip.obj"), name};
  }
  ImportedSource read = read_any_source(layout_file, skin);
  return {std::move(read.source.layout), std::move(read.source.mesh), layout_file, std::move(read.notes)};
}

/// Prints the memory of many samples before they are made. The area of the loaded mesh is an upper limit of the sampled
/// area.
void announce_samples(const Source& source, Console& console) {
  const double count = source.layout.sampling.density * source.mesh.mesh->area();
  if (count > kManySamples && count <= kMaxSamples)
    console.note(fmt::format(
        "{}: /sampling/density: {} per square metre gives up to {:.3g} samples, which need about {:.1f} GiB of memory",
        source.name, source.layout.sampling.density, count, count * kBytesPerSample / (1U << 30U)));
}

/// Builds the model and shows its progress.
SensorModelPtr build_with_progress(const Source& source, SampleQuality quality, SensorCache* cache, Console& console) {
  return with_progress(console, [&](Progress& progress) {
    SensorBuild how(&progress);
    how.quality = quality;
    how.cache = cache;
    return build_sensor_model(source.layout, source.mesh.mesh, source.mesh.sha256, source.name, how);
  });
}

}  // namespace

DefaultLayout default_source() {
  Source source = read_source("", {});
  return {{source.name, std::move(source.layout), std::move(source.mesh)},
          std::string(embedded_file("assets/meshes/fingertip.obj"))};
}

SensorModelPtr load_model(const std::string& layout_file, const LayoutOptions& over, Console& console,
                          std::vector<int>* file_face_of, SensorCache* cache) {
  Source source = read_source(layout_file, over.skin);
  if (over.as_in_the_paper) source.layout = as_in_the_paper(std::move(source.layout));
  source.layout.sampling.density = over.density.value_or(source.layout.sampling.density);
  source.layout.sampling.seed = over.seed.value_or(source.layout.sampling.seed);
  source.layout.readout = over.readout.applied_to(source.layout.readout);
  announce_samples(source, console);
  const SensorModelPtr model =
      build_with_progress(source, over.preview ? SampleQuality::preview : SampleQuality::polished, cache, console);
  for (const std::string& note : source.notes) console.note(source.name + ": " + note);
  for (const std::string& note : source.mesh.notes) console.note(source.name + ": /mesh/file: " + note);
  console.report(model->problems);
  if (file_face_of != nullptr) *file_face_of = std::move(source.mesh.file_face_of);
  return model;
}

}  // namespace taxel::cli
