// Arguments of the benchmarks of layouts: [--threads N], and layout files in addition to our own fingertip.
#pragma once

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <vector>

#include <tbb/global_control.h>

namespace taxel::bench {

struct LayoutArguments {
  std::vector<std::filesystem::path> files{TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json"};
  std::optional<tbb::global_control> threads;  ///< limit of all threads while it exists

  LayoutArguments(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
      if (std::strcmp(argv[i], "--threads") == 0 && i + 1 < argc) {
        threads.emplace(tbb::global_control::max_allowed_parallelism, std::strtoul(argv[++i], nullptr, 10));
      } else {
        files.emplace_back(argv[i]);
      }
    }
  }
};

}  // namespace taxel::bench
