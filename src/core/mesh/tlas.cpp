#include "core/mesh/tlas.h"

namespace taxel {

void Tlas::build(std::span<const Bvh* const> blas) {
  blas_.assign(blas.begin(), blas.end());
  boxes_.clear();
  for (const Bvh* tree : blas_) boxes_.push_back(tree->empty() ? Aabb{} : tree->nodes()[0].box);
  top_.build(boxes_, 1);
}

}  // namespace taxel
