// Why a command line was refused, in words of this program: versions of CLI11 word their messages differently.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace taxel {

/// Returns the message on one line, after a parse that threw `error`. `app` is the command that was recognised, or the
/// program. `words` are the arguments of main() without the program's name.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& words);

}  // namespace taxel
