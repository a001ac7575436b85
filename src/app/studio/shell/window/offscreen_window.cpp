// The window without a display, an offscreen image.
#include <epoxy/gl.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>

#include "app/studio/shell/window/window.h"
#include "ui/gl/offscreen_context.h"

namespace taxel::studio {

namespace {

class OffscreenWindow final : public Window {
 public:
  OffscreenWindow(int width, int height) { resize(width, height); }

  std::vector<InputEvent> take_events(double seconds) override {
    std::unique_lock lock(mutex_);
    if (seconds > 0) woken_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return is_woken_; });
    is_woken_ = false;
    return {};
  }
  void wake() override {
    const std::lock_guard lock(mutex_);
    is_woken_ = true;
    woken_.notify_all();
  }
  [[nodiscard]] int width() const override { return picture_->width(); }
  [[nodiscard]] int height() const override { return picture_->height(); }
  void resize(int width, int height) final { picture_.emplace(width, height); }
  void begin_picture(const ImVec4& background) override {
    picture_->bind();
    glClearColor(background.x, background.y, background.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  [[nodiscard]] gl::RgbImage read() const override { return picture_->read(); }
  void show() override { glFinish(); }  // as a real window waits for its picture
  void set_title(const std::string&) override {}
  void set_cursor(ImGuiMouseCursor) override {}
  void set_clipboard(const std::string& text) override { clipboard_ = text; }
  [[nodiscard]] const std::string& clipboard() override { return clipboard_; }

 private:
  gl::OffscreenContext context_;
  std::optional<gl::Framebuffer> picture_;
  std::string clipboard_;
  std::mutex mutex_;  // guards is_woken_
  std::condition_variable woken_;
  bool is_woken_ = false;
};

}  // namespace

std::unique_ptr<Window> make_offscreen_window(int width, int height) {
  return std::make_unique<OffscreenWindow>(width, height);
}

}  // namespace taxel::studio
