// Where pictures appear and input comes from: a real window (GLFW) or an offscreen picture (EGL). The same loop runs on
// both.
#pragma once

#include <imgui.h>

#include <memory>
#include <string>
#include <vector>

#include "app/studio/shell/window/input_event.h"
#include "ui/gl/framebuffer.h"

namespace taxel::studio {

class Window {
 public:
  Window() = default;
  virtual ~Window() = default;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Events since the last call; waits up to `seconds` for the first one.
  virtual std::vector<InputEvent> take_events(double seconds) = 0;
  [[nodiscard]] virtual int width() const = 0;   ///< [pixels]
  [[nodiscard]] virtual int height() const = 0;  ///< [pixels]
  [[nodiscard]] virtual float content_scale() const {
    return 1.0f;
  }  ///< what the screen asks texts to be multiplied with
  virtual void resize(int width, int height) = 0;
  virtual void begin_picture(const ImVec4& background) = 0;  ///< binds what is drawn into and fills it
  [[nodiscard]] virtual gl::RgbImage read() const = 0;       ///< the picture drawn, before show()
  virtual void show() = 0;
  virtual void wake() {}  ///< ends a wait in take_events(); from any thread
  virtual void set_title(const std::string& title) = 0;
  virtual void set_full_screen(bool /*on*/) {}  ///< and back to where it was; nothing where it is so already
  virtual void set_cursor(ImGuiMouseCursor cursor) = 0;
  virtual void set_clipboard(const std::string& text) = 0;
  [[nodiscard]] virtual const std::string& clipboard() = 0;
};

/// Needs a display. Throws Error that says what is missing.
std::unique_ptr<Window> make_glfw_window(int width, int height, const std::string& title);
/// Needs no display. Throws Error that says what is missing.
std::unique_ptr<Window> make_offscreen_window(int width, int height);

}  // namespace taxel::studio
