#include "core/sim/study.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <thread>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/parallel.h"
#include "core/document/batch/job.h"
#include "core/document/batch/job_sources.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/mesh_io.h"
#include "core/run/batch/study_of_batch.h"
#include "core/sim/batch/run_batch.h"

namespace taxel {

void run_study(const std::vector<StudyRun>& runs, const StudyModel& model, const StudyStep& on_step,
               const StudyEnd& on_end, Progress& progress) {
  const auto together = static_cast<std::size_t>(std::max(1, tbb::this_task_arena::max_concurrency()));
  for (std::size_t first = 0; first < runs.size(); first += together) {
    progress.check(static_cast<double>(first) / static_cast<double>(runs.size()));
    std::vector<std::unique_ptr<Simulator>> batch(std::min(together, runs.size() - first));
    for (std::size_t k = 0; k < batch.size(); ++k) {
      const SensorModelPtr sensor = model(first + k);
      try {
        if (sensor) batch[k] = Simulator::make_scenario(sensor, runs[first + k].scenario);
      } catch (const Error& e) {
        on_end(first + k, e.what());
      }
    }
    parallel_chunks(static_cast<int>(batch.size()), 1, [&](int begin, int) {
      const auto k = static_cast<std::size_t>(begin);
      if (!batch[k]) return;
      std::string error;
      try {
        bool is_running = true;
        while (is_running && !batch[k]->finished()) {
          progress.stop_if_cancelled();
          batch[k]->step();
          is_running = on_step(first + k, *batch[k]);
        }
      } catch (const Error& e) {
        error = e.what();
      }
      on_end(first + k, error);
      batch[k].reset();
    });
  }
  progress.check(1);
}

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

BatchCounts save_study(const StudyToSave& what, Progress& progress) {
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
  if (result.was_complete) throw Error(what.folder.string(), "has the batch of this study already");
  return std::move(result.counts);
}

}  // namespace taxel
