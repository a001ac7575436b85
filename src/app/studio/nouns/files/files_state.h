// Questions and notices about files: open files that other programs changed, unsaved work, recovery, examples and
// recent files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/frame/command.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/files/file_dialog_state.h"

namespace taxel::ui {

/// Remedies for an open file that another program has changed.
enum class FileOffer {
  reload,        ///< read the document again, as an edit
  use_mesh,      ///< the mesh of the file as it is now
  project_back,  ///< use the mesh, and bring the taxels back to its surface
  locate         ///< choose the file of a missing mesh
};

/// An open file has changed on disk. The notice is displayed until the user answers it.
struct FileNotice {
  std::string file;
  std::string text;
  std::vector<FileOffer> offers;  ///< remedies, in addition to leaving everything as it is
};

/// A document that was lost unsaved and can be recovered.
struct Recovery {
  std::string name;    ///< name of the document; empty if there is none
  std::string detail;  ///< when and where the document was lost
};

/// An example on the card that invites to open something.
struct ExampleTile {
  std::string label, tip;
  std::string name;           ///< for OpenExample
  std::uint64_t picture = 0;  ///< texture
  float aspect = 1.6f;        ///< width of the picture divided by its height
};

struct FilesState {
  std::vector<FileNotice> notices;  ///< oldest first
  Recovery recovery;
  std::vector<ExampleTile> examples;      ///< examples with a picture, for the start card
  std::vector<std::string> recent;        ///< recently opened files, newest first; kept in the settings file
  bool asks_unsaved = false;              ///< whether the window asks to save before the document is left
  std::optional<Command> held;            ///< command that waits until unsaved edits are saved or discarded
  bool discards_edits = false;            ///< the user agreed to lose the unsaved edits
  std::string layout_without_mesh;        ///< layout file that waits for its mesh, or empty
  std::optional<Command> pending_export;  ///< an ExportFile that waits for polished samples
};

/// Makes a file the first one in the list of recent files.
inline void remember_recent(std::vector<std::string>& recent, const std::string& file) {
  constexpr std::size_t kMostRecent = 8;
  std::erase(recent, file);
  recent.insert(recent.begin(), file);
  if (recent.size() > kMostRecent) recent.resize(kMostRecent);
}

/// Draws the card in the middle of the view while nothing is open: an invitation, pictures of the examples, recent
/// files, and a line about the tour if `shows_tour`. A click on a picture opens its example.
void draw_start_card(WindowUi& ui, const ViewPlace& place, const std::vector<ExampleTile>& examples, FileDialog& dialog,
                     const std::vector<std::string>& recent, bool shows_tour);

/// Draws a card about a load or a scene that is being built.
void draw_loading(WindowUi& ui, const ViewPlace& place, const DocumentView& document);
/// Notices, dialogs and questions about files.
extern const Feature kFiles;
/// Sets "recovery", "notices" and "file_dialog".
void dump_files(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
