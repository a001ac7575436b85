// The presentation: the 3-D view alone, with the readings as bars in it, one range of colours, a caption and large
// type, for talks.
#pragma once

#include <optional>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "ui/scene/camera.h"

namespace taxel::ui {

/// Begins the presentation, or ends it and restores the window. The camera looks at the contact, if there is one and
/// the user has not moved the camera, and returns at the end if the user does not move it meanwhile.
struct TogglePresentation {};
void carry_out(const TogglePresentation& command, App& app);

/// Ends the presentation, displays the panels that the demo leaves out, and lets no panel fill the window.
void show_all_parts(App& app);

/// A camera that was turned to the contact.
struct PresentedCamera {
  Mode mode = Mode::simulate;  ///< mode of the camera
  Camera before, at_contact;
};

struct PresentState {
  std::string was_maximised;              ///< Arrangement::maximised before
  int frames_to_restore = 0;              ///< frames until the panels return, or 0
  Rect caption = {}, bars = {};           ///< boxes of the view that the texts and the bars cover
  std::optional<PresentedCamera> camera;  ///< the camera before, if the presentation has turned it
};

/// Returns the scale of the interface while a window of a size is presented, which has `scale` otherwise.
[[nodiscard]] float presentation_scale(float width, float height, float scale);

/// Draws the caption over the view: the name of the run or layout, time and force.
void draw_presentation_caption(WindowUi& ui, const Viewer& viewer, const Shown& shown, PresentState& state);

extern const Feature kPresent;
/// Sets "presentation": whether there is one, and the boxes of its caption and its bars.
void dump_presentation(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
