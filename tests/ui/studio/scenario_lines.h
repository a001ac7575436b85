// Lines of scripts for scenarios in the inspector.
#pragma once

#include "script_lines.h"

namespace taxel::test {

inline Lines choose_kind(const std::string& kind) {
  return {press("Inspector/Kind"), kIdle, press(kind), kIdle};
}
inline Lines typed_in_inspector(const std::string& field, const std::string& text) {
  return {press("Inspector/" + field), kIdle, key("a", kCtrl), type(text), key("Enter"), kIdle};
}
/// Lines that leave only the scenario in the inspector.
inline const Lines kScenarioAlone{kIdle, press("Inspector/Selected taxel"), kIdle, press("Inspector/Sampling"),
                                  kIdle, press("Inspector/Material"),       kIdle, press("Inspector/Scene"),
                                  kIdle};
inline const Lines kRunScenario{press("Inspector/Run scenario"), kIdle};

/// Returns the arguments of a window with our fingertip and few samples.
inline std::vector<std::string> coarse_fingertip(const StudioProgram& studio, const std::string& size) {
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = kMeshFile;
  layout["sampling"]["density"] = 1e5;
  write_text(studio.folder() / "coarse.taxels.json", layout.dump());
  std::vector<std::string> arguments = tall_window(studio, "coarse.taxels.json");
  arguments[3] = size;
  // The inspector alone has the column of panels.
  write_text(studio.folder() / "state/settings.json",
             R"({"panel_bars": false, "panel_plot": false, "panel_section": false, "panel_outliner": false,)"
             R"( "panel_taxels": false})");
  return arguments;
}
inline std::vector<std::string> coarse_fingertip(const StudioProgram& studio) {
  return coarse_fingertip(studio, "1400x1000");
}

}  // namespace taxel::test
