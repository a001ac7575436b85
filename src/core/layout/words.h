// The words that a layout file uses for choices, one table per choice. Menus and messages use the same words.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/text/words.h"
#include "core/layout/layout.h"

namespace taxel {

inline constexpr Word<Metric> kMetricWords[] = {{Metric::euclidean, "euclidean"}, {Metric::geodesic, "geodesic"}};
inline constexpr Word<FieldNormals> kFieldNormalsWords[] = {{FieldNormals::face, "face"},
                                                            {FieldNormals::interpolated, "interpolated"}};
inline constexpr Word<Misses> kMissesWords[] = {{Misses::zero, "zero"}, {Misses::omit, "omit"}};
inline constexpr Word<SampleWeights> kSampleWeightsWords[] = {{SampleWeights::equal, "equal"},
                                                              {SampleWeights::voronoi, "voronoi"}};
inline constexpr Word<Shells> kShellsWords[] = {{Shells::outer, "outer"}, {Shells::all, "all"}};
inline constexpr Word<RayDirection> kRayDirectionWords[] = {{RayDirection::surface_normal, "surface_normal"},
                                                            {RayDirection::taxel_normal, "taxel_normal"}};
inline constexpr Word<ReadingMethod> kReadingMethodWords[] = {{ReadingMethod::samples, "samples"},
                                                              {ReadingMethod::exact, "exact"}};

/// An aggregate as files and menus name it. The sensor's AggregateSpec has its formulas.
struct AggregateRow {
  Aggregate value;
  std::string_view text;  ///< word in files
  const char* unit;       ///< SI unit of the readings
  const char* help;       ///< formula in words, for help and tooltips
};
inline constexpr AggregateRow kAggregates[] = {
    {Aggregate::weighted_mean, "weighted_mean", "Pa", "the paper's formula, a mean with the weights of the field"},
    {Aggregate::weighted_sum, "weighted_sum", "Pa m^2",
     "the formula of the paper's released code, which does not divide"},
    {Aggregate::mean, "mean", "Pa", "the mean of the pressures"},
    {Aggregate::nearest, "nearest", "Pa", "the pressure at the sample nearest to the centre"},
    {Aggregate::max, "max", "Pa", "the largest pressure"},
    {Aggregate::force, "force", "N", "the force on the field, integrated over the contact polygons"}};

inline constexpr Word<FieldKind> kFieldKindWords[] = {{FieldKind::pad, "pad"},
                                                      {FieldKind::medial_axis, "medial_axis"},
                                                      {FieldKind::star, "star"},
                                                      {FieldKind::tets, "tets"}};

inline constexpr Word<FaceRule> kFaceRuleWords[] = {{FaceRule::along_gradient, "along_gradient"},
                                                    {FaceRule::all, "all"}};

inline constexpr Word<RepairLevel> kRepairLevelWords[] = {{RepairLevel::automatic, "auto"},
                                                          {RepairLevel::exact, "exact"},
                                                          {RepairLevel::wrap, "wrap"},
                                                          {RepairLevel::keep, "keep"}};

inline constexpr Word<TouchedRepair> kTouchedRepairWords[] = {
    {TouchedRepair::automatic, "auto"}, {TouchedRepair::exact, "exact"}, {TouchedRepair::off, "off"}};

inline std::span<const Word<Metric>> words_of(Metric) {
  return kMetricWords;
}
inline std::span<const Word<FieldNormals>> words_of(FieldNormals) {
  return kFieldNormalsWords;
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
inline std::span<const Word<ReadingMethod>> words_of(ReadingMethod) {
  return kReadingMethodWords;
}
inline std::span<const AggregateRow> words_of(Aggregate) {
  return kAggregates;
}
inline std::span<const Word<FieldKind>> words_of(FieldKind) {
  return kFieldKindWords;
}
inline std::span<const Word<FaceRule>> words_of(FaceRule) {
  return kFaceRuleWords;
}
inline std::span<const Word<RepairLevel>> words_of(RepairLevel) {
  return kRepairLevelWords;
}
inline std::span<const Word<TouchedRepair>> words_of(TouchedRepair) {
  return kTouchedRepairWords;
}

/// Returns the SI unit of an aggregate's readings.
inline const char* reading_unit(Aggregate aggregate) {
  return kAggregates[static_cast<std::size_t>(aggregate)].unit;
}

/// Returns true if ReadingMethod::exact computes the aggregate.
inline bool has_exact_method(Aggregate aggregate) {
  return aggregate == Aggregate::weighted_mean || aggregate == Aggregate::mean || aggregate == Aggregate::force;
}

/// Returns a list of all aggregates with their formulas, for help and tooltips.
inline std::string aggregate_help() {
  std::string list;
  for (const AggregateRow& row : kAggregates)
    list += (list.empty() ? "\"" : ", \"") + std::string(row.text) + "\" is " + row.help;
  return list;
}

}  // namespace taxel
