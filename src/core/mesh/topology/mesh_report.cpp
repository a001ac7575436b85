#include "core/mesh/topology/mesh_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/mesh/topology/mesh_check.h"

namespace taxel {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 9> kMeanings{{
    {"mesh_open",
     "The surface has no inside there. A repair closes it when the mesh is used (Inspector > Mesh); the file does not "
     "change."},
    {"mesh_nonmanifold",
     "Inside and outside are not defined there. A repair removes loose faces, and separates parts that touch."},
    {"mesh_winding",
     "Inside and outside are exchanged there. A repair reverses the faces, or wraps the mesh if that is not possible."},
    {"mesh_inverted",
     "Samples and the normals of placed taxels point into the body, so readings would be 0. Reverse the faces."},
    {"mesh_cavity", "Its wall cannot be touched: it has no samples, and rays from the skin end halfway to it."},
    {"mesh_shells",
     "Each shell is a separate skin: samples are on all of them, and distances along the surface do not cross from one "
     "shell to another."},
    {"mesh_self_intersection",
     "Skin inside other parts has samples but cannot be touched, and pressures near it are too high."},
    {"mesh_units", "Radii and densities are in metres: with the wrong unit no receptive field fits the mesh."},
    {"mesh_repaired", "Done while reading; the file does not change."},
}};

std::string meaning_of(std::string_view code) {
  const auto* const found =
      std::find_if(kMeanings.begin(), kMeanings.end(), [&](const auto& entry) { return entry.first == code; });
  return found == kMeanings.end() ? std::string() : std::string(found->second);
}

MeshFindings report_of(const Problems& problems, const std::vector<std::string>& notes) {
  MeshFindings findings;
  for (const Problem& problem : problems)
    findings.push_back({problem.severity, problem.code, problem.message, meaning_of(problem.code)});
  std::stable_sort(findings.begin(), findings.end(),
                   [](const MeshFinding& a, const MeshFinding& b) { return a.severity > b.severity; });
  const std::string_view repaired = "mesh_repaired";
  for (const std::string& note : notes)
    findings.push_back({Severity::note, std::string(repaired), note, meaning_of(repaired)});
  return findings;
}

}  // namespace

MeshFindings mesh_report(const TriMesh& mesh, const std::vector<std::string>& notes) {
  return report_of(check_mesh(mesh, ""), notes);
}

MeshFindings mesh_report(const MeshIndex& index, const std::vector<std::string>& notes) {
  return report_of(check_mesh(index, ""), notes);
}

std::string count_findings(const MeshFindings& findings) {
  std::string text;
  for (const Severity severity : {Severity::error, Severity::warning, Severity::note}) {
    const auto count = std::count_if(findings.begin(), findings.end(),
                                     [&](const MeshFinding& finding) { return finding.severity == severity; });
    if (count > 0)
      text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", count, to_string(severity), count == 1 ? "" : "s");
  }
  return text;
}

}  // namespace taxel
