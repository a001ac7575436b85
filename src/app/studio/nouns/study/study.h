// Parameter studies: the scenario run with several values of one or two parameters, as small multiples.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// Runs of a scenario in which one or two values vary.
extern const Feature kStudy;
/// Sets "study": its runs, none if no study was made.
void dump_study(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
