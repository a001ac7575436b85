// Lines of scripts for tests of editing.
#pragma once

#include <string>
#include <vector>

#include "core/base/math.h"
#include "studio_program.h"

namespace taxel::test {

using Lines = std::vector<std::string>;

inline const std::string kMeshFile = TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj";
inline const std::string kLayoutFile = TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json";
inline const std::string kIdle = R"({"do": "wait_idle"})";
inline const std::string kLayoutMode = R"({"event": "key", "key": "1", "mods": ["ctrl"]})";
inline const std::string kCtrl = R"("ctrl")", kShift = R"("shift")", kCtrlShift = R"("ctrl", "shift")";

/// Returns a line that waits until the simulation has reached a time, in seconds.
inline std::string wait_time(double time) {
  return R"({"do": "wait_time", "time": )" + std::to_string(time) + "}";
}
/// Returns a line that waits for a frame and then until all jobs have ended.
inline std::string at_frame(int frame) {
  return R"({"frame": )" + std::to_string(frame) + R"(, "do": "wait_idle"})";
}
inline std::string dump(const std::string& name) {
  return R"({"do": "dump_state", "file": ")" + name + R"("})";
}
inline std::string key(const std::string& name, const std::string& mods = "") {
  return R"({"event": "key", "key": ")" + name + R"(", "mods": [)" + mods + "]}";
}
inline std::string type(const std::string& text) {
  return R"({"event": "text", "text": ")" + text + R"("})";
}
inline std::string click(const std::string& at, const std::string& mods = "") {
  return R"({"event": "click", "at": )" + at + R"(, "mods": [)" + mods + "]}";
}
inline std::string press(const std::string& label) {
  return click(R"({"widget": ")" + label + R"("})");
}
/// Returns a place in the 3-D view, in fractions of its size from its top left corner.
inline std::string in_view(double u, double v) {
  return R"({"view": [)" + std::to_string(u) + ", " + std::to_string(v) + "]}";
}
inline std::string taxel(int id) {
  return R"({"taxel": )" + std::to_string(id) + "}";
}

/// Returns the arguments of a large window without bars and plots, where all fields of the inspector are visible.
inline std::vector<std::string> tall_window(const StudioProgram& studio, const std::string& file = kLayoutFile) {
  std::filesystem::create_directories(studio.folder() / "state");
  write_text(studio.folder() / "state/settings.json",
             R"({"panel_bars": false, "panel_plot": false, "panel_section": false, "panel_heat": false})");
  return {"--state-dir", "state", "--size", "1500x2700", file};
}

/// Writes our fingertip with few samples per m^2 as first.taxels.json, and returns the arguments that open it.
inline std::vector<std::string> sparse_fingertip(const StudioProgram& studio, double density = 5e5,
                                                 const char* size = "1280x1000") {
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = kMeshFile;
  layout["sampling"]["density"] = density;
  write_text(studio.folder() / "first.taxels.json", layout.dump());
  return {"--size", size, "first.taxels.json"};
}

inline Lines joined(const std::vector<Lines>& parts) {
  Lines all;
  for (const Lines& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

inline dvec3 vector_of(const Json& json) {
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

/// Returns the taxel with an id from a layout's JSON.
inline Json taxel_of(const Json& layout, int id) {
  for (const Json& taxel : layout["taxels"])
    if (taxel["id"] == id) return taxel;
  throw std::runtime_error("no taxel " + std::to_string(id));
}

}  // namespace taxel::test
