// Touch sites of MuJoCo scenes as taxels, and scenes with a site and a touch sensor for each taxel: for programs
// without the plugin.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/layout/formats/layout_format.h"
#include "core/layout/formats/mjcf.h"
#include "core/layout/formats/text.h"

namespace taxel {
namespace {

constexpr double kDefaultSiteSize = 0.005;  ///< MuJoCo's radius of a site without a size [m]

/// A site of the scene.
struct FoundSite {
  XmlNode node;
  std::string body, geom;
};

constexpr const char* kOnlyCompiled =
    "is known only of the compiled scene: `taxel convert` compiles scenes by their file";

/// Returns the name of the geom of a body that has only one, otherwise an empty text.
std::string only_geom(const XmlNode& body) {
  const std::vector<XmlNode> geoms = body.children("geom");
  return geoms.size() == 1 ? geoms.front().text_or_empty("name") : "";
}

/// Adds the named sites of a body and of all bodies below it. The parser bounds the depth.
void collect_sites(const XmlNode& body, const std::string& name, const std::string& geom,
                   std::map<std::string, FoundSite>& sites) {
  for (const XmlNode& child : body.children()) {
    if (child.name() == "site" && child.find("name"))
      sites.try_emplace(child.text("name"), FoundSite{child, name, geom});
    if (child.name() == "body") collect_sites(child, child.text_or_empty("name"), only_geom(child), sites);
    if (child.name() == "frame") collect_sites(child, name, geom, sites);
    for (const char* key : {"pos", "quat", "axisangle", "xyaxes", "zaxis", "euler", "childclass"})
      if (child.find(key) && (child.name() == "frame" || std::string_view(key) == "childclass"))
        child.fail(kOnlyCompiled, key);
  }
}

/// Returns the z axis of a site; nothing if the site has no orientation that is read here.
std::optional<dvec3> axis_of(const XmlNode& site) {
  dvec3 axis(0);
  if (site.find("zaxis")) {
    axis = site.vector("zaxis", axis);
  } else if (site.find("quat")) {
    const std::vector<double> q = site.numbers("quat", 4, 4);  // w x y z
    axis = {2 * (q[1] * q[3] + q[0] * q[2]), 2 * (q[2] * q[3] - q[0] * q[1]),
            q[0] * q[0] - q[1] * q[1] - q[2] * q[2] + q[3] * q[3]};
  } else if (site.find("xyaxes")) {
    const std::vector<double> v = site.numbers("xyaxes", 6, 6);
    axis = glm::cross(dvec3(v[0], v[1], v[2]), dvec3(v[3], v[4], v[5]));
  } else {
    return std::nullopt;
  }
  if (!(glm::dot(axis, axis) > 0) || !is_finite(axis))
    site.fail("has an orientation of length 0 or of no finite length");
  return axis;
}

/// Returns the size of sites in the scene's main default class, if there is one.
std::optional<double> default_size(const XmlNode& mujoco) {
  const std::optional<XmlNode> defaults = mujoco.child("default");
  const std::optional<XmlNode> site = defaults ? defaults->child("site") : std::nullopt;
  if (!site || !site->find("size")) return std::nullopt;
  return site->numbers("size", 1, 3).front();
}

void add_site(ImportedLayout& imported, const FoundSite& site, const std::string& name, double size) {
  for (const char* key : {"axisangle", "euler", "fromto", "class"})
    if (site.node.find(key)) site.node.fail(kOnlyCompiled, key);
  Taxel taxel;
  taxel.id = static_cast<int>(imported.layout.taxels.size());
  taxel.name = name;
  taxel.center = site.node.vector("pos", dvec3(0));
  if (site.node.find("size")) size = site.node.numbers("size", 1, 3).front();
  if (!(size > 0)) site.node.fail(fmt::format("must be greater than 0, is {}", size), "size");
  taxel.radius = size;
  const std::optional<dvec3> axis = axis_of(site.node);
  taxel.normal = axis.value_or(dvec3(0));
  imported.has_normals = imported.has_normals && axis;
  imported.layout.taxels.push_back(std::move(taxel));
}

}  // namespace

std::string name_of_site(const std::string& body, int id) {
  return fmt::format("{} taxel {}", body, id);
}

void take_site_ids(ImportedLayout& imported, const std::vector<double>& first_user) {
  constexpr double kMostId = 2e9;
  std::vector<Taxel>& taxels = imported.layout.taxels;
  const auto is_id = [&](double value) { return value >= 0 && value <= kMostId && value == std::floor(value); };
  const std::set<double> different(first_user.begin(), first_user.end());
  if (different.size() != taxels.size() || first_user.size() != taxels.size() ||
      !std::all_of(first_user.begin(), first_user.end(), is_id))
    return;
  for (std::size_t i = 0; i < taxels.size(); ++i) {
    taxels[i].id = static_cast<int>(first_user[i]);
    if (taxels[i].name == name_of_site(imported.layout.name, taxels[i].id)) taxels[i].name.clear();
  }
  imported.notes.emplace_back("ids are the first user values of the sites");
}

std::vector<ImportedLayout> touch_sites(const XmlNode& mujoco) {
  const std::vector<XmlNode> lists = mujoco.children("sensor");
  if (std::none_of(lists.begin(), lists.end(), [](const XmlNode& list) { return list.child("touch").has_value(); }))
    return {};
  std::map<std::string, FoundSite> sites;
  for (const XmlNode& world : mujoco.children("worldbody")) collect_sites(world, "world", only_geom(world), sites);
  const double size = default_size(mujoco).value_or(kDefaultSiteSize);
  std::vector<ImportedLayout> layouts;
  std::map<std::string, std::vector<double>> users;  // first user values, by body
  for (const XmlNode& list : lists) {
    for (const XmlNode& touch : list.children("touch")) {
      const std::string name = touch.text("site");
      const auto site = sites.find(name);
      if (site == sites.end()) touch.fail(fmt::format("there is no site \"{}\"", name.substr(0, 60)), "site");
      auto on = std::find_if(layouts.begin(), layouts.end(),
                             [&](const ImportedLayout& one) { return one.layout.name == site->second.body; });
      if (on == layouts.end()) {
        on = layouts.insert(layouts.end(), ImportedLayout{});
        on->layout.name = site->second.body;
        on->geom = site->second.geom;
        on->has_density = on->has_material = on->has_frame = false;
      }
      add_site(*on, site->second, name, size);
      constexpr std::size_t kMostUser = 1000;
      if (site->second.node.find("user"))
        for (const double value : site->second.node.numbers("user", 1, kMostUser)) {
          users[on->layout.name].push_back(value);
          break;
        }
    }
  }
  for (ImportedLayout& one : layouts) {
    take_site_ids(one, users[one.layout.name]);
    one.notes.push_back(
        fmt::format("touch sites of body \"{}\": positions are in the frame of the body, which is taken to be that of "
                    "the mesh; the "
                    "radius is the size of a site",
                    one.layout.name));
    if (!one.has_normals) one.notes.emplace_back("some sites have no orientation: the skin gives the normals");
  }
  return layouts;
}

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
