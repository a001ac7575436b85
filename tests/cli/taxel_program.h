// The program `taxel` for the tests of this folder, files for it, and sweeps that several tests share.
#pragma once

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "fixtures/read_npz.h"
#include "fixtures/run_program.h"

namespace taxel::test {

using Json = nlohmann::json;

/// Returns an empty folder for the running test.
std::filesystem::path test_folder();

/// Runs taxel in the given folder.
Outcome taxel(const std::vector<std::string>& arguments, const std::filesystem::path& folder = TAXEL_BINARY_DIR);

/// A `taxel` process in the background. Its stdout and stderr go to files in `folder`.
class Running {
 public:
  Running(const std::vector<std::string>& arguments, const std::filesystem::path& folder) : folder_(folder) {
    child_ = ::fork();
    if (child_ != 0) return;
    if (::chdir(folder.c_str()) != 0) ::_exit(125);
    ::dup2(::open("stdout.txt", O_WRONLY | O_CREAT | O_TRUNC, 0666), STDOUT_FILENO);
    ::dup2(::open("stderr.txt", O_WRONLY | O_CREAT | O_TRUNC, 0666), STDERR_FILENO);
    std::vector<char*> argv{const_cast<char*>(TAXEL_PROGRAM)};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    ::execv(TAXEL_PROGRAM, argv.data());
    ::_exit(126);
  }
  void send(int signal) const { ::kill(child_, signal); }
  /// Returns whether the process has ended. wait() then returns at once.
  [[nodiscard]] bool has_ended() const {
    siginfo_t info{};
    return ::waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid != 0;
  }
  /// Waits for the end of the process.
  Outcome wait() const {
    int status = 0;
    ::waitpid(child_, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), file_text(folder_ / "stdout.txt"),
            file_text(folder_ / "stderr.txt")};
  }

 private:
  std::filesystem::path folder_;
  pid_t child_ = 0;
};

/// Waits until `condition` is true, for at most a minute.
template <class Condition>
bool wait_until(const Condition& condition) {
  for (int i = 0; i < 6000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

/// Runs taxel, expects exit status 0, and parses its stdout.
Json taxel_json(std::vector<std::string> arguments, const std::filesystem::path& folder = TAXEL_BINARY_DIR);

/// Expects exit status 2, nothing on stdout, and exactly this line on stderr.
void expect_refusal(const Outcome& outcome, const std::string& line);

/// Return the layout of our fingertip, and a copy of it with one change (a JSON patch).
std::filesystem::path fingertip_layout();
std::filesystem::path changed_layout(const std::filesystem::path& folder, const Json& patch);

/// Makes a folder with our fingertip of 1e6 samples per m^2 and one change (a JSON patch), fingertip.taxels.json, and
/// the contact case of the golden test, case.json.
std::filesystem::path finger_on_box(const std::string& patch = "[]");

/// Returns the OBJ text of a box of half size `half` whose first corner is the file's vertex `first` (from 1): two
/// triangles on each side, in the order -z, +z, -y, +y, -x, +x, facing outward, or inward as the wall of a cavity.
/// Corner 1 + 2 bits: the corner at +x has bit 0 set, at +y bit 1, at +z bit 2.
std::string box_obj(double half, int first = 1, bool outward = true);

/// The columns of a CSV file by name.
using Table = std::map<std::string, std::vector<double>>;
Table read_csv(const std::filesystem::path& path);

/// The largest change of a taxel from a row of a recording to the next.
struct RecordedJump {
  int taxel = 0;        ///< id of the taxel
  double time = 0;      ///< time of the later row [s]
  std::size_t row = 0;  ///< index of the later row
  double before = 0, after = 0;
};
RecordedJump largest_jump(const std::filesystem::path& run);

/// Returns the output folder of `taxel sweep` with these options. The first test that needs it makes it; a changed
/// program makes it again.
std::filesystem::path shared_sweep(const std::vector<std::string>& options = {});

/// Returns the output folder of a short sweep over a box, which ends in contact.
std::filesystem::path shared_box_sweep(std::vector<std::string> options = {});

/// Returns the layout of the real fingertip, or an empty path if it is absent.
std::filesystem::path real_layout();
#define SKIP_WITHOUT_REAL_DATA()            \
  if (::taxel::test::real_layout().empty()) \
  GTEST_SKIP() << "shadow_fingertip.taxels.json is absent from " TAXEL_REAL_DATA

}  // namespace taxel::test
