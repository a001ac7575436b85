// Notices about open files that other programs changed, and questions about unsaved work.
#pragma once

#include <string>
#include <vector>

#include "app/studio/app/command.h"

namespace taxel::ui {

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

}  // namespace taxel::ui
