// The taxels unrolled into a flat map, in the colours of their readings: the state of its panel, and the place of the
// map in it.
#pragma once

#include <imgui.h>

#include <span>
#include <vector>

#include "app/studio/frame/feature.h"
#include "core/layout/field/flat_map.h"
#include "core/sensor/sensor_model.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {

/// A disc as it was drawn in the last frame.
struct MapDisc {
  int sensor = 0;  ///< index of the sensor in the simulation
  int taxel_id = 0;
  double value = 0;                 ///< reading in SI units, or 0 without a reading
  double x = 0, y = 0, radius = 0;  ///< middle and radius [pixels]
};

/// The unrolled layout of one sensor.
struct SensorMap {
  SensorModelPtr model;  ///< model that `map` was unrolled from
  FlatMap map;
};

struct MapState {
  std::vector<SensorMap> maps;  ///< one per displayed sensor
  bool unrolled = false;        ///< whether the map of the selected sensor is unrolled
  std::vector<MapDisc> discs;   ///< one disc per taxel; empty if the panel is closed
};

/// The taxels as discs in a plane.
extern const Feature kTaxelMap;
/// Sets "map": the drawn discs.
void dump_taxel_map(const App& app, nlohmann::ordered_json& state);

/// Fraction of the least distance of two places that the radius of a disc takes.
inline constexpr double kDiscRadiusFraction = 0.46;

/// The similarity that takes places of the map to pixels.
struct MapFit {
  ImVec2 middle;     ///< middle of the room [pixels]
  dvec2 center{0};   ///< middle of the map [m]
  double scale = 1;  ///< [pixels/m]
  float radius = 1;  ///< radius of a disc [pixels]

  /// Returns the pixel of a place; up in the map is up in the window.
  [[nodiscard]] ImVec2 at(const dvec2& p) const {
    return {middle.x + static_cast<float>(scale * (p.x - center.x)),
            middle.y - static_cast<float>(scale * (p.y - center.y))};
  }
};

/// Fits a map into a room of `size` pixels whose upper left corner is `origin`. `line` is the height of text [pixels]:
/// a margin of 0.3 of it remains on each side, and no disc has a radius above 2.2 of it or below 1.5 pixels.
[[nodiscard]] MapFit fit_map(const FlatMap& map, const ImVec2& origin, const ImVec2& size, float line);

/// A cell of the panel, for the map of one sensor [pixels].
struct MapCell {
  ImVec2 origin, size;
};

/// Divides a room into a cell for each map, row by row, so that the smallest scale of all maps is as large as possible.
/// Below each cell, `name` pixels are left for the name of the sensor. Cells are at least `widest` wide, the width of
/// the widest name, if this does not halve the scale.
[[nodiscard]] std::vector<MapCell> map_cells(std::span<const FlatMap* const> maps, const ImVec2& origin,
                                             const ImVec2& size, float line, float name, float widest = 0);

}  // namespace taxel::ui
