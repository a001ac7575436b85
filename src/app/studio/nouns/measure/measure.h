// The distance of two points on the skin.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// The distance of two points on the skin.
extern const Feature kMeasure;
/// Sets "measure", which is null while nothing is measured.
void dump_measure(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
