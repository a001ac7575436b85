#include "core/sim/batch/job_package.h"

#include "core/base/error.h"
#include "core/layout/file/layout_json.h"
#include "core/mesh/mesh_io.h"
#include "core/run/batch/shard.h"
#include "core/sim/batch/run_batch.h"

namespace taxel {
namespace {

using Files = std::map<std::string, std::string>;

void add_file(const std::string& file, JobSources& sources, Files& files) {
  files.try_emplace(file, sources.file_sha256(file));
}

void add_scenario_files(Scenario scenario, JobSources& sources, Files& files) {
  for (const auto& [key, file] : files_of(scenario))
    if (!file->empty()) add_file(*file, sources, files);
}

/// Adds the mesh of a job's layout file, and the mesh of its changed layout.
void add_meshes(const Job& job, JobSources& sources, Files& files) {
  const SensorSource& source = sources.source(job.layout);
  if (!job.layout.empty()) add_file(mesh_path(source.layout, source.file).string(), sources, files);
  const Layout changed = sources.changed_layout(job.layout, job.changes);
  if (changed.mesh.file != source.layout.mesh.file) add_file(mesh_path(changed, source.file).string(), sources, files);
}

/// Replaces the names of copies by the names where the list is.
std::string with_original_names(std::string text, const Files& files) {
  for (const auto& [original, copy] : files)
    for (std::size_t at = text.find(copy); at != std::string::npos; at = text.find(copy, at + original.size()))
      text.replace(at, copy.size(), original);
  return text;
}

/// Makes the layout of a package known to the sources, if it is new.
void put_source(const JobPackage& package, JobSources& sources) {
  for (const auto& [original, copy] : package.files) sources.put_copy(original, copy);
  if (!package.source || package.jobs.empty()) return;
  const std::string& path = package.jobs.front().layout;
  if (sources.has_source(path)) return;
  SensorSource source;
  source.file = package.source->file;
  source.layout = parse_layout(package.source->layout_json, source.file);
  source.mesh = load_mesh(sources.copy_of(mesh_path(source.layout, source.file)), source.layout.mesh.scale);
  sources.put_source(path, std::move(source));
}

}  // namespace

JobPackage pack_group(const JobList& list, const JobGroup& group, const BatchFormat& format, JobSources& sources) {
  if (list.of_scenes) throw Error("a group of scenes cannot be packed: the files of a scene do not travel");
  JobPackage package;
  package.group = group.id;
  package.format = format;
  for (const std::size_t index : group.jobs) {
    package.jobs.push_back(list.jobs[index]);
    add_scenario_files(list.jobs[index].scenario, sources, package.files);
  }
  add_meshes(package.jobs.front(), sources, package.files);
  const std::string& layout = package.jobs.front().layout;
  if (!layout.empty()) package.source = PackedSource{sources.source(layout).file, sources.layout_json(layout)};
  return package;
}

std::string run_package(const JobPackage& package, JobSources& sources, JobRunner& runner, const JobWatch& watch) {
  put_source(package, sources);
  std::vector<Job> jobs = package.jobs;
  std::vector<const Job*> pointers;
  for (Job& job : jobs) {
    job.layout = jobs.front().layout;  // other jobs may reach the layout of the group from another file
    job.changes = jobs.front().changes;
    for (const auto& [key, file] : files_of(job.scenario)) *file = sources.copy_of(*file).string();
    pointers.push_back(&job);
  }
  GroupResult result = runner.run(package.group, pointers, package.format, watch);
  for (JobOutcome& outcome : result.head.outcomes) outcome.error = with_original_names(outcome.error, package.files);
  return shard_bytes(result, package.format);
}

std::string failed_shard(const JobPackage& package, const std::string& reason) {
  GroupResult result;
  result.head.group = package.group;
  for (const Job& job : package.jobs) {
    JobOutcome& outcome = result.head.outcomes.emplace_back();
    outcome.id = job.id;
    outcome.error = reason;
  }
  return shard_bytes(result, package.format);
}

}  // namespace taxel
