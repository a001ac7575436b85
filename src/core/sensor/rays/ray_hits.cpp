#include "core/sensor/rays/ray_hits.h"

#include <bit>

namespace taxel {

void RayHits::clear(std::size_t ray_count) {
  if (hits_.size() != ray_count) {
    hits_.assign(ray_count, RayHit{});
    marks_.assign((ray_count + kBits - 1) / kBits, 0);
    rays_.clear();
    rays_.reserve(ray_count);  // no step allocates, however many rays it hits
    return;
  }
  for (const std::int32_t ray : rays_) {
    hits_[static_cast<std::size_t>(ray)] = RayHit{};
    marks_[static_cast<std::size_t>(ray) / kBits] = 0;
  }
  rays_.clear();
}

void RayHits::finish() {
  rays_.clear();
  for (std::size_t word = 0; word < marks_.size(); ++word)
    for (std::uint64_t bits = marks_[word]; bits != 0; bits &= bits - 1)
      rays_.push_back(static_cast<std::int32_t>(word * kBits + static_cast<std::size_t>(std::countr_zero(bits))));
}

}  // namespace taxel
