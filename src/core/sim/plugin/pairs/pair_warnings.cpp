#include "core/sim/plugin/pairs/pair_warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/hydro/hydro_body.h"
#include "core/sim/model/geometry.h"

namespace taxel {
namespace {

void note_mujoco_contacts(const mjModel& m, const mjData& d, BodyContacts& body) {
  const int geom = body.settings().geom;
  for (int c = 0; c < d.ncon; ++c) {
    const mjContact& contact = d.contact[c];
    if (contact.efc_address < 0) continue;
    if (contact.geom[0] != geom && contact.geom[1] != geom) continue;
    const std::size_t i = pair_with(body.touched(), contact.geom[0] == geom ? contact.geom[1] : contact.geom[0]);
    if (i == body.touched().size()) continue;
    const TouchedGeom& t = body.touched()[i];
    if (!t.role.applies || t.role.mirrored || body.checks[i].mujoco_too) continue;
    body.checks[i].mujoco_too = true;
    body.warnings.push_back(
        fmt::format("MuJoCo's own contact of geoms \"{}\" and \"{}\" acts as well: exclude the pair, or "
                    "set contype and conaffinity to 0 and name the geom in \"others\"",
                    geom_name(m, geom), geom_name(m, t.geom)));
  }
}

/// Returns true for a contact of MuJoCo between a geom of this body's MuJoCo body and the body of a touched geom, other
/// than the contacts of note_mujoco_contacts(). Sets the body on the other side.
bool is_share_of_mujoco(const mjModel& m, const BodyContacts& body, const mjContact& contact, int& other_body) {
  if (contact.efc_address < 0 || contact.geom[0] < 0 || contact.geom[1] < 0) return false;
  const int own = m.geom_bodyid[body.settings().geom];
  const bool is_first = m.geom_bodyid[contact.geom[0]] == own;
  if (!is_first && m.geom_bodyid[contact.geom[1]] != own) return false;
  const int mine = contact.geom[is_first ? 0 : 1], other = contact.geom[is_first ? 1 : 0];
  if (mine == body.settings().geom && pair_with(body.touched(), other) != body.touched().size()) return false;
  other_body = m.geom_bodyid[other];
  return true;
}

/// Warns, once for each touched body, if MuJoCo's own contacts with other geoms of this body carry a part of the force:
/// the skin then feels only the rest.
void note_mujoco_share(const mjModel& m, const mjData& d, BodyContacts& contacts) {
  constexpr double kMaxShare = 0.05;
  if (!contacts.settings().apply) return;
  const int geom = contacts.settings().geom;
  const std::vector<TouchedGeom>& touched_geoms = contacts.touched();
  for (int first = 0; first < d.ncon; ++first) {
    int body = -1;
    if (!is_share_of_mujoco(m, contacts, d.contact[first], body)) continue;
    const auto touched = std::find_if(touched_geoms.begin(), touched_geoms.end(),
                                      [&](const TouchedGeom& t) { return m.geom_bodyid[t.geom] == body; });
    if (touched == touched_geoms.end()) continue;
    bool& given = contacts.checks[static_cast<std::size_t>(touched - touched_geoms.begin())].mujoco_share;
    if (given) continue;
    dvec3 skin(0), mujoco(0);
    const Evaluation& e = contacts.sensed();
    for (const std::size_t i : e.near)
      if (m.geom_bodyid[touched_geoms[i].geom] == body) skin += e.X_WM.rotate(e.pairs[i].wrench.force);
    std::vector<std::string> geoms;
    for (int c = first; c < d.ncon; ++c) {
      const mjContact& contact = d.contact[c];
      int other = -1;
      if (!is_share_of_mujoco(m, contacts, contact, other) || other != body) continue;
      mjtNum force[6];  // along the axes of the contact, which are the rows of its frame
      mj_contactForce(&m, &d, c, force);
      const bool is_first = m.geom_bodyid[contact.geom[0]] == m.geom_bodyid[geom];
      for (int axis = 0; axis < 3; ++axis)
        mujoco += (is_first ? -force[axis] : force[axis]) * vec3(contact.frame + 3 * axis);
      const std::string name = fmt::format("\"{}\"", geom_name(m, contact.geom[is_first ? 0 : 1]));
      if (std::find(geoms.begin(), geoms.end(), name) == geoms.end()) geoms.push_back(name);
    }
    const double share = glm::length(mujoco) / (glm::length(mujoco) + glm::length(skin));
    if (!(share > kMaxShare)) continue;
    given = true;
    contacts.warnings.push_back(
        fmt::format("MuJoCo's own contact of {} carries {:.0f} % of the force between the bodies \"{}\" and \"{}\"; "
                    "the skin on \"{}\" "
                    "feels only the rest: set contype and conaffinity of these geoms to 0 and name the touched geoms "
                    "in \"others\", as `taxel run --layout` does",
                    fmt::join(geoms, ", "), 100 * share, body_name(m, m.geom_bodyid[geom]), body_name(m, body),
                    geom_name(m, geom)));
  }
}

/// Warns, once for each pair, that the middle of one body is behind the pad of the other.
void note_bodies_behind_skin(const mjModel& m, const mjData& d, BodyContacts& body) {
  constexpr unsigned kEvery = 16;  // a search in the skin's tree for each: bodies that pass it stay behind it
  const Evaluation& e = body.sensed();
  for (const std::size_t i : e.near) {
    const TouchedGeom& t = body.touched()[i];
    PairChecks& checks = body.checks[i];
    if (checks.behind_skin || t.role.mirrored || checks.skin_checks++ % kEvery != 0) continue;
    const Pose X_MB = e.X_WM.inverse() * e.pairs[i].X_WB;
    const BehindSkin other = behind_skin(*body.body(), X_MB * t.inner),
                     own = behind_skin(*t.body, X_MB.inverse() * body.inner_M());
    const bool is_other = other.beyond_the_pad() && !t.body->half_space();
    if (!is_other && !(own.beyond_the_pad() && !body.body()->half_space())) continue;
    checks.behind_skin = true;
    const int inside = is_other ? t.geom : body.settings().geom, skin = is_other ? body.settings().geom : t.geom;
    const BehindSkin& found = is_other ? other : own;
    body.warnings.push_back(fmt::format(
        "at {:.4g} s the middle of geom \"{}\" is {:.3g} mm behind the skin of geom \"{}\", whose pad is {:.3g} mm "
        "thick: {}",
        d.time, geom_name(m, inside), 1e3 * found.depth, geom_name(m, skin), 1e3 * found.thickness,
        d.time > 0 ? "if it fell through, a larger modulus or thickness of the pad keeps it out"
                   : "move it out of the skin, where it begins"));
  }
}

}  // namespace

bool is_step_check_due(PairChecks& checks, double bound) {
  constexpr double kGrown = 1.02;
  constexpr unsigned kEvery = 8;
  if (bound < kGrown * checks.checked_bound && ++checks.step_checks < kEvery) return false;
  checks.checked_bound = bound;
  checks.step_checks = 0;
  return true;
}

void warn_of_pair(const mjModel& m, BodyContacts& body, std::size_t pair, bool PairChecks::*given,
                  const std::string& text) {
  body.checks[pair].*given = true;
  body.warnings.push_back(fmt::format("the contact of geoms \"{}\" and \"{}\" {}", geom_name(m, body.settings().geom),
                                      geom_name(m, body.touched()[pair].geom), text));
}

void sense_and_warn(const mjModel& m, mjData& d, BodyContacts& body) {
  body.sense(m, d);
  note_mujoco_contacts(m, d, body);
  note_mujoco_share(m, d, body);
  note_bodies_behind_skin(m, d, body);
}

}  // namespace taxel
