// The parts of a scene that do not change while it runs: geoms, sensors, and the sites, cameras and joints that viewers
// mark. MuJoCo's figures of a step are here as well. Plain values, free of MuJoCo.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/document/scenario/scenario.h"
#include "core/mesh/tri_mesh.h"
#include "core/run/controls.h"
#include "core/run/scene_look.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// MuJoCo's mjNGROUP: viewers hide and show geoms and sites by groups 0 to 5.
inline constexpr std::size_t kSceneGroups = 6;
using GroupsShown = std::array<bool, kSceneGroups>;

/// A site of a body, frame S, drawn as `mesh`.
struct SceneSite {
  std::string name;
  int body = 0;  ///< index in SceneControls::bodies
  Pose X_BS;
  TriMeshPtr mesh;  ///< frame S; null if the site's mesh cannot be drawn
  std::array<float, 4> rgba{0.5f, 0.5f, 0.5f, 1.0f};
  int group = 0;  ///< 0 to 5
};
/// A camera, frame C, which looks along -z, with y up.
struct SceneCamera {
  std::string name;
  double height = 45;  ///< vertical field of view [degrees], or visible height if orthographic [m]
  bool orthographic = false;
};
struct SceneJointPlace {
  std::string name;
  int body = 0;
  dvec3 p_B{0};  ///< anchor
};
/// The first view of the scene, from MJCF's <statistic> and <visual><global>.
struct SceneOverview {
  dvec3 center_W{0};
  double extent = 0;  ///< [m]; 0 if unknown
  /// Direction from the centre to the eye: angle about +z from +x, and angle above the horizon.
  double azimuth_deg = 90, elevation_deg = 45;
  double fov_deg = 45;  ///< vertical field of view
};

/// The marks of a scene. They do not change while the scene runs.
struct SceneMarks {
  std::vector<SceneSite> sites;
  std::vector<SceneCamera> cameras;
  std::vector<SceneJointPlace> joints;  ///< joints of all kinds
  SceneOverview overview;
  double mean_size = 0;     ///< MuJoCo's mean body size, the length of drawn frames [m]; 0 if unknown
  int dofs = 0;             ///< degrees of freedom
  std::uint64_t arena = 0;  ///< MuJoCo's memory for contacts and constraints [bytes]
  std::string solver;       ///< MJCF keyword
};

/// The poses of marks at one step. Empty in a step that was read from a file.
struct MarkPoses {
  std::vector<Pose> bodies;   ///< X_WB, parallel to SceneControls::bodies
  std::vector<Pose> cameras;  ///< X_WC, parallel to SceneMarks::cameras
};

struct SceneEnergy {
  double potential = 0, kinetic = 0;  ///< [J]
};
/// MuJoCo's figures of one step.
struct StepFacts {
  std::int32_t contacts = 0, constraints = 0;  ///< numbers of MuJoCo's own, without contacts of sensors
  std::int32_t iterations = 0;                 ///< iterations of the solver, summed over all islands
  std::int32_t islands = 0;
  std::uint64_t arena = 0;            ///< largest part of the arena that was used so far [bytes]
  std::optional<SceneEnergy> energy;  ///< empty if the scene does not compute its energy
};

/// The surface of a geom as the mesh of a layout, frame M: the frame of the mesh file after scaling. The frame of a
/// geom without a mesh is its own.
struct GeomSkin {
  /// Path of the mesh file; empty if the shape is in no file, in one that cannot be read, or mirrored by its scale.
  std::string file;
  dvec3 scale{1};  ///< scale of the file
  Pose X_GM;       ///< pose of frame M in the geom
  /// Reason why the geom can have no layout, such as "is a plane"; empty if it can have one.
  std::string problem;
};

/// A geom as it is drawn, frame G. Meshes and primitives are triangles; a plane is a large square with `plane` set.
struct SceneGeom {
  std::string name;   ///< name; a geom without one has that of geom_sensor_names()
  std::string label;  ///< geom_labels() of a geom without a name; empty for others
  /// Class of defaults that the geom names itself, and name of the mesh asset. Empty if there is none, and in a step
  /// that was read from a file.
  std::string class_name, mesh_name;
  std::string body;
  int body_index = 0;  ///< index in SceneControls::bodies
  TriMeshPtr mesh;
  std::array<float, 4> rgba{0.6f, 0.6f, 0.6f, 1.0f};
  bool plane = false;
  int sensor = -1;                         ///< index of the sensor whose skin is drawn instead, or -1
  int group = 0;                           ///< MuJoCo's group, 0 to 5, by which viewers hide and show geoms
  int covered_by = -1;                     ///< index of the sensor whose skin coincides with the geom's surface, or -1
  std::array<double, 2> plane_size{0, 0};  ///< half sizes of a plane [m]; 0 if infinite
  SceneMaterialPtr material;               ///< material; null for MuJoCo's default material
  TextureCoordsPtr texture_coords;         ///< places of `mesh` in a flat texture of the material; null if none
  GeomSkin skin;

  /// Returns the name in lists and messages.
  [[nodiscard]] const std::string& shown_name() const { return label.empty() ? name : label; }
};

/// A body that a sensor can touch. At most one of `geom` and `sensor` is set; a body with neither does not move.
struct TouchedBody {
  HydroBodyPtr body;                   ///< the touched body; null for a sensor that cannot be touched
  int geom = -1;                       ///< index in SimScene::geoms, or -1; the body is in that geom's frame
  int sensor = -1;                     ///< index in SimScene::sensors, or -1; the body is in that sensor's frame M
  bool mirrored = false;               ///< the other sensor computes the surface of this pair
  Pose X_WB;                           ///< pose of a body that does not move
  std::string name;                    ///< name of its geom
  std::shared_ptr<const Shape> shape;  ///< shape in the frame of the body; null for a sensor with taxels
};

/// The parts of a scene that do not change while it runs.
struct SimScene {
  std::string title;
  std::vector<std::string> files;  ///< included files, assets and layouts, without the scene file itself
  std::vector<SceneGeom> geoms;
  std::vector<SensorModelPtr> sensors;
  std::vector<std::string> sensor_geoms;   ///< geom name of each sensor
  std::vector<std::string> sensor_labels;  ///< short_sensor_names() of `sensor_geoms`, for labels such as "index 3"
  /// Layout file of each sensor that the scene's file declares by a file; empty for other sensors.
  std::vector<std::string> sensor_layouts;
  std::vector<bool> sensor_slips;  ///< true if the friction of the sensor sticks, so that it reads slip
  /// Bodies that each sensor can touch. Empty in steps that were saved by a version that did not write them.
  std::vector<std::vector<TouchedBody>> touched;
  std::vector<dvec3> path_W;         ///< path of the finger's lowest point, drawn as a red line; may be empty
  dvec3 lead_M{0};                   ///< the finger's lowest point, in the frame of its mesh file
  std::vector<WayPoint> way_points;  ///< points between the parts of a scenario's motion; empty for a drop
  double duration = 0;               ///< length of the scenario [s]; 0 for a scene without an end
  double timestep = 0;               ///< simulated time per step [s]
  std::uint64_t model_edition = 0;   ///< number of model replacements since the scene was loaded
  SceneControls controls;
  SceneMarks marks;
  SceneLookPtr look;  ///< lights and sky of the user's file; null for a built-in scenario and a saved step
};

}  // namespace taxel
