// Lists of jobs, and journals and shards of batches.
#include "core/document/batch/job.h"
#include "core/document/batch/job_sources.h"
#include "core/run/batch/batch_folder.h"
#include "core/run/batch/shard.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

/// Returns whether a list has few jobs and names no files, which a fuzzer must not open.
bool is_quick_list(const std::string& text) {
  std::size_t count = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    if (line.find("file") != std::string::npos || line.find("\"object\"") != std::string::npos) return false;
    const auto read = read_or_refuse([&] { return parse_job_line(line, "/nowhere"); });
    if (read) count += read->count();
  }
  return count <= 200;
}

DefaultLayout without_mesh() {
  SensorSource source;
  source.layout.mesh.file = "finger.obj";
  source.layout.taxels.push_back({});
  return {source};
}

void run(const std::string& input) {
  read_or_refuse([&] { return replay_journal(input, "journal"); });
  const auto head = read_or_refuse([&] { return parse_shard_head(input, "shard"); });
  if (head) require(parse_shard_head(shard_head_to_json(*head), "shard") == *head, "a shard's head is written again");
  if (!is_quick_list(input)) return;
  const auto expand = [&] {
    JobSources sources(without_mesh);
    return parse_job_list(input, "jobs.jsonl", "/nowhere", sources);
  };
  const auto list = read_or_refuse(expand);
  if (!list) return;
  require(expand().sha256 == list->sha256, "a list gives the same jobs twice");
  for (const Job& job : list->jobs)
    require(job.error.empty() == (job.layout_key != ""), "a job has content or an error");
}

const Registered kTarget("jobs", run);

}  // namespace
}  // namespace taxel::fuzz
