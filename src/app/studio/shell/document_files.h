// The files around the open document: changes by other programs, files to write or to recover, and the dialog for them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/studio/frame/command.h"
#include "app/studio/host/document/autosave.h"
#include "app/studio/host/document/file_watch.h"
#include "app/studio/host/document/mesh_comparison.h"
#include "app/studio/nouns/files/desktop_dialog.h"
#include "core/sim/host/recording_journal.h"

namespace taxel::studio {

struct DocumentFiles {
  DocumentFiles(JobExecutor& executor, double autosave_every)
      : autosave(executor, autosave_every), comparison(executor) {}

  Autosave autosave;
  FileWatch watch;
  std::string hash;                              ///< hash of the document's file, as it was read or written
  MeshComparison comparison;                     ///< with the mesh that replaced the document's
  std::optional<ComparedMesh> offered_mesh;      ///< mesh that a notice offers
  std::string layout_without_mesh;               ///< layout file that waits for its mesh, or empty
  std::vector<LostDocument> lost;                ///< documents to be offered, the first one now
  std::vector<LeftRecording> recordings;         ///< recordings to be offered after the documents
  std::optional<ui::ExportFile> pending_export;  ///< export that waits for polished samples
  ui::DesktopDialog desktop_dialog{os::make_file_chooser()};
};

}  // namespace taxel::studio
