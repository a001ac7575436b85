// The interface's font: DejaVu Sans, which is part of the program.
#pragma once

namespace taxel::studio {
/// Loads the font into the current ImGui context, which keeps a pointer to the program's own copy.
void load_fonts();
}  // namespace taxel::studio
