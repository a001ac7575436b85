// Receptive fields as pieces of the skin: filled, with their boundary and area, by straight or by geodesic distance.
#pragma once

#include <memory>
#include <vector>

#include "core/layout/field/field_disc.h"
#include "core/mesh/geodesic/geodesic_distance.h"
#include "core/sensor/sensor_model.h"
#include "ui/scene/geometry/field_ring.h"

namespace taxel::ui {

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

/// Cuts fields out of a skin: faces are halved until their edges are 1 / `fineness` of the radius, and cut where the
/// distance, linear between corners, is the radius. A circle of radius r in a plane comes out with its area to
/// 1 / fineness^2. Keeps the memory of the geodesic propagation: one per thread.
class FieldCutter {
 public:
  FieldCutter(const MeshIndex& skin, std::shared_ptr<const UnfoldedMesh> unfolded, double min_cosine, int fineness);
  /// Appends the field of a disc, by the rules of make_receptive_fields.
  void append(const FieldDisc& disc, FieldPart part, FieldPatch& out);

 private:
  struct Corner {
    dvec3 p{0};
    double euclidean = 0, geodesic = 0;  ///< distance less the radius [m]
  };
  struct Cut;
  void halve(const Cut& cut, const std::array<dvec3, 3>& corners, FieldPatch& out);
  void cut_leaf(const Cut& cut, const std::array<dvec3, 3>& corners, FieldPatch& out);

  const MeshIndex& skin_;
  GeodesicDistance geodesic_;
  double min_cosine_;
  int fineness_;
};

/// The skin of a model prepared for geodesic distances.
std::shared_ptr<const UnfoldedMesh> unfolded_skin(const SensorModel& model);

/// Fills the patches of the taxels listed, of `patches` in layout order. `unfolded`: the model's skin. The same on any
/// number of threads.
void cut_patches(const SensorModel& model, FieldPart part, const std::shared_ptr<const UnfoldedMesh>& unfolded,
                 const std::vector<int>& taxels, std::vector<FieldPatch>& patches);

/// How finely fields are cut: by the number of taxels.
int field_fineness(const SensorModel& model);

/// The fields of all taxels in layout order; those of subtaxels lie over each other. The same on any number of threads.
std::vector<FieldPatch> taxel_patches(const SensorModel& model, FieldPart part);

}  // namespace taxel::ui
