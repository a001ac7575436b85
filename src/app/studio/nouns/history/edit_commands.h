// Edits of the document and their undoing, and the steps of its history as a list.
#pragma once

#include <functional>
#include <optional>

#include "app/studio/frame/command.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/window_ui.h"
#include "core/document/edit.h"
#include "core/document/history.h"

namespace taxel::ui {

struct EditProject {
  Edit edit;
  taxel::Gesture gesture;
  std::optional<FieldInput> from = {};  ///< field that shows the reason if the edit is refused
};
struct CancelGesture {
  std::uint64_t number = 0;
};
struct EndGesture {};
struct UndoStep {};
struct RedoStep {};
/// Undoes or redoes steps until the project has this revision.
struct GoToEdit {
  std::uint64_t revision = 0;
};

/// Requests an edit of the field drawn last. If the edit is refused, the field says why.
void post_edit(WindowUi& ui, Edit edit);

/// The steps of the document's history as a list: a click undoes or redoes up to a step.
extern const Feature kHistory;

}  // namespace taxel::ui

namespace taxel::studio {

class EditSession;

void carry_out(const ui::EditProject& command, Host& host);
void carry_out(const ui::CancelGesture& command, Host& host);
void carry_out(const ui::EndGesture& command, Host& host);
void carry_out(const ui::UndoStep& command, Host& host);
void carry_out(const ui::RedoStep& command, Host& host);
void carry_out(const ui::GoToEdit& command, Host& host);

/// Edits the document. Shows why an edit is refused at the field or the gesture that requested it, or as a message. The
/// document stays then.
void edit_document(Host& host, const std::function<void(EditSession&)>& body, bool in_gesture = false,
                   const std::optional<ui::FieldInput>& from = std::nullopt);

}  // namespace taxel::studio
