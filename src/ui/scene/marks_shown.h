// Selection of the frames and labels of a scene's parts that are drawn, in the order in which keys go through them.
#pragma once

#include <array>
#include <cstddef>

namespace taxel::ui {

enum class FramesShown { none, bodies, geoms, sites, world };
inline constexpr std::array kFramesWords = {"none", "bodies", "geoms", "sites", "world"};

enum class LabelsShown { none, bodies, joints, geoms, sites, cameras };
inline constexpr std::array kLabelsWords = {"none", "bodies", "joints", "geoms", "sites", "cameras"};

inline const char* to_word(FramesShown shown) {
  return kFramesWords.at(static_cast<std::size_t>(shown));
}
inline const char* to_word(LabelsShown shown) {
  return kLabelsWords.at(static_cast<std::size_t>(shown));
}

/// Returns the next selection; after the last selection, the first one.
inline FramesShown next(FramesShown shown) {
  return static_cast<FramesShown>((static_cast<std::size_t>(shown) + 1) % kFramesWords.size());
}
inline LabelsShown next(LabelsShown shown) {
  return static_cast<LabelsShown>((static_cast<std::size_t>(shown) + 1) % kLabelsWords.size());
}

}  // namespace taxel::ui
