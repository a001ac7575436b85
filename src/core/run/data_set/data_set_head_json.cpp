#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/base/text/json_reader.h"
#include "core/run/data_set/data_set_head.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;
using Node = JsonNode<Json>;

constexpr const char* kEpisodesVersion = "v3.0";
constexpr int kDataSetVersion = 1;
constexpr int kFloat32 = 32, kFloat64 = 64;

/// Returns the text of a file of the data set. Throws Error with the remedy if the file is missing.
std::string text_of(const fs::path& folder, const char* name) {
  const fs::path path = folder / name;
  std::error_code ignored;
  if (fs::exists(path, ignored)) return read_file(path);
  if (!fs::is_directory(folder, ignored)) throw Error(folder.string(), "no such folder");
  if (fs::exists(folder / ".batch", ignored))
    throw Error(path.string(), "no such file: the batch is not finished; run the same `taxel batch` command again");
  if (name == std::string_view(kDataSetHeadFile))
    throw Error(
        path.string(),
        "no such file: only data sets of `taxel batch` hold the jobs of their episodes; make one by that command");
  throw Error(path.string(), "no such file: the folder is no data set of `taxel batch`, or was copied in part");
}

void check_info(const std::string& text, const std::string& file) {
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  root.must_be_object();
  if (const std::string version = root.at("codebase_version").text(); version != kEpisodesVersion)
    throw Error(file, "/codebase_version",
                fmt::format("is {}, this program reads {}: write the data set by `taxel batch` of this version",
                            short_quote(version), kEpisodesVersion));
}

void read_head(const std::string& text, const std::string& file, DataSetHead& head) {
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  root.must_be_object();
  if (const auto format = root.find("format"); !format || !format->is_text() || format->text() != "taxel-data-set")
    throw Error(file, "/format", "must be taxel-data-set: the file does not describe a data set of `taxel batch`");
  if (const double version = root.at("version").number(); version != kDataSetVersion)
    throw Error(file, "/version",
                fmt::format("is {}, this program reads version {}: update this program", version, kDataSetVersion));
  head.program = root.at("program").text();
  head.bits = root.at("bits").small_integer();
  if (head.bits != kFloat32 && head.bits != kFloat64)
    throw Error(file, "/bits", fmt::format("must be 32 or 64, is {}", head.bits));
  head.episodes = static_cast<std::int64_t>(root.at("episodes").natural());
}

std::vector<JobChange> changes_of(const Json& json) {
  std::vector<JobChange> changes;
  for (const auto& [pointer, value] : json.items()) changes.push_back({pointer, json_line(value)});
  return changes;
}

void read_failed(const std::string& line, const std::string& file, std::size_t number, DataSetHead& head) {
  const std::string place = fmt::format("{}: line {}", file, number);
  const Json json = parse_json<Json>(line, place);
  const Node root(json, place);
  root.must_be_object();
  const int of_list = root.at("line").small_integer();
  const std::string error = root.at("error").text();
  if (!root.find("number")) return head.broken.push_back({of_list, error});
  FailedJob job{of_list, static_cast<std::int64_t>(root.at("number").natural()), root.at("job").text(), error, {}};
  root.at("changes").must_be_object();
  job.changes = changes_of(json["changes"]);
  head.failed.push_back(std::move(job));
}

}  // namespace

DataSetHead parse_data_set_head(const DataSetTexts& texts, const fs::path& folder) {
  DataSetHead head;
  check_info(texts.info, (folder / kDataSetInfoFile).string());
  read_head(texts.head, (folder / kDataSetHeadFile).string(), head);
  const std::string& text = texts.failed;
  std::size_t number = 1;
  for (std::size_t begin = 0; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end > begin) read_failed(text.substr(begin, end - begin), (folder / kFailedJobsFile).string(), number, head);
    begin = end + 1;
  }
  return head;
}

DataSetHead read_data_set_head(const fs::path& folder) {
  DataSetTexts texts{text_of(folder, kDataSetInfoFile), text_of(folder, kDataSetHeadFile), ""};
  std::error_code ignored;
  if (fs::exists(folder / kFailedJobsFile, ignored)) texts.failed = read_file(folder / kFailedJobsFile);
  return parse_data_set_head(texts, folder);
}

std::vector<JobChange> parse_changes(const std::string& text, const std::string& file, const std::string& where) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) throw Error(file, where, "must be a JSON object, is " + short_quote(text));
  return changes_of(json);
}

std::optional<double> number_of_json(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_number()) return std::nullopt;
  return json.get<double>();
}

}  // namespace taxel
