// Bodies with a tessellation twice as fine, and the error that is left according to two tessellations.
#pragma once

#include <span>
#include <vector>

#include "core/hydro/hydro_body.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// Returns the shape with edges half as long. Faces of soft meshes are divided into four, and their numbers are left
/// out. Planes, boxes, tets, and meshes of rigid bodies are returned unchanged: planes, boxes and meshes are exact, and
/// tets are the user's own. Throws Error if a soft mesh is not a manifold or would have too many faces (subdivide.h).
Shape finer_shape(Shape shape, const Material& material);

/// Returns a model of the same samples, fields and rays, whose body has edges half as long. A rigid model is returned
/// as it is. Throws Error as finer_shape() and make_body() do.
SensorModelPtr with_finer_body(const SensorModelPtr& model);

/// Returns a bar of the error of each coarse reading from readings with edges half as long. The pressure is linear on
/// each tet, so that errors fall with the square of the length of edges: coarse - limit = 4/3 (coarse - fine), the
/// extrapolation of Richardson (1911, "The Approximate Arithmetical Solution by Finite Differences").
std::vector<double> richardson_bars(std::span<const double> coarse, std::span<const double> fine);

}  // namespace taxel
