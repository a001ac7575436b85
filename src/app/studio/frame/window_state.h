// The window on the screen: its place, which is kept from one start to the next, its title, its theme, and the
// arrangement of its panels and tool rows.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>

namespace taxel::ui {

/// A place in screen coordinates, which may be coarser than pixels. A width of 0 is no place.
struct WindowPlace {
  int x = 0, y = 0, width = 0, height = 0;
  bool maximized = false;  ///< the window fills the screen; the place is the one before
  bool operator==(const WindowPlace&) const = default;
};

/// The window of the operating system.
struct WindowState {
  WindowPlace place;  ///< kept in the settings file
  std::string title;
  bool full_screen = false;       ///< whether it has no frame
  bool saves_screenshot = false;  ///< a picture of it is to be saved
  bool quits = false;             ///< the program is to end
};

/// Returns a place at which the window is visible and can be moved: the kept place, no larger than the screen that
/// shows most of it and inside of that screen; or no place if there is none or no screen shows a usable part of it.
inline WindowPlace visible_place(const WindowPlace& kept, std::span<const WindowPlace> screens) {
  constexpr int kLeastSize = 200, kLeastPart = 80;  // of the window, and of its part on a screen
  if (kept.width < kLeastSize || kept.height < kLeastSize) return {};
  const auto end = [](long begin, long size) { return begin + size; };  // a file may have any numbers
  const WindowPlace* best = nullptr;
  long most = 0;
  for (const WindowPlace& screen : screens) {
    const long wide = std::min(end(kept.x, kept.width), end(screen.x, screen.width)) - std::max(kept.x, screen.x);
    const long high = std::min(end(kept.y, kept.height), end(screen.y, screen.height)) - std::max(kept.y, screen.y);
    if (wide < kLeastPart || high < kLeastPart || wide * high <= most) continue;
    most = wide * high;
    best = &screen;
  }
  if (best == nullptr) return {};
  WindowPlace place = kept;
  place.width = std::min(place.width, best->width);
  place.height = std::min(place.height, best->height);
  place.x = std::clamp(place.x, best->x, best->x + best->width - place.width);
  place.y = std::clamp(place.y, best->y, best->y + best->height - place.height);
  return place;
}

/// Kept in the settings file.
struct Appearance {
  bool dark = true;
  float scale = 1.0f;  ///< scale of the interface, in addition to the screen's own
};

/// Each mode has an arrangement of its own. Only the arrangement of the displayed mode exists in ImGui; the others
/// are kept as texts, which are also the texts of their files.
struct Arrangement {
  double scale = 0;                      ///< scale for which the panels were arranged, or 0 before that
  bool reset = false;                    ///< whether the panels are to be arranged again
  bool resets_twice = false;             ///< whether they are again in the next frame
  int toolbar_rows = 1;                  ///< rows of the toolbar in the previous frame
  int timeline_rows = 1;                 ///< rows of the timeline's buttons in the previous frame
  std::array<std::string, 3> kept;       ///< arrangement of each mode, or empty for a new one
  std::optional<std::size_t> displayed;  ///< index in `kept` of the displayed arrangement
  std::string maximised;                 ///< title of the panel that is to fill the window, or empty
  std::string filling;                   ///< title of the panel that fills the window now, or empty
  float width = 0, height = 0;           ///< size of the window [pixels]
};

/// How many of the window's parts are displayed next to the 3-D view.
struct WindowParts {
  bool is_presenting = false;  ///< whether there is only the view, with a caption and bars in large type
  bool has_few = false;        ///< whether the demo leaves out all panels but the readings
};

}  // namespace taxel::ui
