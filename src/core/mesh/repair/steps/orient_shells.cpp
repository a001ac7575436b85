// Closed shells are turned outward, cavities inward.
#include "core/mesh/repair/steps.h"
#include "core/mesh/repair/steps/shells.h"
#include "core/mesh/repair/wrap/winding_number.h"

namespace taxel {
namespace {

/// Returns the winding number of all other shells around a shell, at the middle of its largest faces. Just outside of a
/// face the winding number of the shell itself is 0, or -1 if it is a cavity or inside out.
double winding_of_others(const Draft& draft, const WindingNumber& winding, const std::vector<int>& shell, double volume,
                         double step_out) {
  constexpr std::size_t kProbes = 3;
  std::vector<int> largest = shell;
  const std::size_t probes = std::min(kProbes, largest.size());
  std::partial_sort(largest.begin(), largest.begin() + static_cast<std::ptrdiff_t>(probes), largest.end(),
                    [&](int a, int b) {
                      const double area_a = draft.area(a), area_b = draft.area(b);
                      return area_a != area_b ? area_a > area_b : a < b;
                    });
  double sum = 0;
  for (std::size_t i = 0; i < probes; ++i) {
    const dvec3 n = glm::normalize(draft.area_normal(largest[i]));
    sum += winding(draft.center(largest[i]) + step_out * n) + (volume < 0 ? 1 : 0);
  }
  return sum / static_cast<double>(probes);
}

void turn_shell(Draft& draft, const std::vector<int>& shell, RepairStep& step) {
  for (const int f : shell) {
    std::swap(draft.faces[at(f)].y, draft.faces[at(f)].z);
    add_place(step, draft.center(f));
    ++step.faces;
  }
}

}  // namespace

RepairStep orient_shells(Draft& draft) {
  RepairStep step = start_step("repair_oriented");
  const FaceShells shells = find_shells(draft);
  if (shells.faces.size() == 1) {
    if (volume_of(draft, shells.faces[0]) < 0) turn_shell(draft, shells.faces[0], step);
    return step;
  }
  Aabb box;
  for (const dvec3& p : draft.points) box.include(p);
  const double step_out = 1e-7 * box.diagonal();
  const WindingNumber winding(draft.points, draft.faces);
  for (const std::vector<int>& shell : shells.faces) {
    const double volume = volume_of(draft, shell);
    const double others = winding_of_others(draft, winding, shell, volume, step_out);
    // A cavity is inside a solid. A shell in a body that is inside out is inside out as well.
    if ((volume < 0 && others < 0.5) || (volume > 0 && others < -0.5)) turn_shell(draft, shell, step);
  }
  return step;
}

}  // namespace taxel
