#include "core/layout/formats/urdf/taxel_links.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/layout/formats/urdf/link_mesh.h"
#include "core/mesh/mesh_io.h"

namespace taxel {
namespace {

constexpr double kMostTravel = 0.005;     ///< longest way of a joint that belongs to a taxel [m]
constexpr std::size_t kLeastUnnamed = 4;  ///< fewest links of a group without the word "taxel"
constexpr int kMostJoints = 1000;         ///< longest chain of joints
constexpr std::size_t kMostTaxelLinks = 100'000;

/// A link and the joint above it.
struct TreeLink {
  XmlNode node;
  std::string parent = {};  ///< empty for the root
  std::optional<XmlNode> joint = {};
  UrdfPose in_parent = {};
  bool is_held = false;  ///< true if the joint is fixed, or moves by a taxel's travel at most
  bool slides = false;
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

 private:
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
  }
  static bool is_short(const XmlNode& joint) {
    const std::optional<XmlNode> limit = joint.child("limit");
    if (!limit) return false;
    const auto bound = [&](const char* key) { return limit->find(key) ? limit->number(key) : 0.0; };
    return bound("upper") - bound("lower") <= kMostTravel;
  }

  std::map<std::string, TreeLink> links_;
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
  bool is_named = false;  ///< true if the names have the word "taxel"
};

bool has_word_taxel(std::string name) {
  for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return name.find("taxel") != std::string::npos;
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

/// Walks from a link up to the one with the sensor's mesh. Without a mesh it is the first link with several links
/// below.
std::optional<std::string> find_base(const LinkTree& tree, const std::string& name, FoundTaxel& taxel,
                                     bool needs_mesh) {
  std::string at = name;
  std::optional<std::string> forked;
  UrdfPose forked_pose, pose;
  for (int i = 0;; ++i) {
    const TreeLink& link = tree.at(at);
    if (i > kMostJoints) link.node.fail(fmt::format("hangs on more than {} joints, or on a circle", kMostJoints));
    if (i > 0 && mesh_of_link(link.node)) {
      taxel.pose = pose;
      return at;
    }
    if (i > 0 && link.children > 1 && !forked) forked = at, forked_pose = pose;
    if (!link.is_held) break;
    taxel.slides = taxel.slides || link.slides;
    pose = link.in_parent * pose;
    at = link.parent;
  }
  taxel.pose = forked_pose;
  return needs_mesh ? std::nullopt : forked;
}

std::vector<TaxelGroup> groups_of(const LinkTree& tree) {
  std::map<std::pair<std::string, std::string>, TaxelGroup> groups;
  std::size_t count = 0;
  for (const auto& [name, link] : tree.links()) {
    if (link.children > 0 || !link.is_held) continue;
    const bool is_named = has_word_taxel(name);
    if (!is_named && !is_sphere(link.node)) continue;
    FoundTaxel taxel{name, {}, {}};
    const std::optional<std::string> pattern = without_numbers(name, taxel.numbers);
    if (!pattern || taxel.numbers.empty()) continue;
    const std::optional<std::string> base = find_base(tree, name, taxel, !is_named);
    if (!base) continue;
    if (++count > kMostTaxelLinks)
      link.node.fail(fmt::format("is beyond the {} taxels that are read", kMostTaxelLinks));
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
      : group_(group), base_(tree.at(group.base).node), file_(file) {}

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
    const std::optional<LinkMesh> mesh = mesh_of_link(base_);
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

  const TaxelGroup& group_;
  const XmlNode& base_;
  const std::string& file_;
  ImportedLayout imported_;
  UrdfPose to_mesh_;
  bool has_origin_ = false;
};

}  // namespace

std::vector<ImportedLayout> layouts_of_taxel_links(const XmlNode& robot, const std::string& file) {
  if (robot.children("joint").empty()) return {};
  const LinkTree tree(robot);
  std::vector<ImportedLayout> layouts;
  for (const TaxelGroup& group : groups_of(tree)) layouts.push_back(GroupReader(tree, group, file).read());
  return layouts;
}

}  // namespace taxel
