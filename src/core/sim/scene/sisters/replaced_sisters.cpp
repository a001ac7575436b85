#include "core/sim/scene/sisters/replaced_sisters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "core/sim/model/geometry.h"
#include "core/sim/plugin/plugin_instances.h"
#include "core/sim/plugin/sensor_config.h"
#include "core/sim/scene/sisters/sister_geoms.h"

namespace taxel {
namespace {

/// Returns the sensor that was added as an instance, or null.
AddedSensor* added_as(std::vector<AddedSensor>& added, const std::string& instance) {
  const auto found = std::ranges::find(added, instance, &AddedSensor::instance);
  return found == added.end() ? nullptr : &*found;
}

std::string ids_key(const std::vector<int>& ids) {
  return fmt::format(R"(<config key="other_ids" value="{}"/>)", fmt::join(ids, " "));
}

}  // namespace

std::map<int, int> replaced_sisters(const mjModel& m, std::vector<AddedSensor>& added,
                                    std::vector<std::string>& notes) {
  std::map<int, int> sisters;
  for (const int i : sensor_instances(m)) {
    const SensorConfig config = read_sensor_config(m, i);
    const AddedSensor* one = added_as(added, config.name);
    if (one == nullptr || one->keeps_sisters || !config.apply) continue;
    std::vector<std::string> replaced;
    for (const auto& [sister, share] : sister_geoms(m, config.geom, *one->model)) {
      bool is_replaced = true;
      for (int g = 0; g < m.ngeom; ++g)
        if (would_collide(m, sister, g)) is_replaced = is_replaced && std::ranges::binary_search(config.others, g);
      if (!is_replaced) {
        notes.push_back(
            fmt::format("geom \"{}\" lies within the skin on \"{}\" and keeps MuJoCo's own contacts: it "
                        "can touch geoms that the skin does not touch",
                        geom_name(m, sister), config.geom_name));
        continue;
      }
      sisters.emplace(sister, config.geom);
      replaced.push_back(fmt::format("\"{}\" ({:.0f} % of its surface)", geom_name(m, sister), 100 * share));
    }
    if (!replaced.empty())
      notes.push_back(fmt::format("the skin on \"{}\" replaces the contacts of what lies within it: {}",
                                  config.geom_name, fmt::join(replaced, ", ")));
  }
  return sisters;
}

void list_others(const mjModel& m, const std::map<int, int>& sisters, std::vector<AddedSensor>& added) {
  for (const int i : sensor_instances(m)) {
    const SensorConfig config = read_sensor_config(m, i);
    AddedSensor* one = added_as(added, config.name);
    if (one == nullptr || config.others_named) continue;
    std::set<int> others;
    for (const int other : config.others) {
      const auto sister = sisters.find(other);
      others.insert(sister == sisters.end() ? other : sister->second);
    }
    one->keys += ids_key({others.begin(), others.end()});
  }
}

}  // namespace taxel
