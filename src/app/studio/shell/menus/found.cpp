#include "app/studio/shell/menus/found.h"

#include <algorithm>

#include "app/studio/frame/app.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/guide/guide_state.h"
#include "app/studio/nouns/guide/guide_text.h"
#include "app/studio/nouns/menus/menus_state.h"
#include "app/studio/nouns/menus/window_commands.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "app/studio/shell/interface/carry_out.h"

namespace taxel::ui {
namespace {

// Of entries that match equally well, commands come before parts of panels, then gestures, then headings.
constexpr double kCommandBias = 1.2, kPartBias = 0.9, kGestureBias = 0.2, kHeadingBias = 0;

bool is_found(const Binding& row) {
  return row.context != Context::gesture && row.context != Context::widget && !row.command.is<Escape>() &&
         !row.command.is<OpenPalette>();
}

/// Returns a text with another sign between its parts: "Edit/Selection" becomes "Edit > Selection".
std::string with_arrows(std::string_view menu) {
  std::string text;
  for (const char c : menu) text += c == '/' ? std::string(" > ") : std::string(1, c);
  return text;
}

Found found_command(const Binding& row, const KeyNames& names) {
  return {{row.label, with_arrows(row.menu != nullptr ? row.menu : ""), std::string(synonyms_of(row.label)),
           chord_names(row, names), "", kCommandBias},
          &row};
}

Found found_part(const Feature& panel, PanelPart part) {
  const bool has_section = !part.section.empty();
  return {{part.label, has_section ? std::string(panel.title) + " > " + part.section : panel.title,
           std::string(synonyms_of(part.label)), "", part.help, kPartBias},
          FoundPart{&panel, std::move(part)}};
}

/// Returns the key that shows a mode.
std::string key_of_mode(Context mode, const App& app) {
  const Mode shown = mode == kLayout ? Mode::layout : Mode::simulate;
  return chord_name(binding_of(SetMode{shown}).chord, app.ui->key_names);
}

bool is_mode(Context context) {
  return context == kLayout || context == kSimulate;
}

std::string why_not_now(const Binding& row, const App& app) {
  if (is_enabled(row, app)) return {};
  const Context present = app.viewer->mode == Mode::layout ? kLayout : kSimulate;
  if (is_mode(row.context) && row.context != present)
    return std::string("Only in ") + to_string(row.context) + " (" + key_of_mode(row.context, app) + ")";
  return why_disabled(row, app);
}

}  // namespace

std::vector<Found> all_found(const KeyNames& names) {
  std::vector<Found> entries;
  for (const Binding& row : bindings())
    if (is_found(row)) entries.push_back(found_command(row, names));
  for (const Feature* panel : features()) {
    if (panel->parts == nullptr) continue;
    for (PanelPart& part : panel->parts()) entries.push_back(found_part(*panel, std::move(part)));
  }
  for (const Gesture& gesture : gestures())
    entries.push_back(
        {{gesture.label, "Mouse and keys", std::string(synonyms_of(gesture.label)), gesture.gesture, "", kGestureBias},
         &gesture});
  for (const std::string& heading : headings_of(user_guide()))
    entries.push_back(
        {{heading, kGuide.title, std::string(synonyms_of(heading)), "", "", kHeadingBias}, FoundHeading{heading}});
  return entries;
}

std::vector<std::size_t> find_entries(std::string_view typed, const std::vector<Found>& entries) {
  std::vector<const SearchWords*> words;
  words.reserve(entries.size());
  for (const Found& entry : entries) words.push_back(&entry.words);
  std::vector<std::size_t> found = search(typed, words);
  if (typed.find_first_not_of(' ') == std::string_view::npos)
    std::erase_if(found, [&](std::size_t i) { return entries[i].target.index() != 0; });
  return found;
}

std::string why_not_now(const Found& entry, const App& app) {
  if (const auto* row = std::get_if<const Binding*>(&entry.target)) return why_not_now(**row, app);
  const auto* found = std::get_if<FoundPart>(&entry.target);
  const char* why = found != nullptr && found->part.why_not != nullptr ? found->part.why_not(app) : nullptr;
  return why != nullptr ? why : "";
}

void choose(const Found& entry, App& app) {
  if (const auto* row = std::get_if<const Binding*>(&entry.target)) {
    carry_out_if_enabled(**row, app);
  } else if (const auto* found = std::get_if<FoundPart>(&entry.target)) {
    // The mode changes before the panel is prepared: commands to the program are carried out in their order.
    const bool of_run = found->part.mode != kLayout;
    const Mode of_panel = found->panel->analyse.tab > 0 ? Mode::analyse : Mode::simulate;
    if (is_mode(found->part.mode) && shows_run(app.viewer->mode) != of_run)
      app.ui->post(SetMode{of_run ? of_panel : Mode::layout});
    app.ui->post(ShowPart{found->panel, found->part});
  } else if (const auto* gesture = std::get_if<const Gesture*>(&entry.target)) {
    app.get<PanelsShown>()[kHelp] = true;
    app.get<HelpState>().typed = (*gesture)->gesture;
  } else {
    carry_out(ShowGuide{std::get<FoundHeading>(entry.target).text}, app);
  }
}

}  // namespace taxel::ui
