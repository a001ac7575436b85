// Repairs of the problems that layout_check lists, one by one or all together.
//
// Repairing all goes in rounds: each applies at most one repair per taxel or setting and checks the project again,
// since a repair may solve another problem or uncover one. A repair that was tried at a place once is not tried there
// again, so the rounds end, at the latest after 32. Changes of taxels are merged into two edits per round, one that
// mirrored taxels follow and one that they do not. Problems that need a decision, such as another file or unit, are
// left to the user.
#include "core/document/fixes.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <utility>

#include "core/document/edit.h"
#include "core/layout/check/layout_check.h"
#include "core/layout/layout_fields.h"
#include "core/layout/sampling/poisson_disk.h"
#include "core/layout/words.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel {
namespace {

/// Returns the absolute value of a number, or the default if the number is not finite.
double without_sign(double v, double otherwise) {
  return std::isfinite(v) ? std::abs(v) : otherwise;
}

std::optional<Fix> fix_of_material(const Problem& problem, Material material) {
  const Material usual = Layout().material;
  const auto mended = [&](const char* what, double Material::*value) {
    material.*value = without_sign(material.*value, usual.*value);
    return Fix{fmt::format("Set the {} to {}", what, material.*value), SetMaterial{material}};
  };
  if (problem.code == "modulus_negative") return mended("modulus", &Material::modulus);
  if (problem.code == "thickness_negative") return mended("thickness", &Material::thickness);
  if (problem.code == "dissipation_negative") return mended("dissipation", &Material::dissipation);
  if (problem.code == "friction_negative") return mended("friction", &Material::friction);
  if (problem.code == "stiffness_negative") return mended("tangential stiffness", &Material::tangential_stiffness);
  if (problem.code == "stiffness_of_rigid") {
    material.tangential_stiffness = 0;
    return Fix{"Set the tangential stiffness to 0: friction is regularised", SetMaterial{material}};
  }
  if (problem.code == "bristles_out_of_range") {
    material.bristles = std::clamp(material.bristles, 1, kMostBristles);
    return Fix{fmt::format("Set the number of bristles to {}", material.bristles), SetMaterial{material}};
  }
  if (problem.code == "law_invalid") {
    material.law = {};
    return Fix{"Use the linear pressure law", SetMaterial{material}};
  }
  if (problem.code != "not_available") return std::nullopt;
  material.field = usual.field;
  return Fix{fmt::format("Use the field \"{}\"", to_word(usual.field)), SetMaterial{material}};
}

std::optional<Fix> fix_of_sampling(const Problem& problem, Sampling sampling, const MeshIndex* skin) {
  const double usual = Sampling().density, most = skin != nullptr ? kMaxSamples / skin->mesh().area() : usual;
  if (problem.code == "density_too_high") {
    const double digits = std::pow(10.0, std::floor(std::log10(most)) - 1.0);
    sampling.density = std::floor(most / digits) * digits;  // two digits, rounded down
  } else if (problem.code == "density_not_positive" || problem.code == "density_too_low") {
    sampling.density = std::min(usual, most);
  } else if (problem.code.starts_with("region_")) {
    return Fix{"Clear the painted region: the whole skin senses", SetRegion{}};
  } else {
    return std::nullopt;
  }
  return Fix{fmt::format("Set the density to {:g} per square metre", sampling.density), SetSampling{sampling}};
}

/// Returns a frame with `pad` at right angles to `distal`, turned as little as possible.
std::optional<Fix> fix_of_frame(const Problem& problem, SensorFrame frame) {
  if (problem.code != "frame_parallel" && problem.code != "frame_skew") return std::nullopt;
  const dvec3 along = glm::normalize(frame.distal);
  const dvec3 across = frame.pad - glm::dot(frame.pad, along) * along;
  frame.pad = problem.code == "frame_skew" ? glm::normalize(across) : any_perpendicular(along);
  return Fix{fmt::format("Turn pad to [{:.3g}, {:.3g}, {:.3g}], at right angles to distal", frame.pad.x, frame.pad.y,
                         frame.pad.z),
             SetFrame{frame}};
}

std::optional<Fix> fix_of_mesh(const Problem& problem, const Project& project, const MeshIndex* skin,
                               const std::string& sha256) {
  ReplaceMesh edit{project.layout.mesh, *project.layout.sampling.region};
  if (problem.code == "mesh_changed" && !sha256.empty()) {
    edit.mesh.sha256 = sha256;
    edit.region.clear();
    return Fix{project.layout.sampling.region->empty() ? "Take the mesh as it is now"
                                                       : "Take the mesh as it is now; the painted region is cleared",
               edit};
  }
  if (problem.code == "mesh_units" && skin != nullptr) {
    const UnitGuess guess = guess_unit(skin->mesh());
    if (guess.scale == 1.0) return std::nullopt;
    edit.mesh.scale *= guess.scale;
    return Fix{fmt::format("Read the mesh in {}", guess.unit), edit};
  }
  RepairRecipe repair = project.layout.mesh.repair;
  if (problem.code == "mesh_open" && repair.level != RepairLevel::automatic) {
    repair.level = RepairLevel::automatic;
    return Fix{"Repair the mesh", SetRepair{repair}};
  }
  if (problem.code == "repair_out_of_range") {
    for_each_field<RepairRecipe>([&](const LayoutField& field, auto member) {
      if (problem.pointer.ends_with(std::string("/") + field.spec.key)) repair.*member = RepairRecipe{}.*member;
    });
    return Fix{"Set it to its default", SetRepair{repair}};
  }
  if (problem.code != "scale_zero") return std::nullopt;
  for (int axis = 0; axis < 3; ++axis)
    if (edit.mesh.scale[axis] == 0.0 || !std::isfinite(edit.mesh.scale[axis])) edit.mesh.scale[axis] = 1.0;
  return Fix{"Set the scale to 1", edit};
}

/// Returns the repair of centres in mm. A radius that is larger than the mesh is read in mm too.
std::optional<Fix> fix_of_units(const Layout& layout, const MeshIndex* skin) {
  if (skin == nullptr) return std::nullopt;
  constexpr double kMillimetre = 0.001;
  const double size = skin->mesh().bounds().diagonal();
  const auto radius_of = [&](double radius) { return radius > size ? kMillimetre * radius : radius; };
  SetTaxels edit{{}, false};
  for (const Taxel& taxel : layout.taxels) {
    TaxelChange change;
    change.id = taxel.id;
    change.center = kMillimetre * taxel.center;
    change.radius = radius_of(taxel.radius);
    if (!taxel.subtaxels.empty()) {
      change.subtaxels = taxel.subtaxels;
      for (Subtaxel& subtaxel : *change.subtaxels) {
        subtaxel.center *= kMillimetre;
        subtaxel.radius = radius_of(subtaxel.radius);
      }
    }
    edit.changes.push_back(std::move(change));
  }
  return Fix{"Read the centres in mm", std::move(edit)};
}

std::optional<Fix> fix_of_settings(const Problem& problem, const Layout& layout) {
  if (problem.code == "angle_out_of_range") {
    ReceptiveFieldRule rule = layout.receptive_field;
    rule.max_angle_deg = ReceptiveFieldRule().max_angle_deg;
    // A roll-off that is wider than the new angle would be refused with it.
    const bool fits = rule.angle_falloff_deg >= 0 && rule.angle_falloff_deg <= rule.max_angle_deg;
    if (!fits) rule.angle_falloff_deg = 0.0;
    return Fix{fmt::format("Set the largest angle to {} degrees{}", rule.max_angle_deg,
                           fits ? "" : " and the roll-off to 0 degrees"),
               SetReceptiveField{rule}};
  }
  if (problem.code == "falloff_out_of_range") {
    ReceptiveFieldRule rule = layout.receptive_field;
    rule.angle_falloff_deg = 0.0;
    return Fix{"Set the roll-off to 0 degrees", SetReceptiveField{rule}};
  }
  Readout readout = layout.readout;
  if (problem.code == "method_not_available") {
    readout.method = ReadingMethod::samples;
    return Fix{"Set the method to \"samples\"", SetReadout{readout}};
  }
  if (problem.code == "depth_negative") {
    readout.max_depth = without_sign(readout.max_depth, Readout().max_depth);
    return Fix{fmt::format("Set the largest depth to {} m", readout.max_depth), SetReadout{readout}};
  }
  if (problem.code == "ray_unused" || problem.code == "method_needs_surface_rays") {
    readout.ray = RayDirection::surface_normal;
    return Fix{"Set the rays to the surface's normals", SetReadout{readout}};
  }
  return std::nullopt;
}

std::optional<Fix> fix_of_calibration(const Problem& problem, const Layout& layout) {
  if (problem.code != "calibration_unused" || !layout.calibration) return std::nullopt;
  const std::string start = "/calibration/taxels/";
  std::size_t index = 0;
  const char* const end = problem.pointer.data() + problem.pointer.size();
  if (!problem.pointer.starts_with(start) ||
      std::from_chars(problem.pointer.data() + start.size(), end, index).ec != std::errc() ||
      index >= layout.calibration->taxels.size())
    return std::nullopt;
  Calibration calibration = *layout.calibration;
  const int id = calibration.taxels[index].id;
  calibration.taxels.erase(calibration.taxels.begin() + static_cast<std::ptrdiff_t>(index));
  return Fix{fmt::format("Remove the calibration of taxel {}, which is not there", id), SetCalibration{calibration}};
}

}  // namespace

std::optional<Fix> fix_for(const Problem& problem, const Project& project, const MeshIndex* skin,
                           const std::string& mesh_sha256) {
  const Layout& layout = project.layout;
  const auto below = [&](const char* pointer) { return problem.pointer.starts_with(pointer); };
  if (problem.code == "centers_in_mm") return fix_of_units(layout, skin);
  if (below("/taxels/")) return fix_of_taxel(problem, project, skin);
  if (below("/material/")) return fix_of_material(problem, layout.material);
  if (below("/sampling/")) return fix_of_sampling(problem, layout.sampling, skin);
  if (below("/frame/")) return fix_of_frame(problem, layout.frame);
  if (below("/mesh/")) return fix_of_mesh(problem, project, skin, mesh_sha256);
  if (below("/calibration/")) return fix_of_calibration(problem, layout);
  return fix_of_settings(problem, layout);
}

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
