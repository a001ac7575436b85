#include "app/studio/shell/window/window_painter.h"

#include <epoxy/gl.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace taxel::studio {

namespace {

/// Returns whether two vectors, ImGui's and ours, hold the same bytes.
template <class T, class U>
bool same_bytes(const std::vector<T>& a, const ImVector<U>& b) {
  static_assert(sizeof(T) == sizeof(U));
  return a.size() == static_cast<std::size_t>(b.Size) &&
         (a.empty() || std::memcmp(a.data(), b.Data, a.size() * sizeof(T)) == 0);
}

bool same_command(const ImDrawCmd& a, const ImDrawCmd& b) {
  return std::memcmp(&a.ClipRect, &b.ClipRect, sizeof(ImVec4)) == 0 && a.TexRef._TexData == b.TexRef._TexData &&
         a.TexRef._TexID == b.TexRef._TexID && a.VtxOffset == b.VtxOffset && a.IdxOffset == b.IdxOffset &&
         a.ElemCount == b.ElemCount && a.UserCallback == b.UserCallback && a.UserCallbackData == b.UserCallbackData;
}

bool shows(const ImDrawList& list, ImTextureID texture) {
  return std::any_of(list.CmdBuffer.begin(), list.CmdBuffer.end(), [texture](const ImDrawCmd& command) {
    return command.TexRef._TexData == nullptr && command.TexRef._TexID == texture;
  });
}

/// Turns draw data upside down, or back: the window's lower edge becomes the first row, from which y is measured.
void turn_over(ImDrawData& data) {
  data.DisplayPos.y += data.DisplaySize.y;
  data.DisplaySize.y = -data.DisplaySize.y;
  data.FramebufferScale.y = -data.FramebufferScale.y;
}

/// Returns whether glyphs are yet to be sent to the graphics card.
bool textures_pending(const ImDrawData& data) {
  return data.Textures != nullptr &&
         std::any_of(data.Textures->begin(), data.Textures->end(),
                     [](const ImTextureData* texture) { return texture->Status != ImTextureStatus_OK; });
}

}  // namespace

bool WindowPainter::Shown::is(const ImDrawList& list) const {
  return same_bytes(vertices, list.VtxBuffer) && same_bytes(indices, list.IdxBuffer) &&
         std::equal(commands.begin(), commands.end(), list.CmdBuffer.begin(), list.CmdBuffer.end(), same_command);
}

/// Returns an area around everything that a list draws.
WindowPainter::Area WindowPainter::bounds_of(const ImDrawList& list, const Area& window) {
  Area all{window.x1, window.y1, window.x0, window.y0};
  for (const ImDrawCmd& command : list.CmdBuffer) {
    if (command.UserCallback != nullptr) continue;
    ImVec2 lo(command.ClipRect.z, command.ClipRect.w), hi(command.ClipRect.x, command.ClipRect.y);
    for (unsigned i = 0; i < command.ElemCount; ++i) {
      const ImDrawIdx index = list.IdxBuffer[static_cast<int>(command.IdxOffset + i)];
      const ImVec2& p = list.VtxBuffer[static_cast<int>(command.VtxOffset + index)].pos;
      lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
      hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
    }
    lo = {std::max(lo.x, command.ClipRect.x), std::max(lo.y, command.ClipRect.y)};
    hi = {std::min(hi.x, command.ClipRect.z), std::min(hi.y, command.ClipRect.w)};
    if (lo.x >= hi.x || lo.y >= hi.y) continue;
    all.x0 = std::min(all.x0, static_cast<int>(std::floor(lo.x)));
    all.y0 = std::min(all.y0, static_cast<int>(std::floor(lo.y)));
    all.x1 = std::max(all.x1, static_cast<int>(std::ceil(hi.x)));
    all.y1 = std::max(all.y1, static_cast<int>(std::ceil(hi.y)));
  }
  return {std::max(all.x0, window.x0), std::max(all.y0, window.y0), std::min(all.x1, window.x1),
          std::min(all.y1, window.y1)};
}

WindowPainter::Shown WindowPainter::copy_of(const ImDrawList& list, const Area& window) {
  return {{list.VtxBuffer.begin(), list.VtxBuffer.end()},
          {list.IdxBuffer.begin(), list.IdxBuffer.end()},
          {list.CmdBuffer.begin(), list.CmdBuffer.end()},
          bounds_of(list, window)};
}

/// Adds an area. Overlapping areas are united, so that nothing is drawn twice.
void WindowPainter::include(std::vector<Area>& areas, Area area) {
  if (area.empty()) return;
  for (std::size_t i = 0; i < areas.size();) {
    if (!areas[i].meets(area)) {
      ++i;
      continue;
    }
    area = {std::min(area.x0, areas[i].x0), std::min(area.y0, areas[i].y0), std::max(area.x1, areas[i].x1),
            std::max(area.y1, areas[i].y1)};
    areas.erase(areas.begin() + static_cast<std::ptrdiff_t>(i));
    i = 0;
  }
  areas.push_back(area);
}

/// Returns the areas of the lists that changed, both before and after the change.
std::vector<WindowPainter::Area> WindowPainter::changed_areas(const ImDrawData& data, const Area& window,
                                                              ImTextureID scene, bool scene_changed) {
  std::vector<Area> areas;
  const auto count = static_cast<std::size_t>(data.CmdLists.Size);
  for (std::size_t i = count; i < shown_.size(); ++i) include(areas, shown_[i].bounds);
  shown_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const ImDrawList& list = *data.CmdLists[static_cast<int>(i)];
    const bool same = shown_[i].is(list);
    if (same && !(scene_changed && shows(list, scene))) continue;
    include(areas, shown_[i].bounds);
    if (!same) shown_[i] = copy_of(list, window);
    include(areas, shown_[i].bounds);
  }
  return areas;
}

/// Draws the contents of an area over the background; `data` is upside down.
void WindowPainter::paint_area(ImDrawData& data, const Area& area) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(area.x0, area.y0, area.x1 - area.x0, area.y1 - area.y0);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  std::vector<std::pair<ImDrawCmd*, ImVec4>> clips;
  for (ImDrawList* list : data.CmdLists) {
    for (ImDrawCmd& command : list->CmdBuffer) {
      if (command.UserCallback != nullptr) continue;
      clips.emplace_back(&command, command.ClipRect);
      ImVec4& clip = command.ClipRect;
      clip = {std::max(clip.x, static_cast<float>(area.x0)), std::min(clip.w, static_cast<float>(area.y1)),
              std::min(clip.z, static_cast<float>(area.x1)), std::max(clip.y, static_cast<float>(area.y0))};
    }
  }
  ImGui_ImplOpenGL3_RenderDrawData(&data);
  for (const auto& [command, clip] : clips) command->ClipRect = clip;
}

void WindowPainter::send_glyphs(ImDrawData& data) {
  if (data.Textures == nullptr) return;
  for (ImTextureData* texture : *data.Textures)
    if (texture->Status != ImTextureStatus_OK) ImGui_ImplOpenGL3_UpdateTexture(texture);
}

void WindowPainter::paint(Window& window, ImDrawData& data, const ImVec4& background, ImTextureID scene,
                          int scene_draws) {
  const int width = window.width(), height = window.height();
  const Area all{0, 0, width, height};
  painted_ = all.pixels();
  if (whole_) {
    window.begin_picture(background);
    ImGui_ImplOpenGL3_RenderDrawData(&data);
    return;
  }
  const bool resized = !picture_ || picture_->width() != width || picture_->height() != height;
  if (resized) picture_.emplace(width, height);
  const bool anew = resized || shown_.empty() || textures_pending(data) ||
                    std::memcmp(&background, &background_, sizeof(ImVec4)) != 0;
  std::vector<Area> areas = changed_areas(data, all, scene, scene_draws != scene_draws_);
  if (anew) areas = {all};
  background_ = background;
  scene_draws_ = scene_draws;
  picture_->bind();
  // Filling only a part of a window rounds differently.
  const auto level = [](float part) { return std::round(255 * part) / 255; };
  glClearColor(level(background.x), level(background.y), level(background.z), 1);
  painted_ = 0;
  turn_over(data);
  for (const Area& area : areas) {
    paint_area(data, area);
    painted_ += area.pixels();
  }
  turn_over(data);
  window.begin_picture(background);  // binds the framebuffer to copy into
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  picture_->copy_to(static_cast<GLuint>(bound));
}

}  // namespace taxel::studio
