#include "app/studio/nouns/data_set/data_set_commands.h"

#include "app/studio/frame/feature.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/data_set/data_set.h"
#include "app/studio/nouns/data_set/data_set_state.h"
#include "app/studio/nouns/files/files_state.h"

namespace taxel::studio {

/// Begins to read a data set. The open document stays.
void read_data_set(Host& host, const std::string& folder) {
  ui::DataSetState& state = host.app.get<ui::DataSetState>();
  const std::uint64_t number = state.request ? state.request->number + 1 : 1;
  state.request = ui::DataSetRequest{number, folder};
}

void show_data_set(Host& host, const DataSetRead& read) {
  if (!read.is_good) return;
  host.app.get<ui::PanelsShown>()[ui::kDataSet] = true;
  host.app.get<ui::DataSetState>().wants_focus = true;
  ui::remember_recent(host.app.get<ui::FilesState>().recent, read.folder);
}

void carry_out(const ui::OpenEpisode& episode, Host& host) {
  host.app.get<ui::FilesState>().layout_without_mesh.clear();
  host.document.open(EpisodeChoice{episode.folder, episode.episode});
}

}  // namespace taxel::studio
