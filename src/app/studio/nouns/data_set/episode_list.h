// The list of episodes: filter, order and choice.
#pragma once

#include <string>

#include "app/studio/nouns/data_set/data_set_state.h"

namespace taxel::ui {

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

}  // namespace taxel::ui
