// taxelstudio: the window.
#include <fmt/format.h>
#include <imgui.h>
#include <implot.h>

#include <cstdio>
#include <exception>

#include "app/studio/app/keymap.h"
#include "app/studio/shell/end_signal.h"
#include "app/studio/shell/options.h"
#include "app/studio/shell/studio.h"
#include "app/version/version.h"
#include "core/sim/plugin/plugin_folder.h"

int main(int argc, char** argv) {
  const taxel::studio::ParsedOptions parsed = taxel::studio::parse_options(argc, argv);
  if (parsed.exit_status) return *parsed.exit_status;
  const taxel::studio::Options& options = parsed.options;
  if (options.version) {
    fmt::print("{}, Dear ImGui {}, ImPlot {}\n", taxel::version_line("taxelstudio"), IMGUI_VERSION, IMPLOT_VERSION);
    return 0;
  }
  if (options.list_bindings) {
    fmt::print("{}", taxel::ui::bindings_as_text());
    return 0;
  }
  try {
    if (!options.plugins.empty()) taxel::load_plugin_folder(options.plugins);
    taxel::studio::record_end_signals();
    taxel::studio::Studio studio(options);
    const bool good = studio.run();
    constexpr int kEndedBySignal = 128;  // added to its number, as shells report it
    if (const int number = taxel::studio::end_signal(); number != 0) return kEndedBySignal + number;
    return good ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "taxelstudio: {}\n", error.what());
    return 2;
  }
}
