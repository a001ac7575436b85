// The parts of a scene that do not change while it runs. Plain values, free of MuJoCo.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/document/scenario/scenario.h"
#include "core/mesh/tri_mesh.h"
#include "core/run/controls.h"
#include "core/run/marks.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// A geom as it is drawn, frame G. Meshes and primitives are triangles; a plane is a large square with `plane` set.
struct SceneGeom {
  std::string name;
  std::string body;
  int body_index = 0;  ///< index in SceneControls::bodies
  TriMeshPtr mesh;
  std::array<float, 4> rgba{0.6f, 0.6f, 0.6f, 1.0f};
  bool plane = false;
  int sensor = -1;  ///< index of the sensor whose skin is drawn instead, or -1
  int group = 0;    ///< MuJoCo's group, 0 to 5, by which viewers hide and show geoms
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
  std::vector<std::string> sensor_geoms;  ///< geom name of each sensor
  std::vector<bool> sensor_slips;         ///< true if the friction of the sensor sticks, so that it reads slip
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
};

}  // namespace taxel
