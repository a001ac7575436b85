#include "core/sensor/tet_table.h"

#include "core/base/parallel.h"

namespace taxel {

TetTable::TetTable(const PressureField& field, std::span<const SensorRay> rays) {
  const TetCrossings tets(field);
  std::vector<std::vector<TetCrossing>> found(rays.size());
  parallel_chunks(static_cast<int>(rays.size()), 512, [&](int begin, int end) {
    for (auto r = static_cast<std::size_t>(begin); r < static_cast<std::size_t>(end); ++r) tets.find(rays[r], found[r]);
  });
  fill(field.tets().size(), rays, std::vector<std::span<const TetCrossing>>(found.begin(), found.end()));
}

void TetTable::fill(std::size_t tets, std::span<const SensorRay> rays,
                    std::span<const std::span<const TetCrossing>> crossings) {
  first_.assign(tets + 1, 0);
  for (const auto& of_ray : crossings)
    for (const TetCrossing& c : of_ray) ++first_[static_cast<std::size_t>(c.tet) + 1];
  for (std::size_t t = 0; t < tets; ++t) first_[t + 1] += first_[t];
  rays_ = RayList(first_.back());
  std::vector<std::uint32_t> filling(first_.begin(), first_.end() - 1);
  for (std::size_t r = 0; r < rays.size(); ++r) {
    for (const TetCrossing& c : crossings[r])
      rays_.set(filling[static_cast<std::size_t>(c.tet)]++, rays[r], static_cast<std::int32_t>(r), c.t_min, c.t_max);
  }
}

}  // namespace taxel
