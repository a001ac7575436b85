// The version of OpenGL that the program asks for, and the message if a driver has less.
#pragma once

#include <string>

namespace taxel::gl {

/// The oldest version that draws everything. macOS offers no later one, and virtual machines and remote desktops often
/// do not.
inline constexpr int kMajor = 4, kMinor = 1;

/// Returns a sentence about the version and the renderer that a driver offers instead, such as "this machine offers
/// 3.3 from llvmpipe". `version` and `renderer` are GL_VERSION and GL_RENDERER, or null if there is no context at all.
std::string offered_text(const char* version, const char* renderer);

}  // namespace taxel::gl
