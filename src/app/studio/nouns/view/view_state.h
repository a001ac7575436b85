// The 3-D view: the image that it drew last, as numbers, the texts over it, and the tools of its pointer.
#pragma once

#include <string>
#include <vector>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "ui/scene/camera.h"
#include "ui/scene/geometry/shown_fields.h"
#include "ui/scene/scene_input.h"
#include "ui/scene/scene_labels.h"

namespace taxel::ui {

/// Number of clicks in the view since the start.
struct Clicks {
  int left = 0, left_double = 0, right = 0, right_double = 0;
};

/// The input of the last image. The view is drawn again when it changes.
struct ViewShown {
  SceneInput input;
  Camera camera;
  std::vector<SceneLabel> labels;  ///< labels of the image
  std::vector<LabelBox> covered;   ///< boxes of the view that `labels` avoid
  int labelled = 0;                ///< value of `draws` for which `labels` were placed
  FieldNumbers numbers;            ///< figures of the image's overlays
  bool drawn = false;
  int draws = 0;
  bool folds_legend = false;  ///< whether the legend of the marks is folded, because it would cover a sensor
  Clicks clicks;
};

/// A row of the information about a scene and the displayed step, as MuJoCo's viewer lists it.
struct InfoRow {
  std::string name, value;
};
/// Returns the rows of information. Rates measured in real time are left out in script mode.
[[nodiscard]] std::vector<InfoRow> scene_info(const RunView& run);

/// Draws the texts about the scene: the followed camera or body, and the displayed glyphs. `row` is the first free line
/// below the heading. Returns the next free line.
int draw_scene_overlay(const WindowUi& ui, const Viewer& viewer, const RunView& run, const FollowState& follow,
                       const ViewShown& view, int row);
/// Draws the information (F2) in a separate window, from line `row` on. Must be called after the view's window is
/// drawn.
void draw_info_card(WindowUi& ui, const Viewer& viewer, const RunView& run, const PanelsShown& panels, int row);

/// The card with numbers about the scene, which the view draws.
extern const Feature kInfo;
/// Sets the contents of the 3-D view: "labels" and the boxes "covered" that they avoid, "marks", "skin", "info" and
/// others.
void dump_view(const App& app, nlohmann::ordered_json& state);

// The pointer in the 3-D view, where no other tool takes it.

extern const Feature kClicks;      ///< counts the clicks in the view
extern const Feature kWheel;       ///< the wheel zooms, or changes a size of the tool in use
extern const Feature kGizmo;       ///< a click on an axis looks along it
extern const Feature kPlaceTaxel;  ///< a click with Ctrl places a taxel
extern const Feature kSelection;   ///< a click selects, a double click centres the camera

}  // namespace taxel::ui
