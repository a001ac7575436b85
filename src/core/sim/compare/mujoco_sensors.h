// What MuJoCo's own tactile sensors say of a contact: the same bodies in a small model of their own, which shares
// nothing with the scene that runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/run/frame.h"
#include "core/sim/mujoco_handles.h"

namespace taxel {

/// Of each taxel, in layout order.
struct MujocoReadings {
  std::vector<double> depth;  ///< `<tactile>`, mean over the taxel's field [m]
  std::vector<double> touch;  ///< `<touch>`, one sphere for each taxel, at its centre and of its radius [N]
};

/// A sensor's skin, which MuJoCo takes for its convex hull, on a body that slides but does not turn; the bodies that it
/// touches, each of them where it is put.
///
/// Depth: MuJoCo's signed distance of the other body, of the deepest body, at the vertices of a mesh; 0 where MuJoCo
/// finds no contact. The vertices are samples of the taxel, up to kMostVertices of them, and its value is their mean by
/// the weights of its field; its centre where it has no samples. Meshes get an octree of distances (mjsMesh.needsdf).
///
/// Touch: the poses are those of the hydroelastic contact, so MuJoCo's own compliance (solref) has no say: of each pair
/// its constraints carry, without friction and at rest (solref -0 -0), the force of the contact's elastic pressure.
/// What is MuJoCo's is where it finds contact points, and how its solver shares the force among them.
class MujocoSensors {
 public:
  /// Throws Error with MuJoCo's reason where a shape cannot be compiled.
  MujocoSensors(const SensorModel& model, const std::vector<TouchedBody>& touched,
                const std::vector<SensorModelPtr>& sensors);

  /// The contact where the sensor's mesh frame lies at X_WM and the bodies at X_WB, parallel to `touched`. `load_W`:
  /// the force with which each pushes the sensor, zero without contact. A pure function of these.
  [[nodiscard]] MujocoReadings read(const Pose& X_WM, const std::vector<Pose>& X_WB, const std::vector<dvec3>& load_W);

 private:
  static constexpr std::size_t kMostVertices = 64;
  /// A vertex of the tactile mesh.
  struct Vertex {
    dvec3 at{0};
    std::size_t taxel = 0;
    double share = 0;  // of the taxel's weights
  };
  void add_taxel_mesh(mjSpec* spec, const SensorModel& model);
  void place(const Pose& X_WM, const std::vector<Pose>& X_WB);
  void add_pair(std::size_t body, const dvec3& load_W, std::vector<double>& depths, MujocoReadings& out);

  std::size_t taxels_ = 0;
  std::vector<Vertex> vertices_;
  ModelHandle model_;
  DataHandle data_;
  int sensor_body_ = 0;
  std::vector<int> geoms_, mocaps_;  // parallel to touched; -1: a body that cannot be touched
  int depths_ = 0, touches_ = 0;     // where their values begin
};

}  // namespace taxel
