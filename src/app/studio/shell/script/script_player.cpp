// Plays a script: its events before a frame, its commands after the frame.
#include "app/studio/shell/script/script.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <utility>

#include "core/base/error.h"
#include "core/base/text/message.h"

namespace taxel::studio {

namespace {

/// Number of idle frames in a row after which the window is idle. Widgets settle a frame or two after the last input: a
/// menu opens, a table lays itself out.
constexpr int kIdleFrames = 3;
constexpr std::chrono::seconds kPatience{60};

/// Converts event lines to the input events that the window's callbacks would report.
class Hand {
 public:
  explicit Hand(const ScriptStage& stage) : stage_(stage) {}
  std::vector<InputEvent> events;

  bool operator()(const MouseMoveEvent& e) { return move(e.at), true; }
  bool operator()(const MouseButtonEvent& e) {
    if (e.at) move(*e.at);
    press_modifiers(e.mods, true);
    events.emplace_back(MouseButton{e.button, e.down});
    if (!e.down) press_modifiers(e.mods, false);  // modifiers stay pressed during a drag
    return true;
  }
  bool operator()(const ClickEvent& e) {
    if (e.at) move(*e.at);
    press_modifiers(e.mods, true);
    for (int i = 0; i < e.count; ++i) {
      events.emplace_back(MouseButton{e.button, true});
      events.emplace_back(MouseButton{e.button, false});
    }
    press_modifiers(e.mods, false);
    return true;
  }
  bool operator()(const WheelEvent& e) {
    if (e.at) move(*e.at);
    press_modifiers(e.mods, true);
    events.emplace_back(MouseWheel{static_cast<float>(e.x), static_cast<float>(e.y)});
    press_modifiers(e.mods, false);
    return true;
  }
  bool operator()(const KeyEvent& e) {
    if (e.down) press_modifiers(e.mods, true);
    if (e.down) events.emplace_back(KeyPress{e.key, true});
    if (e.up) events.emplace_back(KeyPress{e.key, false});
    if (e.up) press_modifiers(e.mods, false);
    return true;
  }
  bool operator()(const TextEvent& e) {
    const char* at = e.text.c_str();
    while (*at != '\0') {
      unsigned codepoint = 0;
      at += ImTextCharFromUtf8(&codepoint, at, nullptr);
      events.emplace_back(TextInput{codepoint});
    }
    return true;
  }
  bool operator()(const DropEvent& e) { return events.emplace_back(DropFiles{e.files}), true; }
  bool operator()(const ResizeEvent& e) { return events.emplace_back(ResizeWindow{e.width, e.height}), true; }
  bool operator()(const CloseEvent&) { return events.emplace_back(CloseWindow{}), true; }
  template <class Command>
  bool operator()(const Command&) {
    return false;
  }

 private:
  void move(const Target& target) {
    const ImVec2 pixel = stage_.locate(target);
    events.emplace_back(MouseMove{pixel.x, pixel.y});
  }
  void press_modifiers(const Modifiers& mods, bool down) {
    for (const ImGuiKey mod : mods) events.emplace_back(KeyPress{mod, down});
  }
  const ScriptStage& stage_;
};

/// Returns whether a step clicks the tab of a panel. ImGui takes a click on a tab only if the pointer was over it in
/// the frame before, as it always is under a real hand.
bool clicks_tab(const ScriptStep& step) {
  const auto* click = std::get_if<ClickEvent>(&step);
  const auto* label = click != nullptr && click->at ? std::get_if<WidgetTarget>(&*click->at) : nullptr;
  return label != nullptr && label->label.ends_with(" tab");
}

}  // namespace

template <class Body>
void ScriptPlayer::at_line(const Body& body) {
  try {
    body();
  } catch (const Error& error) {
    throw Error(script_.file, fmt::format("line {}", script_.lines[next_].number), shown_message(error));
  }
}

bool ScriptPlayer::due() const {
  return !finished() && script_.lines[next_].frame <= frame_;
}

std::vector<InputEvent> ScriptPlayer::before_frame(const ScriptStage& stage) {
  Hand hand(stage);
  bool is_event = true;
  while (due() && is_event) {
    hovers_tab_ = !hovers_tab_ && clicks_tab(script_.lines[next_].step);
    if (hovers_tab_) {  // the click follows in the next frame
      at_line([&] { hand(MouseMoveEvent{*std::get<ClickEvent>(script_.lines[next_].step).at}); });
      break;
    }
    at_line([&] { is_event = std::visit(hand, script_.lines[next_].step); });
    if (is_event) ++next_;
  }
  return std::move(hand.events);
}

/// Returns whether the state meets an expectation. Throws the Error of check_expectation() after kPatience.
bool ScriptPlayer::is_so(const ExpectCommand& expect, const ScriptStage& stage) {
  const auto now = std::chrono::steady_clock::now();
  if (!waits_since_) waits_since_ = now;
  try {
    check_expectation(expect, stage.state());
  } catch (const Error&) {
    if (now - *waits_since_ > kPatience) throw;
    return false;
  }
  waits_since_.reset();
  return true;
}

bool ScriptPlayer::rests() const {
  if (finished() || !waits_since_) return false;
  const auto* rest = std::get_if<RestCommand>(&script_.lines[next_].step);
  return rest != nullptr &&
         std::chrono::steady_clock::now() - *waits_since_ < std::chrono::duration<double>(rest->seconds);
}

bool ScriptPlayer::run_command(const ScriptStage& stage) {
  const ScriptStep& step = script_.lines[next_].step;
  if (const auto* shot = std::get_if<ScreenshotCommand>(&step)) stage.save_screenshot(shot->file);
  if (const auto* dump = std::get_if<DumpStateCommand>(&step)) stage.save_state(dump->file);
  if (const auto* expect = std::get_if<ExpectCommand>(&step)) check_expectation(*expect, stage.state());
  if (const auto* wait = std::get_if<WaitForCommand>(&step)) return is_so(wait->expect, stage);
  if (std::holds_alternative<RestCommand>(step)) {
    if (!waits_since_ || stage.works()) waits_since_ = std::chrono::steady_clock::now();
    if (rests()) return false;
    waits_since_.reset();
  }
  if (std::holds_alternative<QuitCommandLine>(step)) stage.quit();
  if (std::holds_alternative<WaitIdleCommand>(step)) return idle_frames_ >= kIdleFrames;
  if (const auto* wait = std::get_if<WaitTimeCommand>(&step)) {
    const std::optional<double> time = stage.running_time();
    if (!time) throw Error(fmt::format("the simulation does not run: it will not reach {} s", wait->time));
    return *time >= wait->time;
  }
  return true;
}

void ScriptPlayer::after_frame(const ScriptStage& stage) {
  idle_frames_ = stage.idle() ? idle_frames_ + 1 : 0;
  while (due()) {
    const std::size_t kind = script_.lines[next_].step.index();
    constexpr std::size_t kFirstCommand = 9;  // ScreenshotCommand in ScriptStep
    static_assert(std::is_same_v<std::variant_alternative_t<kFirstCommand, ScriptStep>, ScreenshotCommand>);
    if (kind < kFirstCommand) return;  // an event after a command belongs to the next frame
    bool done = false;
    at_line([&] { done = run_command(stage); });
    if (!done) return;
    ++next_;
    idle_frames_ = 0;
  }
  ++frame_;
}

}  // namespace taxel::studio
