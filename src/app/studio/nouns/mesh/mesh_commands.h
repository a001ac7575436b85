// Commands about the mesh under the taxels: its unit and its samples.
#pragma once

#include "app/studio/frame/command.h"

namespace taxel::ui {

struct SetMeshUnit {
  double metres = 1;  ///< length of one unit of the mesh file
};
struct PolishSamples {};  ///< polishes the document's samples if a preview's are shown

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::SetMeshUnit& command, Host& host);
void carry_out(const ui::PolishSamples& command, Host& host);

}  // namespace taxel::studio
