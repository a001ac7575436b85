#include "app/studio/host/run/stop_text.h"

#include <fmt/format.h>

#include "core/base/index.h"
#include "ui/widgets/format.h"

namespace taxel::studio {
namespace {

std::string taxel_text(const Taxel& taxel) {
  return fmt::format("taxel {}{}", taxel.id, taxel.name.empty() ? "" : " (" + taxel.name + ")");
}

std::string text_of(const Jump& jump, const Taxel& taxel, const ui::ReadingUnit& unit, const char* whose) {
  const double force = jump.force_before > 0 ? 100 * (jump.force_after / jump.force_before - 1) : 0.0;
  constexpr int kForceDigits = 4;
  const NumberPair readings = ui::pair_in_unit(jump.before, jump.after, unit);
  const NumberPair forces = number_pair(jump.force_before, jump.force_after, kForceDigits);
  return fmt::format(
      "{} jumped from {} to {}, {:.1f} % of {} largest reading, while the force {} {} to {} N ({:+.2f} %)",
      taxel_text(taxel), readings.first, readings.second, 100 * jump.part, whose,
      jump.at_equal_force ? "stayed," : "went from", forces.first, forces.second, force);
}

std::string text_of(const Disagreement& gap, const Taxel& taxel, const ui::ReadingUnit& unit, const char* whose) {
  const NumberPair readings = ui::pair_in_unit(gap.sampled, gap.exact, unit);
  return fmt::format("{} reads {} by its samples and {} by the surface, {:.1f} % of {} largest reading apart",
                     taxel_text(taxel), readings.first, readings.second, 100 * gap.part, whose);
}

}  // namespace

std::string stop_text(const Stopped& stopped, bool of_sensor) {
  return std::visit(
      [&](const auto& stop) {
        const Layout& layout = stopped.scene->sensors[at(stop.sensor)]->layout;
        const std::string text = text_of(stop, layout.taxels[at(stop.taxel)], ui::shown_unit(layout.readout.aggregate),
                                         of_sensor ? "the sensor's" : "its");
        return fmt::format("Paused at step {}, {:.6g} s: {}", stop.step, stop.time, text);
      },
      stopped.stop);
}

}  // namespace taxel::studio
