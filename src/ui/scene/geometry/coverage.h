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
