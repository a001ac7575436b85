// The edits that change which taxels there are, or what they are; apply_edit (edit.h) carries them out on a copy.
#pragma once

#include "core/document/edit.h"

namespace taxel {

void add_taxels(Project& project, const AddTaxels& edit);
void delete_taxels(Project& project, const DeleteTaxels& edit);
void set_taxels(Project& project, const SetTaxels& edit);
void renumber_taxels(Project& project, const RenumberTaxels& edit);
void reorder_taxels(Project& project, const ReorderTaxels& edit);

}  // namespace taxel
