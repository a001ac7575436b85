// Frames of an interface without a window: keys and the pointer go in, the effects of tools and actions come out.
#pragma once

#include <imgui.h>

#include <functional>

namespace taxel::ui::test {

/// Dear ImGui without a renderer. Only one object may exist at a time.
class InterfaceFrames {
 public:
  InterfaceFrames() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {800, 600};
    io.BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
    io.ConfigInputTrickleEventQueue = false;
    frame([] {});
  }
  ~InterfaceFrames() { ImGui::DestroyContext(); }
  InterfaceFrames(const InterfaceFrames&) = delete;
  InterfaceFrames& operator=(const InterfaceFrames&) = delete;

  /// One frame of 20 ms, in which `draw` is called.
  void frame(const std::function<void()>& draw) {
    ImGui::GetIO().DeltaTime = 0.02f;
    ImGui::NewFrame();
    draw();
    ImGui::EndFrame();
    for (ImTextureData* texture : ImGui::GetPlatformIO().Textures) texture->SetStatus(ImTextureStatus_OK);
  }
  void move(double x, double y) { ImGui::GetIO().AddMousePosEvent(static_cast<float>(x), static_cast<float>(y)); }
  void button(bool down) { ImGui::GetIO().AddMouseButtonEvent(ImGuiMouseButton_Left, down); }
  void key(ImGuiKey key, bool down) { ImGui::GetIO().AddKeyEvent(key, down); }
};

}  // namespace taxel::ui::test
