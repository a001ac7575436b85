// The fields of the selected taxels in the inspector. A typed value applies to all selected taxels.
#pragma once

#include "app/studio/frame/selection.h"
#include "app/studio/frame/window_ui.h"
#include "core/document/project.h"

namespace taxel::ui {
/// Draws the fields as rows of a table of properties.
void draw_taxel_fields(WindowUi& ui, Selection& selection, const Project& project);
}  // namespace taxel::ui
