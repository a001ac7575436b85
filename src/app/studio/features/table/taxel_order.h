// Orders of taxels: as the table shows them, and as an edit is to make them.
#pragma once

#include <string>
#include <vector>

#include "app/studio/features/inspector/layout_problems.h"
#include "app/studio/features/table/table_state.h"
#include "core/layout/layout.h"

namespace taxel::ui {

/// All ids, with each run of the selected ones moved by one place.
std::vector<int> moved_by_one(const Layout& layout, const std::vector<int>& selected, bool up);
/// All ids, with the selected ones together at the place of the taxel `target`: before it where they come from below,
/// else behind it.
std::vector<int> moved_to(const Layout& layout, const std::vector<int>& selected, int target);

/// What the table shows of a taxel beside its own fields.
struct TableNumbers {
  const std::vector<double>* readings = nullptr;  ///< by index in the layout; may be shorter
  const std::vector<int>* samples = nullptr;
};

/// Indices of the taxels that the filter leaves, in the order of the table. The filter is part of an id, a name or the
/// words of a problem, in any case.
std::vector<int> table_rows(const TableState& table, const Layout& layout, const LayoutProblems& problems,
                            const TableNumbers& numbers);

}  // namespace taxel::ui
