// Orders of taxels: the order of the table's rows, and new orders for an edit of the layout.
#pragma once

#include <string>
#include <vector>

#include "app/studio/nouns/inspector/layout_problems.h"
#include "app/studio/nouns/table/table_state.h"
#include "core/layout/layout.h"

namespace taxel::ui {

/// Returns all ids, with each run of consecutive selected taxels moved by one place.
std::vector<int> moved_by_one(const Layout& layout, const std::vector<int>& selected, bool up);
/// Returns all ids, with the selected taxels together at the place of the taxel `target`: before the target if they
/// come from below, otherwise after the target.
std::vector<int> moved_to(const Layout& layout, const std::vector<int>& selected, int target);

/// The numbers that the table shows in addition to the fields of the taxels.
struct TableNumbers {
  const std::vector<double>* readings = nullptr;  ///< readings by index in the layout; may be shorter
  const std::vector<int>* samples = nullptr;
  const std::vector<dvec2>* shear = nullptr;  ///< parallel to `readings`; sorted by magnitude
  const std::vector<double>* slip = nullptr;  ///< parallel to `readings`
};

/// Returns the indices of the taxels that pass the filter, in the order of the table. A taxel passes if its id, its
/// name or the text of one of its problems contains the filter, ignoring case.
std::vector<int> table_rows(const TableState& table, const Layout& layout, const LayoutProblems& problems,
                            const TableNumbers& numbers);

}  // namespace taxel::ui
