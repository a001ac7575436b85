// GLFW's key numbers as ImGui's.
#pragma once

#include <imgui.h>

namespace taxel::studio {
ImGuiKey imgui_key(int glfw_key);  ///< None: a key that ImGui does not know
}  // namespace taxel::studio
