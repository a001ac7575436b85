// Edits of taxels, applied in place; apply_edit() calls these functions with a copy of the project.
#pragma once

#include "core/document/edit.h"

namespace taxel {

// Each throws Error that names the taxel if its id, or a value, is not valid.
void add_taxels(Project& project, const AddTaxels& edit);
void delete_taxels(Project& project, const DeleteTaxels& edit);
void set_taxels(Project& project, const SetTaxels& edit);
void renumber_taxels(Project& project, const RenumberTaxels& edit);
void reorder_taxels(Project& project, const ReorderTaxels& edit);

}  // namespace taxel
