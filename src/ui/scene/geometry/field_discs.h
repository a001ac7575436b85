// Receptive fields as discs on the skin, which glow with the readings of their taxels.
#pragma once

#include <vector>

#include "ui/scene/geometry/field_patch.h"
#include "ui/scene/geometry/skin_paint.h"

namespace taxel::ui {

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

}  // namespace taxel::ui
