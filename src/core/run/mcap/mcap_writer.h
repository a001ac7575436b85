// Writes MCAP files, version 0 (https://mcap.dev/spec): messages with times on channels, in compressed chunks with
// checksums, indices and a summary, so that readers find any channel and time without reading the whole file.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/run/mcap/crc32.h"
#include "core/run/mcap/mcap_record.h"

namespace taxel {

/// A stream of messages of one type.
struct McapChannel {
  std::uint16_t schema = 0;  ///< result of McapWriter::add_schema()
  std::string topic;
  std::string encoding;  ///< encoding of the messages, such as "cdr"
  McapMap metadata;
};

/// Writes one file from its begin to its end. Equal calls give equal bytes. Schemas and channels are added before the
/// messages that use them. Texts are UTF-8. Times are in nanoseconds.
class McapWriter {
 public:
  /// Receives the bytes of the file, piece by piece.
  using Sink = std::function<void(std::string_view bytes)>;

  /// Writes the begin of a file. `profile` is "ros2" or empty, `library` names the writing program.
  McapWriter(std::string_view profile, std::string_view library, Sink sink);

  /// Adds the definition of a type of messages and returns its number. Throws Error if there are 65535 already.
  std::uint16_t add_schema(std::string_view name, std::string_view encoding, std::string_view definition);
  /// Adds a channel and returns its number. Throws Error if there are 65536 already.
  std::uint16_t add_channel(const McapChannel& channel);
  /// Adds a message; the messages of a channel are numbered from 0. The times may be in any order. Throws Error if
  /// Zstandard fails.
  void add_message(std::uint16_t channel, std::uint64_t time, std::string_view bytes);
  /// Adds a whole file, with the time 0.
  void add_attachment(std::string_view name, std::string_view media_type, std::string_view bytes);
  void add_metadata(std::string_view name, const McapMap& metadata);
  /// Writes the indices and the end of the file. No other function may be called afterwards.
  void finish();

 private:
  /// Times of messages; both are 0 without messages.
  struct TimeRange {
    std::uint64_t first = 0, last = 0;
    std::uint64_t messages = 0;
    void add(std::uint64_t time);
  };
  /// Records that are compressed together.
  struct Chunk {
    std::string records;
    std::map<std::uint16_t, std::string> index;  ///< times and offsets of the messages, by channel
    TimeRange times;
  };
  /// Finished records of the summary, by kind.
  struct Summary {
    std::string schemas, channels, chunks, attachments, metadata;
  };
  struct Counts {
    std::vector<std::uint64_t> messages;  ///< by channel
    std::uint16_t schemas = 0;
    std::uint32_t chunks = 0, attachments = 0, metadata = 0;
    TimeRange times;
  };

  void put(std::string_view bytes);
  void end_chunk();
  [[nodiscard]] std::string statistics() const;
  void put_summary();

  Sink sink_;
  std::uint64_t offset_ = 0;  // number of bytes written
  Crc32 crc_;                 // of all bytes written
  Chunk chunk_;
  Summary summary_;
  Counts counts_;
};

}  // namespace taxel
