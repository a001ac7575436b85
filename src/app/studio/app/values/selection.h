// Which taxels are selected: by id, so that an edit or a model that is still being built does not change what is meant.
#pragma once

#include <optional>
#include <vector>

#include "core/layout/layout.h"

namespace taxel::ui {

struct Selection {
  int sensor = 0;           ///< of the simulation
  std::vector<int> taxels;  ///< ids, each once, in the order in which they were selected: the last is the active one
  int body = -1;            ///< of the simulation, as SceneControls::bodies numbers them; -1: none
  bool operator==(const Selection&) const = default;

  [[nodiscard]] bool empty() const { return taxels.empty(); }
  [[nodiscard]] bool contains(int id) const;
  /// The taxel that single numbers are about.
  [[nodiscard]] std::optional<int> active() const;

  void clear() { taxels.clear(); }  ///< of taxels
  void set(int id) { taxels = {id}; }
  void add(int id);  ///< which becomes the active one
  void remove(int id);
  void toggle(int id);
  void set_all(const Layout& layout);
  void invert(const Layout& layout);
  /// Forgets ids that the layout does not have.
  void keep_only(const Layout& layout);
};

/// Index in layout order of a taxel; -1: the layout has none of that id.
int index_of(const Layout& layout, int id);
/// Indices of the selected taxels that the layout has, ascending; and of the active one, or -1.
std::vector<int> selected_indices(const Selection& selection, const Layout& layout);
int active_index(const Selection& selection, const Layout& layout);

}  // namespace taxel::ui
