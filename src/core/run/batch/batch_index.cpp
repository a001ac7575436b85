// Writes the index of a batch: the lists of episodes and layouts, and the summary.
#include "core/run/batch/batch_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/output.h"
#include "core/document/scenario/scenario.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

/// A file that is written piece by piece, into a folder that the caller moves to its place when all files are complete.
class StreamedFile {
 public:
  explicit StreamedFile(fs::path path) : path_(std::move(path)), file_(path_, os::Open::create) {
    if (!file_.is_open()) fail(file_.error());
  }
  void write(std::string_view bytes) {
    if (const int why = file_.write(bytes); why != 0) fail(why);
  }
  /// Waits until all bytes are on the disk.
  void finish() {
    if (const int why = file_.sync(); why != 0) fail(why);
    file_.close();
  }

 private:
  [[noreturn]] void fail(int why) const {
    throw Error(path_.string(), fmt::format("writing failed: {}", os::error_text(why)));
  }

  fs::path path_;
  os::File file_;
};

void write_whole(const fs::path& path, std::string_view bytes) {
  StreamedFile file(path);
  file.write(bytes);
  file.finish();
}

/// Returns a cell of a CSV file, quoted where needed (RFC 4180).
std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

/// The lines of summary.csv.
class SummaryTable {
 public:
  /// Takes the columns of all parameters that the jobs of a list change.
  explicit SummaryTable(const JobList& list) : of_scenes_(list.of_scenes) {
    for (const Job& job : list.jobs)
      for (const JobChange& change : job.changes)
        if (std::ranges::find(pointers_, change.pointer) == pointers_.end()) pointers_.push_back(change.pointer);
  }
  [[nodiscard]] std::string head() const {
    std::string text = "episode,line,number,seed,task";
    for (const std::string& pointer : pointers_) text += "," + csv_cell(pointer);
    return text + ",rows,duration,largest_force,peak,peak_taxel" + (of_scenes_ ? ",peak_sensor" : "") + ",job\n";
  }
  [[nodiscard]] std::string line(const EpisodeEntry& e) const {
    std::string text = fmt::format("{},{},{},{},{}", e.index, e.line, e.number, e.seed, csv_cell(e.task));
    for (const std::string& pointer : pointers_) {
      const auto change = std::ranges::find(e.changes, pointer, &JobChange::pointer);
      text += ',';
      if (change != e.changes.end()) text += csv_cell(change->value);
    }
    const EpisodeSummary& s = e.summary;
    text += fmt::format(",{},{},{},{},{}", e.rows, s.duration, s.largest_force, s.peak, s.peak_taxel);
    if (of_scenes_) text += "," + csv_cell(s.peak_sensor);
    return text + "," + e.job + "\n";
  }

 private:
  bool of_scenes_;
  std::vector<std::string> pointers_;
};

/// Writes the lists of episodes and layouts group by group.
class IndexWriter {
 public:
  IndexWriter(const fs::path& folder, const BatchPlan& plan)
      : plan_(plan),
        summary_(plan.list),
        episodes_(folder / "episodes.jsonl"),
        layouts_(folder / (plan.list.of_scenes ? "scenes.jsonl" : "layouts.jsonl")),
        csv_(folder / "summary.csv"),
        errors_(plan.list.jobs.size()) {
    csv_.write(summary_.head());
    for (std::size_t i = 0; i < errors_.size(); ++i) errors_[i] = plan.list.jobs[i].error;
  }

  /// Adds the episodes of a group, and notes its failed jobs. Throws Error naming the shard or a file.
  void add(const JobGroup& group) {
    EpisodeEntry entry;
    entry.shard = shard_name(group.id);
    const Shard shard(plan_.folder / entry.shard);
    const ShardHead& head = shard.head();
    check_jobs(plan_.list, group, head, shard.file());
    if (head.sensor) entry.layout = index_of(head.sensor->layout_key, layout_entry_to_json(*head.sensor));
    if (head.scene) entry.layout = index_of(head.scene->key, scene_entry_to_json(*head.scene));
    for (std::size_t k = 0; k < group.jobs.size(); ++k) {
      const JobOutcome& outcome = head.outcomes[k];
      errors_[group.jobs[k]] = outcome.error;
      if (outcome.rows > 0) add(plan_.list.jobs[group.jobs[k]], outcome, entry);
    }
  }

  /// Returns the counts, with the failed jobs in the order of the list.
  BatchCounts finish() {
    for (StreamedFile* file : {&episodes_, &layouts_, &csv_}) file->finish();
    for (std::size_t i = 0; i < errors_.size(); ++i) {
      const Job& job = plan_.list.jobs[i];
      if (!errors_[i].empty()) counts_.failed.push_back({job.line, job.number, job.id, errors_[i], job.changes});
    }
    return std::move(counts_);
  }

 private:
  void add(const Job& job, const JobOutcome& outcome, EpisodeEntry& entry) {
    entry.index = counts_.episodes++;
    entry.rows = outcome.rows;
    entry.task = job.task;
    entry.line = job.line;
    entry.number = job.number;
    entry.seed = job.seed;
    entry.job = job.id;
    entry.changes = job.changes;
    if (job.scene)
      entry.scene = scene_job_to_json(*job.scene);
    else
      entry.scenario = scenario_to_json(job.scenario);
    entry.summary = outcome.summary;
    episodes_.write(episode_to_json(entry) + "\n");
    csv_.write(summary_.line(entry));
    entry.first_row += outcome.rows;
    counts_.frames += outcome.rows;
  }
  /// Returns the index of a layout or a scene, and writes its line if it is new.
  std::size_t index_of(const std::string& key, const std::string& line) {
    const auto [entry, is_new] = places_.try_emplace(key, places_.size());
    if (is_new) layouts_.write(line + "\n");
    return entry->second;
  }

  const BatchPlan& plan_;
  SummaryTable summary_;
  StreamedFile episodes_, layouts_, csv_;
  std::vector<std::string> errors_;  // parallel to the jobs of the list
  std::map<std::string, std::size_t> places_;
  BatchCounts counts_;
};

}  // namespace

void check_jobs(const JobList& list, const JobGroup& group, const ShardHead& head, const std::string& file) {
  bool is_same = head.group == group.id && head.outcomes.size() == group.jobs.size();
  for (std::size_t k = 0; is_same && k < group.jobs.size(); ++k)
    is_same = head.outcomes[k].id == list.jobs[group.jobs[k]].id;
  if (!is_same) throw Error(file, "has other jobs than its name says");
}

BatchCounts write_batch_index(const fs::path& folder, const BatchPlan& plan,
                              const std::function<void(double)>& on_progress) {
  IndexWriter writer(folder, plan);
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    on_progress(static_cast<double>(g) / static_cast<double>(plan.groups.size()));
    writer.add(plan.groups[g]);
  }
  BatchCounts counts = writer.finish();
  const std::string reasons = failed_to_jsonl(counts.failed, plan.list.broken);
  if (!reasons.empty()) write_whole(folder / "failed.jsonl", reasons);
  write_whole(folder / kBatchFile, batch_to_json(plan, counts));
  return counts;
}

}  // namespace taxel
