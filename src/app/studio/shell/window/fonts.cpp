#include "app/studio/shell/window/fonts.h"

#include <imgui.h>

#include <array>
#include <filesystem>

#include "ui/theme.h"

namespace taxel::studio {

bool load_fonts() {
  constexpr std::array kPlaces = {
      "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",    // Debian, Ubuntu
      "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",  // Fedora
      "/usr/share/fonts/dejavu/DejaVuSans.ttf",
      "/usr/share/fonts/TTF/DejaVuSans.ttf",  // Arch
      "/usr/local/share/fonts/dejavu/DejaVuSans.ttf",
  };
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  for (const char* place : kPlaces) {
    std::error_code ignored;
    if (std::filesystem::exists(place, ignored) && atlas.AddFontFromFileTTF(place, ui::kTextHeight) != nullptr)
      return true;
  }
  atlas.AddFontDefault();
  return false;
}

}  // namespace taxel::studio
