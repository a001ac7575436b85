#include "app/studio/shell/comparison.h"

#include <fmt/format.h>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/compare/compare.h"
#include "app/studio/nouns/compare/compare_state.h"
#include "app/studio/nouns/compare/compare_tool.h"

namespace taxel::ui {

namespace {

/// Returns the displayed comparison if it has rows, otherwise null.
const ComparedLayouts* compared_rows(const App& app) {
  const ComparedLayouts* compared =
      displayed_comparison(*app.viewer, *app.shown, app.get<CompareState>(), app.get<PanelsShown>()[kCompare]);
  return compared != nullptr && !compared->rows.empty() ? compared : nullptr;
}

}  // namespace

void compare_with(App& app, const std::string& file) {
  begin_comparison(app.get<CompareState>(), file);
  app.get<PanelsShown>()[kCompare] = true;
  app.ui->opened_panel = &app.get<PanelsShown>()[kCompare];
}

std::string second_layout_file(const App& app) {
  return app.get<CompareState>().request ? app.get<CompareState>().request->file : "";
}

void reread_second_layout(App& app) {
  reread_second(app.get<CompareState>());
}

std::optional<ComparisonTable> comparison_table(const App& app) {
  const ComparedLayouts* compared = compared_rows(app);
  if (compared == nullptr) return std::nullopt;
  return ComparisonTable{comparison_csv(*compared),
                         fmt::format("A is {}, B is {}", side_name(*compared, 0), side_name(*compared, 1))};
}

bool has_comparison_table(const App& app) {
  return compared_rows(app) != nullptr;
}

}  // namespace taxel::ui
