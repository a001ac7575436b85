#include "app/studio/nouns/view/view_commands.h"

#include "app/studio/frame/app.h"
#include "app/studio/frame/reading_range.h"
#include "app/studio/frame/shown_scene.h"

namespace taxel::ui {

namespace {

void flip(bool& value) {
  value = !value;
}

}  // namespace

void carry_out(const ToggleOverlay& command, App& app) {
  flip(app.viewer->overlays().*command.overlay);
}

void carry_out(const ToggleGroup& command, App& app) {
  flip((app.viewer->overlays().*command.groups).at(command.group));
}

void carry_out(const CycleFrames&, App& app) {
  app.viewer->overlays().frames = next(app.viewer->overlays().frames);
}

void carry_out(const CycleLabels&, App& app) {
  app.viewer->overlays().labels = next(app.viewer->overlays().labels);
}

void carry_out(const ToggleClipPlane&, App& app) {
  toggle_clip(*app.viewer, *app.shown);
}

void carry_out(const FlipClipPlane&, App& app) {
  app.viewer->clip = app.viewer->clip->flipped();
}

void carry_out(const ToggleRangeLock&, App& app) {
  flip(app.viewer->range.automatic);
}

void carry_out(const ToggleReadingRangeLock&, App& app) {
  toggle_reading_lock(*app.viewer, *app.shown);
}

void carry_out(const LinkRanges&, App& app) {
  flip(app.viewer->readings.linked);
}

}  // namespace taxel::ui
