#include "app/studio/nouns/table/taxel_rows.h"

#include <algorithm>
#include <unordered_map>

namespace taxel::ui {

Table table_of(const Viewer& viewer, const Shown& shown, const Layout& layout, const SensorModel& model) {
  Table table{shown.document.editing.project.get(),
              layout,
              model,
              viewer.mode == Mode::simulate ? shown.sensor(viewer) : nullptr,
              {},
              {},
              false};
  table.edited = viewer.mode == Mode::layout && shown.document.editing.project;
  if (table.sensor != nullptr) table.values.include(*table.sensor);
  const auto& known = model.layout.taxels;
  std::unordered_map<int, std::size_t> indices;
  for (std::size_t i = 0; i < layout.taxels.size(); ++i) {
    const int id = layout.taxels[i].id;
    int found = static_cast<int>(i);
    if (i >= known.size() || known[i].id != id) {
      if (indices.empty()) indices = taxel_indices(model.layout);
      const auto at = indices.find(id);
      found = at == indices.end() ? -1 : static_cast<int>(at->second);
    }
    table.in_model.push_back(found);
    const auto k = static_cast<std::size_t>(std::max(0, found));
    table.samples.push_back(found < 0 ? 0 : model.fields.first[k + 1] - model.fields.first[k]);
  }
  return table;
}

}  // namespace taxel::ui
