// The comparison of a run with a second layout: the request, the readings of both, and the state of the panel.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/nouns/bars/bars_state.h"
#include "app/studio/nouns/compare/compare_rows.h"
#include "app/studio/nouns/plot/plot_choice.h"
#include "core/sensor/compare/second_contact.h"

namespace taxel::ui {

/// A second layout to compare the run with: a file, or the paper's released model.
struct CompareRequest {
  std::uint64_t number = 0;  ///< changes whenever the second layout is to be read again
  std::string file;          ///< layout file; empty for the paper's released model
  SecondContact contact = SecondContact::recorded;

  [[nodiscard]] bool is_paper() const { return file.empty(); }
  bool operator==(const CompareRequest&) const = default;
};

/// The readings of both layouts, as far as the recorded steps were read.
struct ComparedLayouts {
  CompareRequest request;
  int sensor = 0;       ///< index of the compared sensor in the simulation
  SensorModelPtr a, b;  ///< layout of the run and second layout; `b` is null while it is built
  /// Taxels of `b`; null if they are those of `a`.
  std::shared_ptr<const std::vector<Taxel>> taxels_of_b;
  bool reads_recorded = true;        ///< whether both read the same contact surfaces
  bool equal_contact = true;         ///< whether the material of `b` itself gives these surfaces
  std::vector<ComparedRowPtr> rows;  ///< recorded rows from the oldest one on, ascending
  ComparedRowPtr displayed;          ///< step that was displayed, or null
  std::string problem;               ///< reason why there are no readings; empty if there are or will be
};
using ComparedLayoutsPtr = std::shared_ptr<const ComparedLayouts>;

/// The state of the work on a comparison.
struct CompareProgress {
  bool busy = false;
  double building = 0;   ///< finished fraction of building the second layout
  std::size_t read = 0;  ///< number of rows of the run that were read, or passed over
  std::size_t due = 0;   ///< number of rows of the run
};

/// The panel as it was drawn in the last frame.
struct CompareShown {
  std::array<std::vector<ChosenCurve>, 2> curves;  ///< curves of A and of B
  std::vector<TaxelKey> focus;                     ///< curves that stand out; empty if all are equal
  std::string hovered;                             ///< name of the curve under the pointer, or empty
  std::string held;                                ///< sentence on what both layouts have in common
  BarsShown bars;
  ComparedRowPtr step;  ///< step of the bars, or null
};

struct CompareState {
  using PerDocument = CompareState;  ///< another document ends the comparison
  std::optional<CompareRequest> request;
  std::uint64_t number = 0;  ///< number of the newest request
  bool stopped = false;      ///< whether no further recorded steps are to be read
  CompareProgress progress;
  ComparedLayoutsPtr compared;  ///< newest result, or null

  // Options of the panel:
  bool relative = false;  ///< plot fractions of each layout's own largest reading
  bool responding_only = true;
  bool rings = true;  ///< draw the receptive fields of B in the view
  std::array<bool, 2> drawn{true, true};
  std::vector<TaxelKey> isolated;   ///< curves that stand out until they are clicked again
  std::optional<TaxelKey> hovered;  ///< curve that was under the pointer in the last frame

  std::array<CompareSide, 2> sides;   ///< rows of `compared`, as curves and numbers
  std::vector<ComparedRowPtr> taken;  ///< rows that `sides` hold
  CompareShown shown;
};

}  // namespace taxel::ui
