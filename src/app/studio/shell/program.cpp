#include "app/studio/shell/program.h"

#include <fmt/format.h>
#include <imgui.h>
#include <implot.h>

#include <cstdio>
#include <exception>

#include "app/studio/frame/keymap.h"
#include "app/studio/shell/options.h"
#include "app/studio/shell/studio.h"
#include "app/version/version.h"
#include "core/base/text/message.h"
#include "core/sensor/stored_samples.h"
#include "core/sim/plugin/plugin_folder.h"
#include "core/sim/plugin/shared/shared_parts.h"

namespace taxel::studio {
namespace {

/// Prints to stdout. Returns the exit status.
int print(const std::string& text) {
  const bool is_written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  return is_written ? 0 : 2;
}

}  // namespace

int run_program(int argc, char** argv, SensorCache& cache) {
  const ParsedOptions parsed = parse_options(argc, argv);
  if (parsed.exit_status) return *parsed.exit_status;
  const Options& options = parsed.options;
  if (options.version) {
    return print(
        fmt::format("{}, Dear ImGui {}, ImPlot {}\n", version_line("taxelstudio"), IMGUI_VERSION, IMPLOT_VERSION));
  }
  if (options.list_bindings) {
    return print(ui::bindings_as_text());
  }
  try {
    keep_samples_on_disk();
    if (!options.plugins.empty()) load_plugin_folder(options.plugins);
    record_end_signals();
    const PartsFromCache parts(cache);
    Studio studio(options, cache);
    const bool good = studio.run();
    constexpr int kEndedBySignal = 128;  // added to its number, as shells report it
    if (const int number = end_signal(); number != 0) return kEndedBySignal + number;
    return good ? 0 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "taxelstudio: %s\n", shown_message(error).c_str());
    return 2;
  }
}

}  // namespace taxel::studio
