// Reads a list of jobs: the lines with their parameters, and the jobs that they expand to.
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/files.h"
#include "core/base/text/json.h"
#include "core/base/text/message.h"
#include "core/document/batch/job.h"
#include "core/document/batch/job_sources.h"
#include "core/document/scenario/scenario.h"
#include "core/layout/file/layout_json.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;
using Node = JsonNode<Json>;

/// Throws Error unless a number is whole, at least `least` and at most kMaxJobs.
std::int64_t whole_count(const Node& node, int least) {
  const double value = node.number();
  if (!(value >= least && value <= static_cast<double>(kMaxJobs) && value == std::floor(value)))
    node.wrong(fmt::format("a whole number from {} to {}", least, kMaxJobs));
  return static_cast<std::int64_t>(value);
}

std::vector<std::string> range_of(const Node& node) {
  node.only({"from", "to", "count"});
  const double from = node.at("from").number(), to = node.at("to").number();
  const auto count = static_cast<std::size_t>(whole_count(node.at("count"), 2));
  std::vector<std::string> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(json_line(Json(value_of_range(from, to, i, count))));
  return values;
}

std::vector<std::string> listed_values(const Node& node) {
  node.only({"values"});
  const Node list = node.at("values");
  if (list.length() == 0) list.fail("must have at least one value");
  std::vector<std::string> values;
  for (const Json& value : list.json()) values.push_back(json_line(value));
  return values;
}

Draw draw_of(const Node& node, const char* key, Distribution distribution) {
  node.only({key});
  const Node limits = node.at(key);
  const std::vector<double> two = limits.numbers(2);
  const Draw draw{distribution, two[0], two[1]};
  try {
    check_draw(draw);
  } catch (const Error& e) {
    limits.fail(e.message());
  }
  return draw;
}

Choice choice_of(const Node& node) {
  node.only({"choice"});
  const Node list = node.at("choice");
  if (list.length() == 0) list.fail("must have at least one value");
  Choice choice;
  for (const Json& value : list.json()) choice.values.push_back(json_line(value));
  return choice;
}

/// A value is itself, unless it is an object with one of these keys.
JobParameter parameter_of(const std::string& pointer, const Node& node) {
  if (node.json().is_object()) {
    if (node.find("values")) return {pointer, listed_values(node)};
    if (node.find("choice")) return {pointer, choice_of(node)};
    if (node.find("from")) return {pointer, range_of(node)};
    if (node.find("uniform")) return {pointer, draw_of(node, "uniform", Distribution::uniform)};
    if (node.find("log_uniform")) return {pointer, draw_of(node, "log_uniform", Distribution::log_uniform)};
    if (node.find("normal")) return {pointer, draw_of(node, "normal", Distribution::normal)};
  }
  return {pointer, std::vector<std::string>{json_line(node.json())}};
}

/// Returns the scenario object in the text of a scenario file.
std::string inner_scenario(const std::string& text, const std::string& file) {
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  root.must_be_object();
  return json_line(root.find("scenario").value_or(root).json());
}

void read_scenario_of(const Node& node, const std::filesystem::path& folder, JobLine& line) {
  if (!node.is_text()) {
    node.must_be_object();
    line.scenario = json_line(node.json());
    line.scenario_file = (folder / "jobs").string();
    return;
  }
  line.scenario_file = (folder / node.text()).lexically_normal().string();
  line.scenario = inner_scenario(read_file(line.scenario_file), line.scenario_file);
}

/// Returns the JSON text of a scene, of which a list may have the name of the file alone.
std::string scene_object(const Json& json) {
  return json_line(json.is_string() ? Json{{"file", json}} : json);
}

void read_parameters(const Node& node, JobLine& line) {
  node.must_be_object();
  for (const auto& [pointer, value] : node.json().items()) {
    const bool is_of_scene = pointer.starts_with("/scene/");
    if (!line.scene.empty() && !is_of_scene) node.fail_at(pointer, "must begin with /scene/");
    if (line.scene.empty() && !pointer.starts_with("/layout/") && !pointer.starts_with("/scenario/"))
      node.fail_at(pointer, "must begin with /layout/ or /scenario/");
    line.parameters.push_back(parameter_of(pointer, *node.find(pointer)));
    if (line.count() > kMaxJobs) node.fail(fmt::format("gives more than {} jobs", kMaxJobs));
  }
}

}  // namespace

std::size_t JobLine::count() const {
  std::size_t count = static_cast<std::size_t>(repeat);
  for (const JobParameter& parameter : parameters)
    if (const auto* values = std::get_if<std::vector<std::string>>(&parameter.values))
      count = std::min(count * values->size(), kMaxJobs + 1);
  return count;
}

JobLine parse_job_line(const std::string& text, const std::filesystem::path& folder) {
  const std::string file;
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  root.only({"layout", "scenario", "scene", "set", "repeat", "seed", "task"});
  JobLine line;
  line.folder = folder;
  if (const auto layout = root.find("layout")) line.layout = (folder / layout->text()).lexically_normal().string();
  if (const auto scene = root.find("scene")) {
    for (const char* other : {"scenario", "layout"})
      if (root.find(other)) root.fail_at(other, "excludes a scene, which has its own sensors and motions");
    if (!scene->is_text()) scene->must_be_object();
    line.scene = scene_object(scene->json());
  } else {
    read_scenario_of(root.at("scenario"), folder, line);
  }
  if (const auto set = root.find("set")) read_parameters(*set, line);
  if (const auto repeat = root.find("repeat")) line.repeat = whole_count(*repeat, 1);
  if (const auto seed = root.find("seed")) line.seed = seed->natural();
  if (const auto task = root.find("task")) line.task = task->text();
  return line;
}

namespace {

using SortedJson = nlohmann::json;  // keys in the order of the alphabet: equal values give equal texts

/// The first key of a job's content. Another way to compute ids needs another number.
constexpr const char* kContent = "taxel-job 1";

/// Returns the first 52 bits of a hash, which every JSON reader holds exactly.
std::uint64_t seed_of(const std::string& hash) {
  return std::stoull(hash.substr(0, 13), nullptr, 16);
}

/// Expands one line. Layouts that many jobs share are hashed once.
class Expansion {
 public:
  Expansion(const JobLine& line, int number, JobSources& sources) : line_(line), number_(number), sources_(sources) {}

  /// Returns the job of a combination: one index for each parameter, and the repetition.
  Job job(const std::vector<std::size_t>& indices, std::int64_t index, std::int64_t repetition) {
    Job job;
    job.line = number_;
    job.number = index;
    job.layout = line_.layout;
    job.changes = listed_changes(indices);
    try {
      job.id = line_.scene.empty() ? id_of(job, repetition) : id_of_scene(job, repetition);
      job.seed = seed_of(job.id);
      job.changes = all_changes(indices, job.seed);
      if (line_.scene.empty()) {
        job.scenario = scenario_of(job.changes);
        job.layout_key = layout_key(job.changes);
      } else {
        job.scene = scene_of(job.changes);
        job.layout_key = scene_key(*job.scene);
      }
    } catch (const Error& e) {
      job.error = shown_message(e);
    }
    job.task = line_.task;
    if (!line_.scene.empty()) {
      if (job.task.empty() && job.scene) job.task = std::filesystem::path(job.scene->file).stem().string();
      return job;
    }
    if (job.task.empty() && job.error.empty()) job.task = "fingertip " + std::string(to_word(job.scenario.kind()));
    return job;
  }

 private:
  /// Returns the changes without random values.
  [[nodiscard]] std::vector<JobChange> listed_changes(const std::vector<std::size_t>& indices) const {
    std::vector<JobChange> changes;
    for (std::size_t p = 0; p < line_.parameters.size(); ++p)
      if (const auto* values = std::get_if<std::vector<std::string>>(&line_.parameters[p].values))
        changes.push_back({line_.parameters[p].pointer, (*values)[indices[p]]});
    return changes;
  }

  [[nodiscard]] std::vector<JobChange> all_changes(const std::vector<std::size_t>& indices, std::uint64_t seed) const {
    std::vector<JobChange> changes;
    for (std::size_t p = 0; p < line_.parameters.size(); ++p) {
      const auto& [pointer, values] = line_.parameters[p];
      if (const auto* listed = std::get_if<std::vector<std::string>>(&values))
        changes.push_back({pointer, (*listed)[indices[p]]});
      else if (const auto* choice = std::get_if<Choice>(&values))
        changes.push_back({pointer, choice->values[draw_choice(choice->values.size(), seed, pointer)]});
      else
        changes.push_back({pointer, json_line(SortedJson(draw_number(std::get<Draw>(values), seed, pointer)))});
    }
    return changes;
  }

  [[nodiscard]] Scenario scenario_of(const std::vector<JobChange>& changes) const {
    try {
      const std::string text = with_changes(line_.scenario, changes_below("/scenario", changes));
      return with_absolute_files(parse_scenario(text), line_.scenario_file);
    } catch (const Error& e) {
      throw Error("", "/scenario" + e.where(), e.message());
    }
  }

  /// Returns the hash of a changed layout, in which the bytes of the mesh replace its name.
  std::string layout_key(const std::vector<JobChange>& changes) {
    std::vector<JobChange> below = changes_below("/layout", changes);
    const auto is_same = [&](const auto& entry) { return entry.first == below; };
    const auto found = std::find_if(keys_.begin(), keys_.end(), is_same);
    if (found != keys_.end()) return found->second;
    Layout layout = changed_layout(changes);
    if (below.empty() || layout.mesh.file == sources_.source(line_.layout).layout.mesh.file)
      layout.mesh.file = sources_.source(line_.layout).mesh.sha256;
    else
      layout.mesh.file = sources_.file_sha256(mesh_path(layout, sources_.source(line_.layout).file).string());
    std::string key = sha256_hex(layout_to_json(layout));
    if (keys_.size() >= kKeptKeys) keys_.erase(keys_.begin());
    keys_.emplace_back(std::move(below), key);
    return key;
  }

  Layout changed_layout(const std::vector<JobChange>& changes) {
    return sources_.changed_layout(line_.layout, changes);
  }

  /// Returns the hash of a job's content. Its random values follow from the hash and are not part of the content.
  std::string id_of(const Job& job, std::int64_t repetition) {
    Scenario scenario = scenario_of(job.changes);
    for (const auto& [key, file] : files_of(scenario))
      if (!file->empty()) *file = sources_.file_sha256(*file);
    const SortedJson content{{"content", kContent},
                             {"layout", layout_key(job.changes)},
                             {"scenario", SortedJson::parse(scenario_to_json(scenario))},
                             {"random", draws()},
                             {"repetition", repetition},
                             {"seed", line_.seed}};
    return sha256_hex(json_line(content));
  }

  /// Returns the distributions of a line.
  [[nodiscard]] SortedJson draws() const {
    SortedJson draws = SortedJson::object();
    for (const JobParameter& parameter : line_.parameters) {
      if (const auto* draw = std::get_if<Draw>(&parameter.values))
        draws[parameter.pointer] = {static_cast<int>(draw->distribution), draw->first, draw->second};
      if (const auto* choice = std::get_if<Choice>(&parameter.values)) draws[parameter.pointer] = choice->values;
    }
    return draws;
  }

  /// Returns the scene with changes, checked against its file.
  [[nodiscard]] SceneJob scene_of(const std::vector<JobChange>& changes) {
    try {
      SceneJob scene = parse_scene_job(with_changes(line_.scene, changes_below("/scene", changes)), line_.folder);
      facts_ = sources_.scene_facts(scene);
      return scene;
    } catch (const Error& e) {
      throw Error(e.file(), e.where().starts_with("/") || e.where().empty() ? "/scene" + e.where() : e.where(),
                  e.message());
    }
  }

  /// Returns the scene with the hashes of files instead of their names, as sorted JSON. The scene is the latest of
  /// scene_of().
  SortedJson nameless(SceneJob scene) {
    std::vector<std::string> hashes;
    for (const std::string& file : facts_.files) hashes.push_back(sources_.file_sha256(file));
    std::sort(hashes.begin(), hashes.end());
    std::string all;
    for (const std::string& hash : hashes) all += hash + "\n";
    scene.file = sources_.file_sha256(scene.file) + sha256_hex(all);
    for (const auto& [pointer, file] : files_of(scene)) *file = sources_.file_sha256(file_of_run(*file));
    return SortedJson::parse(scene_job_to_json(scene));
  }

  /// Returns the hash of the parts of a scene that are compiled.
  std::string scene_key(const SceneJob& scene) {
    SceneJob compiled;
    compiled.file = scene.file;
    compiled.attach = scene.attach;
    compiled.geoms = scene.geoms;
    return sha256_hex(json_line(nameless(compiled)));
  }

  /// Returns the hash of the content of a job with a scene, as id_of() does.
  std::string id_of_scene(const Job& job, std::int64_t repetition) {
    const SortedJson content{{"content", kContent},
                             {"scene", nameless(scene_of(job.changes))},
                             {"random", draws()},
                             {"repetition", repetition},
                             {"seed", line_.seed}};
    return sha256_hex(json_line(content));
  }

  /// Returns the file of a recorded run, which a job may name by its folder.
  static std::string file_of_run(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::is_directory(path, ignored) ? path + "/readings.npz" : path;
  }

  static constexpr std::size_t kKeptKeys = 64;

  const JobLine& line_;
  int number_;
  JobSources& sources_;
  SceneFacts facts_;                                                  // of the latest scene
  std::vector<std::pair<std::vector<JobChange>, std::string>> keys_;  // the latest layouts of the line
};

/// Returns the jobs of a line in order: the repetition changes fastest, then the last parameter.
std::vector<Job> jobs_of(const JobLine& line, int number, JobSources& sources) {
  Expansion expansion(line, number, sources);
  std::vector<std::size_t> sizes;
  for (const JobParameter& parameter : line.parameters) {
    const auto* values = std::get_if<std::vector<std::string>>(&parameter.values);
    sizes.push_back(values != nullptr ? values->size() : 1);
  }
  std::vector<std::size_t> indices(sizes.size(), 0);
  std::vector<Job> jobs;
  for (bool is_end = false; !is_end;) {
    for (std::int64_t k = 0; k < line.repeat; ++k)
      jobs.push_back(expansion.job(indices, static_cast<std::int64_t>(jobs.size()), k));
    std::size_t p = sizes.size();
    while (p > 0 && ++indices[p - 1] == sizes[p - 1]) indices[--p] = 0;
    is_end = p == 0;
  }
  return jobs;
}

/// Returns the common error of all jobs, or an empty text if the jobs differ or have none.
std::string common_error(const std::vector<Job>& jobs) {
  const std::string& first = jobs.front().error;
  const bool is_common = std::all_of(jobs.begin(), jobs.end(), [&](const Job& job) { return job.error == first; });
  return is_common ? first : "";
}

void add_line(const std::string& text, int number, const std::string& file, const std::filesystem::path& folder,
              JobSources& sources, std::map<std::string, int>& line_of_id, JobList& list) {
  std::vector<Job> jobs;
  std::size_t count = 0;
  try {
    const JobLine line = parse_job_line(text, folder);
    count = line.count();
    if (list.jobs.size() + count <= kMaxJobs) jobs = jobs_of(line, number, sources);
  } catch (const Error& e) {
    list.broken.push_back({number, shown_message(e)});
    return;
  }
  if (list.jobs.size() + count > kMaxJobs)
    throw Error(file, fmt::format("line {}", number), fmt::format("the list has more than {} jobs", kMaxJobs));
  if (const std::string error = common_error(jobs); !error.empty()) {
    list.broken.push_back({number, error});
    return;
  }
  std::size_t repeated = 0;
  int first_line = 0;
  for (Job& job : jobs) {
    const auto [entry, is_new] =
        job.id.empty() ? std::pair{line_of_id.end(), true} : line_of_id.try_emplace(job.id, number);
    if (is_new) {
      list.jobs.push_back(std::move(job));
    } else if (repeated++ == 0) {
      first_line = entry->second;
    }
  }
  if (repeated > 0)
    list.repeats.push_back(fmt::format("line {}: {} of its jobs are listed before, the first in line {}, and run once",
                                       number, repeated, first_line));
}

/// Sets JobList::of_scenes. Throws Error if jobs of both kinds are in the list, because their rows differ.
void refuse_both_kinds(JobList& list, const std::string& file) {
  const Job* of_kind[2] = {nullptr, nullptr};
  for (const Job& job : list.jobs)
    if (job.error.empty() && of_kind[job.scene ? 1 : 0] == nullptr) of_kind[job.scene ? 1 : 0] = &job;
  list.of_scenes = of_kind[1] != nullptr;
  if (of_kind[0] == nullptr || of_kind[1] == nullptr) return;
  throw Error(file, fmt::format("line {}", of_kind[1]->line),
              fmt::format("runs a scene, and line {} a scenario: give each kind a list of its own, because their rows "
                          "have other columns",
                          of_kind[0]->line));
}

}  // namespace

JobList parse_job_list(const std::string& text, const std::string& file, const std::filesystem::path& folder,
                       JobSources& sources) {
  JobList list;
  std::map<std::string, int> line_of_id;
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    if (line.find_first_not_of(" \t\r") != std::string::npos)
      add_line(line, number, file, folder, sources, line_of_id, list);
  }
  refuse_both_kinds(list, file);
  std::string all;
  for (const Job& job : list.jobs) all += job.id + job.error + "\n";
  list.sha256 = sha256_hex(all);
  return list;
}

JobList read_job_list(const std::filesystem::path& path, JobSources& sources) {
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  return parse_job_list(read_file(path), path.string(), folder, sources);
}

}  // namespace taxel
