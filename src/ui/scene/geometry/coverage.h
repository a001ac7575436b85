// Coverage of the skin: the number of taxels at each spot as a map in pieces, and areas as numbers.
#pragma once

#include <vector>

#include "core/sensor/sensor_model.h"
#include "ui/scene/geometry/field_patch.h"
#include "ui/scene/geometry/per_taxel.h"

namespace taxel::ui {

struct Coverage {
  struct Piece {
    SkinPiece at;
    int taxels = 0;  ///< number of taxels whose field contains the piece's centroid
  };
  std::vector<Piece> pieces;            ///< all of the skin, by face
  std::vector<double> area_of_overlap;  ///< by number of taxels: [0] is seen by none [m^2]
  double area = 0;                      ///< area of the skin [m^2]

  [[nodiscard]] double uncovered() const { return area_of_overlap.empty() ? 0 : area_of_overlap[0]; }
  [[nodiscard]] double shared() const;   ///< seen by two or more [m^2]
  [[nodiscard]] double overlap() const;  ///< mean number of taxels over the covered area; 0 where none is
};

/// What make_coverage() worked out of each taxel, for the next model of the same skin.
struct CoverageMemory {
  PerTaxel<std::vector<int>> seen;               ///< pieces
  std::shared_ptr<const UnfoldedMesh> unfolded;  ///< the skin of this coverage; null if it is to be made
};

/// By the metric and the angle limit of the layout; the union of a taxel's subtaxels counts once. Faces are cut evenly
/// into at least `pieces` in all. The same on any number of threads.
Coverage make_coverage(const SensorModel& model, int pieces = 40'000);
Coverage make_coverage(const SensorModel& model, CoverageMemory& memory, int pieces = 40'000);

}  // namespace taxel::ui
