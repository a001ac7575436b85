// The version of OpenGL that the program asks for, and a core context of it without a window or a display: Mesa's
// surfaceless platform, or otherwise an EGL device.
#pragma once

#include <memory>
#include <string>

namespace taxel::gl {

/// The oldest version that draws everything. macOS offers no later one, and virtual machines and remote desktops often
/// do not.
inline constexpr int kMajor = 4, kMinor = 1;

/// Returns a sentence about the version and the renderer that a driver offers instead, such as "this machine offers
/// 3.3 from llvmpipe". `version` and `renderer` are GL_VERSION and GL_RENDERER, or null if there is no context at all.
std::string offered_text(const char* version, const char* renderer);

class OffscreenContext {
 public:
  /// Creates the context and makes it current on this thread. Throws Error that names the missing part.
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  void make_current() const;                   ///< makes the context current on this thread; throws Error if it fails
  [[nodiscard]] std::string renderer() const;  ///< GL_RENDERER, for messages

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Returns true if the current context draws on the CPU (llvmpipe, softpipe, SwiftShader).
bool software_renderer();

}  // namespace taxel::gl
