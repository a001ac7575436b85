// Reads a data set for the list of episodes.
#pragma once

#include <string>

#include "app/studio/nouns/data_set/data_set_state.h"
#include "core/base/progress.h"

namespace taxel::studio {

/// Reads everything but the rows of the episodes. Throws Error naming the file and the remedy: the data set is missing,
/// damaged, or of a newer version; throws Cancelled.
ui::OpenDataSet read_open_data_set(const std::string& folder, Progress& progress);

}  // namespace taxel::studio
