// taxel cache: the samples on disk, and their removal.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "app/cli/command_line.h"
#include "app/cli/report_writer.h"
#include "core/sensor/stored_samples.h"

namespace taxel::cli {
namespace {

struct CacheReport {
  std::optional<DiskCache> cache;  ///< nothing if the environment turns it off
  DiskCache::Content content;      ///< values that are there, or that were removed
  bool is_cleared = false;

  void visit(ReportWriter& w) const {
    w("on", cache.has_value());
    w("folder", cache ? cache->folder().string() : "");
    w("max_bytes", cache ? cache->max_bytes() : 0);
    w(is_cleared ? "removed_skins" : "skins", content.values);
    w(is_cleared ? "removed_bytes" : "bytes", content.bytes);
  }
  [[nodiscard]] std::string text() const {
    if (!cache) return fmt::format("No samples are kept on disk: {} is \"off\"\n", kSampleCacheVariable);
    const std::string size = fmt::format("{} skin{}, {:.1f} MB", content.values, content.values == 1 ? "" : "s",
                                         1e-6 * static_cast<double>(content.bytes));
    if (is_cleared) return fmt::format("Removed the samples of {} from {}\n", size, cache->folder().string());
    return fmt::format("{}: samples of {} (at most {:.0f} MB)\n", cache->folder().string(), size,
                       1e-6 * static_cast<double>(cache->max_bytes()));
  }
};

int run_cache_command(bool clears, Console& console) {
  CacheReport report{sample_cache(), {}, clears};
  if (report.cache) report.content = clears ? report.cache->clear() : report.cache->content();
  print_report(console, report);
  return kDone;
}

}  // namespace

Run add_cache(OptionList& list) {
  const auto clears = std::make_shared<bool>(false);
  list.add("--clear", clears.get(), "Remove them all");
  return [clears](Console& console) { return run_cache_command(*clears, console); };
}

}  // namespace taxel::cli
