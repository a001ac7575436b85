#include "cli/taxel_program.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "core/base/files.h"

namespace taxel::test {
namespace fs = std::filesystem;
namespace {

const fs::path kScratch = fs::path(TAXEL_BINARY_DIR) / "tests" / "cli" / "scratch";

/// Returns a hash of everything that all sweeps depend on: the program, the versions of its libraries, and the
/// environment variables that determine how numbers are written.
std::string program_stamp() {
  static const std::string stamp = [] {
    std::string inputs = file_text(TAXEL_PROGRAM) + run_program(TAXEL_PROGRAM, {"--version"}, kScratch).out;
    for (const char* variable : {"LC_ALL", "LC_NUMERIC", "LANG"}) {
      const char* value = std::getenv(variable);
      inputs += std::string("\n") + variable + "=" + (value != nullptr ? value : "");
    }
    return sha256_hex(inputs);
  }();
  return stamp;
}

/// Returns the bytes of a file, followed by those of its mesh if it is a layout.
std::string file_inputs(const fs::path& file) {
  std::string inputs = file_text(file);
  const Json layout = Json::parse(inputs, nullptr, false);
  if (!layout.is_object() || !layout.contains("mesh")) return inputs;
  const fs::path mesh = file.parent_path() / layout["mesh"].value("file", "");
  return fs::is_regular_file(mesh) ? inputs + file_text(mesh) : inputs;
}

/// Returns a hash of the options and of the files that they name.
std::string folder_name(const std::vector<std::string>& options) {
  std::string inputs;
  for (const std::string& option : options) {
    inputs += option + '\n';
    if (fs::is_regular_file(option)) inputs += file_inputs(option);
  }
  return sha256_hex(inputs);
}

}  // namespace

fs::path test_folder() {
  const ::testing::TestInfo* info = ::testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "." + info->name();
  std::replace(name.begin(), name.end(), '/', '-');
  return fresh_folder(kScratch, name);
}

Outcome taxel(const std::vector<std::string>& arguments, const fs::path& folder) {
  return run_program(TAXEL_PROGRAM, arguments, folder);
}

Json taxel_json(std::vector<std::string> arguments, const fs::path& folder) {
  arguments.emplace_back("--json");
  const Outcome outcome = taxel(arguments, folder);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return outcome.status == 0 ? Json::parse(outcome.out) : Json();
}

void expect_refusal(const Outcome& outcome, const std::string& line) {
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, line + "\n");
}

fs::path fingertip_layout() {
  return fs::path(TAXEL_SOURCE_DIR) / "assets" / "layouts" / "fingertip.taxels.json";
}

fs::path changed_layout(const fs::path& folder, const Json& patch) {
  Json layout = Json::parse(file_text(fingertip_layout()));
  layout["mesh"]["file"] = (fs::path(TAXEL_SOURCE_DIR) / "assets" / "meshes" / "fingertip.obj").string();
  layout = layout.patch(patch);
  const fs::path path = folder / "changed.taxels.json";
  write_text(path, layout.dump(2));
  return path;
}

fs::path finger_on_box(const std::string& patch) {
  const fs::path folder = test_folder();
  Json changes = Json::parse(R"([{"op": "replace", "path": "/sampling/density", "value": 1e6}])");
  for (const Json& change : Json::parse(patch)) changes.push_back(change);
  fs::rename(changed_layout(folder, changes), folder / "fingertip.taxels.json");
  fs::copy(fs::path(TAXEL_SOURCE_DIR) / "tests/golden/finger_on_box.json", folder / "case.json");
  return folder;
}

std::string box_obj(double half, int first, bool outward) {
  std::ostringstream obj;
  for (int c = 0; c < 8; ++c)
    obj << "v " << (c & 1 ? half : -half) << ' ' << (c & 2 ? half : -half) << ' ' << (c & 4 ? half : -half) << '\n';
  const int faces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                            {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  for (const auto& f : faces)
    obj << "f " << f[0] + first << ' ' << f[outward ? 1 : 2] + first << ' ' << f[outward ? 2 : 1] + first << '\n';
  return obj.str();
}

Table read_csv(const fs::path& path) {
  std::istringstream in(file_text(path));
  std::string line, field;
  std::vector<std::string> heads;
  std::getline(in, line);
  for (std::istringstream fields(line); std::getline(fields, field, ',');) heads.push_back(field);
  Table table;
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    for (const std::string& head : heads) {
      std::getline(fields, field, ',');
      table[head].push_back(std::stod(field));
    }
  }
  return table;
}

RecordedJump largest_jump(const fs::path& run) {
  const Table table = read_csv(run / "readings.csv");
  const std::string prefix = "taxel_";
  RecordedJump jump;
  for (const auto& [head, r] : table) {
    if (head.rfind(prefix, 0) != 0) continue;
    for (std::size_t i = 1; i < r.size(); ++i)
      if (std::abs(r[i] - r[i - 1]) > std::abs(jump.after - jump.before))
        jump = {std::stoi(head.substr(prefix.size())), table.at("time")[i], i, r[i - 1], r[i]};
  }
  return jump;
}

fs::path shared_sweep(const std::vector<std::string>& options) {
  fs::create_directories(kScratch);
  const fs::path all = kScratch / "sweeps";
  const fs::path mine = all / program_stamp();
  const fs::path folder = mine / folder_name(options);
  if (fs::exists(folder)) return folder;
  fs::create_directories(mine);
  std::error_code ec;
  for (const fs::directory_entry& old : fs::directory_iterator(all)) {
    if (old.path() != mine) fs::remove_all(old.path(), ec);
  }
  const fs::path making = folder.string() + "." + std::to_string(::getpid());
  std::vector<std::string> arguments{"sweep", "--quiet", "--out", making.string()};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = taxel(arguments);
  if (outcome.status != 0) throw std::runtime_error("taxel sweep failed: " + outcome.err);
  fs::rename(making, folder, ec);  // fails if another test was faster
  if (ec) fs::remove_all(making);
  return folder;
}

fs::path shared_box_sweep(std::vector<std::string> options) {
  options.insert(options.end(), {"--object", "box"});
  return shared_sweep(options);
}

fs::path real_layout() {
  const fs::path path = fs::path(TAXEL_REAL_DATA) / "shadow_fingertip.taxels.json";
  return fs::exists(path) ? path : fs::path();
}

}  // namespace taxel::test
