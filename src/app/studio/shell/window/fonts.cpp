#include "app/studio/shell/window/fonts.h"

#include <imgui.h>

#include <string_view>

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

}  // namespace taxel::studio
