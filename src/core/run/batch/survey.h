// The shards of a batch as a whole: everything that a data set needs before its rows are written.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/run/batch/data_set.h"
#include "core/run/batch/data_set_meta.h"

namespace taxel {

/// Everything that is known before the rows are written.
struct Survey {
  std::vector<ShardHead> heads;              ///< parallel to the groups; without the sensors
  std::vector<EpisodeSensor> sensors;        ///< each layout once
  std::vector<std::size_t> sensor_of_group;  ///< index of `sensors`
  std::vector<std::string> tasks;
  std::map<std::string, std::int64_t> task_indices;
  std::map<std::string, std::int64_t> widths;  ///< values in a row of each column; -1 if it differs between rows
  DataSetInfo info;
};

/// Reads the descriptions of all shards. Throws Error naming a shard that cannot be read or has other jobs.
Survey survey_shards(const DataSetPlan& plan);

/// Throws Error naming `file` unless a shard has the jobs of its group.
void check_jobs(const JobList& list, const JobGroup& group, const ShardHead& head, const std::string& file);

/// Returns a column of the rows as a feature. `type` is the type of its numbers.
Feature feature_of(const std::string& name, const Survey& survey, const std::string& type);

}  // namespace taxel
