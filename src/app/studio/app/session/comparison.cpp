#include "app/studio/app/session/comparison.h"

#include <fmt/format.h>

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/simulate_features.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_features.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/compare/compare_tool.h"

namespace taxel::ui {

namespace {

/// Returns the displayed comparison if it has rows, otherwise null.
const ComparedLayouts* compared_rows(const App& app) {
  const ComparedLayouts* compared =
      displayed_comparison(*app.viewer, *app.shown, app.simulate->compare, app.window->panels.compare);
  return compared != nullptr && !compared->rows.empty() ? compared : nullptr;
}

}  // namespace

void compare_with(App& app, const std::string& file) {
  begin_comparison(app.simulate->compare, file);
  app.window->panels.compare = true;
  app.ui->opened_panel = &app.window->panels.compare;
}

std::string second_layout_file(const App& app) {
  return app.simulate->compare.request ? app.simulate->compare.request->file : "";
}

void reread_second_layout(App& app) {
  reread_second(app.simulate->compare);
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
