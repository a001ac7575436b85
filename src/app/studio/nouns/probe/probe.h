// The probe: a ball under the pointer that presses the skin.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// The ball under the pointer that presses the skin.
extern const Feature kProbe;
/// Sets "probe", which is null while the probe is off.
void dump_probe(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
