// Names of topics and frames in ROS 2, made from any names.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace taxel {

/// Gives each name a part of a topic that ROS 2 accepts and no other name has: letters, digits and single underscores,
/// the first of them a letter.
class RosNames {
 public:
  /// Returns "thumb_tip" for "thumb tip", and "thumb_tip_2" if that is taken; "geom_3" for "3"; "geom" for "".
  std::string add(std::string_view name);

 private:
  std::set<std::string> taken_;
};

/// Returns a text that is valid UTF-8, as messages and records need it. In any other text each byte that is not ASCII
/// becomes "?".
std::string utf8_or_marks(std::string_view text);

}  // namespace taxel
