#include "core/layout/formats/losses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace taxel {
namespace {

bool any_taxel(const std::vector<ImportedLayout>& layouts, bool (*has)(const Taxel&)) {
  return std::any_of(layouts.begin(), layouts.end(), [&](const ImportedLayout& one) {
    return std::any_of(one.layout.taxels.begin(), one.layout.taxels.end(), has);
  });
}

bool any_layout(const std::vector<ImportedLayout>& layouts, bool (*has)(const ImportedLayout&)) {
  return std::any_of(layouts.begin(), layouts.end(), has);
}

/// Returns true if a setting other than the density differs from its default, or is known.
bool has_settings(const ImportedLayout& one) {
  const Layout &layout = one.layout, defaults;
  Sampling sampling = layout.sampling;
  sampling.density = defaults.sampling.density;
  return one.has_frame || one.has_material || !layout.mesh.file.empty() || sampling != defaults.sampling ||
         layout.receptive_field != defaults.receptive_field || layout.readout != defaults.readout;
}

}  // namespace

bool are_ids_row_numbers(const std::vector<Taxel>& taxels) {
  for (std::size_t i = 0; i < taxels.size(); ++i)
    if (taxels[i].id != static_cast<int>(i)) return false;
  return true;
}

std::vector<std::string> losses_in(const std::vector<ImportedLayout>& layouts, const HeldValues& holds,
                                   const std::string& noun) {
  std::vector<std::string> lost;
  const auto lose = [&](bool is_lost, const std::string& values) {
    if (is_lost) lost.push_back(fmt::format("{} holds no {}", noun, values));
  };
  lose(!holds.settings && any_layout(layouts, has_settings),
       holds.density ? "mesh, receptive field rule, readout and material"
                     : "mesh, sampling, receptive field rule, readout and material");
  lose(!holds.settings && !holds.density && !any_layout(layouts, has_settings) &&
           any_layout(layouts, [](const ImportedLayout& one) { return one.has_density; }),
       "density of samples");
  lose(!holds.settings &&
           any_layout(layouts, [](const ImportedLayout& one) { return one.layout.calibration.has_value(); }),
       "calibration");
  lose(!holds.settings && any_layout(layouts, [](const ImportedLayout& one) { return !one.layout.unknown.empty(); }),
       "keys of other programs");
  lose(!holds.geom && any_layout(layouts, [](const ImportedLayout& one) { return !one.geom.empty(); }),
       "geom or link of the sensor");
  lose(!holds.ids &&
           any_layout(layouts, [](const ImportedLayout& one) { return !are_ids_row_numbers(one.layout.taxels); }),
       "ids: taxels are numbered by their order");
  lose(!holds.names && any_taxel(layouts, [](const Taxel& taxel) { return !taxel.name.empty(); }), "names of taxels");
  lose(!holds.normals && any_layout(layouts, [](const ImportedLayout& one) { return one.has_normals; }),
       "normals of taxels");
  lose(!holds.radii && any_layout(layouts, [](const ImportedLayout& one) { return one.has_radii(); }),
       "radii of taxels");
  lose(!holds.subtaxels && any_taxel(layouts, [](const Taxel& taxel) { return !taxel.subtaxels.empty(); }),
       "subtaxels");
  lose(!holds.settings && any_taxel(layouts, [](const Taxel& taxel) { return taxel.density > 0; }),
       "densities of taxels");
  return lost;
}

void check_taxels_to_write(const std::vector<ImportedLayout>& layouts) {
  for (const ImportedLayout& one : layouts) {
    if (one.cell > 0)
      throw Error(
          "", one.layout.name,
          fmt::format("lists no taxels but cells of {} m over a mesh: name the mesh with --mesh FILE", one.cell));
    if (one.layout.taxels.empty()) throw Error("", one.layout.name, "has no taxels to write");
    for (const Taxel& taxel : one.layout.taxels)
      if (!is_finite(taxel.center) || !is_finite(taxel.normal) || !std::isfinite(taxel.radius))
        throw Error("", fmt::format("taxel {}", taxel.id), "must be finite to be written");
  }
}

void require_normals(const std::vector<ImportedLayout>& layouts, const std::string& noun) {
  for (const ImportedLayout& one : layouts) {
    if (!one.has_normals)
      throw Error("", one.layout.name,
                  fmt::format("has no normals, which {} needs: name the mesh that gives them with --mesh FILE", noun));
    for (const Taxel& taxel : one.layout.taxels)
      if (!(glm::dot(taxel.normal, taxel.normal) > 0))
        throw Error("", fmt::format("taxel {}", taxel.id), "has a normal of length 0");
  }
}

}  // namespace taxel
