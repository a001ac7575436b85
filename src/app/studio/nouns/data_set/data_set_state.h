// Data sets in the window: the open data set, its list of episodes with filter, order and choice, the curves of the
// chosen episode, and its replay with the comparison and the sentence about it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/frame/command.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown.h"
#include "app/studio/host/document/replayed_episode.h"
#include "app/studio/host/run/host_event.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "core/layout/layout.h"
#include "core/run/batch/data_set.h"

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

/// Returns whether a row has all words of a filter. A word is a part of a number, a layout, a scenario, a value or the
/// reason of a failure, in any case.
[[nodiscard]] bool passes_filter(const OpenDataSet& set, const EpisodeRow& row, const std::string& filter);

/// Displays a data set that was read, with its first episode chosen if it is another one, and the rows of an episode.
/// A data set that could not be read is not displayed: the earlier one stays.
void show_data_set(DataSetState& state, const OpenDataSetPtr& set, const EpisodeCurvesPtr& curves);

/// Returns the request for the rows of the chosen episode, or nothing if no episode is chosen.
[[nodiscard]] std::optional<EpisodeRequest> episode_request(const DataSetState& state);

/// Fills the list for the data set and the order of the state, if one of them has changed. Equal rows keep the order of
/// the data set; rows without a value are last.
void update_episode_list(DataSetState& state);

/// Continues the comparison of the run with the episode that the document repeats. A run of an edited document is not
/// compared.
void follow_replay(const Shown& shown, DataSetState& state);

/// The outcome of a replay, as far as it is known.
enum class ReplayVerdict {
  none,      ///< no episode is repeated, or its run has no rows yet
  edited,    ///< the document was edited, so that its run is not the episode's
  running,   ///< all rows so far are equal
  equal,     ///< all rows of the episode are equal
  different  ///< rows differ, or their number does
};
[[nodiscard]] ReplayVerdict replay_verdict(const Shown& shown, const DataSetState& state);

/// Returns a sentence about the replay; empty for ReplayVerdict::none. It has the largest difference with its unit,
/// taxel and time.
[[nodiscard]] std::string replay_text(const Shown& shown, const DataSetState& state);

/// Opens the layout and the scenario of an episode of a data set and runs it.
struct OpenEpisode {
  std::string folder;  ///< folder of the data set
  std::int64_t episode = 0;
  bool operator==(const OpenEpisode&) const = default;
};

/// The panel of data sets: episodes as a list, the curves of one, and its replay.
extern const Feature kDataSet;
/// Sets "data_set": the set, the listed episodes and the replayed one.
void dump_data_set(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::OpenEpisode& command, Host& host);

/// Begins to read a data set. The open document stays.
void read_data_set(Host& host, const std::string& folder);
/// Shows a data set that was read.
void show_data_set(Host& host, const DataSetRead& read);

/// Makes the job of the feature.
[[nodiscard]] std::unique_ptr<FeatureJob> make_data_set_job(JobExecutor& executor);

}  // namespace taxel::studio
