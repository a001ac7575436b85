// Commands about the files of studies.
#pragma once

#include <string>

#include "app/studio/frame/command.h"

namespace taxel::ui {

/// Writes the displayed study as a data set. An empty path asks for the folder.
struct SaveStudy {
  std::string path = {};
  bool operator==(const SaveStudy&) const = default;
};
/// Shows the runs of a data set in the panel of studies. An empty path asks for its meta/info.json.
struct OpenStudy {
  std::string path = {};
  bool operator==(const OpenStudy&) const = default;
};

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::SaveStudy& command, Host& host);
void carry_out(const ui::OpenStudy& command, Host& host);

}  // namespace taxel::studio
