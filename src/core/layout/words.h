// The words that a layout file uses for choices, one table per choice; menus and messages use the same ones.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/layout/layout.h"

namespace taxel {

template <class E>
struct Word {
  E value;
  std::string_view text;
};

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

/// The word of a value, as files spell it.
template <class E>
std::string_view to_word(E value) {
  for (const Word<E>& w : words_of(value))
    if (w.value == value) return w.text;
  return "";
}

/// The value of a word, or nothing.
template <class E>
std::optional<E> from_word(std::string_view text) {
  for (const Word<E>& w : words_of(E{}))
    if (w.text == text) return w.value;
  return std::nullopt;
}

/// The SI unit of readings.
inline const char* reading_unit(Aggregate aggregate) {
  if (aggregate == Aggregate::force) return "N";
  return aggregate == Aggregate::weighted_sum ? "Pa m^2" : "Pa";
}

/// All words of a choice for messages: "equal", "voronoi".
template <class E>
std::string word_list() {
  std::string list;
  for (const Word<E>& w : words_of(E{})) {
    if (!list.empty()) list += ", ";
    list.append("\"").append(w.text).append("\"");
  }
  return list;
}

}  // namespace taxel
