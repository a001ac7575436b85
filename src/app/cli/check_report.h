// `taxel check`: the problems of files, as lines and as JSON.
#pragma once

#include <string>

#include "core/base/error.h"

namespace taxel::cli {

/// "FILE: POINTER: severity: message; fix", one line a problem, and a line that counts them.
std::string problems_text(const Problems& problems, int files);
std::string problems_json(const Problems& problems);

}  // namespace taxel::cli
