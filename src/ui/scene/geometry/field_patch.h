// Receptive fields as pieces of the skin, with their boundary and area, by Euclidean or by geodesic distance; and the
// coverage of the skin, the number of taxels at each spot.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/layout/field/receptive_field.h"
#include "core/layout/layout.h"
#include "core/mesh/geodesic.h"
#include "core/mesh/query/closest_point.h"
#include "core/sensor/sensor_model.h"

namespace taxel::ui {

// The boundary of a Euclidean receptive field: the intersection of the skin with the sphere around the taxel's centre.

/// A short straight piece of the boundary, on one face.
struct RingPiece {
  dvec3 a{0}, b{0};  ///< [m], frame of the mesh; on the sphere and on the face
  int face = -1;
};

/// Returns the intersection of the sphere |x - center| = radius with the faces whose normal is less than
/// `max_angle_deg` from `normal`. It consists of circular arcs in the planes of the faces, divided into pieces of at
/// most `step_deg` of their circle. Only faces near the sphere are tested. The order of the pieces has no meaning but
/// is always the same.
std::vector<RingPiece> field_ring(const MeshIndex& skin, const dvec3& center, double radius, const dvec3& normal,
                                  double max_angle_deg, double step_deg = 6.0);

/// Returns the rings of a taxel: its own ring, or the rings of its subtaxels.
std::vector<RingPiece> taxel_rings(const MeshIndex& skin, const Taxel& taxel, const ReceptiveFieldRule& rule,
                                   double step_deg = 6.0);

/// Part of the skin within the radius: by the named distance, or by the Euclidean distance but not by the geodesic one.
enum class FieldPart { euclidean, geodesic, euclidean_only };

/// A triangle on one face of the skin with the same winding, in the frame of the mesh [m].
struct SkinPiece {
  dvec3 a{0}, b{0}, c{0};
  int face = -1;
};

struct FieldPatch {
  std::vector<SkinPiece> pieces;
  std::vector<RingPiece> boundary;  ///< line at which the named distance is the radius; empty for euclidean_only
  double area = 0;                  ///< [m^2]
};

/// Cuts fields out of a skin. Faces are halved until their edges are at most 1 / `fineness` of the radius, and are
/// clipped where the distance, linear between corners, equals the radius. The relative error of the area of a circle in
/// a plane is about 1 / fineness^2. A cutter reuses the memory of the geodesic propagation, so each thread needs its
/// own.
class FieldCutter {
 public:
  FieldCutter(const MeshIndex& skin, std::shared_ptr<const UnfoldedMesh> unfolded, const ReceptiveFieldRule& rule,
              int fineness);
  /// Appends the field of a disc, by the rules of make_receptive_fields.
  void append(const FieldDisc& disc, FieldPart part, FieldPatch& out);

 private:
  struct Corner {
    dvec3 p{0};
    double euclidean = 0, geodesic = 0;  ///< distance minus the radius [m]
    double turned = -1;                  ///< cosine of the limit minus that of the interpolated normal
  };
  struct Cut;
  void halve(const Cut& cut, const std::array<dvec3, 3>& corners, FieldPatch& out);
  void cut_leaf(const Cut& cut, const std::array<dvec3, 3>& corners, FieldPatch& out);

  const MeshIndex& skin_;
  GeodesicDistance geodesic_;
  ReceptiveFieldRule rule_;
  double min_cosine_;
  int fineness_;
};

/// The skin of a model prepared for geodesic distances.
std::shared_ptr<const UnfoldedMesh> unfolded_skin(const SensorModel& model);

/// Fills the patches of the listed taxels. `patches` is in layout order; `unfolded` is the skin of the model. The
/// result does not depend on the number of threads.
void cut_patches(const SensorModel& model, FieldPart part, const std::shared_ptr<const UnfoldedMesh>& unfolded,
                 const std::vector<int>& taxels, std::vector<FieldPatch>& patches);

/// Returns the fineness with which fields are cut; it depends on the number of taxels.
int field_fineness(const SensorModel& model);

/// Returns the fields of all taxels in layout order. The fields of subtaxels overlap each other. The result does not
/// depend on the number of threads.
std::vector<FieldPatch> taxel_patches(const SensorModel& model, FieldPart part);

/// A corner of a piece of a skin in a flat colour.
struct PaintVertex {
  glm::vec3 position{0};
  std::uint32_t rgba = 0;  ///< sRGB, straight alpha, red in the lowest byte
};

inline void append_piece(const SkinPiece& piece, std::uint32_t rgba, std::vector<PaintVertex>& out) {
  for (const dvec3& p : {piece.a, piece.b, piece.c}) out.push_back({glm::vec3(p), rgba});
}

/// A cache of results that are computed for each taxel alone. It is kept from one model of a layout to the next, so an
/// edit of one taxel costs one computation.
template <class Value>
class PerTaxel {
 public:
  /// Returns the values in layout order. `make(missing, values)` computes the values at the ascending indices
  /// `missing`: those of taxels that are new or have changed since the last call. If the skin, the rule or `variant`
  /// has changed, all values are computed.
  template <class Make>
  const std::vector<Value>& update(const SensorModel& model, int variant, const Make& make) {
    const std::vector<Taxel>& taxels = model.layout.taxels;
    const bool comparable = skin_ == model.skin && rule_ == model.layout.receptive_field && variant_ == variant;
    std::vector<Value> values(taxels.size());
    std::vector<int> missing;
    std::vector<char> taken(taxels_.size(), 0);
    const std::vector<std::size_t> order = comparable ? by_id() : std::vector<std::size_t>{};
    for (std::size_t k = 0; k < taxels.size(); ++k) {
      const auto found = std::lower_bound(order.begin(), order.end(), taxels[k].id,
                                          [this](std::size_t i, int id) { return taxels_[i].id < id; });
      if (found != order.end() && taxels_[*found] == taxels[k] && taken[*found] == 0) {
        taken[*found] = 1;
        values[k] = std::move(values_[*found]);
      } else {
        missing.push_back(static_cast<int>(k));
      }
    }
    made_ = static_cast<int>(missing.size());
    skin_.reset();  // if make() throws, nothing is kept
    if (!missing.empty()) make(missing, values);
    skin_ = model.skin;
    rule_ = model.layout.receptive_field;
    variant_ = variant;
    taxels_ = taxels;
    values_ = std::move(values);
    return values_;
  }
  /// Returns the number of values that the last update() computed.
  [[nodiscard]] int made() const { return made_; }

 private:
  [[nodiscard]] std::vector<std::size_t> by_id() const {
    std::vector<std::size_t> order(taxels_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [this](std::size_t a, std::size_t b) { return taxels_[a].id < taxels_[b].id; });
    return order;
  }

  std::shared_ptr<const MeshIndex> skin_;
  ReceptiveFieldRule rule_;
  int variant_ = 0, made_ = 0;
  std::vector<Taxel> taxels_;
  std::vector<Value> values_;
};

/// The number of taxels at each spot of the skin as a map in pieces, and areas as numbers.
struct Coverage {
  struct Piece {
    SkinPiece at;
    int taxels = 0;  ///< number of taxels whose field contains the piece's centroid
  };
  std::vector<Piece> pieces;            ///< pieces of the whole skin, ordered by face
  std::vector<double> area_of_overlap;  ///< area [m^2] by number of taxels; [0] is outside of all fields
  double area = 0;                      ///< area of the skin [m^2]

  [[nodiscard]] double uncovered() const { return area_of_overlap.empty() ? 0 : area_of_overlap[0]; }
  [[nodiscard]] double shared() const;   ///< area in two or more fields [m^2]
  [[nodiscard]] double overlap() const;  ///< mean number of taxels over the covered area, or 0
};

/// Results of make_coverage() for each taxel, reused for the next model of the same skin.
struct CoverageMemory {
  PerTaxel<std::vector<int>> seen;               ///< indices of the pieces in the field
  std::shared_ptr<const UnfoldedMesh> unfolded;  ///< skin of this coverage, or null
};

/// Computes the coverage by the metric and the angle limit of the layout. The union of a taxel's subtaxels counts once.
/// Faces are divided evenly into at least `pieces` pieces in total. The result does not depend on the number of
/// threads.
Coverage make_coverage(const SensorModel& model, int pieces = 40'000);
Coverage make_coverage(const SensorModel& model, CoverageMemory& memory, int pieces = 40'000);

}  // namespace taxel::ui
