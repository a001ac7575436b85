// Names of sensors: the name of a sensor on a geom without a name, and short names for labels where several sensors are
// in a scene.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace taxel {

/// Returns the name of a sensor on a geom without a name, which the geom gets as well: the name of the body, or the
/// first of BODY_2, BODY_3, ... that is not in `taken`, the names of the other geoms. Spaces and commas become '_',
/// because a name with them cannot be in a list of geoms.
std::string sensor_name(const std::string& body, const std::set<std::string>& taken);

/// Returns a short name for each sensor, for labels such as "index 3": the finger ("index" for "rh_ffdistal"), or the
/// finger and its link ("index distal"), or the side as well ("right index distal"), as long as sensors of the same
/// finger or side need; names without a finger lose the words that all of them begin and end with, if each keeps a
/// word; and a whole name is the last resort. Short names differ if all names differ. The only sensor of a scene keeps
/// its name.
std::vector<std::string> short_sensor_names(const std::vector<std::string>& names);

}  // namespace taxel
