// What a scene has beside its geoms that viewers mark: sites, cameras, joints; and what MuJoCo says of a step. Free of
// MuJoCo.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// MuJoCo's mjNGROUP: viewers show geoms and sites by groups 0 to 5.
inline constexpr std::size_t kSceneGroups = 6;
using GroupsShown = std::array<bool, kSceneGroups>;

/// A place in a body, frame S, drawn as `mesh`.
struct SceneSite {
  std::string name;
  int body = 0;  ///< in SceneControls::bodies
  Pose X_BS;
  TriMeshPtr mesh;  ///< frame S; null: of a mesh that cannot be drawn
  std::array<float, 4> rgba{0.5f, 0.5f, 0.5f, 1.0f};
  int group = 0;  ///< 0 to 5
};
/// Frame C: looks along -z, y up.
struct SceneCamera {
  std::string name;
  double height = 45;  ///< of what is seen: its angle [degrees], or, where it is orthographic, its length [m]
  bool orthographic = false;
};
struct SceneJointPlace {
  std::string name;
  int body = 0;
  dvec3 p_B{0};  ///< anchor
};
/// How MJCF has the scene looked at first: <statistic> and <visual><global>.
struct SceneOverview {
  dvec3 center_W{0};
  double extent = 0;  ///< [m]; 0: unknown
  double azimuth_deg = 90,
         elevation_deg = 45;  ///< of the eye, seen from the centre: about +z from +x, above the horizon
  double fov_deg = 45;        ///< vertical
};

/// Does not change while the scene runs.
struct SceneMarks {
  std::vector<SceneSite> sites;
  std::vector<SceneCamera> cameras;
  std::vector<SceneJointPlace> joints;  ///< all of them
  SceneOverview overview;
  double mean_size = 0;     ///< of bodies, as MuJoCo has it: frames are drawn that long [m]; 0: unknown
  int dofs = 0;             ///< degrees of freedom
  std::uint64_t arena = 0;  ///< MuJoCo's memory for contacts and constraints [bytes]
  std::string solver;       ///< as MJCF says it
};

/// Where marks are in one step. Empty in a step that was saved to a file.
struct MarkPoses {
  std::vector<Pose> bodies;   ///< X_WB parallel to SceneControls::bodies
  std::vector<Pose> cameras;  ///< X_WC parallel to SceneMarks::cameras
};

struct SceneEnergy {
  double potential = 0, kinetic = 0;  ///< [J]
};
/// What MuJoCo says of one step.
struct StepFacts {
  std::int32_t contacts = 0, constraints = 0;  ///< MuJoCo's own: what sensors touch is not among them
  std::int32_t iterations = 0;                 ///< of the solver, in all islands together
  std::int32_t islands = 0;
  std::uint64_t arena = 0;            ///< most of it that was used so far [bytes]
  std::optional<SceneEnergy> energy;  ///< none: the scene does not have it computed
};

}  // namespace taxel
