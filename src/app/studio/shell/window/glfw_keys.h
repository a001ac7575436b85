// Converts GLFW's key numbers to ImGui's, by the place of a key on a US keyboard.
#pragma once

#include <imgui.h>

namespace taxel::studio {
ImGuiKey imgui_key(int glfw_key);  ///< ImGuiKey_None if ImGui does not know the key
}  // namespace taxel::studio
