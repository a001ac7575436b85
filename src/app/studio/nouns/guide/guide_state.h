// The user guide in the window, which opens at a heading or at the section about a panel.
#pragma once

#include <string>

#include "app/studio/frame/command.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/window_ui.h"

namespace taxel::ui {

struct GuideState {
  std::string sought;   ///< heading that the window scrolls to, or empty
  int frames = 0;       ///< frames for which it still scrolls there, until the tables have their heights
  std::string section;  ///< heading of the section at the top of the window
};

/// The window with the user guide.
extern const Feature kGuide;
/// Sets "guide": whether it is open, and the section at the top.
void dump_guide(const App& app, nlohmann::ordered_json& state);

/// Opens the guide at a heading.
struct ShowGuide {
  std::string heading;
  bool operator==(const ShowGuide&) const = default;
};
/// Opens the guide at the section about the panel under the pointer, or at its begin if no panel is there.
struct ShowGuideOfPanel {};

void carry_out(const ShowGuide& command, App& app);
void carry_out(const ShowGuideOfPanel& command, App& app);

/// Returns whether Esc leaves the current window: it has the keyboard, and no field or list in it had it before.
[[nodiscard]] bool is_left_by_escape(const WindowUi& ui);

/// Draws a button "?" at the right end of the tabs of each docked panel that the guide has a section about. Call it
/// after the panels were drawn.
void draw_guide_buttons(App& app);

}  // namespace taxel::ui
