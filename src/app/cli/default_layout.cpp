#include "app/cli/default_layout.h"

#include <fmt/format.h>

#include <string_view>

#include "app/cli/signals.h"
#include "core/base/limits.h"
#include "core/document/paper_setting.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/sampling/poisson_disk.h"
#include "core/mesh/mesh_io.h"
#include "core/sensor/imported_source.h"

namespace taxel::cli {

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
