// Forgetting the state of a document that is no longer open.
#pragma once

#include "app/studio/app/app.h"

namespace taxel::ui {

/// Resets everything in the window that belongs to the document, because another document was opened.
void forget_document(App& app);

}  // namespace taxel::ui
