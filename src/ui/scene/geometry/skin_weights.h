// Weights of the receptive fields on the skin, with which readings are spread over the skin in every frame.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/sensor/sensor_model.h"

namespace taxel::ui {

/// The part of a skin inside receptive fields, in small triangles. Frame M.
struct SkinWeights {
  struct Weight {
    int taxel = 0;    ///< index in layout order
    float share = 0;  ///< fraction of the weights at one point; they sum to 1
  };
  std::vector<glm::vec3> points;              ///< [m]
  std::vector<int> first{0};                  ///< weights of point i: [first[i], first[i + 1])
  std::vector<Weight> weights;                ///< weights of all points; each point has at least one
  std::vector<std::array<int, 3>> triangles;  ///< three points each, with the winding of the skin

  /// Computes the reading at each point: sum of w_k p_k / sum of w_k, w = (r - d)^2.
  void spread(std::span<const double> readings, std::vector<float>& at_points) const;
};

/// Computes the weights by the layout's metric and angle limit, subtaxels included. Faces are divided until their edges
/// are at most a sixth of the smallest radius, within limits, and are clipped at the ends of the fields. The result
/// does not depend on the number of threads.
SkinWeights skin_weights(const SensorModel& model);

}  // namespace taxel::ui
