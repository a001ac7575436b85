// Window that displays frames and delivers input: a real window (GLFW) or an offscreen image (EGL), on which the same
// loop runs; and the contexts of ImGui that draw into it.
#pragma once

#include <imgui.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/frame/keymap.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/shell/window/input_event.h"
#include "core/base/os/fonts.h"
#include "ui/gl/framebuffer.h"

namespace taxel::studio {

class Window {
 public:
  Window() = default;
  virtual ~Window() = default;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Returns the events since the last call. Waits up to `seconds` for the first one.
  virtual std::vector<InputEvent> take_events(double seconds) = 0;
  [[nodiscard]] virtual int width() const = 0;   ///< [pixels]
  [[nodiscard]] virtual int height() const = 0;  ///< [pixels]
  /// Returns the screen's scale factor for texts.
  [[nodiscard]] virtual float content_scale() const { return 1.0f; }
  /// Returns the names of keys in the present layout of the keyboard. Offscreen, keys have their names on a US
  /// keyboard.
  [[nodiscard]] virtual ui::KeyNames key_names() const { return {}; }
  virtual void resize(int width, int height) = 0;
  /// Moves the window to a kept place, if a screen shows it there. Does nothing offscreen.
  virtual void set_place(const ui::WindowPlace& /*place*/) {}
  /// Returns the place of the window when it does not fill the screen. Empty offscreen.
  [[nodiscard]] virtual std::optional<ui::WindowPlace> place() const { return std::nullopt; }
  virtual void begin_picture(const ImVec4& background) = 0;  ///< binds the framebuffer and fills it
  [[nodiscard]] virtual gl::RgbImage read() const = 0;       ///< returns the drawn frame, before show()
  virtual void show() = 0;
  virtual void wake() {}  ///< ends a wait in take_events(); may be called from any thread
  virtual void set_title(const std::string& title) = 0;
  /// Fills the screen, or restores the former place. Does nothing if the window is in that state already.
  virtual void set_full_screen(bool /*on*/) {}
  virtual void set_cursor(ImGuiMouseCursor cursor) = 0;
  virtual void set_clipboard(const std::string& text) = 0;
  [[nodiscard]] virtual const std::string& clipboard() = 0;
};

/// Creates a window on a display. Throws Error that names the missing part.
std::unique_ptr<Window> make_glfw_window(int width, int height, const std::string& title);
/// Creates an offscreen window, which needs no display. Throws Error that names the missing part.
std::unique_ptr<Window> make_offscreen_window(int width, int height);

/// Contexts of ImGui, ImPlot and their OpenGL backend, which are created and destroyed together.
class InterfaceContext {
 public:
  explicit InterfaceContext(Window& window);
  ~InterfaceContext();
  InterfaceContext(const InterfaceContext&) = delete;
  InterfaceContext& operator=(const InterfaceContext&) = delete;
};

/// Loads the interface's font into the current ImGui context, which keeps a pointer to the program's own copy: DejaVu
/// Sans, which is part of the program.
void load_fonts();

/// Returns the fonts of the system for Chinese, Japanese and Korean, as far as there are some.
[[nodiscard]] std::vector<os::FontFile> fonts_of_other_scripts();
/// Adds fonts to the interface's font, for characters that it does not have. A file that is no font is left out.
void add_fonts(const std::vector<os::FontFile>& fonts);

}  // namespace taxel::studio
