#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/files.h"
#include "core/base/text/json.h"
#include "core/run/mcap/recording_mcap.h"

namespace taxel {

RunNotes parse_run_notes(const std::string& text, const std::string& name, const std::string& file) {
  const auto json = parse_json<nlohmann::ordered_json>(text, file);
  const JsonNode root(json, file);
  root.must_be_object();
  const JsonNode versions = root.at("versions");
  versions.must_be_object();
  return {fmt::format("taxel {}, MuJoCo {}", versions.at("taxel").text(), versions.at("mujoco").text()), name, text};
}

RunNotes read_run_notes(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::optional<fs::path> newest;
  std::error_code ignored;
  for (const char* name : {"scenario.json", "sweep.json"}) {
    const fs::path file = folder / name;
    if (!fs::is_regular_file(file, ignored)) continue;
    if (!newest || fs::last_write_time(file, ignored) > fs::last_write_time(*newest, ignored)) newest = file;
  }
  if (!newest) return {};
  return parse_run_notes(read_file(*newest), newest->filename().string(), newest->string());
}

}  // namespace taxel
