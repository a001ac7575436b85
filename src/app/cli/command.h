// What the subcommands share: how they are added, what each may be told, how options are checked.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "app/cli/console.h"
#include "core/base/error.h"
#include "core/layout/file/skin_choice.h"
#include "core/layout/layout.h"

namespace taxel::cli {

/// Exit statuses; nothing else leaves the program.
inline constexpr int kDone = 0;
inline constexpr int kProblemsFound = 1;
inline constexpr int kBadInput = 2;

/// One subcommand: parsed by `app`, done by `run`, which returns the exit status and throws Error for bad input.
struct Command {
  CLI::App* app = nullptr;
  std::function<int(Console&)> run;
};

Command add_sweep(CLI::App& parent, CommonOptions& common);
Command add_play(CLI::App& parent, CommonOptions& common);
Command add_study(CLI::App& parent, CommonOptions& common);
Command add_run(CLI::App& parent, CommonOptions& common);
Command add_contact(CLI::App& parent, CommonOptions& common);
Command add_explain(CLI::App& parent, CommonOptions& common);
Command add_align(CLI::App& parent, CommonOptions& common);
Command add_models(CLI::App& parent, CommonOptions& common);
Command add_read(CLI::App& parent, CommonOptions& common);
Command add_samples(CLI::App& parent, CommonOptions& common);
Command add_mesh(CLI::App& parent, CommonOptions& common);
Command add_presets(CLI::App& parent, CommonOptions& common);
Command add_check(CLI::App& parent, CommonOptions& common);
Command add_validate(CLI::App& parent, CommonOptions& common);

/// A subcommand with --json, --quiet and --threads; `example` stands below its help.
CLI::App* add_command(CLI::App& parent, CommonOptions& common, const std::string& name, const std::string& text,
                      const std::string& example);

/// Option values must be finite and greater than 0, or at least 0.
CLI::Validator positive();
CLI::Validator not_negative();
CLI::Validator finite();
/// Option values must be whole numbers that 64 bits hold, without a sign.
CLI::Validator whole_number();

/// What goes over the values of a layout.
struct LayoutOptions {
  std::optional<double> density;
  std::optional<std::uint64_t> seed;
  std::optional<Aggregate> aggregate;
  bool as_in_the_paper = false;  ///< body and samples of the paper's demo; the values above go over them
  bool preview = false;          ///< samples as they are before they are spread
  SkinChoice skin;
};
/// --mesh, --scale and --sensor: what a layout of another program leaves open.
void add_skin(CLI::App& app, SkinChoice& choice);
/// "0.001", or three numbers such as "1,1,-1". Throws Error naming the command.
dvec3 parse_scale(const std::string& command, const std::string& text);
/// --density and --seed of the samples.
void add_sampling(CLI::App& app, LayoutOptions& options);
/// --tactile-state beside --out.
void add_tactile_state(CLI::App& app, bool& wanted);
/// --aggregate of the readings.
void add_aggregate(CLI::App& app, std::optional<Aggregate>& aggregate);

}  // namespace taxel::cli
