// An OpenGL core context (see version.h) without a window or a display: Mesa's surfaceless platform, or otherwise an
// EGL device.
#pragma once

#include <memory>
#include <string>

namespace taxel::gl {

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
