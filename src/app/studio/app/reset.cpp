#include "app/studio/app/reset.h"

#include "app/studio/app/app.h"
#include "app/studio/app/values/layout_features.h"
#include "app/studio/app/values/simulate_features.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_features.h"
#include "app/studio/app/values/window_ui.h"

namespace taxel::ui {

namespace {

/// Resets the part of a state that belongs to the document. A state names this part PerDocument, or has no such part.
constexpr auto forget = [](auto& state) {
  using State = std::remove_reference_t<decltype(state)>;
  if constexpr (requires { typename State::PerDocument; }) static_cast<typename State::PerDocument&>(state) = {};
};

}  // namespace

void forget_document(App& app) {
  app.ui->fields.refused.reset();
  app.viewer->selection = {};
  app.viewer->clip.reset();
  visit_features(*app.layout, forget);
  visit_features(*app.simulate, forget);
  visit_features(*app.window, forget);
}

}  // namespace taxel::ui
