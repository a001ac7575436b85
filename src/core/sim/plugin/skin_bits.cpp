#include "core/sim/plugin/skin_bits.h"

#include <fmt/format.h>

#include <charconv>
#include <string>

#include "core/base/error.h"
#include "core/sim/model/geometry.h"
#include "core/sim/plugin/plugin_instances.h"

namespace taxel {
namespace {

int read_mask(const std::string& value, const char* key) {
  if (value.empty()) return 0;
  int mask = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), mask);
  if (error != std::errc{} || end != value.data() + value.size() || mask < 0)
    throw Error("", key, fmt::format("must be a whole number from 0 on, whose bits are a mask, is \"{}\"", value));
  return mask;
}

}  // namespace

ContactBits read_skin_bits(const mjModel& m, int instance) {
  return {read_mask(config_value(m, instance, "contype"), "contype"),
          read_mask(config_value(m, instance, "conaffinity"), "conaffinity")};
}

SkinBits::SkinBits(const mjModel& m) : m_(m) {
  for (const int i : sensor_instances(m)) {
    try {
      const ContactBits bits = read_skin_bits(m, i);
      if (!bits.any()) continue;
      const int geom = GeomNames(m, i).sensor_geom();
      if (geom >= 0) skins_[geom] = skins_[geom] | bits;
    } catch (const Error&) {
    }
  }
}

ContactBits SkinBits::of(int geom) const {
  const ContactBits own{m_.geom_contype[geom], m_.geom_conaffinity[geom]};
  const auto skin = skins_.find(geom);
  return skin == skins_.end() ? own : own | skin->second;
}

bool SkinBits::let_touch(int geom, int other) const {
  if (skins_.empty() || !can_bodies_collide(m_, geom, other) || are_bodies_excluded(m_, geom, other)) return false;
  const int body = m_.geom_bodyid[geom];
  for (int i = 0; i < m_.body_geomnum[body]; ++i)
    if (match(of(m_.body_geomadr[body] + i), of(other))) return true;
  return false;
}

}  // namespace taxel
