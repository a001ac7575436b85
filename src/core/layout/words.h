// The words that a layout file uses for choices, one table per choice; menus and messages use the same ones.
#pragma once

#include <optional>
#include <span>

#include "core/base/text/words.h"
#include "core/layout/layout.h"

namespace taxel {

inline constexpr Word<Metric> kMetricWords[] = {{Metric::euclidean, "euclidean"}, {Metric::geodesic, "geodesic"}};
inline constexpr Word<Misses> kMissesWords[] = {{Misses::zero, "zero"}, {Misses::omit, "omit"}};
inline constexpr Word<SampleWeights> kSampleWeightsWords[] = {{SampleWeights::equal, "equal"},
                                                              {SampleWeights::voronoi, "voronoi"}};
inline constexpr Word<Shells> kShellsWords[] = {{Shells::outer, "outer"}, {Shells::all, "all"}};
inline constexpr Word<RayDirection> kRayDirectionWords[] = {{RayDirection::surface_normal, "surface_normal"},
                                                            {RayDirection::taxel_normal, "taxel_normal"}};
inline constexpr Word<Aggregate> kAggregateWords[] = {{Aggregate::weighted_mean, "weighted_mean"},
                                                      {Aggregate::weighted_sum, "weighted_sum"},
                                                      {Aggregate::mean, "mean"},
                                                      {Aggregate::nearest, "nearest"},
                                                      {Aggregate::max, "max"},
                                                      {Aggregate::force, "force"}};
inline constexpr Word<FieldKind> kFieldKindWords[] = {{FieldKind::pad, "pad"},
                                                      {FieldKind::medial_axis, "medial_axis"},
                                                      {FieldKind::star, "star"},
                                                      {FieldKind::tets, "tets"}};

inline constexpr Word<RepairLevel> kRepairLevelWords[] = {{RepairLevel::automatic, "auto"},
                                                          {RepairLevel::exact, "exact"},
                                                          {RepairLevel::wrap, "wrap"},
                                                          {RepairLevel::keep, "keep"}};

/// A number of a repair recipe, which must be greater than 0, and its key in /mesh/repair.
struct RepairNumber {
  const char* key;
  std::optional<double> RepairRecipe::*value;
};
inline constexpr RepairNumber kRepairNumbers[] = {{"join", &RepairRecipe::join},
                                                  {"fill", &RepairRecipe::fill},
                                                  {"edge", &RepairRecipe::edge},
                                                  {"tolerance", &RepairRecipe::tolerance},
                                                  {"refine", &RepairRecipe::refine}};

inline std::span<const Word<Metric>> words_of(Metric) {
  return kMetricWords;
}
inline std::span<const Word<Misses>> words_of(Misses) {
  return kMissesWords;
}
inline std::span<const Word<SampleWeights>> words_of(SampleWeights) {
  return kSampleWeightsWords;
}
inline std::span<const Word<Shells>> words_of(Shells) {
  return kShellsWords;
}
inline std::span<const Word<RayDirection>> words_of(RayDirection) {
  return kRayDirectionWords;
}
inline std::span<const Word<Aggregate>> words_of(Aggregate) {
  return kAggregateWords;
}
inline std::span<const Word<FieldKind>> words_of(FieldKind) {
  return kFieldKindWords;
}
inline std::span<const Word<RepairLevel>> words_of(RepairLevel) {
  return kRepairLevelWords;
}

/// The SI unit of readings.
inline const char* reading_unit(Aggregate aggregate) {
  if (aggregate == Aggregate::force) return "N";
  return aggregate == Aggregate::weighted_sum ? "Pa m^2" : "Pa";
}

}  // namespace taxel
