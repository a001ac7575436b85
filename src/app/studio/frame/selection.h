// Selection of taxels by id, so that an edit, or a model that is still being built, does not change the selection.
#pragma once

#include <optional>
#include <vector>

#include "core/layout/layout.h"

namespace taxel::ui {

struct Selection {
  int sensor = 0;  ///< index of the sensor in the simulation
  /// Ids of the selected taxels, each once, in the order of selection; the last one is the active taxel.
  std::vector<int> taxels;
  int body = -1;  ///< index in SceneControls::bodies, or -1 if no body is selected
  bool operator==(const Selection&) const = default;

  [[nodiscard]] bool empty() const { return taxels.empty(); }
  [[nodiscard]] bool contains(int id) const;
  /// Returns the id of the taxel whose values are displayed as single numbers, or empty if no taxel is selected.
  [[nodiscard]] std::optional<int> active() const;

  void clear() { taxels.clear(); }  ///< deselects all taxels
  void set(int id) { taxels = {id}; }
  void add(int id);  ///< selects a taxel and makes it the active one
  void remove(int id);
  void toggle(int id);
  void set_all(const Layout& layout);
  void invert(const Layout& layout);
  /// Removes ids that the layout does not have.
  void keep_only(const Layout& layout);
};

/// Returns the index of a taxel in layout order, or -1 if the layout has no taxel with that id.
int index_of(const Layout& layout, int id);
/// Returns the indices of the selected taxels that the layout has, in ascending order.
std::vector<int> selected_indices(const Selection& selection, const Layout& layout);
/// Returns the index of the active taxel, or -1 if the layout has no such taxel.
int active_index(const Selection& selection, const Layout& layout);

}  // namespace taxel::ui
