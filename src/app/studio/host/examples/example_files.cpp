#include "app/studio/host/examples/example_files.h"

#include <span>
#include <string_view>

#include "core/base/files.h"

namespace taxel::studio {

std::string_view embedded_file(std::string_view name);
std::span<const std::string_view> embedded_names();

void write_examples(const std::filesystem::path& folder) {
  constexpr std::string_view kAssets = "assets/";
  for (const std::string_view name : embedded_names()) {
    const std::filesystem::path file = folder / name.substr(kAssets.size());
    const std::string kind = file.parent_path().filename().string();
    std::error_code ignored;
    const bool is_example = kind == "layouts" || kind == "meshes" || kind == "scenes";
    if (!is_example || std::filesystem::exists(file, ignored)) continue;
    make_folder(file.parent_path());
    write_file_atomically(file, embedded_file(name));
  }
}

}  // namespace taxel::studio
