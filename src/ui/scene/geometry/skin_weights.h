// The receptive fields as weights on the skin, so that readings can be spread over it in every picture.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/sensor/sensor_model.h"

namespace taxel::ui {

/// The part of a skin that taxels see, in small triangles. Frame M.
struct SkinWeights {
  struct Weight {
    int taxel = 0;    ///< in layout order
    float share = 0;  ///< fraction of the weights at one point; they sum to 1
  };
  std::vector<glm::vec3> points;              ///< [m]
  std::vector<int> first{0};                  ///< weights of point i: [first[i], first[i + 1])
  std::vector<Weight> weights;                ///< never none at a point
  std::vector<std::array<int, 3>> triangles;  ///< three points each, with the winding of the skin

  /// Computes the reading at each point: sum of w_k p_k / sum of w_k, w = (r - d)^2.
  void spread(std::span<const double> readings, std::vector<float>& at_points) const;
};

/// Faces are cut until edges are a sixth of the smallest radius, within bounds, and where the fields end. By the
/// layout's metric and angle limit, subtaxels included. The same on any number of threads.
SkinWeights skin_weights(const SensorModel& model);

}  // namespace taxel::ui
