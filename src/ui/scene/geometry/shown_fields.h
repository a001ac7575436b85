// The receptive fields of the sensors in a frame: the request and its result. They depend on models alone and are
// computed on a worker, since a map of many geodesic fields takes longer than a frame.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "ui/scene/field_numbers.h"
#include "ui/scene/geometry/coverage.h"
#include "ui/scene/geometry/field_patch.h"
#include "ui/scene/geometry/per_taxel.h"
#include "ui/scene/geometry/skin_paint.h"
#include "ui/scene/geometry/skin_weights.h"

namespace taxel::ui {

class FieldGeometry {
 public:
  /// Returns the boundaries of the fields by the metric of the layout, one list for each taxel.
  const std::vector<std::vector<RingPiece>>& rings(const SensorModel& model);
  const std::vector<FieldPatch>& patches(const SensorModel& model, FieldPart part);
  Coverage coverage(const SensorModel& model) { return make_coverage(model, coverage_); }

 private:
  const std::shared_ptr<const UnfoldedMesh>& unfolded(const SensorModel& model);

  PerTaxel<std::vector<RingPiece>> rings_;
  std::array<PerTaxel<FieldPatch>, 3> patches_;  // indexed by FieldPart
  std::shared_ptr<const UnfoldedMesh> unfolded_;
  CoverageMemory coverage_;
};

/// The receptive fields of all taxels of a model in small triangles. Frame M.
struct FieldDiscs {
  struct Triangle {
    glm::vec3 a{0}, b{0}, c{0};  ///< corners with the winding of the skin [m]
    float away = 0;              ///< distance of the middle from the centre, as a fraction of the radius, 0 to 1
  };
  std::vector<Triangle> triangles;
  std::vector<int> first{0};  ///< triangles of taxel k: [first[k], first[k + 1])
};

/// Returns the discs of fields that were cut out of the skin. `patches` has the field of each taxel.
[[nodiscard]] FieldDiscs field_discs(const SensorModel& model, const std::vector<FieldPatch>& patches);

/// Returns the opacity of a disc, 0 to 1, at `away` from its centre, for a reading as a fraction of its range. A
/// reading of 0 is transparent, and larger readings are more opaque.
[[nodiscard]] float disc_alpha(double part, float away);

/// Appends the triangles of one taxel in a colour, with the opacity of its reading times `dim`.
void append_disc(const FieldDiscs& discs, int taxel, const glm::vec3& color, double part, float dim,
                 std::vector<PaintVertex>& out);

/// The map drawn on the skin, one at a time.
enum class FieldMap {
  none,
  filled,  ///< fields by the layout's metric, in the colours of the taxels
  /// The area that both metrics reach in the colours of the taxels, and the area of the Euclidean distance alone in a
  /// separate colour.
  compared,
  coverage  ///< each spot in the colour of the number of taxels whose fields contain it
};

struct FieldsRequest {
  std::vector<SensorModelPtr> models;  ///< models of the sensors, in order
  FieldMap map = FieldMap::none;
  bool weights = false;  ///< requests weights, which spread readings over the skin
  bool discs = false;    ///< requests the fields as discs, which glow with their readings
  /// Returns true if nothing of the request takes long. Euclidean rings alone do not.
  [[nodiscard]] bool empty() const;
  bool operator==(const FieldsRequest&) const = default;
};

using FieldRings = std::vector<std::vector<RingPiece>>;  ///< rings of each taxel, in layout order

/// Fields of one sensor.
struct SensorFields {
  std::shared_ptr<const FieldRings> rings;     ///< boundaries by the layout's metric; never null
  std::vector<PaintVertex> triangles;          ///< triangles of the map, frame M
  std::shared_ptr<const SkinWeights> weights;  ///< weights if requested, otherwise null
  std::shared_ptr<const FieldDiscs> discs;     ///< discs if requested, otherwise null
  std::optional<FieldComparison> comparison;
  std::optional<CoverageNumbers> coverage;
};

struct ShownFields {
  FieldsRequest request;
  std::vector<SensorFields> sensors;  ///< parallel to the requested models
  /// Returns the fields of a model, or null if the model was not requested.
  [[nodiscard]] const SensorFields* of(const SensorModelPtr& model) const;
};
using ShownFieldsPtr = std::shared_ptr<const ShownFields>;

/// Computes fields, and retains the fields of each taxel for the next request, since after an edit most fields are
/// unchanged. May be used by one thread at a time.
class FieldMaker {
 public:
  void make(const FieldsRequest& request, ShownFields& out);

 private:
  std::map<std::size_t, FieldGeometry> fields_;  ///< keyed by sensor
  struct Weights {
    SensorModelPtr model;
    std::shared_ptr<const SkinWeights> weights;
  };
  std::map<std::size_t, Weights> weights_;  ///< keyed by sensor
  struct Discs {
    SensorModelPtr model;
    std::shared_ptr<const FieldDiscs> discs;
  };
  std::map<std::size_t, Discs> discs_;  ///< keyed by sensor
};

}  // namespace taxel::ui
