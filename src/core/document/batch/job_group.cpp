#include "core/document/batch/job_group.h"

#include <map>

#include "core/base/hash.h"

namespace taxel {
namespace {

constexpr std::size_t kIdDigits = 32;

std::string group_id(const JobList& list, const std::vector<std::size_t>& jobs) {
  std::string ids;
  for (const std::size_t job : jobs) ids += list.jobs[job].id + "\n";
  return sha256_hex(ids).substr(0, kIdDigits);
}

}  // namespace

std::vector<JobGroup> group_jobs(const JobList& list, std::size_t size) {
  std::vector<std::vector<std::size_t>> of_layout;
  std::map<std::string, std::size_t> place_of;
  for (std::size_t i = 0; i < list.jobs.size(); ++i) {
    if (!list.jobs[i].error.empty()) continue;
    const auto [place, is_new] = place_of.try_emplace(list.jobs[i].layout_key, of_layout.size());
    if (is_new) of_layout.emplace_back();
    of_layout[place->second].push_back(i);
  }
  std::vector<JobGroup> groups;
  for (const std::vector<std::size_t>& jobs : of_layout) {
    for (std::size_t first = 0; first < jobs.size(); first += size) {
      JobGroup& group = groups.emplace_back();
      for (std::size_t i = first; i < jobs.size() && i < first + size; ++i) group.jobs.push_back(jobs[i]);
      group.id = group_id(list, group.jobs);
    }
  }
  return groups;
}

}  // namespace taxel
