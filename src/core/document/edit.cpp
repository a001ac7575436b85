#include "core/document/edit.h"

namespace taxel {

Edit::Edit(const Edit&) = default;
Edit& Edit::operator=(const Edit&) = default;
Edit::Edit(Edit&&) noexcept = default;
Edit& Edit::operator=(Edit&&) noexcept = default;
Edit::~Edit() = default;

}  // namespace taxel
