// Sites, cameras and joints of a scene, which viewers mark, and MuJoCo's figures of a step. Free of MuJoCo.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/mesh/tri_mesh.h"

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

}  // namespace taxel
