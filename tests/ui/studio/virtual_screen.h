// A virtual screen with a keyboard: the X server Xvfb, layouts by setxkbmap, and keys by place through the extension
// XTEST.
#pragma once

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/base/os/process.h"
#include "fixtures/run_program.h"

namespace taxel::test {

/// Asks every 10 ms, for some seconds at most, whether a condition holds. Returns whether it held in time.
inline bool holds_within(double seconds, const std::function<bool()>& condition) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  for (; !condition(); ::poll(nullptr, 0, 10))
    if (Clock::now() > end) return false;
  return true;
}

/// Functions of the libraries of X, which are loaded when a test runs: their headers define words such as None and
/// Bool.
class XLibrary {
 public:
  static constexpr const char* kName = "libXtst.so.6";

  XLibrary() : library_(::dlopen(kName, RTLD_NOW)) {}  // it is linked to libX11
  [[nodiscard]] bool is_there() const { return library_ != nullptr; }
  template <class Function>
  [[nodiscard]] Function* function(const char* name) const {
    void* found = ::dlsym(library_, name);
    if (found == nullptr) throw std::runtime_error(name);
    return reinterpret_cast<Function*>(found);
  }

 private:
  void* library_;
};

class VirtualScreen {
 public:
  using Display = void;
  using Xid = unsigned long;

  /// Returns the name of a program or library that is not installed, or an empty text.
  static std::string missing() {
    for (const std::string program : {"Xvfb", "setxkbmap"})
      if (std::system(("command -v " + program + " > /dev/null 2>&1").c_str()) != 0) return program;
    return XLibrary().is_there() ? "" : XLibrary::kName;
  }

  /// Starts the server, which writes its messages into `folder`.
  explicit VirtualScreen(const std::filesystem::path& folder, int width = 1400, int height = 900)
      : width_(width), height_(height) {
    const std::filesystem::path number = folder / "display";
    if (!server_.start({"Xvfb", "-displayfd", "1", "-screen", "0",
                        std::to_string(width) + "x" + std::to_string(height) + "x24", "-nolisten", "tcp", "-noreset"},
                       folder / "server", number))
      throw std::runtime_error("Xvfb does not start");
    if (!holds_within(30, [&] { return file_text(number).ends_with("\n"); }))
      throw std::runtime_error("Xvfb: " + file_text(folder / "server"));
    name_ = ":" + file_text(number);
    name_.pop_back();
    x_.function<void*(int (*)(Display*, void*))>("XSetErrorHandler")([](Display*, void*) { return 0; });
    display_ = x_.function<Display*(const char*)>("XOpenDisplay")(name_.c_str());
    if (display_ == nullptr) throw std::runtime_error("no connection to " + name_);
  }
  ~VirtualScreen() {
    if (display_ != nullptr) x_.function<int(Display*)>("XCloseDisplay")(display_);
  }
  VirtualScreen(const VirtualScreen&) = delete;
  VirtualScreen& operator=(const VirtualScreen&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }

  /// Changes the layout of the keyboard by arguments of setxkbmap.
  void set_layout(const std::string& layout) const {
    if (std::system(("setxkbmap -display " + name_ + " " + layout).c_str()) != 0)
      throw std::runtime_error("setxkbmap " + layout);
  }

  static constexpr unsigned kControl = 37, kShift = 50, kRightShift = 62, kDelete = 119;
  /// Returns the number that X has for the key at the place of a character on a US keyboard.
  static unsigned code_of(char place) {
    constexpr unsigned kFirst = 10;  // of the key 1
    constexpr std::string_view kPlaces = "1234567890-=  qwertyuiop[]  asdfghjkl;'` \\zxcvbnm,./";
    return kFirst + static_cast<unsigned>(kPlaces.find(place));
  }
  void turn_key(unsigned code, bool is_down) const {
    x_.function<int(Display*, unsigned, int, unsigned long)>("XTestFakeKeyEvent")(display_, code, is_down ? 1 : 0, 0);
    x_.function<int(Display*, int)>("XSync")(display_, 0);
  }
  /// Presses and releases a key, while the keys before it are down.
  void press(std::initializer_list<unsigned> codes) const {
    for (const unsigned code : codes) turn_key(code, true);
    for (auto code = std::rbegin(codes); code != std::rend(codes); ++code) turn_key(*code, false);
  }

  /// Returns the pixels of the screen, four bytes each, row by row.
  [[nodiscard]] std::string picture() const {
    struct Image {  // the first members of Xlib's XImage
      int width, height, offset, format;
      char* data;
      int order[5], depth, bytes_per_line;
    };
    const Xid screen = x_.function<Xid(Display*)>("XDefaultRootWindow")(display_);
    const auto get = x_.function<Image*(Display*, Xid, int, int, unsigned, unsigned, unsigned long, int)>("XGetImage");
    constexpr int kWholePixels = 2;  // ZPixmap
    Image* image =
        get(display_, screen, 0, 0, static_cast<unsigned>(width_), static_cast<unsigned>(height_), ~0UL, kWholePixels);
    if (image == nullptr) throw std::runtime_error("no picture of the screen");
    std::string pixels(image->data, static_cast<std::size_t>(image->height) * static_cast<std::size_t>(4 * width_));
    x_.function<int(void*)>("XFree")(image->data);
    x_.function<int(void*)>("XFree")(image);
    return pixels;
  }

  /// Returns the title of the first window that has one, or an empty text.
  [[nodiscard]] std::string title() const {
    Xid root = 0, parent = 0, *windows = nullptr;
    unsigned count = 0;
    const Xid screen = x_.function<Xid(Display*)>("XDefaultRootWindow")(display_);
    const auto query = x_.function<int(Display*, Xid, Xid*, Xid*, Xid**, unsigned*)>("XQueryTree");
    if (query(display_, screen, &root, &parent, &windows, &count) == 0) return {};
    std::string title;
    for (unsigned i = 0; i < count && title.empty(); ++i) {
      char* text = nullptr;
      if (x_.function<int(Display*, Xid, char**)>("XFetchName")(display_, windows[i], &text) != 0 && text != nullptr) {
        title = text;
        x_.function<int(void*)>("XFree")(text);
      }
    }
    x_.function<int(void*)>("XFree")(windows);
    return title;
  }

 private:
  int width_, height_;
  XLibrary x_;
  os::ChildProcess server_;
  std::string name_;
  Display* display_ = nullptr;
};

}  // namespace taxel::test
