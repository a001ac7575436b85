#include "core/sim/model/instability.h"

#include <fmt/format.h>

namespace taxel {
namespace {

/// Returns the name of the body or actuator to which the index in a warning belongs.
std::string culprit(const mjModel& m, int warning, int number) {
  const auto named = [&m](int type, int id, const char* word) {
    const char* name = id >= 0 ? mj_id2name(&m, type, id) : nullptr;
    return name != nullptr ? fmt::format("{} \"{}\"", word, name) : fmt::format("{} {}", word, id);
  };
  if (warning == mjWARN_BADCTRL && number >= 0 && number < m.nu) return named(mjOBJ_ACTUATOR, number, "actuator");
  if (warning == mjWARN_BADQPOS) {
    int body = -1;
    for (int j = 0; j < m.njnt && m.jnt_qposadr[j] <= number; ++j) body = m.jnt_bodyid[j];
    return named(mjOBJ_BODY, body, "body");
  }
  return number >= 0 && number < m.nv ? named(mjOBJ_BODY, m.dof_bodyid[number], "body") : "an unknown body";
}

}  // namespace

std::string instability(const mjModel& m, const mjData& d) {
  for (const int kind : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC, mjWARN_BADCTRL}) {
    const mjWarningStat& w = d.warning[kind];
    if (w.number > 0)
      return fmt::format("at {}: {}", culprit(m, kind, w.lastinfo),
                         mju_warningText(kind, static_cast<std::size_t>(w.lastinfo)));
  }
  return {};
}

}  // namespace taxel
