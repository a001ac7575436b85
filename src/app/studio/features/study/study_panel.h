// Parameter studies: the scenario run with several values of one or two parameters, as small multiples.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/study/study_state.h"

namespace taxel::ui {

void draw_study_panel(WindowUi& ui, const ViewPlace& place, const Shown& shown, StudyState& study, bool& open);

}  // namespace taxel::ui
