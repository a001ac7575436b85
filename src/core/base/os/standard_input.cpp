#include "core/base/os/standard_input.h"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <vector>

namespace taxel::os {
namespace {

constexpr int kWaitMilliseconds = 100;
constexpr std::size_t kPartBytes = std::size_t{1} << 16U;

}  // namespace

/// Adds the bytes that are there to the buffer.
StandardInput::Result StandardInput::take_more() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (::poll(&input, 1, kWaitMilliseconds) <= 0) return Result::waiting;
  std::vector<char> part(kPartBytes);
  const ssize_t count = ::read(STDIN_FILENO, part.data(), part.size());
  if (count < 0 && (errno == EINTR || errno == EAGAIN)) return Result::waiting;
  if (count <= 0) return Result::ended;
  buffer_.append(part.data(), static_cast<std::size_t>(count));
  return Result::done;
}

StandardInput::Result StandardInput::take_line(std::string& line) {
  for (;;) {
    const std::size_t end = buffer_.find('\n', searched_);
    if (end != std::string::npos) {
      line = buffer_.substr(0, end);
      buffer_.erase(0, end + 1);
      searched_ = 0;
      return Result::done;
    }
    searched_ = buffer_.size();
    if (const Result result = take_more(); result != Result::done) return result;
  }
}

StandardInput::Result StandardInput::take_bytes(std::string& bytes, std::size_t size) {
  while (buffer_.size() < size)
    if (const Result result = take_more(); result != Result::done) return result;
  bytes = buffer_.substr(0, size);
  buffer_.erase(0, size);
  searched_ = 0;
  return Result::done;
}

}  // namespace taxel::os
