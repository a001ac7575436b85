// A recording of a real sensor beside the run: how it is read, and how it lies over the plot.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/run/real/align.h"
#include "core/run/real/gain_fit.h"
#include "core/run/real/real_recording.h"

namespace taxel::ui {

/// The recording that lies over the run of one sensor.
struct RealShown {
  std::string file;
  int sensor = 0;  ///< the run's
  RealRecording recording;
  std::string unit;                    ///< of its values; empty: unknown
  double shift = 0;                    ///< added to its times [s]
  std::optional<Alignment> alignment;  ///< by which the shift was found; none: it was typed
  FitOptions options;                  ///< of the fits
  std::vector<TaxelFit> fits;          ///< empty: not fitted
};
using RealShownPtr = std::shared_ptr<const RealShown>;

/// Its curves as the plot has them.
struct RealCurves {
  RealShownPtr shown;         ///< made of this recording,
  std::uint64_t edition = 0;  ///< this trace,
  std::size_t rows = 0;       ///< so much of it,
  std::size_t first = 0;      ///< and this sensor
  struct Curve {
    int taxel = 0;
    std::vector<double> x, y;  ///< of the plot; the reading's unit
  };
  std::vector<Curve> curves;
};

struct RealState {
  using PerDocument = RealState;  ///< another document resets all of it
  // Of the dialog in which the columns get their meaning:
  bool asks = false;
  std::string file;
  ColumnMapping mapping;
  TableLook look;       ///< of the file, by the mapping
  std::string problem;  ///< why it cannot be read so; empty: it can
  // Of the panel:
  FitOptions options;
  std::string applied;  ///< why the gains cannot be the layout's calibration; empty: they can, or were not asked for
  RealCurves curves;
  RealShownPtr shown;  ///< the recording that is drawn over the run, or null
};

}  // namespace taxel::ui
