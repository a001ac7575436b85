// taxel check: every problem of the files given.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "app/cli/check_file.h"
#include "app/cli/check_report.h"
#include "app/cli/command.h"

namespace taxel::cli {

std::string problems_text(const Problems& problems, int files) {
  std::string text;
  for (const Problem& p : problems) {
    const std::string place = p.pointer.empty() ? "" : p.pointer + ": ";
    const std::string fix = p.fix.empty() ? "" : "; " + p.fix;
    text += fmt::format("{}: {}{}: {}{}\n", p.file, place, to_string(p.severity), p.message, fix);
  }
  const auto count = [&](Severity severity) {
    return std::count_if(problems.begin(), problems.end(), [&](const Problem& p) { return p.severity == severity; });
  };
  return text + fmt::format("{} file{}: {} errors, {} warnings, {} notes\n", files, files == 1 ? "" : "s",
                            count(Severity::error), count(Severity::warning), count(Severity::note));
}

namespace {

/// Goes on after a file that cannot be read: the others are still checked.
int run(const std::vector<std::string>& files, const SkinChoice& skin, Console& console) {
  Problems problems;
  bool unreadable = false;
  for (const std::string& file : files) {
    try {
      const Problems found = check_file(file, skin);
      problems.insert(problems.end(), found.begin(), found.end());
    } catch (const Error& e) {
      print_failure(e.what());
      problems.push_back(
          {e.file().empty() ? file : e.file(), e.where(), Severity::error, "unreadable", e.message(), ""});
      unreadable = true;
    }
  }
  console.result(console.json() ? problems_json(problems) : problems_text(problems, static_cast<int>(files.size())));
  const bool clean =
      std::all_of(problems.begin(), problems.end(), [](const Problem& p) { return p.severity == Severity::note; });
  return unreadable ? kBadInput : clean ? kDone : kProblemsFound;
}

}  // namespace

Command add_check(CLI::App& parent, CommonOptions& common) {
  const auto files = std::make_shared<std::vector<std::string>>();
  const auto skin = std::make_shared<SkinChoice>();
  CLI::App* app =
      add_command(parent, common, "check",
                  "Every problem of layouts, contact cases, sweeps, meshes and scenes, with its JSON pointer",
                  "taxel check finger.taxels.json");
  app->add_option("FILE", *files,
                  "Files to check; exit status 1 when one has an error or a warning, 2 when one cannot be read")
      ->required()
      ->option_text("(required)");
  add_skin(*app, *skin);
  return {app, [files, skin](Console& console) { return run(*files, *skin, console); }};
}

}  // namespace taxel::cli
