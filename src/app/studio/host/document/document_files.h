// The files around the open document: changes by other programs, and files to recover.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/studio/host/document/autosave.h"
#include "app/studio/host/document/file_watch.h"
#include "app/studio/host/document/mesh_comparison.h"
#include "core/sim/host/recording_journal.h"

namespace taxel::studio {

struct DocumentFiles {
  /// `folder` is that of the files that are left for the next start.
  DocumentFiles(JobExecutor& executor, std::filesystem::path folder, double autosave_every)
      : kept_in(std::move(folder)), autosave(executor, autosave_every), comparison(executor) {}

  std::filesystem::path kept_in;
  Autosave autosave;
  FileWatch watch;
  std::string hash;                          ///< hash of the document's file, as it was read or written
  MeshComparison comparison;                 ///< with the mesh that replaced the document's
  std::optional<ComparedMesh> offered_mesh;  ///< mesh that a notice offers
  std::vector<LostDocument> lost;            ///< documents to be offered, the first one now
  std::vector<LeftRecording> recordings;     ///< recordings to be offered after the documents
};

}  // namespace taxel::studio
