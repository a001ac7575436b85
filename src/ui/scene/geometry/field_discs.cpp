#include "ui/scene/geometry/field_discs.h"

#include <algorithm>
#include <cmath>

#include "ui/scene/color_map.h"

namespace taxel::ui {
namespace {

constexpr double kLargestAlpha = 0.92;
constexpr float kAtRim = 0.45f;  // opacity at the rim as a fraction of that in the middle: the rim stays visible

/// Returns the distance of a point from the nearest disc of a taxel as a fraction of the disc's radius, at most 1.
double distance_part(const std::vector<FieldDisc>& discs, const dvec3& p) {
  double least = 1;
  for (const FieldDisc& disc : discs) least = std::min(least, glm::length(p - disc.center) / disc.radius);
  return least;
}

}  // namespace

FieldDiscs field_discs(const SensorModel& model, const std::vector<FieldPatch>& patches) {
  FieldDiscs out;
  for (std::size_t k = 0; k < patches.size() && k < model.layout.taxels.size(); ++k) {
    const std::vector<FieldDisc> discs = discs_of(model.layout.taxels[k]);
    for (const SkinPiece& piece : patches[k].pieces) {
      const dvec3 middle = (piece.a + piece.b + piece.c) / 3.0;
      out.triangles.push_back({glm::vec3(piece.a), glm::vec3(piece.b), glm::vec3(piece.c),
                               static_cast<float>(distance_part(discs, middle))});
    }
    out.first.push_back(static_cast<int>(out.triangles.size()));
  }
  return out;
}

float disc_alpha(double part, float away) {
  if (!(part > 0)) return 0;  // NaN too
  const auto middle = static_cast<float>(kLargestAlpha * std::sqrt(std::min(part, 1.0)));
  return middle * (1 - (1 - kAtRim) * away * away);
}

void append_disc(const FieldDiscs& discs, int taxel, const glm::vec3& color, double part, float dim,
                 std::vector<PaintVertex>& out) {
  const auto k = static_cast<std::size_t>(taxel);
  if (k + 1 >= discs.first.size()) return;
  for (int i = discs.first[k]; i < discs.first[k + 1]; ++i) {
    const FieldDiscs::Triangle& t = discs.triangles[static_cast<std::size_t>(i)];
    const std::uint32_t rgba = pack(glm::vec4(color, dim * disc_alpha(part, t.away)));
    for (const glm::vec3& corner : {t.a, t.b, t.c}) out.push_back({corner, rgba});
  }
}

}  // namespace taxel::ui
