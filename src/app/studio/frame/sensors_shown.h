// The sensors with taxels of the displayed step, the names of taxels among several sensors, and the ranges of the
// contact surface's pressures and of the taxels' readings.
#pragma once

#include <string>
#include <vector>

#include "app/studio/frame/shown.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

/// A taxel among all sensors.
struct TaxelKey {
  int sensor = 0;  ///< index of the sensor in the simulation
  int id = 0;      ///< id of the taxel
  auto operator<=>(const TaxelKey&) const = default;
};

/// A sensor with taxels.
struct SensorShown {
  int index = 0;          ///< index of the sensor in the simulation
  std::size_t first = 0;  ///< index of its first reading in trace rows, recorded steps and RunView::all_peaks
  std::string name;       ///< name of its geom
  SensorModelPtr model;
  const SensorStep* step = nullptr;  ///< state in the displayed step
  ReadingUnit unit;
  const SimScene* scene = nullptr;  ///< scene of the frame; null for a sensor without one

  [[nodiscard]] const std::vector<Taxel>& taxels() const { return model->layout.taxels; }
};

/// Returns the sensors with taxels of the newest frame, in the order of the simulation. Empty without a frame.
[[nodiscard]] std::vector<SensorShown> sensors_shown(const RunView& run);

/// The place of a sensor among the bodies of a scene.
struct SensorPlace {
  int chain = 0;  ///< index of the first body of its chain, such as a finger
  int body = 0;   ///< index of its body; those of a chain ascend to the tip
};

/// Returns the places of sensors. Two sensors are in one chain if no body on the way between theirs bears several
/// branches with sensors.
[[nodiscard]] std::vector<SensorPlace> places_of(const std::vector<SensorShown>& sensors, const RunView& run);

/// Returns the name of a taxel: its id, and the name of its sensor before it if there are several sensors.
[[nodiscard]] std::string taxel_label(const std::vector<SensorShown>& sensors, const SensorShown& sensor, int id);

/// Returns the contact force on the displayed sensor with its unit, and the name of the sensor before it if there are
/// several: "index: 0.42 N". Empty without a sensor.
[[nodiscard]] std::string force_text(const Viewer& viewer, const Shown& shown, int decimals);

/// Returns whether both units are the same, so that their readings share an axis.
[[nodiscard]] bool same_unit(const ReadingUnit& a, const ReadingUnit& b);

/// Returns the unit of the selected sensor, or of the first sensor if that has no taxels. Needs a sensor.
[[nodiscard]] ReadingUnit selected_unit(const std::vector<SensorShown>& sensors, const Selection& selection);

/// Returns whether a taxel is selected.
[[nodiscard]] bool is_selected(const Selection& selection, const TaxelKey& key);

/// Selects a taxel of any sensor that was clicked. Selecting in another sensor drops the selection of the earlier one.
void click_taxel_of(Selection& selection, const TaxelKey& key, bool shift);

/// Returns the range of colours of a sensor's readings: `selected`, the range of the selected sensor, if the units are
/// the same; otherwise from 0 to a round number above the largest reading of its own unit.
[[nodiscard]] PressureRange range_of(const std::vector<SensorShown>& sensors, const SensorShown& sensor,
                                     const RunView& run, const Selection& selection, const PressureRange& selected);

struct App;

/// Minimum upper end of the pressure range [Pa].
inline constexpr double kLeastRange = 1000;

/// Fits an automatic range to the largest pressure of the run [Pa]; in LAYOUT to that of the probe. Remembers the
/// largest reading of the probe.
void update_range(App& app, double largest_of_run);

/// Returns the unit in which the displayed sensor's readings are shown.
[[nodiscard]] ReadingUnit unit_of_readings(const Viewer& viewer, const Shown& shown);
/// Returns whether readings are pressures, which can share the range of the contact surface.
[[nodiscard]] bool reads_pressures(const Viewer& viewer, const Shown& shown);
/// Returns whether surface and readings share one range now.
[[nodiscard]] bool shares_range(const Viewer& viewer, const Shown& shown);

/// Returns the range of the bars, the skin, the discs and the map: that of the surface if both are linked, or the
/// locked one, or else from 0 to a round number above the largest reading since the start, in SI units. The largest
/// reading is that of all sensors with the unit of the displayed sensor, or of the probe in LAYOUT. Hence the automatic
/// range only grows during a run.
[[nodiscard]] PressureRange reading_range(const Viewer& viewer, const Shown& shown);
/// Locks the range of the readings at its present value, or lets it follow the readings again.
void toggle_reading_lock(Viewer& viewer, const Shown& shown);

}  // namespace taxel::ui
