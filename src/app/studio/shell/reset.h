// Forgetting the state of a document that is no longer open.
#pragma once

namespace taxel::ui {

struct App;

/// Resets everything in the window that belongs to the document, because another document was opened.
void forget_document(App& app);

}  // namespace taxel::ui
