#include "core/run/plot/study_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text/csv.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRunsFile = "runs.csv";
constexpr std::size_t kMaxPlottedRuns = 200;  // more panels cannot be read

PlottedRun read_studied_run(const fs::path& folder, const std::string& name) {
  const fs::path table = folder / name;
  fs::path archive = table;
  archive.replace_extension(".npz");
  std::error_code ignored;
  return read_plotted_run(fs::exists(archive, ignored) ? archive : table);
}

}  // namespace

bool is_study_folder(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_regular_file(folder / kRunsFile, ignored);
}

StudyFolder read_study_folder(const fs::path& folder) {
  const std::string file = (folder / kRunsFile).string();
  const std::vector<CsvRow> rows = parse_csv(read_file(file), file, ',');
  if (rows.empty() || rows.front().fields.front() != "file")
    throw Error(file, "line 1", "must begin with the column \"file\", as `taxel study` writes it");
  if (rows.size() < 2) throw Error(file, "lists no run");
  if (rows.size() - 1 > kMaxPlottedRuns)
    throw Error(file, fmt::format("lists {} runs; at most {} fit into one chart", rows.size() - 1, kMaxPlottedRuns));
  const std::vector<std::string>& names = rows.front().fields;
  StudyFolder study;
  std::set<std::string> values;  // of the second parameter
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const CsvRow& row = rows[i];
    const std::string where = fmt::format("line {}", row.line);
    if (row.fields.size() != names.size())
      throw Error(file, where,
                  fmt::format("has {} fields, the header has {} columns", row.fields.size(), names.size()));
    const std::string& name = row.fields.front();
    if (name.empty() || fs::path(name).filename() != name)
      throw Error(file, where, fmt::format("must name a file of this folder, names \"{}\"", name));
    std::string title;
    for (std::size_t k = 1; k < names.size(); ++k)
      title += fmt::format("{}{} {}", k > 1 ? ", " : "", names[k], row.fields[k]);
    if (names.size() > 2) values.insert(row.fields[2]);
    study.runs.push_back({read_studied_run(folder, name), title});
  }
  const auto square = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(study.runs.size()))));
  study.columns = std::max<std::size_t>(1, names.size() > 2 ? values.size() : square);
  return study;
}

}  // namespace taxel
