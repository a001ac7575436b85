// The contexts of ImGui and ImPlot, and the font of the interface.
#include <imgui.h>
#include <imgui_impl_opengl3.h>
#include <implot.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "app/studio/shell/window/window.h"
#include "ui/theme.h"

namespace taxel::studio {

namespace font {
std::string_view embedded_file(std::string_view name);
}  // namespace font

void load_fonts() {
  const std::string_view bytes = font::embedded_file("DejaVuSans.ttf");
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  // ImGui takes a pointer to bytes that may change, but changes only those that it owns.
  ImGui::GetIO().Fonts->AddFontFromMemoryTTF(const_cast<char*>(bytes.data()), static_cast<int>(bytes.size()),
                                             ui::kTextHeight, &config);
}

namespace {

/// A language whose characters DejaVu Sans does not have, and one of them.
struct FontScript {
  const char* language;
  char32_t character;
};
constexpr std::array kFontScripts{FontScript{"zh-cn", U'\u4E2D'}, FontScript{"ja", U'\u3042'},
                                  FontScript{"ko", U'\uAC00'}};

}  // namespace

std::vector<os::FontFile> fonts_of_other_scripts() {
  std::vector<os::FontFile> fonts;
  for (const FontScript& script : kFontScripts) {
    const std::optional<os::FontFile> font = os::find_font(script.language, script.character);
    if (font && std::ranges::find(fonts, *font) == fonts.end()) fonts.push_back(*font);
  }
  return fonts;
}

void add_fonts(const std::vector<os::FontFile>& fonts) {
  for (const os::FontFile& font : fonts) {
    ImFontConfig config;
    config.MergeMode = true;  // only glyphs that the fonts before do not have
    config.FontNo = static_cast<ImU32>(font.index);
    config.Flags |= ImFontFlags_NoLoadError;
    ImGui::GetIO().Fonts->AddFontFromFileTTF(font.file.c_str(), ui::kTextHeight, &config);
  }
}

InterfaceContext::InterfaceContext(Window& window) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImPlot::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.ConfigFlags |= ImGuiConfigFlags_DockingEnable | ImGuiConfigFlags_NavEnableKeyboard;
  io.ConfigInputTrickleEventQueue = true;  // no click is lost, however many come within one frame
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  io.ConfigInputTextCursorBlink = false;  // a blinking cursor would be another picture twice a second
  io.IniFilename = nullptr;               // the program keeps the arrangement itself
  io.BackendPlatformName = "taxelstudio";
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  ImGuiPlatformIO& platform = ImGui::GetPlatformIO();
  platform.Platform_ClipboardUserData = &window;
  platform.Platform_SetClipboardTextFn = [](ImGuiContext*, const char* text) {
    static_cast<Window*>(ImGui::GetPlatformIO().Platform_ClipboardUserData)->set_clipboard(text);
  };
  platform.Platform_GetClipboardTextFn = [](ImGuiContext*) {
    return static_cast<Window*>(ImGui::GetPlatformIO().Platform_ClipboardUserData)->clipboard().c_str();
  };
  load_fonts();
  static const std::vector<os::FontFile> kFonts = fonts_of_other_scripts();  // searched once
  add_fonts(kFonts);
  ImGui_ImplOpenGL3_Init("#version 410 core");
}

InterfaceContext::~InterfaceContext() {
  ImGui_ImplOpenGL3_Shutdown();
  ImPlot::DestroyContext();
  ImGui::DestroyContext();
}

}  // namespace taxel::studio
