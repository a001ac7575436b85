#include <nlohmann/json.hpp>

#include "core/base/text/json.h"
#include "core/document/scenario/scenario.h"
#include "core/sim/batch/job_package.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;
using Node = JsonNode<Json>;

constexpr int kPackageVersion = 1;

Json job_to_json(const Job& job) {
  Json changes = Json::array();
  for (const JobChange& change : job.changes) changes.push_back({{"pointer", change.pointer}, {"value", change.value}});
  Json json{{"id", job.id},
            {"layout", job.layout},
            {"layout_key", job.layout_key},
            {"scenario", Json::parse(scenario_to_json(job.scenario))},
            {"changes", std::move(changes)}};
  if (!job.error.empty()) json["error"] = job.error;
  return json;
}

Job read_job(const Node& node) {
  Job job;
  job.id = node.at("id").text();
  job.layout = node.at("layout").text();
  job.layout_key = node.at("layout_key").text();
  const Node scenario = node.at("scenario");
  scenario.must_be_object();
  job.scenario = parse_scenario(scenario.json().dump());
  const Node changes = node.at("changes");
  for (std::size_t i = 0; i < changes.length(); ++i)
    job.changes.push_back({changes.item(i).at("pointer").text(), changes.item(i).at("value").text()});
  if (const auto error = node.find("error")) job.error = error->text();
  return job;
}

}  // namespace

std::string package_to_json(const JobPackage& package) {
  Json jobs = Json::array();
  for (const Job& job : package.jobs) jobs.push_back(job_to_json(job));
  Json json{{"version", kPackageVersion},    {"group", package.group},  {"float64", package.format.float64},
            {"poses", package.format.poses}, {"jobs", std::move(jobs)}, {"files", package.files}};
  if (package.format.fps > 0) json["fps"] = package.format.fps;
  if (package.source) json["source"] = {{"file", package.source->file}, {"layout", package.source->layout_json}};
  return json_line(json);
}

JobPackage parse_package(const std::string& text) {
  const std::string file;
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  root.must_be_object();
  if (root.at("version").number() != kPackageVersion)
    root.fail_at("version", fmt::format("must be {}, is {}", kPackageVersion, root.at("version").number()));
  JobPackage package;
  package.group = root.at("group").text();
  package.format.float64 = root.at("float64").flag();
  package.format.poses = root.at("poses").flag();
  if (const auto fps = root.find("fps")) package.format.fps = fps->small_integer();
  const Node jobs = root.at("jobs");
  if (jobs.length() == 0) jobs.fail("must have at least one job");
  for (std::size_t i = 0; i < jobs.length(); ++i) package.jobs.push_back(read_job(jobs.item(i)));
  const Node files = root.at("files");
  files.must_be_object();
  for (const auto& [path, copy] : files.json().items()) package.files[path] = files.at(path).text();
  if (const auto source = root.find("source"))
    package.source = PackedSource{source->at("file").text(), source->at("layout").text()};
  return package;
}

}  // namespace taxel
