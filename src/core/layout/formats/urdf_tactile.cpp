// URDF with the tactile sensors of tactile_toolbox: <sensor> under <robot>, with <tactile>, which has <taxel> elements
// or one <array>. Poses are in the frame of the sensor's <parent link>, after its <origin>. Taxels that are links, as
// XELA describes them, are read too.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/layout/file/imported_layout.h"
#include "core/layout/formats/layout_format.h"
#include "core/layout/formats/text.h"
#include "core/layout/formats/urdf.h"
#include "core/mesh/mesh_io.h"

namespace taxel {
namespace {

constexpr double kMostTravel = 0.005;     ///< longest way of a joint that belongs to a taxel [m]
constexpr std::size_t kLeastUnnamed = 4;  ///< fewest links of a group without the word "taxel"
constexpr int kMostJoints = 1000;         ///< longest chain of joints
constexpr int kMaxUrdfTaxels = 100'000;

/// A link and the joint above it.
struct TreeLink {
  XmlNode node;
  std::string parent = {};  ///< empty for the root
  std::optional<XmlNode> joint = {};
  UrdfPose in_parent = {};
  bool is_held = false;  ///< true if the joint is fixed, or moves by a taxel's travel at most
  bool slides = false;
  std::vector<std::string> held = {};  ///< links that fixed joints hold on it
  int children = 0;
};

/// The links of a robot by name, as a tree.
class LinkTree {
 public:
  explicit LinkTree(const XmlNode& robot) {
    for (const XmlNode& node : robot.children("link"))
      if (!links_.try_emplace(node.text("name"), TreeLink{node}).second)
        node.fail(fmt::format("\"{}\" is there twice", node.text("name").substr(0, 60)), "name");
    for (const XmlNode& joint : robot.children("joint")) add_joint(joint);
  }
  [[nodiscard]] const std::map<std::string, TreeLink>& links() const { return links_; }
  [[nodiscard]] const TreeLink& at(const std::string& name) const { return links_.at(name); }

  /// Returns the mesh of a link, or else that of the only link with a mesh that a fixed joint holds on it: GenTact has
  /// its meshes on links of their own, next to the taxels.
  [[nodiscard]] const std::optional<LinkMesh>& mesh_on(const std::string& name) const {
    const auto [entry, is_new] = meshes_.try_emplace(name);
    if (is_new) entry->second = find_mesh_on(name);
    return entry->second;
  }

 private:
  [[nodiscard]] std::optional<LinkMesh> find_mesh_on(const std::string& name) const {
    if (std::optional<LinkMesh> own = mesh_of_link(at(name).node)) return own;
    std::optional<LinkMesh> found;
    for (const std::string& child : at(name).held) {
      const TreeLink& link = at(child);
      std::optional<LinkMesh> mesh = mesh_of_link(link.node);
      if (!mesh) continue;
      if (found) return std::nullopt;
      mesh->in_link = link.in_parent * mesh->in_link;
      found = std::move(mesh);
    }
    return found;
  }
  TreeLink& linked(const XmlNode& joint, const char* end) {
    const std::optional<XmlNode> node = joint.child(end);
    if (!node) joint.fail(fmt::format("has no <{}>", end));
    const std::string name = node->text("link");
    const auto found = links_.find(name);
    if (found == links_.end()) node->fail(fmt::format("there is no link \"{}\"", name.substr(0, 60)), "link");
    return found->second;
  }
  void add_joint(const XmlNode& joint) {
    TreeLink &parent = linked(joint, "parent"), &child = linked(joint, "child");
    if (child.joint)
      joint.child("child")->fail(fmt::format("\"{}\" hangs on a joint already, at {}",
                                             child.node.text("name").substr(0, 60), child.joint->place()),
                                 "link");
    ++parent.children;
    child.parent = parent.node.text("name");
    child.joint = joint;
    child.in_parent = origin_of(joint);
    const std::string type = joint.text_or_empty("type");
    child.slides = type == "prismatic" && is_short(joint);
    child.is_held = type == "fixed" || child.slides;
    if (type == "fixed") parent.held.push_back(child.node.text("name"));
  }
  static bool is_short(const XmlNode& joint) {
    const std::optional<XmlNode> limit = joint.child("limit");
    if (!limit) return false;
    const auto bound = [&](const char* key) { return limit->find(key) ? limit->number(key) : 0.0; };
    return bound("upper") - bound("lower") <= kMostTravel;
  }

  std::map<std::string, TreeLink> links_;
  mutable std::map<std::string, std::optional<LinkMesh>> meshes_;  ///< results of mesh_on()
};

/// A taxel link with its pose in the link that carries the sensor.
struct FoundTaxel {
  std::string name;
  std::vector<long> numbers;  ///< in the name, from left to right
  UrdfPose pose;
  bool slides = false;
};

/// Taxel links on one link whose names differ only in numbers.
struct TaxelGroup {
  std::string base;  ///< link that carries them
  std::vector<FoundTaxel> taxels = {};
  bool is_named = false;  ///< true if the names have the word "taxel", or "sensor" on a sphere
};

bool has_word(std::string name, const char* word) {
  for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return name.find(word) != std::string::npos;
}

/// Returns the name with "#" for each number, and the numbers. Nothing if a number has more than 9 digits.
std::optional<std::string> without_numbers(const std::string& name, std::vector<long>& numbers) {
  constexpr std::size_t kMostDigits = 9;
  std::string pattern;
  for (std::size_t at = 0; at < name.size();) {
    const std::size_t end = std::min(name.find_first_not_of("0123456789", at), name.size());
    if (end == at) {
      pattern += name[at++];
      continue;
    }
    if (end - at > kMostDigits) return std::nullopt;
    numbers.push_back(std::stol(name.substr(at, end - at)));
    pattern += '#';
    at = end;
  }
  return pattern;
}

bool is_sphere(const XmlNode& link) {
  for (const char* kind : {"visual", "collision"})
    for (const XmlNode& shape : link.children(kind))
      if (const std::optional<XmlNode> geometry = shape.child("geometry"))
        if (geometry->child("sphere")) return true;
  return false;
}

/// Walks from a link up to the one with the sensor's mesh. Without a mesh it is the first link that holds one with a
/// mesh, or else, for a taxel by name, the first one with several links below.
std::optional<std::string> find_base(const LinkTree& tree, const std::string& name, FoundTaxel& taxel,
                                     bool needs_mesh) {
  std::string at = name;
  std::optional<std::string> forked, holding;
  UrdfPose forked_pose, holding_pose, pose;
  for (int i = 0;; ++i) {
    const TreeLink& link = tree.at(at);
    if (i > kMostJoints) link.node.fail(fmt::format("hangs on more than {} joints, or on a circle", kMostJoints));
    if (i > 0 && mesh_of_link(link.node)) {
      taxel.pose = pose;
      return at;
    }
    if (i > 0 && link.children > 1 && !forked) forked = at, forked_pose = pose;
    if (i > 0 && link.children > 1 && !holding && tree.mesh_on(at)) holding = at, holding_pose = pose;
    if (!link.is_held) break;
    taxel.slides = taxel.slides || link.slides;
    pose = link.in_parent * pose;
    at = link.parent;
  }
  taxel.pose = holding ? holding_pose : forked_pose;
  if (holding) return holding;
  return needs_mesh ? std::nullopt : forked;
}

std::vector<TaxelGroup> groups_of(const LinkTree& tree) {
  std::map<std::pair<std::string, std::string>, TaxelGroup> groups;
  std::size_t count = 0;
  for (const auto& [name, link] : tree.links()) {
    if (link.children > 0 || !link.is_held) continue;
    const bool is_marked = is_sphere(link.node);
    const bool is_named = has_word(name, "taxel") || (is_marked && has_word(name, "sensor"));
    if (!is_named && !is_marked) continue;
    FoundTaxel taxel{name, {}, {}};
    const std::optional<std::string> pattern = without_numbers(name, taxel.numbers);
    if (!pattern || taxel.numbers.empty()) continue;
    const std::optional<std::string> base = find_base(tree, name, taxel, !is_named);
    if (!base) continue;
    if (++count > kMaxUrdfTaxels) link.node.fail(fmt::format("is beyond the {} taxels that are read", kMaxUrdfTaxels));
    TaxelGroup& group = groups[{*base, *pattern}];
    group.base = *base;
    group.is_named = is_named;
    group.taxels.push_back(std::move(taxel));
  }
  std::vector<TaxelGroup> found;
  for (auto& [key, group] : groups) {
    if (!group.is_named && group.taxels.size() < kLeastUnnamed) continue;
    std::sort(group.taxels.begin(), group.taxels.end(),
              [](const FoundTaxel& a, const FoundTaxel& b) { return a.numbers < b.numbers; });
    found.push_back(std::move(group));
  }
  return found;
}

/// Returns which of the numbers in the names is that of the taxel: the one that differs, or the last one of a single
/// link; nothing if several differ.
std::optional<std::size_t> varying_number(const std::vector<FoundTaxel>& taxels) {
  std::optional<std::size_t> varying;
  const std::size_t count = taxels.front().numbers.size();
  for (std::size_t k = 0; k < count; ++k) {
    const auto same = [&](const FoundTaxel& one) { return one.numbers[k] == taxels.front().numbers[k]; };
    if (std::all_of(taxels.begin(), taxels.end(), same)) continue;
    if (varying) return std::nullopt;
    varying = k;
  }
  return varying.value_or(count - 1);
}

/// Returns the part of a name before its number of this index, without separators at its end.
std::string name_before(const std::string& name, std::size_t number) {
  std::size_t at = 0;
  for (std::size_t k = 0;; ++k) {
    at = name.find_first_of("0123456789", at);
    if (k == number) break;
    at = name.find_first_not_of("0123456789", at);
  }
  const std::size_t last = at == 0 ? std::string::npos : name.find_last_not_of("_-. ", at - 1);
  return last == std::string::npos ? "" : name.substr(0, last + 1);
}

/// Makes a layout of one group.
class GroupReader {
 public:
  GroupReader(const LinkTree& tree, const TaxelGroup& group, const std::string& file)
      : tree_(tree), group_(group), base_(tree.at(group.base).node), file_(file) {}

  ImportedLayout read() {
    imported_.geom = group_.base;
    imported_.geom_place = base_.place("name");
    imported_.has_density = imported_.has_material = imported_.has_frame = false;
    take_mesh();
    take_taxels();
    imported_.set_all_radii_missing();
    const auto slides =
        std::count_if(group_.taxels.begin(), group_.taxels.end(), [](const FoundTaxel& one) { return one.slides; });
    if (slides > 0)
      note(fmt::format("{} taxels are on joints that slide by {} m at most: they are taken at 0", slides, kMostTravel));
    note(
        fmt::format("taxels are the links on \"{}\" with numbers in their names; the spheres that mark them are no "
                    "receptive radii: the radius is {} m (--radius M gives another)",
                    group_.base, Taxel().radius));
    return std::move(imported_);
  }

 private:
  void note(const std::string& text) { imported_.notes.push_back(text); }

  void take_mesh() {
    const std::optional<LinkMesh> mesh = tree_.mesh_on(group_.base);
    if (!mesh) {
      note(fmt::format("link \"{}\" has no mesh: positions are in its frame, which is taken to be that of the mesh",
                       group_.base));
      return;
    }
    to_mesh_ = inverse(mesh->in_link);
    has_origin_ = mesh->in_link.turn != dmat3(1) || mesh->in_link.shift != dvec3(0);
    const std::string path = find_link_mesh(mesh->name, file_);
    if (path.empty()) {
      note(fmt::format(
          "{}: \"{}\" is not found next to the file or in a folder above it: name the mesh with --mesh FILE{}",
          mesh->place, mesh->name,
          mesh->scale == dvec3(1) ? ""
                                  : fmt::format(" --scale {},{},{}", mesh->scale.x, mesh->scale.y, mesh->scale.z)));
    } else if (!is_mesh_file(path)) {
      note(fmt::format("{}: \"{}\" is of no format that is read: name another mesh with --mesh FILE", mesh->place,
                       mesh->name));
    } else {
      imported_.layout.mesh.file = path;
      imported_.layout.mesh.scale = mesh->scale;
    }
    if (mesh->has_other_visual)
      note(
          fmt::format("link \"{}\" shows another mesh than the one that it collides with: positions are in the frame "
                      "of the latter",
                      group_.base));
  }

  void take_taxels() {
    const std::vector<FoundTaxel>& found = group_.taxels;
    const std::optional<std::size_t> number = varying_number(found);
    std::set<long> ids;
    for (const FoundTaxel& one : found)
      if (number) ids.insert(one.numbers[*number]);
    const bool has_ids = ids.size() == found.size();
    for (std::size_t i = 0; i < found.size(); ++i) {
      const UrdfPose pose = has_origin_ ? to_mesh_ * found[i].pose : found[i].pose;
      Taxel taxel;
      taxel.id = static_cast<int>(has_ids ? found[i].numbers[*number] : static_cast<long>(i));
      taxel.name = found[i].name;
      taxel.center = pose.shift;
      taxel.normal = pose.turn[2];
      if (!is_finite(taxel.center) || !is_finite(taxel.normal))
        base_.fail(fmt::format("taxel link \"{}\" is at no finite place in its frame", found[i].name.substr(0, 60)));
      imported_.layout.taxels.push_back(taxel);
    }
    if (!has_ids) note("the names of the taxels differ in several numbers: ids count the taxels in this order, from 0");
    imported_.layout.name = name_before(found.front().name, number.value_or(0));
    if (imported_.layout.name.empty()) imported_.layout.name = group_.base;
  }

  const LinkTree& tree_;
  const TaxelGroup& group_;
  const XmlNode& base_;
  const std::string& file_;
  ImportedLayout imported_;
  UrdfPose to_mesh_;
  bool has_origin_ = false;
};

/// Returns one layout for each group of taxel links, none if there are no such links. A taxel link has no links below
/// it, and its name has a number: x_taxel_0_uSPa44_07_link. It is joined to the link with the sensor's mesh by fixed
/// joints, or by sliding ones of at most 5 mm, of which XELA's models have one or three for each taxel; they are taken
/// at 0. Links whose names differ only in numbers are a group. A name without the word "taxel" is of a taxel if the
/// link is a sphere, and its name has the word "sensor" or its group has four links or more.
///
/// Positions are in the frame of the mesh, after its scale, or in that of the link that carries the group if no mesh is
/// there. Ids are the numbers in the names. The z axis of a taxel's link is its normal. Throws Error naming file and
/// line: a joint names no link, a link hangs on two joints, or joints form a circle.
std::vector<ImportedLayout> layouts_of_taxel_links(const XmlNode& robot, const std::string& file) {
  if (robot.children("joint").empty()) return {};
  const LinkTree tree(robot);
  std::vector<ImportedLayout> layouts;
  for (const TaxelGroup& group : groups_of(tree)) layouts.push_back(GroupReader(tree, group, file).read());
  return layouts;
}

constexpr HeldValues kHeldByUrdf{true, false, true, true, false, false, false, true};

/// Reads one <sensor> with <tactile>.
class UrdfSensor {
 public:
  UrdfSensor(const XmlNode& sensor, const XmlNode& tactile) : tactile_(tactile) {
    imported_.layout.name = sensor.text_or_empty("name");
    imported_.has_density = imported_.has_material = imported_.has_frame = false;
    if (const std::optional<XmlNode> parent = sensor.child("parent")) {
      imported_.geom = parent->text("link");
      imported_.geom_place = parent->place("link");
    }
    origin_ = origin_of(sensor);
  }

  ImportedLayout read() {
    const std::vector<XmlNode> taxels = tactile_.children("taxel");
    const std::optional<XmlNode> array = tactile_.child("array");
    if (taxels.empty() && !array) tactile_.fail("has no <taxel> and no <array>");
    if (!taxels.empty()) {
      if (taxels.size() > kMaxUrdfTaxels)
        tactile_.fail(fmt::format("has {} taxels, at most {} are read", taxels.size(), kMaxUrdfTaxels));
      for (const XmlNode& taxel : taxels) read_taxel(taxel);
      if (array) note(fmt::format("{} is left out: the sensor lists its taxels", array->place()));
      take_indices();
    } else {
      read_array(*array);
    }
    if (const std::string channel = tactile_.text_or_empty("channel"); !channel.empty())
      note(fmt::format("not carried over: channel \"{}\"", channel));
    note(imported_.geom.empty() ? "the sensor names no parent link: positions are taken to be in the frame of the mesh"
                                : "positions are in the frame of the link, which is taken to be that of the mesh");
    return std::move(imported_);
  }

 private:
  void note(const std::string& text) { imported_.notes.push_back(text); }

  void read_taxel(const XmlNode& node) {
    Taxel taxel;
    const UrdfPose pose = pose_of(node);
    taxel.center = origin_.turn * pose.shift + origin_.shift;
    taxel.normal = origin_.turn * pose.turn[2];
    if (!is_finite(taxel.center) || !is_finite(taxel.normal))
      node.fail("is at no finite place in the frame of the link");
    indices_.push_back(node.find("idx") ? node.integer("idx", 0, 2'000'000'000)
                                        : static_cast<int>(imported_.layout.taxels.size()));
    const std::optional<XmlNode> geometry = node.child("geometry");
    const std::optional<XmlNode> sphere = geometry ? geometry->child("sphere") : std::nullopt;
    if (sphere) {
      taxel.radius = sphere->number("radius");
      if (!(taxel.radius > 0)) sphere->fail(fmt::format("must be greater than 0, is {}", taxel.radius), "radius");
    } else {
      imported_.missing_radii.push_back(imported_.layout.taxels.size());
    }
    imported_.layout.taxels.push_back(taxel);
  }

  /// Takes `idx` as the ids of the taxels if each is there once, otherwise the rows.
  void take_indices() {
    std::vector<Taxel>& taxels = imported_.layout.taxels;
    if (!imported_.has_radii())
      note(fmt::format("{} of {} taxels have no sphere and so no radius: it is {} m (--radius M gives another)",
                       imported_.missing_radii.size(), taxels.size(), Taxel().radius));
    std::set<int> seen;
    std::set<int> repeated;
    for (const int index : indices_)
      if (!seen.insert(index).second) repeated.insert(index);
    for (std::size_t i = 0; i < taxels.size(); ++i) taxels[i].id = repeated.empty() ? indices_[i] : static_cast<int>(i);
    if (!repeated.empty())
      note(fmt::format("idx {} is there more than once: ids are the rows of the taxels, from 0", *repeated.begin()));
  }

  /// Reads a grid. Its offset is subtracted: tactile_toolbox calls it the offset of the grid relative to the origin,
  /// and its only user of arrays, rviz_tactile_plugins (src/tactile_array_visual.cpp), draws the cell (row, column) at
  /// index * spacing - offset. A spacing may be negative, which mirrors the grid (urdf_tactile/README.md).
  void read_array(const XmlNode& array) {
    const int rows = array.integer("rows", 1, kMaxUrdfTaxels), columns = array.integer("cols", 1, kMaxUrdfTaxels);
    if (rows > kMaxUrdfTaxels / columns)
      array.fail(fmt::format("has {} x {} taxels, at most {} are read", rows, columns, kMaxUrdfTaxels));
    const std::vector<double> size = array.numbers("size", 2, 2);
    const std::vector<double> spacing = array.find("spacing") ? array.numbers("spacing", 2, 2) : size;
    const std::vector<double> offset = array.find("offset") ? array.numbers("offset", 2, 2) : std::vector<double>{0, 0};
    const double radius = 0.5 * std::min(size[0], size[1]);  // may round to 0
    if (!(radius > 0)) array.fail("must be two numbers greater than 0", "size");
    const std::string order = array.find("order").value_or("row-major");
    const bool by_column = order == "col-major" || order == "column-major";
    if (!by_column && order != "row-major")
      array.fail(fmt::format("must be row-major or col-major, is \"{}\"", order.substr(0, 60)), "order");
    for (int i = 0; i < rows * columns; ++i) {
      const int row = by_column ? i % rows : i / columns, column = by_column ? i / rows : i % columns;
      Taxel taxel;
      taxel.id = i;
      taxel.center =
          origin_.turn * dvec3(row * spacing[0] - offset[0], column * spacing[1] - offset[1], 0) + origin_.shift;
      taxel.normal = origin_.turn[2];
      taxel.radius = radius;
      if (!is_finite(taxel.center)) array.fail("has taxels at no finite place in the frame of the link");
      imported_.layout.taxels.push_back(taxel);
    }
    note(fmt::format("an array of {} x {}: rows along x, columns along y, radius half of the smaller side of a cell",
                     rows, columns));
  }

  const XmlNode& tactile_;
  ImportedLayout imported_;
  UrdfPose origin_;
  std::vector<int> indices_;  ///< idx of each taxel
};

/// Returns the name of the kind of a sensor: its first element that every sensor may not have.
std::string kind_of(const XmlNode& sensor) {
  for (const XmlNode& child : sensor.children())
    if (child.name() != "parent" && child.name() != "origin") return child.name();
  return "nothing";
}

std::vector<ImportedLayout> parse_urdf(const std::string& text, const std::string& file) {
  const XmlFile xml(text, file);
  const XmlNode robot = xml.root();
  if (robot.name() != "robot") robot.fail("must be <robot>: the file is no URDF");
  for (const XmlNode& child : robot.children())
    if (child.name().starts_with("xacro:"))
      child.fail("is to be expanded first: `xacro FILE > robot.urdf`, or `ros2 run xacro xacro FILE > robot.urdf`");
  std::vector<ImportedLayout> layouts;
  std::string others;
  int other_count = 0;
  std::size_t taxels = 0;
  for (const XmlNode& sensor : robot.children("sensor")) {
    const std::optional<XmlNode> tactile = sensor.child("tactile");
    if (!tactile) {
      if (++other_count <= 10)
        others +=
            fmt::format("{}\"{}\" (<{}>)", others.empty() ? "" : ", ", sensor.text_or_empty("name"), kind_of(sensor));
      continue;
    }
    layouts.push_back(UrdfSensor(sensor, *tactile).read());
    taxels += layouts.back().layout.taxels.size();
    if (taxels > kMaxUrdfTaxels) sensor.fail(fmt::format("is beyond the {} taxels that are read", kMaxUrdfTaxels));
  }
  for (ImportedLayout& one : layouts_of_taxel_links(robot, file)) layouts.push_back(std::move(one));
  if (layouts.empty())
    throw Error(file, "has no <sensor> with <tactile>, and no links that are taxels" +
                          (others.empty() ? "" : ", but sensors of other kinds: " + others));
  if (!others.empty()) layouts.front().notes.push_back("sensors of other kinds are left out: " + others);
  for (ImportedLayout& one : layouts) one.has_units = true;  // lengths of URDF are in m
  return layouts;
}

/// Returns the angles (roll, pitch, 0) that turn +z to this direction.
dvec3 rpy_of_normal(const dvec3& normal) {
  const dvec3 n = normal / std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  return {std::atan2(-n.y, std::hypot(n.x, n.z)), std::atan2(n.x, n.z), 0};
}

std::string words_of(const dvec3& v) {
  return words_of_numbers({v.x, v.y, v.z});
}

WrittenLayouts write_urdf(const std::vector<ImportedLayout>& layouts) {
  check_taxels_to_write(layouts);
  require_normals(layouts, "a taxel of URDF");
  WrittenLayouts written{"<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<robot name=\"" +
                             xml_attribute(layouts.front().layout.name) + "\">\n",
                         losses_in(layouts, kHeldByUrdf, "a URDF")};
  std::set<std::string> links;
  for (const ImportedLayout& one : layouts) {
    const std::string link = one.geom.empty() ? one.layout.name : one.geom;
    if (links.insert(link).second) written.bytes += fmt::format("  <link name=\"{}\"/>\n", xml_attribute(link));
  }
  for (const ImportedLayout& one : layouts) {
    const std::string link = one.geom.empty() ? one.layout.name : one.geom;
    written.bytes +=
        fmt::format("  <sensor name=\"{}\" update_rate=\"100\">\n    <parent link=\"{}\"/>\n    <tactile>\n",
                    xml_attribute(one.layout.name), xml_attribute(link));
    auto missing = one.missing_radii.begin();
    for (std::size_t i = 0; i < one.layout.taxels.size(); ++i) {
      const Taxel& taxel = one.layout.taxels[i];
      const bool has_radius = missing == one.missing_radii.end() || *missing != i;
      if (!has_radius) ++missing;
      if (taxel.id < 0) throw Error("", fmt::format("taxel {}", taxel.id), "must have an id of 0 or more");
      written.bytes += fmt::format("      <taxel idx=\"{}\" xyz=\"{}\" rpy=\"{}\">", taxel.id, words_of(taxel.center),
                                   words_of(rpy_of_normal(taxel.normal)));
      if (has_radius) written.bytes += fmt::format("<geometry><sphere radius=\"{}\"/></geometry>", taxel.radius);
      written.bytes += "</taxel>\n";
    }
    written.bytes += "    </tactile>\n  </sensor>\n";
  }
  written.bytes += "</robot>\n";
  written.notes.emplace_back("update_rate is to be set in the file; normals are angles, exact to 1e-15");
  return written;
}

bool is_robot(std::string_view bytes) {
  return first_element(bytes) == "robot";
}

}  // namespace

LayoutFormat urdf_format() {
  LayoutFormat format{"urdf", "URDF with tactile sensors", {".urdf", ".xacro", ".xml"}};
  format.holds = kHeldByUrdf;
  format.reads_several = format.writes_several = true;
  format.is_start = is_robot;
  format.parse = parse_urdf;
  format.write = write_urdf;
  return format;
}

}  // namespace taxel
