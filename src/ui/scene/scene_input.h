// The input of the 3-D view: the displayed step, the document's layout, the overlays, the range of colours, and the
// results of the measure and the probe.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/mesh/query/closest_point.h"
#include "core/run/frame.h"
#include "core/sensor/probe/probe.h"
#include "ui/scene/camera.h"
#include "ui/scene/color_map.h"
#include "ui/scene/geometry/shown_fields.h"

namespace taxel::ui {

/// Request for the distance of two points, frame M.
struct MeasureRequest {
  std::shared_ptr<const MeshIndex> skin;
  dvec3 a{0}, b{0};  ///< the path connects the nearest points of the skin
  bool operator==(const MeasureRequest&) const = default;
};

struct Measured {
  MeasureRequest request;
  double straight = 0;                                     ///< Euclidean distance from a to b [m]
  double along = std::numeric_limits<double>::infinity();  ///< geodesic distance [m]; infinite without a path
  std::vector<dvec3> path;                                 ///< path on the surface; empty if there is none
};
using MeasuredPtr = std::shared_ptr<const Measured>;

/// A probe pressed on the edited layout: the request and its result. It is drawn and read like a sensor of a
/// simulation.
struct PressedProbe {
  SensorModelPtr model;  ///< model on which the probe is pressed; never null
  Probe probe;           ///< the requested probe; a ProbeMesh has its file only
  std::string problem;   ///< reason why pressing failed, or empty; if set, the rest is not valid
  TriMeshPtr mesh;       ///< mesh of the probe for drawing
  Pose X_MG;             ///< pose of the probe's mesh
  SensorStep state;      ///< state of the model at rest, with its frame M as the world
  double force = 0;      ///< force of the pressure on the sensor [N]
  double area = 0;       ///< area of the contact surface [m^2]
  double largest = 0;    ///< largest pressure [Pa]
  int polygons = 0;
};
using PressedProbePtr = std::shared_ptr<const PressedProbe>;

/// Line and waypoints of the path of the finger's lowest point.
struct ShownPath {
  std::vector<dvec3> line_W, points_W;
  int selected = -1;  ///< index in points_W, or -1
  bool operator==(const ShownPath&) const = default;
};

enum class FramesShown { none, bodies, geoms, sites, world };
inline constexpr std::array kFramesWords = {"none", "bodies", "geoms", "sites", "world"};

enum class LabelsShown { none, bodies, joints, geoms, sites, cameras };
inline constexpr std::array kLabelsWords = {"none", "bodies", "joints", "geoms", "sites", "cameras"};

inline const char* to_word(FramesShown shown) {
  return kFramesWords.at(static_cast<std::size_t>(shown));
}
inline const char* to_word(LabelsShown shown) {
  return kLabelsWords.at(static_cast<std::size_t>(shown));
}

/// Returns the next selection; after the last selection, the first one.
inline FramesShown next(FramesShown shown) {
  return static_cast<FramesShown>((static_cast<std::size_t>(shown) + 1) % kFramesWords.size());
}
inline LabelsShown next(LabelsShown shown) {
  return static_cast<LabelsShown>((static_cast<std::size_t>(shown) + 1) % kLabelsWords.size());
}

/// A range of numbers and the colour map. One range holds the pressures [Pa] of surface and rays, another one the
/// readings of skin, discs, bars and map.
struct PressureRange {
  double lo = 0, hi = 1;
  bool automatic = true;
  const ColorMap* colors = &kColorMaps.front();

  /// Returns the colour of a pressure; all pressures have the first colour while the range is empty.
  [[nodiscard]] glm::vec3 color(double pressure) const {
    return colors->at(hi > lo ? (pressure - lo) / (hi - lo) : 0.0);
  }
  bool operator==(const PressureRange&) const = default;
};

/// The range of the slip map, from bristles that stick to bristles that slip.
inline constexpr PressureRange kSlipRange{0, 1, false};

/// Things drawn in the view; keys in brackets as in the keymap.
struct Overlays {
  bool sensor_transparent = true;  // [T] X-ray: the far side of the skin is seen through it
  bool wireframe = false;          // [W]
  bool rays = true;                // [Y]
  bool contact_surface = true;     // [C]
  bool contact_edges = false;
  bool slip_map = false;           // the part of the contact that slips, instead of the pressure
  bool tractions = false;          // [V] pressure and friction of each polygon, as arrows
  bool readings_on_skin = false;   // [S] the taxels' readings, spread by the weights of their fields
  bool ghost = true;               // contact surfaces of the previous step, while a reading is explained
  bool filtered_polygons = false;  // polygons of the overlap that the surface left out
  bool samples = true;             // [P]
  bool sample_normals = false;     // [N]
  bool taxels = true;              // centre and normal arrow
  bool taxel_labels = true;
  bool receptive_fields = true;  // ring on the surface
  bool reading_discs = false;    // receptive fields that are drawn glow with their readings
  bool all_taxels = true;        // if false, only hovered, selected and responding taxels have arrows and ids
  bool fields_filled = false;    // fields by the layout's metric
  bool fields_compared = false;  // areas that only the Euclidean distance reaches
  bool coverage = false;         // number of taxels at each spot
  bool normal_angles = false;    // taxel normals coloured by their angle to the normals of the skin
  bool path = true;              // path of the finger, red line
  bool grid = true;
  bool scene_grid = false;  // grid in a user's scene, which has a floor of its own
  bool constraints = true;  // points that welds and connections hold together
  bool all_rays = false;    // if false, rays of the selected taxel, or of all responding ones
  GroupsShown geom_groups{true, true, true, false, false, false};  // [0] to [5], as in MuJoCo's viewer
  GroupsShown site_groups{true, true, true, false, false, false};  // [Shift+0] to [Shift+5]
  FramesShown frames = FramesShown::none;                          // [F6]
  LabelsShown labels = LabelsShown::none;                          // [F7]
  bool operator==(const Overlays&) const = default;
};

/// Returns the overlays that are on in LAYOUT at first: everything about the taxels, on an opaque skin.
[[nodiscard]] inline Overlays overlays_of_layout() {
  Overlays overlays;
  overlays.sensor_transparent = false;
  return overlays;
}

/// Returns the overlays that are on in SIMULATE at first: what shows the contact and the readings.
[[nodiscard]] inline Overlays overlays_of_run() {
  Overlays overlays;
  overlays.samples = false;
  overlays.all_taxels = false;
  overlays.reading_discs = true;
  return overlays;
}

/// Returns true if a geom is drawn. A sensor is always drawn, whatever the group of its geom; a geom that coincides
/// with the skin of a sensor never is, because both surfaces would flicker through each other.
[[nodiscard]] inline bool shows(const Overlays& show, const SceneGeom& geom) {
  if (geom.covered_by >= 0) return false;
  return geom.sensor >= 0 || show.geom_groups.at(static_cast<std::size_t>(geom.group));
}
[[nodiscard]] inline bool shows(const Overlays& show, const SceneSite& site) {
  return site.mesh && show.site_groups.at(static_cast<std::size_t>(site.group));
}

/// Returns the drawn map: the most specific one of the active maps.
[[nodiscard]] inline FieldMap field_map(const Overlays& show) {
  if (show.coverage) return FieldMap::coverage;
  if (show.fields_compared) return FieldMap::compared;
  return show.fields_filled ? FieldMap::filled : FieldMap::none;
}

/// A scene around the edited layout, drawn as a ghost.
struct Surroundings {
  SimFramePtr frame;  ///< displayed step of the scene; never null
  Pose X_MW;          ///< pose of the scene's world in the frame of the layout's mesh
  int body = -1;      ///< body of the layout's geom, which is not drawn: index in SceneControls::bodies
  bool operator==(const Surroundings& other) const {
    return frame == other.frame && X_MW.p == other.X_MW.p && X_MW.q == other.X_MW.q && body == other.body;
  }
};

struct SceneInput {
  SimFramePtr frame;                         ///< displayed step; if null only grid and background are drawn
  SensorModelPtr document_model;             ///< layout at the origin, if there is no simulation; may be null
  std::optional<Surroundings> surroundings;  ///< scene around document_model
  PressedProbePtr probe;                     ///< probe pressed on document_model; may be null
  Overlays overlays;
  PressureRange range;
  PressureRange reading_range;  ///< range of the readings, in SI units
  int selected_sensor = 0;
  int selected_body = -1;                       ///< index in SceneControls::bodies, or -1
  int selected_taxel = -1;                      ///< active taxel in layout order, or -1
  std::vector<int> selected_taxels;             ///< all selected taxels, also the active one; ascending
  int hovered_sensor = -1, hovered_taxel = -1;  ///< taxel under the pointer, in layout order, or -1
  std::vector<int> hidden_taxels;  ///< indices in the document's layout, ascending; neither drawn nor picked
  FaceSet region;                  ///< painted faces of the document's mesh, ascending
  bool repair_changes = false;     ///< draws the changes by the repair of the document's mesh
  ShownFieldsPtr fields;           ///< receptive fields computed elsewhere; null if there are none yet
  std::shared_ptr<const std::vector<Taxel>> ghosts;  ///< taxels that are not in the layout (yet); may be null
  int ghosts_sensor = -1;                            ///< sensor of the frame whose frame M `ghosts` are in, or -1
  StepPtr before;                                    ///< previous step, whose surfaces are drawn as ghosts; may be null
  int marked_surface = -1, marked_polygon = -1;      ///< outlined surface and polygon of the selected sensor, or -1
  std::optional<ClipPlane> clip;                     ///< plane that cuts bodies and their marks, not the contact
  MeasuredPtr measured;                              ///< measured line on the document's skin; may be null
  std::vector<dvec3> measure_points;                 ///< ends of the measured line, and the point under the pointer
  std::optional<ShownPath> path;                     ///< edited path, replaces the path of the frame
  bool dark = true;
  bool has_gizmo = true;                               ///< whether the gizmo of the axes is drawn
  double scale = 1;                                    ///< scale of lines, points and the gizmo
  bool operator==(const SceneInput&) const = default;  ///< same values, same frame and model (not equal copies)
};

}  // namespace taxel::ui
