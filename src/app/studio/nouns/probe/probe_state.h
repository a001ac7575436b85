// The probe tool: a ball or another shape that the user grabs, moves over the skin, presses into it and places. Its
// state, its settings and the window with its readings.
#pragma once

#include <optional>
#include <vector>

#include "app/studio/frame/command.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "core/base/text/field_spec.h"
#include "core/sensor/probe/probe.h"

namespace taxel::ui {

struct ProbeSettings {
  std::size_t chosen = 0;                                           ///< index of the shape in `shapes`
  std::vector<ProbeShape> shapes = each_alternative<ProbeShape>();  ///< last values of each shape
  Material material;                                                ///< modulus 0 for a rigid probe
  double depth = 0.001;                                             ///< indentation depth [m]
  double roll_deg = 0;

  [[nodiscard]] const ProbeShape& shape() const { return shapes[chosen]; }
  [[nodiscard]] const ProbeSphere& sphere() const {
    return std::get<ProbeSphere>(shapes[ProbeShape(ProbeSphere{}).index()]);
  }
};

/// The part of the probe's state that another document resets.
struct PlacedProbe {
  bool on = false;                ///< the tool is active; without a place the probe does not press
  bool held = false;              ///< the probe follows the pointer over the skin
  std::optional<dvec3> at;        ///< place on the skin, frame M
  bool sized = false;             ///< the settings were fitted to the sensor
  bool pressed = false;           ///< the left button was pressed on the probe
  bool dragged = false;           ///< the pointer has moved since the press
  double largest = 0;             ///< largest pressure since the activation [Pa]
  double largest_reading = 0;     ///< largest reading since the activation, in SI units
  std::optional<double> latency;  ///< time from the last edit to its reading [s]
};

struct ProbeState : PlacedProbe {
  using PerDocument = PlacedProbe;
  ProbeSettings settings;
};

/// Largest depth of the probe, as a fraction of the sensor's size.
inline constexpr double kDeepestProbe = 0.5;

[[nodiscard]] bool can_probe(const Viewer& viewer, const DocumentView& document);
/// Activates or deactivates the probe tool. Returns whether the tool was activated.
bool toggle_probe(const Viewer& viewer, const DocumentView& document, ProbeState& probe);
void leave_probe(ProbeState& probe);

/// Returns the probe to press, or nothing.
[[nodiscard]] std::optional<Probe> probe_request(const Viewer& viewer, const ProbeState& state);

/// Handles the view's mouse before other tools and the camera. Returns whether the probe tool consumed the event.
bool handle_probe_mouse(const WindowUi& ui, const Viewer& viewer, const Shown& shown, bool has_other_tool,
                        ProbeState& probe, const PointerEvent& event);

/// Returns the change of depth per notch of the wheel [m] on a sensor with a bounding box of this diagonal [m]: 1, 2 or
/// 5 times a power of ten.
[[nodiscard]] double probe_notch(double diagonal);

struct ToggleProbe {};

/// Changes to LAYOUT and starts the probe.
struct ProbeInLayout {};
void carry_out(const ToggleProbe& command, App& app);
void carry_out(const ProbeInLayout& command, App& app);

/// Draws a small window over the 3-D view with the settings and the readings of the probe.
void draw_probe_panel(WindowUi& ui, const Viewer& viewer, const Shown& shown, ProbeState& probe);

/// The ball under the pointer that presses the skin.
extern const Feature kProbe;
/// Sets "probe", which is null while the probe is off.
void dump_probe(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
