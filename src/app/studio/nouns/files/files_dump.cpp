// Notices and questions about files in the state of the window.
#include <nlohmann/json.hpp>

#include "app/studio/frame/app.h"
#include "app/studio/nouns/files/files_state.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_files(const App& app, nlohmann::ordered_json& state) {
  state["recovery"] = app.get<FilesState>().recovery.name;
  state["notices"] = Json::array();
  for (const FileNotice& notice : app.get<FilesState>().notices)
    state["notices"].push_back({{"file", notice.file}, {"text", notice.text}, {"offers", notice.offers.size()}});
}

}  // namespace taxel::ui
