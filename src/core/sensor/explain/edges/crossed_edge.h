// An edge of the skin's mesh that a contact crossed, as a value.
#pragma once

#include <array>

namespace taxel {

/// An edge of the skin's mesh in the receptive field of a taxel. Force crossed the edge from one step to the next.
struct CrossedEdge {
  std::array<int, 2> faces{};  ///< faces of SensorModel::mesh at the edge, ascending
  double bend_deg = 0;         ///< angle between the normals of the faces [degrees]
  double distance = 0;         ///< distance of the edge from the taxel's centre [m]
  double force = 0;            ///< force that crossed the edge [N]
};

}  // namespace taxel
