// `taxel validate`: the closed forms as a table, as JSON and as docs/validation.md.
#pragma once

#include <string>
#include <vector>

#include "core/project/validation.h"

namespace taxel::cli {

std::string validate_text(const std::vector<ClosedFormCheck>& checks);
std::string validate_json(const std::vector<ClosedFormCheck>& checks);
/// The page, with formulas. Errors at rounding level are shown as "< 1e-12", so that the page is the same everywhere.
std::string validate_markdown(const std::vector<ClosedFormCheck>& checks);

}  // namespace taxel::cli
