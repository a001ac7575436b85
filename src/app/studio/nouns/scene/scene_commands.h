// Commands about the layouts on a scene, and its file.
#pragma once

#include <string>
#include <vector>

#include "app/studio/frame/command.h"

namespace taxel::ui {

/// Attaches a layout to geoms of the open scene and compiles the scene again; its file stays as it is. An empty path
/// asks for the layout.
struct AttachLayout {
  std::vector<std::string> geoms;
  std::string path;
};
struct DetachLayout {
  std::string geom;
};

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::AttachLayout& command, Host& host);
void carry_out(const ui::DetachLayout& command, Host& host);

}  // namespace taxel::studio
