// The status line at the bottom of the window: rates, force, counts, messages.
#pragma once

#include <string>

#include "app/studio/frame/arrangement.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"

namespace taxel::ui {

/// Returns "0.98 x real time", or a word for a run that is paused, has ended or waits for polished samples. Empty
/// without a scene, and while a run plays in script mode.
std::string pace_text(const Shown& shown);

/// The line at the bottom of the window.
extern const Feature kStatusLine;

}  // namespace taxel::ui
