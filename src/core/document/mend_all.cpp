#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "core/document/apply_edit.h"
#include "core/document/fixes.h"
#include "core/layout/check/layout_check.h"

namespace taxel {
namespace {

/// Largest number of rounds. A round repairs one value of each taxel: its centre, normal or radius, or one of its
/// subtaxels.
constexpr int kRounds = 32;

/// Returns the errors and warnings of `project`. `mesh` belongs to the project `before` any repair.
Problems problems_of(const Project& project, const Project& before, const LayoutMesh& mesh) {
  Problems problems = check_layout_values(project.layout, "");
  const bool repairs = project.layout.mesh.repair != before.layout.mesh.repair;
  Problems on_skin = check_layout_on_skin(project.layout, mesh, "", "");
  problems.insert(problems.end(), std::make_move_iterator(on_skin.begin()), std::make_move_iterator(on_skin.end()));
  std::erase_if(problems, [&](const Problem& problem) {
    return problem.severity == Severity::note || (repairs && problem.code == "mesh_open");
  });
  return problems;
}

/// Returns true if the user must decide: about another file, unit or mesh, but not about a repair of the mesh.
bool is_decision(const Problem& problem) {
  return problem.pointer.starts_with("/mesh") && problem.code != "mesh_open" && problem.code != "repair_out_of_range";
}

/// The owner of a problem (a taxel's id, or the settings at a pointer), and the place in the owner.
struct Subject {
  std::string whose, place;
};
Subject subject_of(const Problem& problem, const Layout& layout) {
  const std::optional<std::size_t> index = taxel_of_pointer(problem.pointer);
  if (!index || *index >= layout.taxels.size()) return {problem.pointer, ""};
  const std::string start = fmt::format("/taxels/{}", *index);
  return {fmt::format("taxel {}", layout.taxels[*index].id), problem.pointer.substr(start.size())};
}

class Mender {
 public:
  Mender(const Project& project, const LayoutMesh& mesh) : before_(project), project_(project), mesh_(mesh) {}

  Mending mend() {
    Problems problems = problems_of(project_, before_, mesh_);
    const std::size_t before = problems.size();
    for (int round = 0; round < kRounds && mend_some(problems); ++round)
      problems = problems_of(project_, before_, mesh_);
    Mending mending;
    mending.mended = static_cast<int>(before) - static_cast<int>(problems.size());
    mending.left = std::move(problems);
    if (!edits_.empty())
      mending.edit = ApplyAll{before == 1 ? "Fix a problem" : "Fix all problems",
                              std::make_shared<const EditList>(EditList{std::move(edits_)})};
    return mending;
  }

 private:
  /// Applies one repair for each taxel and setting. Returns true if there was any.
  bool mend_some(const Problems& problems) {
    std::set<std::string> mended;
    std::vector<Edit> round;
    for (const Problem& problem : problems) {
      const Subject subject = subject_of(problem, project_.layout);
      if (is_decision(problem) || mended.contains(subject.whose)) continue;
      std::optional<Fix> fix = fix_for(problem, project_, &mesh_.skin);
      // A repair that failed once fails again.
      if (!fix || !tried_.insert(subject.whose + subject.place + " " + problem.code).second) continue;
      mended.insert(subject.whose);
      round.push_back(std::move(fix->edit));
    }
    bool any = false;
    for (Edit& edit : together(std::move(round))) any = take(std::move(edit)) || any;
    return any;
  }

  /// Merges the changes of taxels into two edits, because a layout has thousands of taxels: one that mirrored taxels
  /// follow, and one that they do not.
  static std::vector<Edit> together(std::vector<Edit> edits) {
    std::vector<Edit> rest;
    SetTaxels followed{{}, true}, alone{{}, false};
    for (Edit& edit : edits) {
      if (auto* set = std::get_if<SetTaxels>(&edit)) {
        auto& changes = set->twins_follow ? followed.changes : alone.changes;
        changes.insert(changes.end(), set->changes.begin(), set->changes.end());
      } else {
        rest.push_back(std::move(edit));
      }
    }
    if (!alone.changes.empty()) rest.insert(rest.begin(), std::move(alone));
    if (!followed.changes.empty()) rest.insert(rest.begin(), std::move(followed));
    return rest;
  }

  bool take(Edit edit) {
    try {
      project_ = apply_edit(project_, edit);
    } catch (const Error&) {
      return false;  // another problem of the same place prevents it, and is reported
    }
    edits_.push_back(std::move(edit));
    return true;
  }

  const Project& before_;
  Project project_;
  const LayoutMesh& mesh_;
  std::vector<Edit> edits_;
  std::set<std::string> tried_;
};

}  // namespace

Mending mend_all(const Project& project, const LayoutMesh& mesh) {
  return Mender(project, mesh).mend();
}

}  // namespace taxel
