// The panel of data sets: episodes as a list, the curves of one, and its replay.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// The episodes of a data set.
extern const Feature kDataSet;
/// Sets "data_set": the set, the listed episodes and the replayed one.
void dump_data_set(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
