// A rule for the readers of layout formats.
#pragma once

#include <string>
#include <vector>

#include "core/layout/formats/layout_format.h"
#include "fuzz/target.h"

namespace taxel::fuzz {

inline bool same_places(const std::vector<Taxel>& a, const std::vector<Taxel>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].center != b[i].center) return false;
  return true;
}

/// Requires that the layouts of a file are finite, and that the format reads its own file of the first one with the
/// same taxels. The format may refuse to write it. A scene of the plugin may have a sensor without taxels, which feels
/// the force only.
inline void check_layouts_read(const LayoutFormat& format, const std::vector<ImportedLayout>& layouts) {
  require(!layouts.empty(), "a file that is read has a layout");
  for (const ImportedLayout& one : layouts) {
    require(!one.layout.taxels.empty() || one.cell > 0 || format.is_scene, "a layout has taxels or cells");
    for (const Taxel& taxel : one.layout.taxels)
      require(is_finite(taxel.center) && is_finite(taxel.normal), "a taxel that is read is finite");
  }
  const auto written = read_or_refuse([&] { return format.write({layouts.front()}); });
  if (!written) return;
  const std::vector<ImportedLayout> again = format.parse(written->bytes, "written");
  require(again.size() == 1 && same_places(again[0].layout.taxels, layouts[0].layout.taxels),
          "a layout that is written is read with the same taxels");
}

/// Reads the input in the format of this word.
inline void read_layouts_of_input(const char* word, const std::string& input) {
  const LayoutFormat& format = *find_layout_format(word);
  const auto layouts = read_or_refuse([&] { return format.parse(input, "input"); });
  if (layouts) check_layouts_read(format, *layouts);
}

}  // namespace taxel::fuzz
