// The remedy for a jump that the method caused: an edit whose effect the explanation has computed, and the new run.
#pragma once

#include <optional>
#include <string>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "core/document/edit.h"

namespace taxel::ui {

/// An edit of the layout under which the same two contacts read without the jump.
struct Remedy {
  std::string text;  ///< "16 times as many samples, 4 instead of 0.25 per mm²"
  Edit edit;
};

/// Returns the remedy that the explanation has found to bring the change below its limit: for sampling noise
/// four times the samples that it needs, or that number where more would be too many; a pad for a star field or
/// inverted tets; a wider limit of the angle for a cut field. Empty if the contact itself caused the jump, if there is
/// none, or if nothing that was tried helps.
[[nodiscard]] std::optional<Remedy> remedy_of(const Explanation& explanation, const Layout& layout);

/// Returns why the document cannot be edited by a remedy: the readings are not of its layout. Empty if it can.
[[nodiscard]] std::string remedy_blocked(const Shown& shown);

/// Posts the edit. The run begins again when the simulation reads by the edited layout.
void apply_remedy(WindowUi& ui, const Shown& shown, ExplainState& explain, const Remedy& remedy);

/// Begins the run again after apply_remedy(), as soon as the simulation reads by the edited layout. Gives up if the
/// layout cannot be simulated.
void rerun_after_remedy(WindowUi& ui, const Shown& shown, ExplainState& explain);

}  // namespace taxel::ui
