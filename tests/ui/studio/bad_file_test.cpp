// Full disks, folders that cannot be written, and very large documents: nothing is lost, no file is left half written,
// and each error is reported once.
#include <gtest/gtest.h>
#include <regex>

#include <chrono>
#include <cstring>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "core/layout/file/layout_json.h"
#include "core/mesh/mesh_io.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

/// Returns the files in a folder that a failed write left there.
std::vector<std::string> left_over(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".part") names.push_back(entry.path().filename().string());
  }
  return names;
}

int count_errors(const Json& state) {
  int errors = 0;
  for (const Json& message : state["messages"]) errors += message["severity"] == "error" ? 1 : 0;
  return errors;
}

/// Writes a layout with this number of taxels on the faces of our fingertip into the test's folder.
std::string large_layout(const StudioProgram& studio, int taxels) {
  const TriMesh mesh = *load_mesh(kMeshFile).mesh;
  Layout layout;
  layout.name = "large";
  layout.mesh.file = kMeshFile;
  layout.sampling.density = 1e7;
  for (int f = 0; f < taxels; ++f) {
    const int face = f % mesh.face_count();
    const dvec3 center = (mesh.vertex(face, 0) + mesh.vertex(face, 1) + mesh.vertex(face, 2)) / 3.0;
    layout.taxels.push_back({f, "", center, mesh.face_normals()[static_cast<std::size_t>(face)], 0.0006, {}});
  }
  const std::string file = (studio.folder() / "large.taxels.json").string();
  write_layout(file, layout);
  return file;
}

/// A folder that nobody can write to, not even root: the kernel's own. In addition, a file in place of a folder.
TEST(BadTarget, ReportsOnceWhyAnExportCannotBeWritten) {
  const StudioProgram studio;
  write_text(studio.folder() / "file.txt", "mine");
  const std::vector<std::string> exports{"Export layout...", "Export taxels (CSV)...", "Export samples (CSV)...",
                                         "Export sheet to print (HTML)...", "Export picture (PNG)..."};
  Lines script{kLayoutMode, kIdle};
  for (const std::filesystem::path& folder : {std::filesystem::path("/proc"), studio.folder() / "file.txt"}) {
    for (const std::string& label : exports) {
      const Lines one{
          press("File"), kIdle,        press("Export"), kIdle, press(label),  kIdle, type((folder / "out").string()),
          kIdle,         key("Enter"), kIdle,           kIdle, key("Escape"), kIdle};
      script.insert(script.end(), one.begin(), one.end());
    }
  }
  script.push_back(dump("state.json"));
  studio.play(script, {kLayoutFile});
  const Json state = studio.state("state.json");
  const int messages = static_cast<int>(exports.size()) - 1;  // both tables are out.csv: the second says the same
  EXPECT_EQ(count_errors(state), 2 * messages) << state["messages"].dump(1);
  EXPECT_EQ(state["messages"].back()["number"], static_cast<int>(2 * exports.size())) << "each export is answered";
  for (const Json& message : state["messages"]) {
    if (message["severity"] == "error") {
      EXPECT_NE(message["text"].get<std::string>().find("/out"), std::string::npos) << "names the file";
    }
  }
  EXPECT_EQ(state["document"]["layout"]["taxels"].size(), 12U);
  EXPECT_EQ(file_text(studio.folder() / "file.txt"), "mine");
  EXPECT_TRUE(left_over(studio.folder()).empty());
}

/// A limit replaces a full disk: the system lets no file of the program grow beyond some kilobytes, so the write fails
/// half way.
TEST(FullDisk, KeepsTheOldFileAndTheUnsavedEdits) {
  const StudioProgram studio;
  const std::string layout = large_layout(studio, 600), target = (studio.folder() / "kept.taxelproj").string();
  write_text(target, "the old content");
  Lines script{kLayoutMode,
               kIdle,
               key("a"),
               kIdle,
               key("f"),
               type("1"),
               kIdle,
               key("Enter"),
               kIdle,
               key("s", kCtrl),
               kIdle,
               type(target),
               kIdle,
               key("Enter"),
               kIdle,
               key("Enter"),
               kIdle,
               R"({"do": "expect", "pointer": "/messages", "contains": "kept.taxelproj: writing failed"})",
               R"({"do": "expect", "pointer": "/history/dirty", "equals": true})",
               R"({"do": "expect", "pointer": "/history/depth", "equals": 1})"};
  std::string text;
  for (const std::string& line : script) text += line + "\n";
  write_text(studio.folder() / "script.jsonl", text);
  const std::string limited = "trap '' XFSZ; ulimit -f 64; exec \"$0\" \"$@\"";  // blocks of 512 bytes or 1 KiB
  const Outcome outcome = run_program(
      "/bin/sh", {"-c", limited, STUDIO_PROGRAM, "--headless", "--script", "script.jsonl", layout}, studio.folder());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(file_text(target), "the old content");
  EXPECT_TRUE(left_over(studio.folder()).empty());
  EXPECT_GT(std::filesystem::file_size(layout), 64U * 1024U) << "larger than what fits";
}

TEST(LargeLayout, OpensAndIsEditedAndExportedWithFiveThousandTaxels) {
  const StudioProgram studio;
  const std::string out = (studio.folder() / "out.taxels.json").string();
  studio.play({kLayoutMode,
               kIdle,
               key("a"),
               kIdle,
               key("f"),
               type("0.7"),
               kIdle,
               key("Enter"),
               kIdle,
               dump("edited.json"),
               R"({"do": "screenshot", "file": "large.png"})",
               key("z", kCtrl),
               kIdle,
               dump("undone.json"),
               key("e", kCtrl),
               kIdle,
               type(out),
               kIdle,
               key("Enter"),
               kIdle},
              {large_layout(studio, 5000)});
  const Json edited = studio.state("edited.json");
  ASSERT_EQ(edited["document"]["layout"]["taxels"].size(), 5000U);
  EXPECT_EQ(edited["document"]["layout"]["taxels"][4999]["radius"], 0.0007);
  EXPECT_EQ(edited["history"]["depth"], 1);
  const Json exported = Json::parse(file_text(out));
  EXPECT_EQ(exported["taxels"].size(), 5000U);
  EXPECT_EQ(exported["taxels"], studio.state("undone.json")["document"]["layout"]["taxels"]);
  EXPECT_EQ(exported["taxels"][0]["radius"], 0.0006);
}

/// Writes a ball of `rings` x `rings` quads as a binary STL.
void write_large_ball(const std::filesystem::path& file, int rings) {
  const auto point = [rings](int i, int j) {
    const double t = glm::pi<double>() * i / rings, p = 2 * glm::pi<double>() * j / rings;
    return glm::vec3(0.01 * std::sin(t) * std::cos(p), 0.01 * std::sin(t) * std::sin(p), 0.01 * std::cos(t));
  };
  std::string bytes(84, '\0');
  std::uint32_t count = 0;
  const auto add = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const std::array<glm::vec3, 4> numbers{glm::vec3(0), a, b, c};
    bytes.append(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
    bytes.append(2, '\0');
    ++count;
  };
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < rings; ++j) {
      const glm::vec3 a = point(i, j), b = point(i + 1, j), c = point(i + 1, j + 1), d = point(i, j + 1);
      add(a, b, c);
      add(a, c, d);
    }
  }
  std::memcpy(bytes.data() + 80, &count, sizeof count);
  std::ofstream(file, std::ios::binary) << bytes;
}

TEST(LargeMesh, IsCancelledWhileTwoMillionTrianglesLoad) {
  const StudioProgram studio;
  const std::filesystem::path file = studio.folder() / "ball.stl";
  write_large_ball(file, 1000);
  ASSERT_EQ(std::filesystem::file_size(file), 84U + 50U * 2'000'000U);
  studio.play({R"({"frame": 1, "event": "drop", "files": ["ball.stl"]})",
               R"({"frame": 5, "do": "screenshot", "file": "loading.png"})",
               R"({"frame": 5, "do": "dump_state", "file": "loading.json"})",
               R"({"frame": 6, "event": "click", "at": {"widget": "Cancel loading"}})", kIdle, dump("cancelled.json"),
               R"({"event": "drop", "files": [")" + kLayoutFile + R"("]})", kIdle, dump("after.json")},
              {"--empty"});
  std::filesystem::remove(file);
  const std::string shown = studio.state("loading.json")["widgets"].dump();
  EXPECT_EQ(shown.find("Fingertip sweep"), std::string::npos) << "no invitation behind the bar";
  const Json cancelled = studio.state("cancelled.json");
  EXPECT_TRUE(cancelled["document"].is_null());
  ASSERT_EQ(cancelled["messages"].size(), 1U) << cancelled["messages"].dump();
  EXPECT_EQ(cancelled["messages"][0]["text"], "Loading was cancelled.");
  EXPECT_EQ(studio.state("after.json")["document"]["layout"]["taxels"].size(), 12U) << "and it goes on";
}

/// Returns the message of the window for a file whose message differs from that of `taxel check`.
std::string windows_message(const std::string& name, const std::string& expected) {
  const auto ends = [&](const char* end) { return name.ends_with(end); };
  if (ends(".xyz") || ends(".jsonl")) return "cannot be opened: it is no project";
  static const std::set<std::string> kNoLayouts{
      "icub_empty.txt",     "icub_prose.txt",           "icub_section.txt",          "poses_missing.npz",
      "poses_prose.npz",    "probes_empty.probes.json", "probes_object.probes.json", "tactile_empty.urdf",
      "tactile_prose.urdf", "tactile_scene.urdf"};
  if (kNoLayouts.contains(name)) return "file can hold a layout, but the text of this one is none";
  const bool is_foreign =
      ends(".yaml") || ends(".csv") || ends(".txt") || ends(".npz") || ends(".urdf") || ends(".xacro");
  if (is_foreign || name.starts_with("probes_")) return "holds no mesh: drop or open its mesh file as well";
  const bool is_json = expected.find("is not JSON") == std::string::npos;
  if (ends(".json") && !ends(".taxels.json") && !name.starts_with("state_")) {
    std::smatch format;
    const std::string text = file_text(TAXEL_SOURCE_DIR "/tests/fixtures/broken/" + name).substr(0, 300);
    const std::regex other("\"format\"[^\"]*\"(taxel-[^\"]*|column-mapping|contact-case)\"");
    const bool is_other = std::regex_search(text, format, other) && format[1] != "taxel-layout";
    if (is_other) return "is no layout: its format is \"" + format[1].str() + "\"";
    if (is_json) return "/format: must be \"taxel-layout\"";
  }
  if (name == "layout_format.taxels.json") return "/format: must be \"taxel-layout\", is \"layout\"";
  if (name == "mesh_buffer_is_folder.gltf") return "is a folder, not a file";  // the message contains the whole path
  if (name == "layout_mesh_is_folder.taxels.json") return "unknown mesh format";
  const std::size_t severity = expected.find("error: ");
  const std::string said = severity == std::string::npos ? expected : std::string(expected).erase(severity, 7);
  return said.substr(0, said.find("; "));  // without the remedy
}

// All files are opened in one window, one after another.
TEST(BrokenFiles, AreRefusedByTheWindowWithTheirMessage) {
  const StudioProgram studio;
  const std::filesystem::path broken = TAXEL_SOURCE_DIR "/tests/fixtures/broken";
  std::istringstream lines(file_text(broken / "expected.tsv"));
  std::vector<std::pair<std::string, std::string>> files;
  Lines script;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    const std::size_t first = line.find('\t'), second = line.find('\t', first + 1);
    files.emplace_back(line.substr(0, first), line.substr(second + 1));
    const std::string number = std::to_string(files.size() - 1);
    script.push_back(R"({"event": "drop", "files": [")" + (broken / files.back().first).string() + R"("]})");
    script.push_back(kIdle);
    script.push_back(dump(number + ".json"));
  }
  ASSERT_GE(files.size(), 150U);
  studio.play(script, {"--empty", "--size", "480x360"});
  std::size_t message_count = 0;  // number of messages
  std::optional<std::filesystem::file_time_type> before;
  for (std::size_t i = 0; i < files.size(); ++i) {
    SCOPED_TRACE(files[i].first);
    const std::string state = std::to_string(i) + ".json";
    const Json messages = studio.state(state)["messages"];
    const std::string expected = windows_message(files[i].first, files[i].second);
    bool said = false;
    for (std::size_t m = message_count; m < messages.size(); ++m)
      said = said || messages[m]["text"].get<std::string>().find(expected) != std::string::npos;
    EXPECT_TRUE(said) << expected << "\n"
                      << (messages.size() > message_count ? messages[messages.size() - 1].dump() : "nothing is said");
    message_count = messages.size();
    const auto at = std::filesystem::last_write_time(studio.folder() / state);
    EXPECT_LT(at - before.value_or(at), std::chrono::seconds(5));
    before = at;
  }
}

}  // namespace
}  // namespace taxel::test
