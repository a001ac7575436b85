// Commands about the window: its panels, its theme and its end.
#pragma once

#include "app/studio/frame/command.h"
#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// Leaves the innermost activity: tool, popup, selection, camera of the scene.
struct Escape {};
/// Gives the keyboard to a panel.
struct EnterPanel {
  const char* title = nullptr;
  bool operator==(const EnterPanel&) const = default;
};
struct OpenPalette {};
struct TogglePanel {
  const Feature* panel = nullptr;
  bool operator==(const TogglePanel&) const = default;
};
struct ToggleTheme {};
struct ToggleFullScreen {};
struct ScaleInterface {
  int steps = 0;  ///< by which it grows; 0: back to normal size
  bool operator==(const ScaleInterface&) const = default;
};
struct ResetArrangement {};
/// Lets the panel under the pointer fill the window, or restores all panels.
struct MaximisePanel {};
/// Opens a panel at one of its parts and gives the part the keyboard. The mode of the part must be displayed.
struct ShowPart {
  const Feature* panel = nullptr;
  PanelPart part;
};
/// Displays ANALYSE with a panel in front, and looks for its answer.
struct ShowAnswer {
  const Feature* panel = nullptr;
  bool operator==(const ShowAnswer&) const = default;
};
struct TakeScreenshot {};
struct Quit {};

void carry_out(const Escape& command, App& app);
void carry_out(const EnterPanel& command, App& app);
void carry_out(const OpenPalette& command, App& app);
void carry_out(const TogglePanel& command, App& app);
void carry_out(const ToggleTheme& command, App& app);
void carry_out(const ToggleFullScreen& command, App& app);
void carry_out(const ScaleInterface& command, App& app);
void carry_out(const ResetArrangement& command, App& app);
void carry_out(const MaximisePanel& command, App& app);

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::ShowPart& command, Host& host);
void carry_out(const ui::ShowAnswer& command, Host& host);
void carry_out(const ui::TakeScreenshot& command, Host& host);
void carry_out(const ui::Quit& command, Host& host);

}  // namespace taxel::studio
