// Files that are open: whether somebody else changes or deletes them.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace taxel::studio {

enum class FileChange { changed, deleted };

/// Of its bytes; empty: there is no such file, or it cannot be read.
std::string hash_of(const std::string& file);

/// Looks at files now and then: at their time and size, never into them.
class FileWatch {
 public:
  /// These from now on; the ones that are watched already go on as they were.
  void watch(const std::vector<std::string>& files);
  /// As the file stands now it is known: it was read or written by us.
  void accept(const std::string& file);
  /// What happened since, each change once, and only when the file has stood still from one look to the next: who
  /// replaces a file may delete it first, or take long to write it. `now` [s]: looks no more often than every half
  /// second.
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
    Stamp known;  ///< as it was opened, written, or told of
    Stamp last;   ///< at the last look
  };
  static Stamp stamp_of(const std::string& file);

  std::vector<Watched> watched_;
  double next_ = 0;
};

}  // namespace taxel::studio
