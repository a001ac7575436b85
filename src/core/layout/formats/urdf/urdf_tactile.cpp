// URDF with the tactile sensors of tactile_toolbox: <sensor> under <robot>, with <tactile>, which has <taxel> elements
// or one <array>. Poses are in the frame of the sensor's <parent link>, after its <origin>. Taxels that are links, as
// XELA describes them, are read too (taxel_links.h).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/layout/formats/format_rows.h"
#include "core/layout/formats/losses.h"
#include "core/layout/formats/text/number_words.h"
#include "core/layout/formats/text/xml_node.h"
#include "core/layout/formats/urdf/taxel_links.h"
#include "core/layout/formats/urdf/urdf_pose.h"

namespace taxel {
namespace {

constexpr HeldValues kHeldByUrdf{true, false, true, true, false, false, false, true};
constexpr int kMaxUrdfTaxels = 100'000;

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
