// Watches open files for changes and deletions by other programs.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace taxel::studio {

enum class FileChange { changed, deleted };

/// Returns the hash of the file's bytes, or an empty text if the file does not exist or cannot be read.
std::string hash_of(const std::string& file);

/// Polls the times and sizes of files, never their contents.
class FileWatch {
 public:
  /// Watches these files from now on. Files that are watched already keep their known state.
  void watch(const std::vector<std::string>& files);
  /// Records the present state of the file as known, because this program has read or written it.
  void accept(const std::string& file);
  /// Returns the changes since the last call, each once, and only if the file did not change between two polls: a
  /// program that replaces a file may delete it first, or take long to write it. `now` [s]: polls no more often than
  /// every half second.
  std::vector<std::pair<std::string, FileChange>> look(double now);

 private:
  struct Stamp {
    bool there = false;
    std::uintmax_t size = 0;
    std::filesystem::file_time_type time;
    bool operator==(const Stamp&) const = default;
  };
  struct Watched {
    std::string file;
    Stamp known;  ///< state when the file was opened, written, or last reported
    Stamp last;   ///< state at the last poll
  };
  static Stamp stamp_of(const std::string& file);

  std::vector<Watched> watched_;
  double next_ = 0;
};

}  // namespace taxel::studio
