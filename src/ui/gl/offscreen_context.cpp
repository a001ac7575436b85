#include "ui/gl/offscreen_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <array>
#include <string_view>

#include "core/base/error.h"

namespace taxel::gl {

std::string offered_text(const char* version, const char* renderer) {
  if (version == nullptr || *version == '\0') return "this machine offers no OpenGL at all";
  const std::string_view text(version);
  const std::string_view number = text.substr(0, text.find(' '));
  return fmt::format("this machine offers {} from {}", number, renderer != nullptr ? renderer : "an unknown renderer");
}

namespace {

/// Returns the display of Mesa's surfaceless platform, or EGL_NO_DISPLAY.
EGLDisplay surfaceless_display() {
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) return EGL_NO_DISPLAY;
  return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

/// Returns the display of the first EGL device that works. NVIDIA's driver draws offscreen in this way.
EGLDisplay device_display() {
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) return EGL_NO_DISPLAY;
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (!eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count)) return EGL_NO_DISPLAY;
  for (EGLint i = 0; i < count; ++i) {
    const EGLDisplay display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)], nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
  }
  return EGL_NO_DISPLAY;
}

/// Creates a core context of at least this version. Major version 0 asks for no version, and no profile.
EGLContext create_context(EGLDisplay display, int major, int minor) {
  constexpr std::array<EGLint, 5> config_wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
  const std::array<EGLint, 7> context_wanted{major > 0 ? EGL_CONTEXT_MAJOR_VERSION : EGL_NONE,
                                             major,
                                             EGL_CONTEXT_MINOR_VERSION,
                                             minor,
                                             EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                             EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                             EGL_NONE};
  EGLConfig config = nullptr;
  EGLint configs = 0;
  if (!eglBindAPI(EGL_OPENGL_API)) return EGL_NO_CONTEXT;
  if (!eglChooseConfig(display, config_wanted.data(), &config, 1, &configs) || configs < 1) return EGL_NO_CONTEXT;
  return eglCreateContext(display, config, EGL_NO_CONTEXT, context_wanted.data());
}

/// Returns the version that a display offers if it is too old for the program.
std::string offered_by(EGLDisplay display) {
  for (const int major : {3, 0}) {
    const EGLContext context = create_context(display, major, 2);
    if (context == EGL_NO_CONTEXT) continue;
    std::string text;
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
      text = offered_text(reinterpret_cast<const char*>(glGetString(GL_VERSION)),
                          reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(display, context);
    if (!text.empty()) return text;
  }
  return offered_text(nullptr, nullptr);
}

}  // namespace

struct OffscreenContext::Impl {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  ~Impl() {
    if (context == EGL_NO_CONTEXT) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);  // the display is not terminated, because others may use it
  }
};

OffscreenContext::OffscreenContext() : impl_(std::make_unique<Impl>()) {
  std::string offered = "EGL offers neither a surfaceless platform nor a device";
  impl_->display = surfaceless_display();
  if (impl_->display != EGL_NO_DISPLAY && eglInitialize(impl_->display, nullptr, nullptr)) {
    impl_->context = create_context(impl_->display, kMajor, kMinor);
    if (impl_->context == EGL_NO_CONTEXT) offered = offered_by(impl_->display);
  }
  if (impl_->context == EGL_NO_CONTEXT) {
    impl_->display = device_display();
    if (impl_->display != EGL_NO_DISPLAY) impl_->context = create_context(impl_->display, kMajor, kMinor);
  }
  if (impl_->context == EGL_NO_CONTEXT) {
    throw Error(
        fmt::format("drawing without a display needs OpenGL {}.{}, but {}; install Mesa's EGL (libegl-mesa0, "
                    "libgl1-mesa-dri)",
                    kMajor, kMinor, offered));
  }
  make_current();
}

OffscreenContext::~OffscreenContext() = default;

void OffscreenContext::make_current() const {
  if (!eglMakeCurrent(impl_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, impl_->context)) {
    throw Error(fmt::format("cannot make the OpenGL context current (EGL error 0x{:x})", eglGetError()));
  }
}

std::string OffscreenContext::renderer() const {
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return name != nullptr ? name : "";
}

bool software_renderer() {
  const auto* text = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string name = text != nullptr ? text : "";
  for (const char* software : {"llvmpipe", "softpipe", "SwiftShader", "Software"}) {
    if (name.find(software) != std::string::npos) return true;
  }
  return false;
}

}  // namespace taxel::gl
