#include "core/sim/study/save_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/document/batch/job_list.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/mesh_io.h"
#include "core/run/data_set/study_of_data_set.h"
#include "core/sim/batch/run_batch.h"

namespace taxel {
namespace {

/// Returns the layout of a model with its mesh as an OBJ file: the file of the document may have changed.
DefaultLayout source_of(const SensorModel& model) {
  DefaultLayout from{{"", model.layout, {}}, write_obj(*model.loaded)};
  MeshRef& ref = from.source.layout.mesh;
  const std::string stem = std::filesystem::path(ref.file).stem().string();
  ref.file = (stem.empty() ? "mesh" : stem) + ".obj";
  ref.scale = dvec3(1.0);
  ref.sha256 = sha256_hex(from.mesh_bytes);
  from.source.mesh = read_mesh(from.mesh_bytes, ref.file);
  const TriMesh &written = *from.source.mesh.mesh, &loaded = *model.loaded;
  if (!std::ranges::equal(written.vertices(), loaded.vertices()) ||
      !std::ranges::equal(written.faces(), loaded.faces()))
    throw Error(ref.file,
                "the mesh has vertices without faces or several at one place, so that a copy would be another "
                "mesh: repair it (Inspector > Mesh)");
  return from;
}

/// Returns the jobs of a study. Throws Error if the study is not valid.
JobList jobs_of(const Study& study, const std::filesystem::path& folder, JobSources& sources) {
  JobList list = parse_job_list(job_line_of(study), "study", folder, sources);
  if (!list.broken.empty()) throw Error("study", list.broken.front().message);
  return list;
}

}  // namespace

DataSetCounts save_study(const StudyToSave& what, Progress& progress) {
  JobSources sources([&] { return source_of(*what.model); });
  const JobList list = jobs_of(what.study, std::filesystem::absolute(what.folder).parent_path(), sources);
  BatchSettings settings;
  settings.folder = what.folder;
  settings.format.float64 = true;
  settings.program = what.program;
  settings.workers = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  BatchWatch watch;
  watch.on_progress = [&](const BatchProgress& state) {
    progress.set(static_cast<double>(state.finished) / static_cast<double>(std::max<std::size_t>(1, state.jobs)));
  };
  watch.is_stopped = [&] { return progress.cancelled(); };
  BatchResult result = run_batch(list, sources, settings, watch);
  if (result.is_stopped) throw Cancelled{};
  if (result.was_complete) throw Error(what.folder.string(), "has the data set of this study already");
  return std::move(result.counts);
}

}  // namespace taxel
