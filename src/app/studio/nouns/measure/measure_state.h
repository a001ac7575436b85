// The measure tool: two clicks on the surface, the point under the pointer, and the distance of the points, straight
// and along the surface.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/studio/frame/command.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "core/base/math.h"

namespace taxel::ui {

struct MeasurePoint {
  dvec3 at{0};               ///< position of the point, frame M
  std::optional<int> taxel;  ///< id of the taxel if the point is a taxel's centre
};

struct MeasureState {
  using PerDocument = MeasureState;  ///< another document resets all of it
  bool on = false;
  std::vector<MeasurePoint> points;   ///< clicked points, two at most
  std::optional<MeasurePoint> hover;  ///< place that the next click would add
};

[[nodiscard]] bool can_measure(const Viewer& viewer, const DocumentView& document);
/// Begins or ends measuring. Returns whether measuring was begun.
bool toggle_measure(const Viewer& viewer, const DocumentView& document, MeasureState& measure);
void leave_measure(MeasureState& measure);

/// Returns the distance to measure, or nothing with fewer than two points.
[[nodiscard]] std::optional<MeasureRequest> measure_request(const Viewer& viewer, const DocumentView& document,
                                                            const MeasureState& measure);

/// Handles the view's mouse before other tools and the camera. Returns whether the measure tool consumed the event.
bool handle_measure_mouse(const WindowUi& ui, const Viewer& viewer, const Shown& shown, bool has_other_tool,
                          MeasureState& measure, const SceneInput& scene, const PointerEvent& event);

struct ToggleMeasure {};
void carry_out(const ToggleMeasure& command, App& app);

/// The distance of two points on the skin.
extern const Feature kMeasure;
/// Sets "measure", which is null while nothing is measured.
void dump_measure(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui

namespace taxel::studio {

/// Makes the job of the feature.
[[nodiscard]] std::unique_ptr<FeatureJob> make_measure_job(JobExecutor& executor);

}  // namespace taxel::studio
