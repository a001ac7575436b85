// Bytes that another program writes into the standard input of this one.
#pragma once

#include <cstddef>
#include <string>

namespace taxel::os {

/// A buffered reader of the standard input. A process has at most one, and uses no other reader of it.
class StandardInput {
 public:
  enum class Result { done, waiting, ended };

  /// Takes the next line, without its newline, or returns `waiting` if none has come within a tenth of a second.
  /// Returns `ended` at the end of the input; the bytes of a last line without a newline are lost.
  Result take_line(std::string& line);
  /// Takes the next `size` bytes as take_line() takes a line.
  Result take_bytes(std::string& bytes, std::size_t size);

 private:
  Result take_more();

  std::string buffer_;
  std::size_t searched_ = 0;  // bytes of the buffer that have no newline
};

}  // namespace taxel::os
