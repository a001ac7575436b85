// Groups of jobs that share a compiled sensor. A group is the unit of work, and of the results on disk.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/document/batch/job.h"

namespace taxel {

struct JobGroup {
  std::string id;                 ///< 32 hexadecimal digits: hash of the ids of the jobs in order
  std::vector<std::size_t> jobs;  ///< indices of JobList::jobs
};

/// Returns the groups of a list: layouts in the order of their first job, and at most `size` >= 1 jobs of one layout in
/// a group, in the order of the list. Jobs with an error are in no group.
std::vector<JobGroup> group_jobs(const JobList& list, std::size_t size);

}  // namespace taxel
