// The output of a command on a terminal. A pseudo-terminal replaces stderr.
#include "app/cli/console.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <unistd.h>

#include <array>

namespace taxel::cli {
namespace {

/// Makes stderr a terminal during the lifetime of the object, on a machine that has one.
class Terminal {
 public:
  Terminal() : stderr_(dup(STDERR_FILENO)) {
    if (openpty(&reader_, &writer_, nullptr, nullptr, nullptr) == 0) dup2(writer_, STDERR_FILENO);
  }
  ~Terminal() {
    dup2(stderr_, STDERR_FILENO);
    for (const int file : {stderr_, reader_, writer_}) close(file);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  [[nodiscard]] bool is_open() const { return writer_ >= 0; }
  /// Returns the text that was displayed since the last call.
  [[nodiscard]] std::string shown() const {
    std::string text;
    std::array<char, 4096> buffer;
    pollfd ready{reader_, POLLIN, 0};
    while (poll(&ready, 1, 20) == 1 && (ready.revents & POLLIN) != 0) {
      const ssize_t count = read(reader_, buffer.data(), buffer.size());
      if (count <= 0) break;
      text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return text;
  }

 private:
  int stderr_ = -1, reader_ = -1, writer_ = -1;
};

constexpr const char* no_terminal = "no pseudo-terminal can be opened: is /dev/pts mounted?";

TEST(Console, ShowsABarOnATerminal) {
  const Terminal terminal;
  if (!terminal.is_open()) GTEST_SKIP() << no_terminal;
  Console console(CommonOptions{});
  console.progress(0.25);
  EXPECT_EQ(terminal.shown(), "\r[##########..............................]  25 %");
  console.progress(0.2501);
  EXPECT_EQ(terminal.shown(), "") << "the same percent";
  console.progress(0.5);
  EXPECT_EQ(terminal.shown(), "\r[####################....................]  50 %");
  console.note("half");
  EXPECT_EQ(terminal.shown(), "\r" + std::string(48, ' ') + "\rtaxel: note: half\r\n") << "on an empty line";
  console.progress(0.99);
  EXPECT_EQ(terminal.shown().substr(41), ".]  99 %");
  console.progress(1);
  EXPECT_EQ(terminal.shown(), "\r" + std::string(48, ' ') + "\r") << "the bar is cleared";
  console.progress(1);
  EXPECT_EQ(terminal.shown(), "");
}

TEST(Console, ShowsTheTextOfABarWithinEightyColumns) {
  const Terminal terminal;
  if (!terminal.is_open()) GTEST_SKIP() << no_terminal;
  Console console(CommonOptions{});
  console.progress(0.25, "50 of 200 jobs");
  EXPECT_EQ(terminal.shown(), "\r[#####...............]  25 %  50 of 200 jobs");
  console.progress(0.25, "51 jobs");
  EXPECT_EQ(terminal.shown(), "\r[#####...............]  25 %  51 jobs       ") << "blanks over the longer text";
  console.progress(0.5, std::string(500, 'x'));
  EXPECT_EQ(terminal.shown().size(), 79u) << "one row, after the return to its begin";
  console.progress(1);
  EXPECT_EQ(terminal.shown(), "\r" + std::string(78, ' ') + "\r");
}

TEST(Console, ShowsNoBarAndNoMessageIfQuiet) {
  const Terminal terminal;
  if (!terminal.is_open()) GTEST_SKIP() << no_terminal;
  Console console({.json = false, .quiet = true, .threads = 0});
  for (const double fraction : {0.0, 0.25, 0.5, 1.0}) console.progress(fraction);
  console.note("unheard");
  console.warn("unheard");
  EXPECT_EQ(terminal.shown(), "");
  print_failure("an error\nof two lines");
  EXPECT_EQ(terminal.shown(), "taxel: an error of two lines\r\n") << "errors excepted";
}

TEST(Console, ShowsNoBarInAFile) {
  testing::internal::CaptureStderr();
  Console console(CommonOptions{});
  console.progress(0.25);
  console.warn("hot");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "taxel: warning: hot\n");
}

}  // namespace
}  // namespace taxel::cli
