#include "app/studio/nouns/explain/explain_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"

namespace taxel::ui {
namespace {

constexpr int kRowsShown = 8;  // further rows are reached by scrolling

template <std::size_t N>
bool begin_rows(const char* id, const std::array<const char*, N>& heads, std::size_t rows) {
  const float height = ImGui::GetTextLineHeightWithSpacing() *
                       static_cast<float>(1 + std::min(rows, static_cast<std::size_t>(kRowsShown)));
  constexpr auto kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingStretchProp;
  if (!ImGui::BeginTable(id, static_cast<int>(N), kFlags, ImVec2(0, height + 4))) return false;
  ImGui::TableSetupScrollFreeze(0, 1);
  for (const char* head : heads) ImGui::TableSetupColumn(head);
  ImGui::TableHeadersRow();
  return true;
}

void cell(const std::string& text) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(text.c_str());
}

bool is(const PolygonBehind& p, const std::optional<PolygonNumber>& number) {
  return number && p.surface == number->surface && p.polygon == number->polygon;
}

void draw_selected(const PolygonBehind& p) {
  if (!begin_properties("polygon")) return;
  property("Polygon", fmt::format("{} of surface {}", p.polygon, p.surface));
  property("Area", in_mm2(p.area));
  property("Pressure", fmt::format("{} to {}, mean {}", in_kpa(p.lowest), in_kpa(p.highest), in_kpa(p.mean)));
  property("Of the force", fmt::format("{:.3g} %", 100 * p.force_share));
  property("Of the reading", fmt::format("{:.3g} %, exactly {:.3g} %", 100 * p.share, 100 * p.exact_share));
  property("Tet", p.tet < 0 ? "none" : fmt::format("{}{}", p.tet, p.inverted ? ", inside out" : ""));
  property("Serves", p.taxels.empty() ? "no taxel" : fmt::format("taxels {}", fmt::join(p.taxels, ", ")));
  end_properties();
}

void draw_row(WindowUi& ui, ExplainState& explain, const PolygonBehind& p) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const std::string label = fmt::format("{}/{}", p.surface, p.polygon);
  if (ImGui::Selectable((label + "##polygon").c_str(), is(p, explain.polygon), ImGuiSelectableFlags_SpanAllColumns))
    explain.polygon = PolygonNumber{p.surface, p.polygon};
  ui.widgets.note_item("Polygon " + label);
  cell(fmt::format("{:.2f}", 100 * p.share));
  cell(fmt::format("{:.3f}", 1e6 * p.area));
  cell(fmt::format("{:.4g}", 1e-3 * p.mean));
  cell(fmt::format("{:.2f}", 100 * p.force_share));
}

}  // namespace

void draw_polygons(WindowUi& ui, ExplainState& explain, const Explanation& e) {
  std::vector<const PolygonBehind*> rows;
  const PolygonBehind* selected = nullptr;
  for (const PolygonBehind& p : e.polygons) {
    if (is(p, explain.polygon)) selected = &p;
    if (p.samples > 0 || p.exact_share > 0) rows.push_back(&p);
  }
  std::stable_sort(rows.begin(), rows.end(), [](auto* a, auto* b) { return a->share > b->share; });
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  caption(fmt::format("{} of {} polygons in its field", rows.size(), e.polygons.size()).c_str());
  if (selected != nullptr) draw_selected(*selected);
  constexpr std::array kHeads{"Polygon", "Share %", "mm\xc2\xb2", "kPa", "Force %"};
  if (!rows.empty() && begin_rows("polygons", kHeads, rows.size())) {
    for (const PolygonBehind* p : rows) draw_row(ui, explain, *p);
    ImGui::EndTable();
  }
  ImGui::PopFont();
}

void draw_samples(WindowUi& ui, const Explanation& e) {
  std::vector<std::size_t> rows;
  const auto hit_before = [&](std::size_t i) { return !e.samples_before.empty() && e.samples_before[i].hit; };
  for (std::size_t i = 0; i < e.samples.size(); ++i)
    if (e.samples[i].hit || hit_before(i)) rows.push_back(i);
  std::stable_sort(rows.begin(), rows.end(),
                   [&](std::size_t a, std::size_t b) { return e.samples[a].share > e.samples[b].share; });
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  caption(fmt::format("{} of {} samples hit, now or before: share in %, depth in mm, weight in mm\xc2\xb2", rows.size(),
                      e.samples.size())
              .c_str());
  ui.widgets.note_item("Samples caption");
  constexpr std::array kHeads{"No.", "Share", "Depth", "kPa", "Before", "Weight"};
  if (!rows.empty() && begin_rows("samples", kHeads, rows.size())) {
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()));
    while (clipper.Step()) {
      for (int r = clipper.DisplayStart; r < clipper.DisplayEnd; ++r) {
        const std::size_t i = rows[static_cast<std::size_t>(r)];
        const TaxelSampleReading& s = e.samples[i];
        ImGui::TableNextRow();
        cell(fmt::format("{}", s.sample));
        cell(fmt::format("{:.2f}", 100 * s.share));
        cell(s.hit ? fmt::format("{:.3f}", 1e3 * s.depth) : "miss");
        cell(fmt::format("{:.4g}", 1e-3 * s.pressure));
        cell(hit_before(i) ? fmt::format("{:.4g}", 1e-3 * e.samples_before[i].pressure) : "miss");
        cell(fmt::format("{:.3g}", 1e6 * s.weight));
      }
    }
    ImGui::EndTable();
  }
  ImGui::PopFont();
}

}  // namespace taxel::ui
