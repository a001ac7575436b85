// Notices and questions about files in the state of the window.
#include <nlohmann/json.hpp>

#include "app/studio/frame/app.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/files_state.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_files(const App& app, nlohmann::ordered_json& state) {
  state["recovery"] = app.get<FilesState>().recovery.name;
  const FileDialog& dialog = app.get<FileDialog>();
  Json entries = Json::array(), places = Json::array();
  for (const FolderEntry& entry : dialog.entries)
    entries.push_back({{"name", entry.name}, {"folder", entry.folder}, {"bytes", entry.bytes}});
  for (const DialogPlace& place : dialog.places) places.push_back({{"label", place.label}, {"folder", place.folder}});
  state["file_dialog"] = {{"open", dialog.open},
                          {"folder", dialog.folder},
                          {"path", dialog.path},
                          {"error", dialog.error},
                          {"places", std::move(places)},
                          {"entries", std::move(entries)},
                          {"completion", completion(dialog, dialog.path)}};
  state["notices"] = Json::array();
  for (const FileNotice& notice : app.get<FilesState>().notices)
    state["notices"].push_back({{"file", notice.file}, {"text", notice.text}, {"offers", notice.offers.size()}});
}

}  // namespace taxel::ui
