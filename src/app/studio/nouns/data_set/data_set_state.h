// The state of the panel of data sets: the open data set, its list of episodes, the chosen episode and its replay.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/frame/sensors_shown.h"
#include "app/studio/host/episodes/replayed_episode.h"
#include "app/studio/nouns/plot/plot_curves.h"
#include "core/layout/layout.h"
#include "core/run/batch/data_set.h"
#include "core/run/data_set/replay_check.h"

namespace taxel::ui {

/// A data set to be read, with a unique number: the same folder may be read again.
struct DataSetRequest {
  std::uint64_t number = 0;
  std::string folder;
  bool operator==(const DataSetRequest&) const = default;
};

/// A layout of the data set.
struct DataSetLayout {
  std::string name;  ///< with a number if several layouts have one name
  Aggregate aggregate = Aggregate::mean;
  std::vector<std::int64_t> taxel_ids;
};

/// A changed parameter: a column of the list.
struct DataSetParameter {
  std::string pointer;  ///< JSON pointer, such as /scenario/depth
  std::string title;    ///< label with the displayed unit
  int decimal = 0;      ///< the displayed unit is 10^decimal SI units
};

/// The value of a parameter in one job.
struct ParameterValue {
  std::string text;              ///< in the displayed unit; empty if the job does not change the parameter
  std::optional<double> number;  ///< in the displayed unit; empty if the value is not a number
};

/// An episode, or a job that failed.
struct EpisodeRow {
  std::optional<std::int64_t> episode;  ///< number of the episode; empty if the job failed
  std::optional<std::size_t> layout;    ///< index of OpenDataSet::layouts
  int line = 0;                         ///< line in the list of jobs
  std::string scenario;                 ///< kind of the scenario; empty if the job failed
  std::vector<ParameterValue> values;   ///< parallel to OpenDataSet::parameters
  std::int64_t seed = 0;
  double peak = 0;      ///< largest reading, in the unit of the layout's readings
  int peak_taxel = -1;  ///< id of the taxel with the largest reading, or -1
  double force = 0;     ///< largest force [N]
  std::int64_t rows = 0;
  double duration = 0;  ///< [s]
  std::string error;    ///< why the job failed; empty for an episode
};

/// A data set as it was read, without the rows of the episodes.
struct OpenDataSet {
  std::string folder;
  std::string program;  ///< versions of the program and of MuJoCo that wrote the data set
  int bits = 32;        ///< bits of the numbers of the rows
  std::vector<DataSetLayout> layouts;
  std::vector<DataSetParameter> parameters;
  std::vector<EpisodeRow> rows;           ///< episodes by number, then failed jobs in the order of the list
  std::size_t failed = 0;                 ///< number of failed jobs
  std::size_t broken = 0;                 ///< number of lines of the list that gave no jobs
  std::shared_ptr<const DataSet> source;  ///< reader of the rows of the episodes
  std::string problem;                    ///< why the data set cannot be read, or empty
};
using OpenDataSetPtr = std::shared_ptr<const OpenDataSet>;

/// The rows of an episode, to be read.
struct EpisodeRequest {
  std::shared_ptr<const DataSet> source;
  studio::EpisodeChoice choice;
  bool operator==(const EpisodeRequest&) const = default;
};

/// The rows of the chosen episode.
struct EpisodeCurves {
  studio::EpisodeChoice from;
  Trace readings;       ///< readings of the taxels
  Trace forces;         ///< the rows with x, y and z of the force [N] as readings
  std::string problem;  ///< why the rows cannot be read, or empty
};
using EpisodeCurvesPtr = std::shared_ptr<const EpisodeCurves>;

/// The curves of the chosen episode as they are drawn.
struct EpisodePlots {
  EpisodeCurvesPtr from;  ///< rows of the curves
  PlotCurves readings, forces;
  std::vector<TaxelKey> isolated;  ///< curves that stand out until they are clicked again
};

/// The columns before and after those of the parameters.
enum class EpisodeColumnId : std::size_t { episode, layout, scenario, seed, peak, force, rows, duration, parameter };

/// The order of the list, and the filter.
struct EpisodeOrder {
  EpisodeColumnId column = EpisodeColumnId::episode;
  std::size_t parameter = 0;  ///< index of OpenDataSet::parameters if `column` is a parameter
  bool descending = false;
  std::string filter;
  bool operator==(const EpisodeOrder&) const = default;
};

/// The list as it is displayed.
struct EpisodeList {
  OpenDataSetPtr set;  ///< data set of the list
  EpisodeOrder order;
  std::vector<std::size_t> rows;  ///< indices of OpenDataSet::rows
};

struct DataSetState {
  std::optional<DataSetRequest> request;
  OpenDataSetPtr set;  ///< the data set that was read last, or null
  bool is_reading = false;
  EpisodeOrder order;
  EpisodeList list;
  std::optional<std::size_t> chosen;  ///< index of OpenDataSet::rows
  EpisodeCurvesPtr curves;            ///< rows of the chosen episode, or of an earlier one, or null
  EpisodePlots plots;
  bool wants_focus = false;  ///< the panel gets to the front in the next frame

  studio::ReplayedEpisodePtr replayed;  ///< episode that the document repeats, or null
  ReplayCheck check;                    ///< comparison of the run with `replayed`
};

}  // namespace taxel::ui
