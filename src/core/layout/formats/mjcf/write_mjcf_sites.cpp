// MuJoCo scenes with a site and a touch sensor for each taxel: for programs without the plugin.
#include <fmt/format.h>

#include <set>

#include "core/base/error.h"
#include "core/layout/formats/format_rows.h"
#include "core/layout/formats/losses.h"
#include "core/layout/formats/mjcf/mjcf_sites.h"
#include "core/layout/formats/text/number_words.h"

namespace taxel {
namespace {

constexpr HeldValues kHeldBySites{true, true, true, true, false, false, false, true};

std::string words(const dvec3& v) {
  return words_of_numbers({v.x, v.y, v.z});
}

/// The parts of a scene.
struct SitesScene {
  std::string assets, bodies, sensors;
  std::set<std::string> used;  ///< names of sites
  std::vector<std::string> notes;
};

/// Returns the taxel's name, or one that no other site has if that is empty or taken.
std::string take_site_name(SitesScene& scene, const std::string& body, const Taxel& taxel) {
  if (!taxel.name.empty() && scene.used.insert(taxel.name).second) return taxel.name;
  const std::string name = name_of_site(body, taxel.id);
  if (!scene.used.insert(name).second)
    throw Error("", fmt::format("taxel {}", taxel.id),
                fmt::format("there are two sites \"{}\": give it another id or name", name));
  if (!taxel.name.empty())
    scene.notes.push_back(
        fmt::format("taxel {}: another site is named \"{}\": its site is \"{}\"", taxel.id, taxel.name, name));
  return name;
}

void add_body(SitesScene& scene, const ImportedLayout& one, const std::string& number) {
  const Layout& layout = one.layout;
  const std::string body = layout.name.empty() ? "sensor" + number : layout.name;
  scene.bodies += fmt::format("    <body name=\"{}\">\n", xml_attribute(body));
  if (layout.mesh.file.empty()) {
    scene.notes.push_back(
        fmt::format("body \"{}\" has no geom, as its layout has no mesh: sites alone feel nothing", body));
  } else {
    scene.assets += fmt::format("    <mesh name=\"skin{}\" file=\"{}\" scale=\"{}\"/>\n", number,
                                xml_attribute(layout.mesh.file), words(layout.mesh.scale));
    const std::string geom = one.geom.empty() ? "skin" + number : one.geom;
    scene.bodies +=
        fmt::format("      <geom name=\"{}\" type=\"mesh\" mesh=\"skin{}\"/>\n", xml_attribute(geom), number);
  }
  for (const Taxel& taxel : layout.taxels) {
    if (taxel.id < 0) throw Error("", fmt::format("taxel {}", taxel.id), "must have an id of 0 or more");
    if (!(taxel.radius > 0)) throw Error("", fmt::format("taxel {}", taxel.id), "must have a radius greater than 0");
    const std::string name = xml_attribute(take_site_name(scene, body, taxel));
    scene.bodies += fmt::format("      <site name=\"{}\" pos=\"{}\" zaxis=\"{}\" size=\"{}\" user=\"{}\"/>\n", name,
                                words(taxel.center), words(taxel.normal), taxel.radius, taxel.id);
    scene.sensors += fmt::format("    <touch name=\"{}\" site=\"{}\"/>\n", name, name);
  }
  scene.bodies += "    </body>\n";
}

WrittenLayouts write_sites(const std::vector<ImportedLayout>& layouts) {
  check_taxels_to_write(layouts);
  require_normals(layouts, "a site");
  SitesScene scene;
  for (std::size_t i = 0; i < layouts.size(); ++i)
    add_body(scene, layouts[i], layouts.size() > 1 ? fmt::format(" {}", i + 1) : "");
  WrittenLayouts written{"<mujoco>\n", losses_in(layouts, kHeldBySites, "a scene with touch sites")};
  if (!scene.assets.empty()) written.bytes += "  <asset>\n" + scene.assets + "  </asset>\n";
  written.bytes +=
      "  <worldbody>\n" + scene.bodies + "  </worldbody>\n  <sensor>\n" + scene.sensors + "  </sensor>\n</mujoco>\n";
  written.notes.insert(written.notes.end(), scene.notes.begin(), scene.notes.end());
  written.notes.emplace_back(
      "a touch sensor sums the normal forces of MuJoCo's contacts inside its site; the size of a site is the radius, "
      "its first user value the id, and the mesh is that of the geom");
  return written;
}

}  // namespace

LayoutFormat mjcf_sites_format() {
  LayoutFormat format = mjcf_format();
  format.word = "mjcf-sites";
  format.name = "MuJoCo scene with touch sites";
  format.extensions = {".sites.xml"};
  format.holds = kHeldBySites;
  format.write = write_sites;
  return format;
}

}  // namespace taxel
