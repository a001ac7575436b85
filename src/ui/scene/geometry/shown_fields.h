// The receptive fields of the sensors in a frame: the request, its result, and the numbers that the panel writes. They
// depend on models alone and are computed on a worker, since a map of many geodesic fields takes longer than a frame.
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/sensor/sensor_model.h"
#include "ui/scene/geometry/field_discs.h"
#include "ui/scene/geometry/field_patch.h"

namespace taxel::ui {

/// Area [m^2] of the skin that one field covers by each metric, summed over the taxels.
struct FieldComparison {
  double euclidean = 0, geodesic = 0;
  double euclidean_only = 0;  ///< inside the Euclidean field only [m^2]
  int differing = 0;          ///< number of taxels with more than 1 % of the field there
};

/// Areas of the skin by the number of receptive fields that contain them.
struct CoverageNumbers {
  std::vector<double> area_of_overlap;  ///< area [m^2] by number of taxels
  double area = 0;                      ///< area of the skin [m^2]
  double overlap = 0;                   ///< mean number of taxels over the covered area
};

/// Angles between the normals of the taxels and of the skin below them.
struct NormalNumbers {
  double largest_deg = 0, mean_deg = 0;
  int largest_taxel = -1;  ///< taxel with the largest angle, in layout order, or -1
  double limit_deg = 0;    ///< limit of the layout, at which the colours end
};

/// Numbers of the traction arrows.
struct TractionNumbers {
  int polygons = 0;
  double largest_pressure = 0, largest_friction = 0;  ///< largest values [Pa]
  double metres_per_pascal = 0;                       ///< length of arrows per pressure
  bool friction_known = false;                        ///< false if friction was not recorded; then none is drawn
};

/// Numbers of the marks that were drawn for all sensors together.
struct MarkCounts {
  int arrows = 0;      ///< taxels with an arrow along their normal
  int discs = 0;       ///< receptive fields that glow with their reading
  int rings = 0;       ///< receptive fields with a thin ring
  int bold_rings = 0;  ///< bold rings of hovered and selected taxels
  int samples = 0;     ///< samples at most; those that look away are not drawn
  int forces = 0;      ///< net forces
  bool operator==(const MarkCounts&) const = default;
};

/// Numbers of the active overlays, for the first sensor in the frame.
struct FieldNumbers {
  bool due = false;  ///< a map is active and not computed yet
  std::optional<FieldComparison> comparison;
  std::optional<CoverageNumbers> coverage;
  std::optional<NormalNumbers> normals;
  std::optional<TractionNumbers> tractions;  ///< numbers of the selected sensor
  MarkCounts marks;
};

// The coverage has two quiet colours: the skin without taxels, and a tint by which each field multiplies that colour.
// The light on the skin remains visible, and the colour depends on the number of fields alone, not on their order.

/// Colour of skin that no taxel sees, in full light (sRGB).
inline constexpr glm::vec3 kUncoveredColor{0.80f, 0.72f, 0.66f};
/// Colour by which one field multiplies that of the skin.
inline constexpr glm::vec3 kCoveredTint{0.48f, 0.80f, 0.96f};
/// Largest number of taxels with a row of its own in the legend.
inline constexpr int kMostOverlap = 6;
/// Returns the colour of a spot in the fields of `taxels` taxels, in full light (sRGB).
glm::vec3 overlap_color(int taxels);
/// Returns the colour of skin inside the Euclidean field only.
glm::vec3 euclidean_only_color();
/// Returns the colour of an angle between normals: the lighter four fifths of the map up to the limit, and a colour
/// that the map does not have above the limit.
glm::vec3 normal_color(double angle_deg, double limit_deg);

// With these weights, readings are spread over the skin in every frame.

/// The part of a skin inside receptive fields, in small triangles. Frame M.
struct SkinWeights {
  struct Weight {
    int taxel = 0;    ///< index in layout order
    float share = 0;  ///< fraction of the weights at one point; they sum to 1
  };
  std::vector<glm::vec3> points;              ///< [m]
  std::vector<int> first{0};                  ///< weights of point i: [first[i], first[i + 1])
  std::vector<Weight> weights;                ///< weights of all points; each point has at least one
  std::vector<std::array<int, 3>> triangles;  ///< three points each, with the winding of the skin

  /// Computes the reading at each point: sum of w_k p_k / sum of w_k, w = (r - d)^2.
  void spread(std::span<const double> readings, std::vector<float>& at_points) const;
};

/// Computes the weights by the layout's metric and angle limit, subtaxels included. Faces are divided until their edges
/// are at most a sixth of the smallest radius, within limits, and are clipped at the ends of the fields. The result
/// does not depend on the number of threads.
SkinWeights skin_weights(const SensorModel& model);

class FieldGeometry {
 public:
  /// Returns the boundaries of the fields by the metric of the layout, one list for each taxel.
  const std::vector<std::vector<RingPiece>>& rings(const SensorModel& model);
  const std::vector<FieldPatch>& patches(const SensorModel& model, FieldPart part);
  /// Returns the fields for drawing.
  std::shared_ptr<const FieldDiscs> discs(const SensorModel& model);
  Coverage coverage(const SensorModel& model) { return make_coverage(model, coverage_); }

 private:
  const std::shared_ptr<const UnfoldedMesh>& unfolded(const SensorModel& model);

  PerTaxel<std::vector<RingPiece>> rings_;
  std::array<PerTaxel<FieldPatch>, 3> patches_;  // indexed by FieldPart
  PerTaxel<FieldShape> shapes_;
  std::shared_ptr<const UnfoldedMesh> unfolded_;
  CoverageMemory coverage_;
};

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
  /// Returns true if nothing of the request takes long. Euclidean fields alone do not.
  [[nodiscard]] bool empty() const;
  bool operator==(const FieldsRequest&) const = default;
};

using FieldRings = std::vector<std::vector<RingPiece>>;  ///< rings of each taxel, in layout order

/// Fields of one sensor.
struct SensorFields {
  std::shared_ptr<const FieldRings> rings;     ///< boundaries by the layout's metric; never null
  std::vector<PaintVertex> triangles;          ///< triangles of FieldMap::compared, frame M
  std::shared_ptr<const SkinWeights> weights;  ///< weights if requested, otherwise null
  std::shared_ptr<const FieldDiscs> discs;     ///< fields for drawing; never null
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
};

}  // namespace taxel::ui
