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
  int arrows = 0;   ///< taxels with an arrow along their normal
  int discs = 0;    ///< receptive fields that glow with their reading
  int rings = 0;    ///< receptive fields with a rim
  int samples = 0;  ///< samples at most; those that look away are not drawn
  int forces = 0;   ///< net forces
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

/// Colour (sRGB) of a spot in the fields of `taxels` taxels, different from the colours of single taxels. From
/// `kMostOverlap` on the colour is the same.
inline constexpr int kMostOverlap = 6;
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
