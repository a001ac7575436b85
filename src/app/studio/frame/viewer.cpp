#include "app/studio/frame/viewer.h"

#include <algorithm>
#include <unordered_set>

namespace taxel::ui {

bool Selection::contains(int id) const {
  return std::find(taxels.begin(), taxels.end(), id) != taxels.end();
}

std::optional<int> Selection::active() const {
  return taxels.empty() ? std::nullopt : std::optional<int>(taxels.back());
}

void Selection::add(int id) {
  remove(id);
  taxels.push_back(id);
}

void Selection::remove(int id) {
  std::erase(taxels, id);
}

void Selection::toggle(int id) {
  contains(id) ? remove(id) : add(id);
}

void Selection::set_all(const Layout& layout) {
  const std::optional<int> before = active();
  taxels.clear();
  for (const Taxel& taxel : layout.taxels) taxels.push_back(taxel.id);
  if (before && contains(*before)) add(*before);
}

void Selection::invert(const Layout& layout) {
  const std::unordered_set<int> before(taxels.begin(), taxels.end());
  taxels.clear();
  for (const Taxel& taxel : layout.taxels) {
    if (!before.contains(taxel.id)) taxels.push_back(taxel.id);
  }
}

void Selection::keep_only(const Layout& layout) {
  std::unordered_set<int> ids;
  for (const Taxel& taxel : layout.taxels) ids.insert(taxel.id);
  std::erase_if(taxels, [&](int id) { return !ids.contains(id); });
}

int index_of(const Layout& layout, int id) {
  const auto& all = layout.taxels;
  const auto found = std::find_if(all.begin(), all.end(), [id](const Taxel& taxel) { return taxel.id == id; });
  return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

std::vector<int> selected_indices(const Selection& selection, const Layout& layout) {
  std::vector<int> indices;
  const std::unordered_set<int> selected(selection.taxels.begin(), selection.taxels.end());
  if (selected.empty()) return indices;
  for (std::size_t i = 0; i < layout.taxels.size(); ++i) {
    if (selected.contains(layout.taxels[i].id)) indices.push_back(static_cast<int>(i));
  }
  return indices;
}

int active_index(const Selection& selection, const Layout& layout) {
  const std::optional<int> id = selection.active();
  return id ? index_of(layout, *id) : -1;
}

}  // namespace taxel::ui
