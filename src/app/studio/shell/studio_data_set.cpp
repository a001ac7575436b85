// Opens data sets, and episodes of data sets as documents.
#include "app/studio/app/values/simulate_features.h"
#include "app/studio/app/values/window_features.h"
#include "app/studio/shell/studio.h"

namespace taxel::studio {

/// Begins to read a data set. The open document stays.
void Studio::read_data_set(const std::string& folder) {
  ui::DataSetState& state = app_.simulate->data_set;
  const std::uint64_t number = state.request ? state.request->number + 1 : 1;
  state.request = ui::DataSetRequest{number, folder};
}

void Studio::show_data_set(const DataSetRead& read) {
  if (!read.is_good) return;
  outcome_.has_opened = true;
  app_.window->panels.data_set = true;
  app_.simulate->data_set.wants_focus = true;
  remember_recent(app_.window->recent, read.folder);
}

void Studio::carry_out(const ui::OpenEpisode& episode) {
  files_.layout_without_mesh.clear();
  session_.open(EpisodeChoice{episode.folder, episode.episode});
}

}  // namespace taxel::studio
