// Receptive fields as pieces of the skin, with their boundary and area, by Euclidean or by geodesic distance.
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

}  // namespace taxel::ui
