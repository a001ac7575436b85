#include "app/cli/command.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "core/layout/words.h"

namespace taxel::cli {
namespace {

template <class Rule>
CLI::Validator checked(const char* expected, const Rule& rule) {
  return CLI::Validator(
      [expected, rule](const std::string& text) {
        double value = 0;
        const bool number = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
        return number && rule(value) ? std::string() : fmt::format("must be {}, is {}", expected, text);
      },
      "");
}

}  // namespace

CLI::App* add_command(CLI::App& parent, CommonOptions& common, const std::string& name, const std::string& text,
                      const std::string& example) {
  CLI::App* app = parent.add_subcommand(name, text);
  app->add_flag("--json", common.json, "The result on stdout as one JSON object");
  app->add_flag("--quiet", common.quiet, "No messages and no progress bar on stderr");
  app->add_option("--threads", common.threads,
                  "At most this many threads (default: all cores); results do not depend on it")
      ->check(CLI::Range(1, 4096))
      ->option_text("N");
  app->footer("Lengths in metres, forces in newtons, pressures in pascals, angles in degrees where said.\nExample: " +
              example);
  return app;
}

CLI::Validator positive() {
  return checked("greater than 0", [](double v) { return v > 0; });
}
CLI::Validator not_negative() {
  return checked("0 or more", [](double v) { return v >= 0; });
}
CLI::Validator finite() {
  return checked("a finite number", [](double) { return true; });
}

CLI::Validator whole_number() {
  return CLI::Validator(
      [](const std::string& text) {
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool is_whole = error == std::errc() && end == text.data() + text.size();
        return is_whole ? std::string() : fmt::format("must be a whole number from 0 to 2^64 - 1, is {}", text);
      },
      "");
}

void add_sampling(CLI::App& app, LayoutOptions& options) {
  app.add_option("--density", options.density, "Samples per square metre (default: the layout's)")
      ->check(positive())
      ->type_name("PER_M2");
  app.add_option("--seed", options.seed, "Seed of the samples (default: the layout's)")
      ->check(whole_number())
      ->type_name("N");
}

dvec3 parse_scale(const std::string& command, const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& word : CLI::detail::split(text, ',')) {
    double number = 0;
    if (!CLI::detail::lexical_cast(word, number) || !std::isfinite(number) || number == 0) {
      throw Error(command, "--scale", fmt::format("must be one number or three, none of them 0, is {}", text));
    }
    numbers.push_back(number);
  }
  if (numbers.size() != 1 && numbers.size() != 3) {
    throw Error(command, "--scale", fmt::format("must be one number or three, is {}", text));
  }
  return numbers.size() == 3 ? dvec3(numbers[0], numbers[1], numbers[2]) : dvec3(numbers[0]);
}

void add_skin(CLI::App& app, SkinChoice& choice) {
  app.add_option("--mesh", choice.mesh,
                 "Mesh of a layout that holds none (sensor .yaml, table .csv); replaces that of one that does")
      ->type_name("FILE");
  app.add_option_function<std::string>(
         "--scale", [&app, &choice](const std::string& text) { choice.scale = parse_scale(app.get_name(), text); },
         "Multiply coordinates of --mesh by one number, or by three: X,Y,Z (0.001 for mm; default: the unit with which "
         "the taxels are on the mesh)")
      ->type_name("X");
  app.add_option("--sensor", choice.sensor, "Sensor of a .yaml file that holds several: its name, or that of its geom")
      ->type_name("NAME");
}

void add_tactile_state(CLI::App& app, bool& wanted) {
  app.add_flag("--tactile-state", wanted,
               "Also tactile_state.jsonl in the folder of --out: a line a row with the fields of ROS's "
               "tactile_msgs/TactileState; a channel a sensor, calibrated where its layout has a calibration")
      ->needs(app.get_option("--out"));
}

void add_aggregate(CLI::App& app, std::optional<Aggregate>& aggregate) {
  const CLI::Validator word(
      [](const std::string& text) {
        const bool known = from_word<Aggregate>(text).has_value();
        return known ? std::string() : fmt::format("must be one of {}, is {}", word_list<Aggregate>(), text);
      },
      "");
  app.add_option_function<std::string>(
         "--aggregate", [&aggregate](const std::string& text) { aggregate = from_word<Aggregate>(text); },
         "How a taxel's samples make its reading (default: the layout's): weighted_mean is the paper's formula, "
         "weighted_sum what its released code computes, which does not divide; " +
             word_list<Aggregate>())
      ->check(word)
      ->type_name("WORD");
}

}  // namespace taxel::cli
