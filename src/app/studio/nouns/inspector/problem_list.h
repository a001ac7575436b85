// The problems of the edited layout in the inspector, each with the button that repairs it.
#pragma once

#include <cstddef>
#include <vector>

#include "app/studio/frame/message_list.h"
#include "app/studio/frame/selection.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/inspector/layout_problems.h"

namespace taxel::ui {

/// Returns the indices of the problems of the selected taxels, in the order of the selection; of all problems if no
/// taxel is selected.
[[nodiscard]] std::vector<std::size_t> displayed_problems(const Selection& selection, const LayoutProblems& problems);

/// Draws the problems of the selected taxels, or all problems if no taxel is selected, and the button that repairs the
/// whole layout.
void draw_problem_list(WindowUi& ui, const Selection& selection, const DocumentView& document,
                       const LayoutProblems& problems, Messages& messages);

}  // namespace taxel::ui
