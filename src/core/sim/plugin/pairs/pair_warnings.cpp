// Warnings about the pairs of a body: contacts of MuJoCo that act as well, and bodies behind the skin.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/hydro/hydro_body.h"
#include "core/sim/model/geometry.h"
#include "core/sim/plugin/pairs/body_contacts.h"

namespace taxel {

void BodyContacts::warn_of_pair(const mjModel& m, std::size_t pair, bool TouchedGeom::*given, const std::string& text) {
  TouchedGeom& touched = touched_[pair];
  touched.*given = true;
  warnings.push_back(fmt::format("the contact of geoms \"{}\" and \"{}\" {}", geom_name(m, settings().geom),
                                 geom_name(m, touched.geom), text));
}

void BodyContacts::note_mujoco_contacts(const mjModel& m, const mjData& d) {
  for (int c = 0; c < d.ncon; ++c) {
    const mjContact& contact = d.contact[c];
    if (contact.efc_address < 0) continue;
    if (contact.geom[0] != settings().geom && contact.geom[1] != settings().geom) continue;
    const std::size_t i = pair_with(contact.geom[0] == settings().geom ? contact.geom[1] : contact.geom[0]);
    if (i == touched_.size()) continue;
    TouchedGeom& t = touched_[i];
    if (!t.role.applies || t.role.mirrored || t.mujoco_too) continue;
    t.mujoco_too = true;
    warnings.push_back(
        fmt::format("MuJoCo's own contact of geoms \"{}\" and \"{}\" acts as well: exclude the pair, or "
                    "set contype and conaffinity to 0 and name the geom in \"others\"",
                    geom_name(m, settings().geom), geom_name(m, t.geom)));
  }
}

/// Returns true for a contact of MuJoCo between a geom of this body's MuJoCo body and the body of a touched geom, other
/// than the contacts of note_mujoco_contacts(). Sets the body on the other side.
bool BodyContacts::is_share_of_mujoco(const mjModel& m, const mjContact& contact, int& other_body) const {
  if (contact.efc_address < 0 || contact.geom[0] < 0 || contact.geom[1] < 0) return false;
  const int own = m.geom_bodyid[settings().geom];
  const bool is_first = m.geom_bodyid[contact.geom[0]] == own;
  if (!is_first && m.geom_bodyid[contact.geom[1]] != own) return false;
  const int mine = contact.geom[is_first ? 0 : 1], other = contact.geom[is_first ? 1 : 0];
  if (mine == settings().geom && pair_with(other) != touched_.size()) return false;
  other_body = m.geom_bodyid[other];
  return true;
}

/// Warns, once for each touched body, if MuJoCo's own contacts with other geoms of this body carry a part of the force:
/// the skin then feels only the rest.
void BodyContacts::note_mujoco_share(const mjModel& m, const mjData& d) {
  constexpr double kMaxShare = 0.05;
  if (!settings().apply) return;
  for (int first = 0; first < d.ncon; ++first) {
    int body = -1;
    if (!is_share_of_mujoco(m, d.contact[first], body)) continue;
    const auto touched = std::find_if(touched_.begin(), touched_.end(),
                                      [&](const TouchedGeom& t) { return m.geom_bodyid[t.geom] == body; });
    if (touched == touched_.end() || touched->mujoco_share) continue;
    dvec3 skin(0), mujoco(0);
    const Evaluation& e = sensed();
    for (const std::size_t i : e.near)
      if (m.geom_bodyid[touched_[i].geom] == body) skin += e.X_WM.rotate(e.pairs[i].wrench.force);
    std::vector<std::string> geoms;
    for (int c = first; c < d.ncon; ++c) {
      const mjContact& contact = d.contact[c];
      int other = -1;
      if (!is_share_of_mujoco(m, contact, other) || other != body) continue;
      mjtNum force[6];  // along the axes of the contact, which are the rows of its frame
      mj_contactForce(&m, &d, c, force);
      const bool is_first = m.geom_bodyid[contact.geom[0]] == m.geom_bodyid[settings().geom];
      for (int axis = 0; axis < 3; ++axis)
        mujoco += (is_first ? -force[axis] : force[axis]) * vec3(contact.frame + 3 * axis);
      const std::string name = fmt::format("\"{}\"", geom_name(m, contact.geom[is_first ? 0 : 1]));
      if (std::find(geoms.begin(), geoms.end(), name) == geoms.end()) geoms.push_back(name);
    }
    const double share = glm::length(mujoco) / (glm::length(mujoco) + glm::length(skin));
    if (!(share > kMaxShare)) continue;
    touched->mujoco_share = true;
    warnings.push_back(
        fmt::format("MuJoCo's own contact of {} carries {:.0f} % of the force between the bodies \"{}\" and \"{}\"; "
                    "the skin on \"{}\" "
                    "feels only the rest: set contype and conaffinity of these geoms to 0 and name the touched geoms "
                    "in \"others\", as `taxel run --layout` does",
                    fmt::join(geoms, ", "), 100 * share, body_name(m, m.geom_bodyid[settings().geom]),
                    body_name(m, body), geom_name(m, settings().geom)));
  }
}

void BodyContacts::note_bodies_behind_skin(const mjModel& m, const mjData& d) {
  constexpr unsigned kEvery = 16;  // a search in the skin's tree for each: bodies that pass it stay behind it
  const Evaluation& e = slots_[sensed_];
  for (const std::size_t i : e.near) {
    TouchedGeom& t = touched_[i];
    if (t.behind_skin || t.role.mirrored || t.skin_checks++ % kEvery != 0) continue;
    const Pose X_MB = e.X_WM.inverse() * e.pairs[i].X_WB;
    const BehindSkin other = behind_skin(*body_, X_MB * t.inner), own = behind_skin(*t.body, X_MB.inverse() * inner_M_);
    const bool is_other = other.beyond_the_pad() && !t.body->half_space();
    if (!is_other && !(own.beyond_the_pad() && !body_->half_space())) continue;
    t.behind_skin = true;
    const int inside = is_other ? t.geom : settings().geom, skin = is_other ? settings().geom : t.geom;
    const BehindSkin& found = is_other ? other : own;
    warnings.push_back(fmt::format(
        "at {:.4g} s the middle of geom \"{}\" is {:.3g} mm behind the skin of geom \"{}\", whose pad is {:.3g} mm "
        "thick: {}",
        d.time, geom_name(m, inside), 1e3 * found.depth, geom_name(m, skin), 1e3 * found.thickness,
        d.time > 0 ? "if it fell through, a larger modulus or thickness of the pad keeps it out"
                   : "move it out of the skin, where it begins"));
  }
}

}  // namespace taxel
