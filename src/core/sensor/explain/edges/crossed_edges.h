// Finds the edges of the skin's mesh under a taxel that a contact crossed from one step to the next.
//
//        f     |     g        The force of each contact polygon acts on the face of the skin that is nearest to the
//     ____ooo__|______        polygon's centroid. The contact crossed the edge between f and g if the force on one
//     ______oo_|o_____        of them fell while the other's rose, or if it reached or left one of them while it
//                             acted on the other in both steps.
#pragma once

#include <vector>

#include "core/sensor/explain/edges/crossed_edge.h"
#include "core/sensor/sensor_step.h"

namespace taxel {

/// Angle between the normals of two faces up to which their edge is flat [degrees].
inline constexpr double kFlatEdge = 0.1;
/// Largest number of edges that crossed_edges() returns.
inline constexpr std::size_t kMaxCrossedEdges = 8;

/// Returns the edges inside the receptive field of taxel number `taxel` of now.model that the contact crossed, except
/// flat ones, by descending product of force and angle. An edge is inside if a point of the edge is within the radius
/// of the field, by the straight distance. An edge on the way of the centre of the pressure counts as well: then all of
/// the force in the field crossed the edge. `before` is a step of the same model.
std::vector<CrossedEdge> crossed_edges(int taxel, const SensorStep& before, const SensorStep& now);

}  // namespace taxel
