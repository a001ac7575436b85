// Commands about the overlays, the clip plane and the ranges of the 3-D view.
#pragma once

#include "app/studio/frame/command.h"
#include "app/studio/frame/shown_scene.h"

namespace taxel::ui {

struct ToggleOverlay {
  bool Overlays::*overlay = nullptr;
  bool operator==(const ToggleOverlay&) const = default;
};
struct ToggleGroup {
  GroupsShown Overlays::*groups = nullptr;  ///< geoms or sites
  std::size_t group = 0;
  bool operator==(const ToggleGroup&) const = default;
};
struct CycleFrames {};
struct CycleLabels {};
struct ToggleClipPlane {};
struct FlipClipPlane {};
struct ToggleRangeLock {};
struct ToggleReadingRangeLock {};
struct LinkRanges {};

void carry_out(const ToggleOverlay& command, App& app);
void carry_out(const ToggleGroup& command, App& app);
void carry_out(const CycleFrames& command, App& app);
void carry_out(const CycleLabels& command, App& app);
void carry_out(const ToggleClipPlane& command, App& app);
void carry_out(const FlipClipPlane& command, App& app);
void carry_out(const ToggleRangeLock& command, App& app);
void carry_out(const ToggleReadingRangeLock& command, App& app);
void carry_out(const LinkRanges& command, App& app);

}  // namespace taxel::ui
