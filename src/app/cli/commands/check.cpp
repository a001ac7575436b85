// taxel check: lists every problem of the given files.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "app/cli/commands/check_file.h"
#include "app/cli/layout_options.h"
#include "app/cli/report_writer.h"
#include "core/base/text/shown_message.h"

namespace taxel::cli {
namespace {

struct CheckOptions {
  std::vector<std::string> files;
  SkinChoice skin;
};

struct CheckReport {
  Problems problems;
  std::size_t files = 0;  ///< number of files

  void visit(ReportWriter& w) const {
    w.list("problems", problems, [](ReportWriter& problem, const Problem& p) {
      problem("file", p.file);
      problem("pointer", p.pointer);
      problem("severity", to_string(p.severity));
      problem("code", p.code);
      problem("message", shown_part(p.message));
      problem("fix", shown_part(p.fix));
    });
  }
  /// "FILE: POINTER: severity: message; fix" for each problem, and a line with their numbers.
  [[nodiscard]] std::string text() const {
    std::string text;
    for (const Problem& p : problems) {
      const std::string place = p.pointer.empty() ? "" : shown_part(p.pointer) + ": ";
      const std::string fix = p.fix.empty() ? "" : "; " + shown_part(p.fix);
      text += fmt::format("{}: {}{}: {}{}\n", p.file, place, to_string(p.severity), shown_part(p.message), fix);
    }
    const auto count = [&](Severity severity) {
      return std::count_if(problems.begin(), problems.end(), [&](const Problem& p) { return p.severity == severity; });
    };
    return text + fmt::format("{} file{}: {} errors, {} warnings, {} notes\n", files, files == 1 ? "" : "s",
                              count(Severity::error), count(Severity::warning), count(Severity::note));
  }
};

/// Checks all files, also after one that cannot be read.
int run_check_command(const CheckOptions& options, Console& console) {
  CheckReport report{{}, options.files.size()};
  Problems& problems = report.problems;
  bool is_unreadable = false;
  for (const std::string& file : options.files) {
    try {
      const Problems found = check_file(file, options.skin);
      problems.insert(problems.end(), found.begin(), found.end());
    } catch (const Error& e) {
      print_failure(e);
      problems.push_back(
          {e.file().empty() ? file : e.file(), e.where(), Severity::error, "unreadable", e.message(), ""});
      is_unreadable = true;
    }
  }
  print_report(console, report);
  const bool is_clean =
      std::all_of(problems.begin(), problems.end(), [](const Problem& p) { return p.severity == Severity::note; });
  return is_unreadable ? kBadInput : is_clean ? kDone : kProblemsFound;
}

}  // namespace

Run add_check(OptionList& list) {
  const auto options = std::make_shared<CheckOptions>();
  list.add("FILE", &options->files,
           "Files to check; exit status 1 if one has an error or a warning, 2 if one cannot be read", required());
  add_skin(list, options->skin);
  return [options](Console& console) { return run_check_command(*options, console); };
}

}  // namespace taxel::cli
