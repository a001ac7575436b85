// The tour of the window: five steps, each displayed next to the part that the step explains.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/demo/demo_state.h"
#include "app/studio/nouns/inspector/inspector_state.h"
#include "app/studio/nouns/table/table_state.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {
namespace {

/// One step of the tour, which points at a window or at a range of widgets.
struct TourStep {
  const char* title;
  const char* text;
  const char* window;
  const char *first, *last;
};

const std::array kSteps = {
    TourStep{"Press X and touch the finger",
             "X takes up a ball. Move it over the skin: the bars show what each taxel reads, the wheel presses deeper, "
             "Esc puts it away. Left-drag turns the view, right-drag shifts it.",
             kViewTitle, nullptr, nullptr},
    TourStep{
        "Three modes",
        "LAYOUT edits taxels, SIMULATE presses and slides the sensor and shows contact, rays and readings, ANALYSE "
        "answers questions about the run. Ctrl+1, Ctrl+2 and Ctrl+3 change between them.",
        nullptr, "LAYOUT", "ANALYSE"},
    TourStep{"All taxels",
             "Every taxel is a row. Ctrl+click on the skin adds one in LAYOUT. Edit > Generate taxels makes many at "
             "once: grids, rings, spirals, N spread evenly, tables, pictures, known sensors.",
             kTaxelTable.title, nullptr, nullptr},
    TourStep{"Exact numbers",
             "Edit the selection here. Fields take arithmetic and units: 2*3.5 mm, 45 deg. Every edit can be "
             "undone with Ctrl+Z.",
             kInspector.title, nullptr, nullptr},
    TourStep{
        "Try it",
        "Run starts the simulation, and readings follow every edit. Ctrl+K finds any command by its name, F1 lists "
        "all keys. This tour is under Help.",
        nullptr, "Reset", "Step"},
};

Rect rect_of(const WindowUi& ui, const TourStep& step) {
  if (step.window != nullptr) {
    const ImGuiWindow* window = ImGui::FindWindowByName(step.window);
    if (window == nullptr || !window->WasActive || window->Hidden) return {};
    return {window->Pos.x, window->Pos.y, window->Pos.x + window->Size.x, window->Pos.y + window->Size.y};
  }
  const WidgetRegistry::Entry *a = ui.widgets.find(step.first), *b = ui.widgets.find(step.last);
  if (a == nullptr || b == nullptr) return {};
  return {std::min(a->rect.x0, b->rect.x0), std::min(a->rect.y0, b->rect.y0), std::max(a->rect.x1, b->rect.x1),
          std::max(a->rect.y1, b->rect.y1)};
}

/// Returns the place of the tour's popup: next to the part, on the side with most room, or within the part if the part
/// fills the window.
ImVec2 card_place(const Rect& part, const ImVec2& size, const ImGuiViewport& viewport, float gap) {
  const ImVec2 lo = viewport.Pos, hi(viewport.Pos.x + viewport.Size.x, viewport.Pos.y + viewport.Size.y);
  ImVec2 at(part.center_x() - 0.5f * size.x, part.y0 + 3 * gap);
  if (part.empty()) {
    at = {0.5f * (lo.x + hi.x - size.x), 0.5f * (lo.y + hi.y - size.y)};
  } else if (part.x1 + gap + size.x < hi.x && part.width() < 0.5f * viewport.Size.x && part.height() > size.y) {
    at = {part.x1 + gap, part.center_y() - 0.5f * size.y};
  } else if (part.x0 - gap - size.x > lo.x && part.width() < 0.5f * viewport.Size.x && part.height() > size.y) {
    at = {part.x0 - gap - size.x, part.center_y() - 0.5f * size.y};
  } else if (part.height() < 0.5f * viewport.Size.y) {
    at.y = part.y1 + gap + size.y < hi.y ? part.y1 + gap : part.y0 - gap - size.y;
  }
  at.x = std::clamp(at.x, lo.x + gap, std::max(lo.x + gap, hi.x - gap - size.x));
  at.y = std::clamp(at.y, lo.y + gap, std::max(lo.y + gap, hi.y - gap - size.y));
  return at;
}

/// Draws a frame around the part and a line from the popup to the part.
void point_at(const WindowUi& ui, const Rect& part, bool window, const ImVec2& card, const ImVec2& size) {
  if (part.empty()) return;
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  const ImU32 color = to_u32(palette(ui.dark).accent);
  constexpr float kFrameWidth = 3;
  const float margin = window ? 2.0f : -4.0f;  // the frame lies inside of a window, and around widgets
  const ImVec2 a(part.x0 + margin, part.y0 + margin), b(part.x1 - margin, part.y1 - margin);
  list.AddRect(a, b, color, 4, kFrameWidth);
  const ImVec2 from(std::clamp(part.center_x(), card.x, card.x + size.x),
                    std::clamp(part.center_y(), card.y, card.y + size.y));
  const ImVec2 to(std::clamp(from.x, a.x, b.x), std::clamp(from.y, a.y, b.y));
  list.AddLine(from, to, color, kFrameWidth);
}

void draw_card(WindowUi& ui, TourState& tour, const TourStep& step) {
  const int last = static_cast<int>(kSteps.size()) - 1;
  ImGui::TextDisabled("%s", fmt::format("{} of {}", tour.step + 1, kSteps.size()).c_str());
  ImGui::SameLine();
  ImGui::TextUnformatted(step.title);
  ui.widgets.note_item(step.title);
  ImGui::Spacing();
  ImGui::TextWrapped("%s", step.text);
  ImGui::Spacing();
  ImGui::BeginDisabled(tour.step == 0);
  if (button(ui, "Back")) --tour.step;
  ImGui::EndDisabled();
  ImGui::SameLine();
  const bool entered = !ui.fields.had_keys && ImGui::IsKeyPressed(ImGuiKey_Enter, false);
  if (small_choice(ui, tour.step < last ? "Next" : "Finish", true) || entered)
    tour.step = tour.step < last ? tour.step + 1 : -1;
  ImGui::SameLine();
  if (tour.step >= 0 && tour.step < last && button(ui, "Skip the tour")) tour.step = -1;
}

void draw_tour(WindowUi& ui, TourState& tour) {
  if (tour.step < 0 || tour.step >= static_cast<int>(kSteps.size())) return;
  tour.seen = true;
  if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) return;
  const TourStep& step = kSteps[static_cast<std::size_t>(tour.step)];
  const float line = ImGui::GetFontSize();
  const ImVec2 size(24 * line, 9 * line);
  const Rect part = rect_of(ui, step);
  const ImVec2 at = card_place(part, size, *ImGui::GetMainViewport(), 1.2f * line);
  point_at(ui, part, step.window != nullptr, at, size);
  ImGui::SetNextWindowPos(at);
  ImGui::SetNextWindowSize(size);
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoDocking |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNavInputs;
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(ui.dark).panel);
  ImGui::PushStyleColor(ImGuiCol_Border, palette(ui.dark).accent);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(line, 0.8f * line));
  if (ImGui::Begin("Tour", nullptr, kFlags)) {
    ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
    draw_card(ui, tour, step);
  }
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
}

std::vector<Binding> tour_commands() {
  return {{.command = ShowTour{}, .label = "Tour", .menu = "Help"}};
}

}  // namespace

void carry_out(const ShowTour&, App& app) {
  app.get<TourState>().step = 0;
}

constinit const Feature kTour{
    .draw_card = [](App& app) { draw_tour(*app.ui, app.get<TourState>()); },
    .tool = {"tour", kEverywhere, nullptr, 3, [](const App& app) { return app.get<TourState>().step >= 0; },
             [](App& app) { app.get<TourState>().step = -1; }},
    .commands = tour_commands,
    .dump = dump_tour,
    .saved =
        [](App& app) {
          return std::vector<SavedValue>{{"tour_seen", &app.get<TourState>().seen}};
        },
};

}  // namespace taxel::ui
