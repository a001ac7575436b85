// The interface's font: DejaVu Sans where it is installed, ImGui's own otherwise.
#pragma once

namespace taxel::studio {
/// Into the current ImGui context. True when DejaVu Sans was found.
bool load_fonts();
}  // namespace taxel::studio
