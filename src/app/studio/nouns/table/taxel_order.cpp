#include "app/studio/nouns/table/taxel_order.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

std::vector<int> ids_of(const Layout& layout) {
  std::vector<int> ids;
  for (const Taxel& taxel : layout.taxels) ids.push_back(taxel.id);
  return ids;
}

bool passes(const std::string& filter, const Taxel& taxel, const LayoutProblems& problems) {
  if (filter.empty() || std::to_string(taxel.id).find(filter) != std::string::npos) return true;
  if (contains_word(taxel.name, filter)) return true;
  const std::vector<std::size_t> own = problems.of(taxel.id);
  return std::any_of(own.begin(), own.end(),
                     [&](std::size_t i) { return contains_word(problems.list[i].message, filter); });
}

template <class T>
double number_at(const std::vector<T>* numbers, int index) {
  const auto i = static_cast<std::size_t>(index);
  return numbers != nullptr && i < numbers->size() ? static_cast<double>((*numbers)[i]) : 0.0;
}

double number_in(TableColumn column, const Layout& layout, const TableNumbers& numbers, int index) {
  const Taxel& taxel = layout.taxels[static_cast<std::size_t>(index)];
  switch (column) {
    case TableColumn::id:
    case TableColumn::name:
    case TableColumn::sensor:
      return taxel.id;
    case TableColumn::x:
    case TableColumn::y:
    case TableColumn::z:
      return taxel.center[static_cast<int>(column) - static_cast<int>(TableColumn::x)];
    case TableColumn::nx:
    case TableColumn::ny:
    case TableColumn::nz:
      return taxel.normal[static_cast<int>(column) - static_cast<int>(TableColumn::nx)];
    case TableColumn::radius:
      return taxel.radius;
    case TableColumn::samples:
      return number_at(numbers.samples, index);
    case TableColumn::reading:
      return number_at(numbers.readings, index);
    case TableColumn::shear: {
      const auto i = static_cast<std::size_t>(index);
      return numbers.shear != nullptr && i < numbers.shear->size() ? glm::length((*numbers.shear)[i]) : 0.0;
    }
    case TableColumn::slip:
      return number_at(numbers.slip, index);
  }
  return 0;
}

}  // namespace

std::vector<int> moved_by_one(const Layout& layout, const std::vector<int>& selected, bool up) {
  std::vector<int> ids = ids_of(layout);
  const std::set<int> moved(selected.begin(), selected.end());
  if (!up) std::reverse(ids.begin(), ids.end());
  for (std::size_t i = 1; i < ids.size(); ++i)
    if (moved.contains(ids[i]) && !moved.contains(ids[i - 1])) std::swap(ids[i], ids[i - 1]);
  if (!up) std::reverse(ids.begin(), ids.end());
  return ids;
}

std::vector<int> moved_to(const Layout& layout, const std::vector<int>& selected, int target) {
  std::vector<int> ids = ids_of(layout);
  const std::set<int> moved(selected.begin(), selected.end());
  const auto is_moved = [&](int id) { return moved.contains(id); };
  const auto at = std::find(ids.begin(), ids.end(), target);
  if (at == ids.end() || is_moved(target)) return ids;
  const bool from_above = std::any_of(ids.begin(), at, is_moved);
  const auto place = from_above ? at + 1 : at;
  std::stable_partition(ids.begin(), place, [&](int id) { return !is_moved(id); });
  std::stable_partition(place, ids.end(), is_moved);
  return ids;
}

std::vector<int> table_rows(const TableState& table, const Layout& layout, const LayoutProblems& problems,
                            const TableNumbers& numbers) {
  std::vector<int> rows;
  for (std::size_t i = 0; i < layout.taxels.size(); ++i)
    if (passes(table.filter, layout.taxels[i], problems)) rows.push_back(static_cast<int>(i));
  if (!table.sorted) return rows;
  const auto before = [&](int a, int b) {
    if (*table.sorted == TableColumn::name)
      return layout.taxels[static_cast<std::size_t>(a)].name < layout.taxels[static_cast<std::size_t>(b)].name;
    return number_in(*table.sorted, layout, numbers, a) < number_in(*table.sorted, layout, numbers, b);
  };
  std::stable_sort(rows.begin(), rows.end(),
                   [&](int a, int b) { return table.descending ? before(b, a) : before(a, b); });
  return rows;
}

}  // namespace taxel::ui
