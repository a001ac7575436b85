// Jobs of a batch: one run of one scenario around one layout, or one run of a scene, with changed parameters. Plain
// values, with their random numbers, their groups, and the list of jobs that a file expands to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/document/batch/scene_job.h"
#include "core/document/scenario/scenario.h"

namespace taxel {

// Random numbers of jobs: a pure function of the job's seed, the parameter and the distribution.

enum class Distribution { uniform, log_uniform, normal };

/// A number that each job draws.
struct Draw {
  Distribution distribution = Distribution::uniform;
  double first = 0;   ///< lower limit, or mean of `normal`
  double second = 1;  ///< upper limit, or standard deviation of `normal`
  bool operator==(const Draw&) const = default;
};

/// Throws Error("", "", ...) if the limits are not finite or not in order, the limits of `log_uniform` are not
/// positive, or the deviation is negative.
void check_draw(const Draw& draw);

/// Returns the number that the job with this seed draws for the parameter `pointer`. The limits of `uniform` and
/// `log_uniform` are never exceeded.
double draw_number(const Draw& draw, std::uint64_t seed, std::string_view pointer);

/// Returns the index of the value that the job with this seed chooses from `count` >= 1 values.
std::size_t draw_choice(std::size_t count, std::uint64_t seed, std::string_view pointer);

/// Returns the value `index` of `count` >= 2 values at even distances; the first is `from` and the last is `to`.
double value_of_range(double from, double to, std::size_t index, std::size_t count);

/// A changed value of a layout, a scenario or a scene.
struct JobChange {
  std::string pointer;  ///< JSON pointer, such as /layout/material/modulus or /scene/moves/ball/x
  std::string value;    ///< JSON text
  bool operator==(const JobChange&) const = default;
};

/// One job. All random values are drawn.
struct Job {
  int line = 0;             ///< line in the list of jobs, from 1
  std::int64_t number = 0;  ///< index among the jobs of the line, from 0
  /// SHA-256 of the content: the values of layout and scenario or of the scene, the bytes of the files that they name,
  /// `repeat` and `seed` of the line. Neither the place in a list nor the name of a file changes the id.
  std::string id;
  std::uint64_t seed = 0;          ///< seed of the job's random values, from the id; below 2^53
  std::string layout;              ///< absolute path of the layout file; empty for the default layout
  std::string layout_key;          ///< SHA-256 of the changed layout, or of the scene: such jobs share a compiled one
  Scenario scenario;               ///< with all changes, and absolute paths
  std::optional<SceneJob> scene;   ///< scene that the job runs instead of a scenario, with all changes
  std::vector<JobChange> changes;  ///< in the order of the line
  std::string task;                ///< task of the episode in words
  std::string error;               ///< reason why the job cannot run; empty if it can
};

/// A line of a list that gives no jobs.
struct BrokenLine {
  int line = 0;         ///< from 1
  std::string message;  ///< with a JSON pointer into the line
};

/// The jobs of a list, expanded.
struct JobList {
  std::vector<Job> jobs;             ///< in the order of the list; each id occurs once
  std::vector<BrokenLine> broken;    ///< lines without jobs
  std::vector<std::string> repeats;  ///< notes on jobs that were listed before and are left out
  std::string sha256;                ///< hash of the ids and errors in order: two lists of the same jobs have one hash
  bool of_scenes = false;            ///< the jobs run scenes instead of scenarios
};

/// Largest number of jobs of a list.
inline constexpr std::size_t kMaxJobs = 1'000'000;

/// Jobs that share a compiled sensor. A group is the unit of work, and of the results on disk.
struct JobGroup {
  std::string id;                 ///< 32 hexadecimal digits: hash of the ids of the jobs in order
  std::vector<std::size_t> jobs;  ///< indices of JobList::jobs
};

/// Returns the groups of a list: layouts or scenes in the order of their first job, and at most `size` >= 1 jobs of one
/// layout or scene in a group, in the order of the list. Jobs with an error are in no group.
std::vector<JobGroup> group_jobs(const JobList& list, std::size_t size);

/// Checks that a data set of the jobs has one rate, and even intervals. Throws Error naming `file`, the rates and a
/// line of each unless all jobs without an error have the same rate and a whole number of time steps between two rows.
void check_rates(const JobList& list, const std::string& file);

// A list of jobs: JSON Lines, one line for one or many jobs (docs/many_runs.md).
//
//   {"layout": "finger.taxels.json", "scenario": "press.json",
//    "set": {"/scenario/depth": {"from": 0.0005, "to": 0.002, "count": 4},
//            "/layout/material/modulus": {"values": [3e4, 5e4]},
//            "/scenario/tilt_deg": {"uniform": [10, 50]}}, "repeat": 100, "seed": 7}
//
//   {"scene": {"file": "hand.xml", "controls": "close.csv"}, "set": {"/scene/moves/ball/x": {"uniform": [0, 0.01]}}}
//
// The first line gives 4 x 2 x 100 jobs. The last listed parameter changes faster than the ones before, and the
// repetition changes fastest.

class JobSources;

/// JSON texts of the values of which each job chooses one.
struct Choice {
  std::vector<std::string> values;
};

/// A parameter of a line.
struct JobParameter {
  std::string pointer;                                          ///< below /layout, /scenario or /scene
  std::variant<std::vector<std::string>, Draw, Choice> values;  ///< JSON texts of the values, or a distribution
};

/// One line of a list as read, before the expansion.
struct JobLine {
  std::string layout;            ///< absolute path; empty for the default layout
  std::string scenario;          ///< JSON text of the scenario; empty for a scene
  std::string scenario_file;     ///< file in whose folder the paths of the scenario begin
  std::string scene;             ///< JSON text of the scene; empty for a scenario
  std::filesystem::path folder;  ///< folder in which the paths of the scene begin
  std::vector<JobParameter> parameters;
  std::int64_t repeat = 1;
  std::uint64_t seed = 0;
  std::string task;  ///< empty if the line names none

  /// Returns the number of jobs, at most kMaxJobs + 1.
  [[nodiscard]] std::size_t count() const;
};

/// Parses a line. Throws Error("", JSON pointer, ...) if it is not valid.
JobLine parse_job_line(const std::string& text, const std::filesystem::path& folder);

/// Expands the text of a list. Paths in it are relative to `folder`. A line that is not valid, or names a parameter
/// that its layout or scenario does not have, is in JobList::broken; a job with a value out of range has
/// Job::error. Throws Error naming `file` if there are more than kMaxJobs jobs, or jobs of scenes and of scenarios.
JobList parse_job_list(const std::string& text, const std::string& file, const std::filesystem::path& folder,
                       JobSources& sources);

/// Reads a file by parse_job_list(), with paths relative to the file's folder. Throws Error if it cannot be read.
JobList read_job_list(const std::filesystem::path& path, JobSources& sources);

}  // namespace taxel
