// The points near a place, found through a list of cells and tested in the lanes of vectors.
//
// Points are sorted by the keys of their cells, which are x, y and z packed into one number. The three cells next to
// each other along x are one range of the sorted points, so the 27 cells around a cell are nine ranges, found for all
// cells in one pass per row. The points of these ranges are copied into arrays of single precision, relative to a point
// of the cell and in units of the spacing, and each query tests all of them, sixteen at a time. Places far away fill
// the last lanes. There are no fused operations, so all instruction sets give the same bits.
#include "core/layout/sampling/surroundings.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/layout/sampling/surroundings.cpp"
#include <hwy/foreach_target.h>
// The line above includes this file once per instruction set: it stays first.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<float, 16>;
using TagI = hn::RebindToSigned<Tag>;
using Vec = hn::Vec<Tag>;

struct Three {
  Vec x, y, z;
};
HWY_INLINE Three spread(const float (&v)[3]) {
  return {hn::Set(Tag(), v[0]), hn::Set(Tag(), v[1]), hn::Set(Tag(), v[2])};
}
HWY_INLINE Vec inner(const Three& a, const Three& b) {  // no fused operations: the same bits on every machine
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

int run_find_near(const PointRows& in, const NearPlace& place, float reach, int except, NearPoints& near) {
  const Tag d;
  const TagI di;
  const Three center = spread(place.position), normal = spread(place.normal);
  const Vec limit = hn::Set(d, reach * reach), right_angle = hn::Set(d, -1e-6F);  // a cosine of 0 with rounding
  const auto self = hn::Set(di, except);
  std::size_t count = 0;
  for (std::size_t i = 0; i < in.size; i += hn::Lanes(d)) {
    const Three apart{hn::Sub(hn::LoadU(d, in.x.data() + i), center.x),
                      hn::Sub(hn::LoadU(d, in.y.data() + i), center.y),
                      hn::Sub(hn::LoadU(d, in.z.data() + i), center.z)};
    const Vec squared = inner(apart, apart);
    const auto rank = hn::LoadU(di, in.rank.data() + i);
    const auto found = hn::AndNot(hn::RebindMask(d, hn::Eq(rank, self)), hn::Lt(squared, limit));
    if (hn::AllFalse(d, found)) continue;
    const Three other{hn::LoadU(d, in.normal_x.data() + i), hn::LoadU(d, in.normal_y.data() + i),
                      hn::LoadU(d, in.normal_z.data() + i)};
    const Vec cosine = inner(normal, other), rise_a = inner(normal, apart), rise_b = inner(other, apart);
    const Vec steepest =
        hn::Sub(hn::Set(d, 1.5F), cosine);  // at least sin(30 degrees + bend), up to 1, which allows everything
    const Vec rise = hn::Max(hn::Mul(rise_a, rise_a), hn::Mul(rise_b, rise_b));
    const auto patch =
        hn::And(hn::Gt(cosine, right_angle), hn::Le(rise, hn::Mul(hn::Mul(steepest, steepest), squared)));
    hn::CompressStore(rank, hn::RebindMask(di, found), di, near.rank.data() + count);
    hn::CompressStore(apart.x, found, d, near.x.data() + count);
    hn::CompressStore(apart.y, found, d, near.y.data() + count);
    hn::CompressStore(apart.z, found, d, near.z.data() + count);
    hn::CompressStore(hn::Sqrt(squared), found, d, near.distance.data() + count);
    count += hn::CompressStore(hn::IfThenElse(patch, cosine, hn::Set(d, NearPoints::kOffPatch)), found, d,
                               near.cosine.data() + count);
  }
  return static_cast<int>(count);
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace taxel {

namespace {

constexpr int kBits = 21;
constexpr std::uint64_t kLargest = (1U << kBits) - 1;  // largest coordinate; points farther away share the last cells

std::uint64_t pack(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return x | (y << kBits) | (z << (2 * kBits));
}

std::array<std::uint64_t, 3> unpack(std::uint64_t key) {
  return {key & kLargest, (key >> kBits) & kLargest, key >> (2 * kBits)};
}

}  // namespace

CellList::CellList(std::span<const dvec3> points, double cell) {
  Aabb box;
  for (const dvec3& p : points) box.include(p);
  std::vector<std::pair<Key, int>> sorted;
  sorted.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const dvec3 c = glm::min((points[i] - box.lo) / cell, dvec3(static_cast<double>(kLargest)));
    sorted.emplace_back(pack(static_cast<Key>(c.x), static_cast<Key>(c.y), static_cast<Key>(c.z)), static_cast<int>(i));
  }
  std::sort(sorted.begin(), sorted.end());
  points_.reserve(points.size());
  for (const auto& [key, point] : sorted) {
    const auto rank = static_cast<std::uint32_t>(points_.size());
    if (cells_.empty() || cells_.back().key != key) cells_.push_back({key, {rank, rank}, {}});
    cells_.back().ranks.end = rank + 1;
    points_.push_back(point);
  }
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy) find_row(dy, dz);
}

/// Finds the row of up to three cells next to each cell. Both ends advance with the keys, so that one pass finds all.
void CellList::find_row(int dy, int dz) {
  const auto row = static_cast<std::size_t>(4 + dy + 3 * dz);
  std::size_t begin = 0, end = 0;
  const auto rank = [&](std::size_t c) {
    return c < cells_.size() ? cells_[c].ranks.begin : static_cast<std::uint32_t>(points_.size());
  };
  for (Cell& cell : cells_) {
    const auto [x, below_y, below_z] = unpack(cell.key);
    const Key y = below_y + static_cast<Key>(dy), z = below_z + static_cast<Key>(dz);  // -1 wraps to beyond the largest
    if (y > kLargest || z > kLargest) continue;
    const Key lo = pack(x > 0 ? x - 1 : 0, y, z), hi = pack(std::min(x + 1, kLargest), y, z);
    while (begin < cells_.size() && cells_[begin].key < lo) ++begin;
    end = std::max(begin, end);
    while (end < cells_.size() && cells_[end].key <= hi) ++end;
    cell.around[row] = {rank(begin), rank(end)};
  }
}

int CellList::colour(int cell) const {
  const auto [x, y, z] = unpack(cells_[static_cast<std::size_t>(cell)].key);
  return static_cast<int>((x & 1) | (y & 1) << 1 | (z & 1) << 2);
}

HWY_EXPORT(run_find_near);

namespace {
constexpr std::size_t kLanes = 16;  // largest number of lanes
}  // namespace

void Surroundings::gather(const CellList& cells, int cell, std::span<const dvec3> positions,
                          std::span<const dvec3> normals, double spacing) {
  first_own_ = cells.ranks_in(cell).begin;
  origin_ = positions[first_own_];
  spacing_ = spacing;
  std::size_t wanted = kLanes;
  for (const CellList::Ranks& row : cells.ranks_around(cell)) wanted += row.end - row.begin;
  if (wanted > rows_.rank.size()) {
    rows_.rank.resize(wanted);
    for (auto* values : {&rows_.x, &rows_.y, &rows_.z, &rows_.normal_x, &rows_.normal_y, &rows_.normal_z})
      values->resize(wanted);
  }
  std::size_t at = 0;
  for (const CellList::Ranks& row : cells.ranks_around(cell)) {
    if (row.begin <= first_own_ && first_own_ < row.end) own_ = at + (first_own_ - row.begin);
    for (std::uint32_t r = row.begin; r < row.end; ++r) put(at++, static_cast<int>(r), place(positions[r], normals[r]));
  }
  const float far = 1e18F;
  while (at % kLanes != 0) put(at++, -1, {{far, far, far}, {0, 0, 1}});
  rows_.size = at;
}

NearPlace Surroundings::place(const dvec3& position, const dvec3& normal) const {
  const dvec3 p = (position - origin_) / spacing_;
  return {{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)},
          {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)}};
}

void Surroundings::put(std::size_t at, int rank, const NearPlace& p) {
  rows_.rank[at] = rank;
  rows_.x[at] = p.position[0], rows_.y[at] = p.position[1], rows_.z[at] = p.position[2];
  rows_.normal_x[at] = p.normal[0], rows_.normal_y[at] = p.normal[1], rows_.normal_z[at] = p.normal[2];
}

void Surroundings::move(std::uint32_t rank, const NearPlace& to) {
  put(own_ + (rank - first_own_), static_cast<int>(rank), to);
}

void Surroundings::find_near(const NearPlace& place, float reach, std::uint32_t except, NearPoints& near) const {
  const std::size_t room = rows_.size + kLanes;  // whole lanes may be written behind the last point
  if (near.rank.size() < room) {
    near.rank.resize(room);
    for (auto* values : {&near.x, &near.y, &near.z, &near.distance, &near.cosine}) values->resize(room);
  }
  near.count = HWY_DYNAMIC_DISPATCH(run_find_near)(rows_, place, reach, static_cast<int>(except), near);
}

}  // namespace taxel
#endif
