// A group of jobs as it travels to another machine: all values that its runs depend on, and the names of the files
// whose bytes travel apart. The bytes of the shard do not depend on the machine.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/document/batch/job.h"
#include "core/document/batch/job_sources.h"
#include "core/run/batch/episode.h"

namespace taxel {

class JobRunner;
struct JobWatch;

/// The layout of a group, as read by the machine that expands the list.
struct PackedSource {
  std::string file;         ///< name of the layout file in messages
  std::string layout_json;  ///< layout in our own format, also if the file has the format of another program
};

struct JobPackage {
  std::string group;  ///< JobGroup::id
  BatchFormat format;
  std::optional<PackedSource> source;  ///< empty for the default layout
  std::vector<Job> jobs;               ///< a job with an error is not run; the shard has the error as its reason
  /// Files that the jobs read, by their absolute paths where the list is. The values are SHA-256 in a package that was
  /// made by pack_group(), and paths of copies in a package that run_package() gets.
  std::map<std::string, std::string> files;
};

/// Packs a group of a list. Throws Error naming a file that cannot be read, and for scenes.
JobPackage pack_group(const JobList& list, const JobGroup& group, const BatchFormat& format, JobSources& sources);

/// Runs the jobs of a package, and returns the bytes of their shard: the same as for the group on the machine of the
/// list. `sources` are those of `runner`; they keep layouts and meshes for later packages of the same list. Throws
/// Error if a copy of a mesh cannot be read, BatchStopped, and the errors of `watch`.
std::string run_package(const JobPackage& package, JobSources& sources, JobRunner& runner, const JobWatch& watch);

/// Returns the bytes of the shard of a group whose jobs all have failed with the same reason.
std::string failed_shard(const JobPackage& package, const std::string& reason);

/// Returns one line of JSON.
std::string package_to_json(const JobPackage& package);
/// Parses package_to_json(). Throws Error("", JSON pointer, ...).
JobPackage parse_package(const std::string& text);

}  // namespace taxel
