// Opens data sets, and episodes of data sets as documents.
#pragma once

#include <string>

#include "app/studio/frame/command.h"
#include "app/studio/host/run/host_event.h"

namespace taxel::ui {

/// Opens the layout and the scenario of an episode of a data set and runs it.
struct OpenEpisode {
  std::string folder;  ///< folder of the data set
  std::int64_t episode = 0;
  bool operator==(const OpenEpisode&) const = default;
};

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::OpenEpisode& command, Host& host);

/// Begins to read a data set. The open document stays.
void read_data_set(Host& host, const std::string& folder);
/// Shows a data set that was read.
void show_data_set(Host& host, const DataSetRead& read);

}  // namespace taxel::studio
