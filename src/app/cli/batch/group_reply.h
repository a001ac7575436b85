// The answer of another program to a group that it was given to run.
#pragma once

#include <cstddef>
#include <string>

namespace taxel::cli {

/// {"group": ID, "bytes": N} with the N bytes of a shard behind the line, or {"group": ID, "error": REASON}.
struct GroupReply {
  std::string group;
  std::size_t bytes = 0;  ///< size of the shard that follows
  std::string error;      ///< reason why all jobs of the group fail; empty with a shard
};

/// Throws Error("", JSON pointer, ...) if the line is not a reply.
GroupReply parse_group_reply(const std::string& line);

}  // namespace taxel::cli
