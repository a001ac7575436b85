// The 3-D view as the user set it: mode, cameras, selection, overlays, range of colours and clip plane.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "app/studio/frame/app.h"
#include "core/layout/layout.h"
#include "ui/scene/camera.h"
#include "ui/scene/picking.h"
#include "ui/scene/scene_input.h"
#include "ui/widgets/format.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {

/// Selection of taxels by id, so that an edit, or a model that is still being built, does not change the selection.
struct Selection {
  int sensor = 0;  ///< index of the sensor in the simulation
  /// Ids of the selected taxels, each once, in the order of selection; the last one is the active taxel.
  std::vector<int> taxels;
  int body = -1;  ///< index in SceneControls::bodies, or -1 if no body is selected
  /// Whether the user chose the sensor. Otherwise it is only the one whose numbers are displayed.
  bool is_sensor_chosen = false;
  bool operator==(const Selection&) const = default;

  [[nodiscard]] bool empty() const { return taxels.empty(); }
  [[nodiscard]] bool contains(int id) const;
  /// Returns the id of the taxel whose values are displayed as single numbers, or empty if no taxel is selected.
  [[nodiscard]] std::optional<int> active() const;

  /// Deselects all taxels, and the sensor.
  void clear() {
    taxels.clear();
    is_sensor_chosen = false;
  }
  void set(int id) { taxels = {id}; }
  void add(int id);  ///< selects a taxel and makes it the active one
  void remove(int id);
  void toggle(int id);
  void set_all(const Layout& layout);
  void invert(const Layout& layout);
  /// Removes ids that the layout does not have.
  void keep_only(const Layout& layout);
};

/// Returns the index of a taxel in layout order, or -1 if the layout has no taxel with that id.
int index_of(const Layout& layout, int id);
/// Returns the indices of the selected taxels that the layout has, in ascending order.
std::vector<int> selected_indices(const Selection& selection, const Layout& layout);
/// Returns the index of the active taxel, or -1 if the layout has no such taxel.
int active_index(const Selection& selection, const Layout& layout);

/// A fixed range of readings. It is valid for readings of one unit.
struct LockedReadings {
  double hi = 1;  ///< upper end, in SI units
  ReadingUnit unit;
};

/// How readings are scaled, for colours and bars, apart from the pressures of the contact surface.
struct ReadingScale {
  bool linked = false;                   ///< readings that are pressures share the range of the surface
  std::optional<LockedReadings> locked;  ///< fixed range, or nothing if the range follows the largest reading
  double probed = 0;                     ///< largest reading of the probe since its activation, in SI units
  double probed_pressure = 0;            ///< largest pressure of the probe since its activation [Pa]
};

/// The place of the 3-D view in the window, and the size of its texture.
struct ViewPlace {
  Rect rect;
  int width = 0, height = 0;  ///< size of the texture [pixels]
  float strip = 0;            ///< width at the left edge that the strip of tools covers [pixels]
  Rect tools;                 ///< strip of tools in the last frame; empty without a strip
};

struct Viewer {
  Mode mode = Mode::simulate;
  std::array<Camera, 2> cameras;  ///< one per mode
  Selection selection;
  std::array<Overlays, 2> mode_overlays{overlays_of_layout(), overlays_of_run()};  ///< one per mode
  PressureRange range;                                                             ///< range of the contact surface
  ReadingScale readings;                                                           ///< range of the readings
  std::optional<ClipPlane> clip;
  std::optional<Pick> hovered;  ///< the object under the resting pointer
  ViewPlace view;

  [[nodiscard]] Camera& camera() { return cameras[mode == Mode::layout ? 0 : 1]; }
  [[nodiscard]] const Camera& camera() const { return cameras[mode == Mode::layout ? 0 : 1]; }
  /// Returns the overlays of the present mode.
  [[nodiscard]] Overlays& overlays() { return mode_overlays[mode == Mode::layout ? 0 : 1]; }
  [[nodiscard]] const Overlays& overlays() const { return mode_overlays[mode == Mode::layout ? 0 : 1]; }
  /// Returns the pixel of the view that shows a point, and the depth of the point.
  [[nodiscard]] dvec3 project(const dvec3& p_W) const { return camera().project(p_W, view.width, view.height); }
};

/// Selects a taxel that was clicked: alone, or with Shift in addition, or no longer if it was selected.
inline void click_taxel(Selection& selection, int id, bool shift) {
  shift ? selection.toggle(id) : selection.set(id);
}

}  // namespace taxel::ui
