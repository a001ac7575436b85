// Receptive fields that have their own density of samples.
#pragma once

#include <vector>

#include "core/layout/layout.h"
#include "core/layout/sampling/dense_samples.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Returns true if a taxel has more samples than the layout gives.
inline bool is_dense(const Taxel& taxel, const Sampling& sampling) {
  return taxel.density > sampling.density;
}

/// Returns the number of samples on `area` without the densities of taxels. `count` is the number of samples that there
/// are, which is returned if no taxel has a density of its own.
double uniform_samples(const Layout& layout, std::size_t count, double area);

/// Returns the discs of all taxels with a density of their own, on the side of the skin to which their normals point.
/// Each disc contains the receptive field of its taxel or subtaxel.
std::vector<DenseDisc> dense_fields(const Layout& layout, const MeshIndex& skin);

/// Multiplies all densities of a layout.
void multiply_densities(Layout& layout, double factor);

}  // namespace taxel
