// taxel: Taxel Studio without a window.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/signals.h"
#include "app/version/version.h"
#include "core/base/error.h"

namespace {

using namespace taxel;
using namespace taxel::cli;

/// What is wrong with the arguments, in one line; `app` is the command, or the program where none was recognised.
std::string usage_message(const CLI::App& app, const CLI::App& program, const CLI::ParseError& e) {
  const bool command = &app != &program;
  const std::vector<std::string> unknown = app.remaining();
  if (!unknown.empty()) return fmt::format("unknown {} {}", command ? "argument" : "command", unknown.front());
  return e.what();
}

/// Throws Error for the first option or argument whose value is empty, as an unset shell variable leaves it: such a
/// value must not have the meaning of an option that is not given.
void refuse_empty_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    for (const std::string& value : option->results())
      if (value.empty())
        throw Error(command.get_name(), option->get_name(), "must not be empty; leave the option out for its default");
}

/// Runs the command that was asked for. Throws Error, or CLI::ParseError for bad usage.
int run(int argc, char** argv) {
  CLI::App app("Tactile sensing with hydroelastic contact in MuJoCo: the core of Taxel Studio without a window.",
               "taxel");
  app.set_version_flag("--version", version_line("taxel"));
  app.require_subcommand(1);
  app.footer(
      "`taxel COMMAND --help` shows a command's options, units and an example.\n"
      "Exit status: 0 done; 1 done, and problems were found (check, validate); 2 bad usage or bad input; 128 + "
      "N\nended by signal N, after writing what was computed.");
  CommonOptions common;
  const std::vector<Command> commands{add_sweep(app, common),   add_play(app, common),    add_study(app, common),
                                      add_run(app, common),     add_contact(app, common), add_read(app, common),
                                      add_explain(app, common), add_align(app, common),   add_models(app, common),
                                      add_samples(app, common), add_mesh(app, common),    add_presets(app, common),
                                      add_check(app, common),   add_validate(app, common)};
  const auto chosen = [&] {
    return std::find_if(commands.begin(), commands.end(), [](const Command& c) { return c.app->parsed(); });
  };
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    Console(common).result(chosen() == commands.end() ? app.help() : chosen()->app->help("taxel"));
    return kDone;
  } catch (const CLI::CallForVersion&) {
    Console(common).result(version_line("taxel") + "\n");
    return kDone;
  } catch (const CLI::ParseError& e) {
    if (chosen() == commands.end()) throw Error(usage_message(app, app, e));
    throw Error(chosen()->app->get_name(), usage_message(*chosen()->app, app, e));
  }
  refuse_empty_values(*chosen()->app);
  std::optional<tbb::global_control> limit;
  if (common.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(common.threads));
  }
  Console console(common);
  return chosen()->run(console);
}

}  // namespace

int main(int argc, char** argv) {
  taxel::cli::handle_signals();
  try {
    return run(argc, argv);
  } catch (const taxel::Error& e) {
    taxel::cli::print_failure(e.what());
  } catch (const std::bad_alloc&) {
    taxel::cli::print_failure("out of memory");
  } catch (const std::exception& e) {
    taxel::cli::print_failure(fmt::format("unexpected: {}", e.what()));
  } catch (...) {
    taxel::cli::print_failure("unexpected failure");
  }
  return taxel::cli::kBadInput;
}
