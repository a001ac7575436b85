// The window on a display, made by GLFW.
#include <epoxy/gl.h>
// GLFW must not include another OpenGL header in addition to epoxy's.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "app/studio/shell/window/keyboard.h"
#include "app/studio/shell/window/window.h"
#include "core/base/error.h"
#include "ui/gl/offscreen_context.h"

namespace taxel::studio {

namespace {

std::string glfw_reason() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "unknown reason";
}

/// Calls of glfwInit and glfwTerminate, bound to the lifetime of an object.
struct Library {
  Library() {
    if (glfwInit() == GLFW_FALSE)
      throw Error("cannot open a window: " + glfw_reason() + "; --headless needs no display");
  }
  ~Library() { glfwTerminate(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

/// Asks for a core context of at least this version, for the next window. Major version 1 asks for any context.
void request_version(int major, int minor) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
  const bool core = major >= 3;
  glfwWindowHint(GLFW_OPENGL_PROFILE, core ? GLFW_OPENGL_CORE_PROFILE : GLFW_OPENGL_ANY_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, core ? GLFW_TRUE : GLFW_FALSE);  // macOS has no other core contexts
}

/// Returns the version that a display offers if it is too old for the program.
std::string offered_version() {
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  for (const int major : {3, 1}) {
    request_version(major, major == 3 ? 2 : 0);
    GLFWwindow* window = glfwCreateWindow(16, 16, "", nullptr, nullptr);
    if (window == nullptr) continue;
    glfwMakeContextCurrent(window);
    std::string text = gl::offered_text(reinterpret_cast<const char*>(glGetString(GL_VERSION)),
                                        reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    glfwDestroyWindow(window);
    return text;
  }
  return gl::offered_text(nullptr, nullptr);
}

void push_modifiers(int mods, std::vector<InputEvent>& events) {
  events.push_back(KeyPress{static_cast<ImGuiKey>(ImGuiMod_Ctrl), (mods & GLFW_MOD_CONTROL) != 0});
  events.push_back(KeyPress{static_cast<ImGuiKey>(ImGuiMod_Shift), (mods & GLFW_MOD_SHIFT) != 0});
  events.push_back(KeyPress{static_cast<ImGuiKey>(ImGuiMod_Alt), (mods & GLFW_MOD_ALT) != 0});
  events.push_back(KeyPress{static_cast<ImGuiKey>(ImGuiMod_Super), (mods & GLFW_MOD_SUPER) != 0});
}

/// Returns the modifiers after a key event. GLFW reports the modifiers from before the key changed them.
int mods_after(int key, int action, int mods) {
  const auto with = [&](int bit) { return action == GLFW_RELEASE ? mods & ~bit : mods | bit; };
  switch (key) {
    case GLFW_KEY_LEFT_CONTROL:
    case GLFW_KEY_RIGHT_CONTROL:
      return with(GLFW_MOD_CONTROL);
    case GLFW_KEY_LEFT_SHIFT:
    case GLFW_KEY_RIGHT_SHIFT:
      return with(GLFW_MOD_SHIFT);
    case GLFW_KEY_LEFT_ALT:
    case GLFW_KEY_RIGHT_ALT:
      return with(GLFW_MOD_ALT);
    default:
      return mods;
  }
}

ui::WindowPlace present_place(GLFWwindow* window) {
  ui::WindowPlace place;
  glfwGetWindowPos(window, &place.x, &place.y);
  glfwGetWindowSize(window, &place.width, &place.height);
  return place;
}

class GlfwWindow final : public Window {
 public:
  GlfwWindow(int width, int height, const std::string& title) {
    request_version(gl::kMajor, gl::kMinor);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);  // the 3-D view has its own; a software renderer fills rectangles faster
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (window_ == nullptr) {
      const std::string reason = glfw_reason();
      throw Error(
          fmt::format("a window needs OpenGL {}.{}, but {}; install a newer graphics driver, or set "
                      "LIBGL_ALWAYS_SOFTWARE=1 to draw with Mesa's software renderer ({})",
                      gl::kMajor, gl::kMinor, offered_version(), reason));
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(window_, this);
    glfwGetFramebufferSize(window_, &width_, &height_);
    set_callbacks();
    read_labels();
  }
  ~GlfwWindow() override {
    for (const auto& [shape, cursor] : cursors_) glfwDestroyCursor(cursor);
    glfwDestroyWindow(window_);
  }
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  std::vector<InputEvent> take_events(double seconds) override {
    seconds > 0 ? glfwWaitEventsTimeout(seconds) : glfwPollEvents();
    read_labels();
    std::vector<InputEvent> events;
    events.swap(events_);
    return events;
  }
  [[nodiscard]] int width() const override { return width_; }
  [[nodiscard]] int height() const override { return height_; }
  [[nodiscard]] float content_scale() const override {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return x;
  }
  [[nodiscard]] ui::KeyNames key_names() const override { return keyboard_.names(); }
  void resize(int width, int height) override {
    glfwSetWindowSize(window_, width, height);
    glfwPollEvents();
    glfwGetFramebufferSize(window_, &width_, &height_);
  }
  void set_place(const ui::WindowPlace& kept) override;
  [[nodiscard]] std::optional<ui::WindowPlace> place() const override;
  void begin_picture(const ImVec4& background) override {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width_, height_);
    glClearColor(background.x, background.y, background.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  [[nodiscard]] gl::RgbImage read() const override { return gl::read_pixels(0, width_, height_); }
  void show() override { glfwSwapBuffers(window_); }
  void wake() override { glfwPostEmptyEvent(); }
  void set_title(const std::string& title) override { glfwSetWindowTitle(window_, title.c_str()); }
  void set_full_screen(bool on) override;
  void set_cursor(ImGuiMouseCursor shape) override;
  void set_clipboard(const std::string& text) override { glfwSetClipboardString(window_, text.c_str()); }
  [[nodiscard]] const std::string& clipboard() override {
    const char* text = glfwGetClipboardString(window_);
    clipboard_ = text != nullptr ? text : "";
    return clipboard_;
  }

 private:
  static GlfwWindow& of(GLFWwindow* window) { return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window)); }
  void push(InputEvent event) { events_.push_back(std::move(event)); }
  void set_callbacks();
  void set_mouse_callbacks();
  void read_labels();
  void take_key(int key, int action, int mods);

  Library library_;
  GLFWwindow* window_ = nullptr;
  int width_ = 0, height_ = 0;
  std::vector<InputEvent> events_;
  Keyboard keyboard_;
  std::map<int, GLFWcursor*> cursors_;  ///< cursors by GLFW's shape
  std::string clipboard_;
  std::optional<ui::WindowPlace> windowed_;  ///< place of the window before it filled the screen
  ui::WindowPlace restored_;                 ///< kept place of a window that is maximized
};

/// Returns the monitor that shows most of a window, or null if there is none.
GLFWmonitor* monitor_of(GLFWwindow* window) {
  int x = 0, y = 0, width = 0, height = 0, count = 0;
  glfwGetWindowPos(window, &x, &y);
  glfwGetWindowSize(window, &width, &height);
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  GLFWmonitor* best = nullptr;
  long most = -1;
  for (int i = 0; i < count; ++i) {
    const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
    int left = 0, top = 0;
    glfwGetMonitorPos(monitors[i], &left, &top);
    if (mode == nullptr) continue;
    const long wide = std::max(0, std::min(x + width, left + mode->width) - std::max(x, left));
    const long high = std::max(0, std::min(y + height, top + mode->height) - std::max(y, top));
    if (wide * high > most) most = wide * high, best = monitors[i];
  }
  return best;
}

void GlfwWindow::set_full_screen(bool on) {
  if (on == windowed_.has_value()) return;
  if (!on) {
    const ui::WindowPlace& p = *windowed_;
    glfwSetWindowMonitor(window_, nullptr, p.x, p.y, p.width, p.height, GLFW_DONT_CARE);
    windowed_.reset();
    return;
  }
  GLFWmonitor* monitor = monitor_of(window_);
  const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  if (mode == nullptr) return;
  windowed_ = present_place(window_);
  glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void GlfwWindow::set_place(const ui::WindowPlace& kept) {
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  std::vector<ui::WindowPlace> screens(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < screens.size(); ++i)
    glfwGetMonitorWorkarea(monitors[i], &screens[i].x, &screens[i].y, &screens[i].width, &screens[i].height);
  const ui::WindowPlace place = ui::visible_place(kept, screens);
  if (place.width == 0) return;
  restored_ = place;
  glfwSetWindowPos(window_, place.x, place.y);
  glfwSetWindowSize(window_, place.width, place.height);
  if (place.maximized) glfwMaximizeWindow(window_);
  glfwPollEvents();
  glfwGetFramebufferSize(window_, &width_, &height_);
}

std::optional<ui::WindowPlace> GlfwWindow::place() const {
  const bool maximized = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) == GLFW_TRUE;
  ui::WindowPlace place = windowed_                          ? *windowed_
                          : maximized && restored_.width > 0 ? restored_
                                                             : present_place(window_);
  place.maximized = maximized && !windowed_;
  return place;
}

void GlfwWindow::set_mouse_callbacks() {
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
    int width = 1, height = 1;
    glfwGetWindowSize(w, &width, &height);
    GlfwWindow& self = of(w);  // screen coordinates may be coarser than pixels
    self.push(MouseMove{static_cast<float>(x * self.width_ / std::max(1, width)),
                        static_cast<float>(y * self.height_ / std::max(1, height))});
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int mods) {
    push_modifiers(mods, of(w).events_);
    if (button <= GLFW_MOUSE_BUTTON_MIDDLE) of(w).push(MouseButton{button, action == GLFW_PRESS});
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) {
    of(w).push(MouseWheel{static_cast<float>(x), static_cast<float>(y)});
  });
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    of(w).push(DropFiles{std::vector<std::string>(paths, paths + count)});
  });
}

/// Asks GLFW for the labels of the present layout, which takes 6 us. GLFW reports no change of the layout. Xlib follows
/// changes after the first of these calls.
void GlfwWindow::read_labels() {
  KeyLabels labels;
  visit_labelled_keys([&](int key) {
    const char* label = glfwGetKeyScancode(key) >= 0 ? glfwGetKeyName(key, 0) : nullptr;
    if (label != nullptr) labels[key] = label;
  });
  if (keyboard_.set_labels(std::move(labels))) push(RenameKeys{});
}

/// Reads the labels at each press: between two frames the layout may change and the first key of the new one be
/// pressed.
void GlfwWindow::take_key(int key, int action, int mods) {
  push_modifiers(mods_after(key, action, mods), events_);
  if (action == GLFW_REPEAT) return;
  if (action == GLFW_PRESS) read_labels();
  const ImGuiKey imgui_key = action == GLFW_PRESS ? keyboard_.press(key) : keyboard_.release(key);
  if (imgui_key != ImGuiKey_None) push(KeyPress{imgui_key, action == GLFW_PRESS});
}

void GlfwWindow::set_callbacks() {
  set_mouse_callbacks();
  glfwSetKeyCallback(window_,
                     [](GLFWwindow* w, int key, int, int action, int mods) { of(w).take_key(key, action, mods); });
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned codepoint) { of(w).push(TextInput{codepoint}); });
  glfwSetWindowFocusCallback(window_,
                             [](GLFWwindow* w, int focused) { of(w).push(FocusChange{focused == GLFW_TRUE}); });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int width, int height) {
    GlfwWindow& self = of(w);
    self.width_ = width;
    self.height_ = height;
    self.push(ResizeWindow{width, height});
  });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { of(w).push(ResizeWindow{of(w).width_, of(w).height_}); });
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) {
    glfwSetWindowShouldClose(w, GLFW_FALSE);  // the program decides
    of(w).push(CloseWindow{});
  });
}

void GlfwWindow::set_cursor(ImGuiMouseCursor shape) {
  const auto glfw_shape = [&] {
    switch (shape) {
      case ImGuiMouseCursor_TextInput:
        return GLFW_IBEAM_CURSOR;
      case ImGuiMouseCursor_ResizeNS:
        return GLFW_VRESIZE_CURSOR;
      case ImGuiMouseCursor_ResizeEW:
        return GLFW_HRESIZE_CURSOR;
      case ImGuiMouseCursor_Hand:
        return GLFW_HAND_CURSOR;
      default:
        return GLFW_ARROW_CURSOR;
    }
  }();
  GLFWcursor*& cursor = cursors_[glfw_shape];
  if (cursor == nullptr) cursor = glfwCreateStandardCursor(glfw_shape);
  glfwSetCursor(window_, cursor);
}

}  // namespace

std::unique_ptr<Window> make_glfw_window(int width, int height, const std::string& title) {
  return std::make_unique<GlfwWindow>(width, height, title);
}

}  // namespace taxel::studio
