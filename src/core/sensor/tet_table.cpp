#include "core/sensor/tet_table.h"

#include <limits>

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
  std::vector<std::uint32_t> first(tets + 1, 0);
  for (const auto& of_ray : crossings)
    for (const TetCrossing& c : of_ray) ++first[static_cast<std::size_t>(c.tet) + 1];
  tets_.assign(tets, TetRays{});
  std::uint32_t tiles = 0;
  for (std::size_t t = 0; t < tets; ++t) {
    tets_[t].first_tile = tiles;
    tets_[t].tiles = (first[t + 1] + Tile::kRays - 1) / Tile::kRays;
    tiles += tets_[t].tiles;
    first[t + 1] += first[t];
  }
  tiles_.resize(tiles);
  std::vector<std::uint32_t> filling(first.begin(), first.end() - 1);
  std::vector<RayPiece> pieces(first.back());
  for (std::size_t r = 0; r < rays.size(); ++r) {
    for (const TetCrossing& c : crossings[r])
      pieces[filling[static_cast<std::size_t>(c.tet)]++] = {&rays[r], static_cast<std::int32_t>(r), c.t_min, c.t_max};
  }
  parallel_chunks(static_cast<int>(tets), 512, [&](int begin, int end) {
    for (auto t = static_cast<std::size_t>(begin); t < static_cast<std::size_t>(end); ++t)
      set(t, std::span(pieces).subspan(first[t], first[t + 1] - first[t]));
  });
}

void TetTable::set(std::size_t tet, std::span<const RayPiece> pieces) {
  if (pieces.empty()) return;
  const RayViewer viewer(pieces);
  TetRays& rays = tets_[tet];
  rays.view = viewer.view();
  for (std::size_t i = 0; i < rays.tiles * Tile::kRays; ++i) {
    Tile& tile = tiles_[rays.first_tile + i / Tile::kRays];
    const bool empty = i >= pieces.size();
    const RayPlace place = empty ? RayPlace{std::numeric_limits<float>::infinity()} : viewer.place_of(pieces[i]);
    const std::size_t k = i % Tile::kRays;
    tile.u[k] = place.u;
    tile.v[k] = place.v;
    tile.u_slope[k] = place.u_slope;
    tile.v_slope[k] = place.v_slope;
    tile.middle[k] = place.middle;
    tile.half[k] = place.half;
    tile.ray[k] = empty ? -1 : pieces[i].number;
  }
}

}  // namespace taxel
