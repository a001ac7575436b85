// The document that the window edits: a plain value. Everything that a user saves is in it, nothing stands in it twice;
// what is computed from it (mesh, samples, fields) is not part of it.
//
// Taxels are known by their ids, which are unique in a project; an index changes with the order.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/base/error.h"
#include "core/base/shared_value.h"
#include "core/document/scenario/scenario.h"
#include "core/layout/generators/mirror.h"
#include "core/layout/layout.h"

namespace taxel {

/// Two taxels that are mirror images of each other and stay so: when one is edited, the other follows.
struct MirrorLink {
  int taxel = 0, image = 0;  ///< ids
  bool operator==(const MirrorLink&) const = default;
};

/// A plane and the links across it. A taxel has at most one link across each plane.
struct Mirror {
  MirrorPlane plane;
  std::vector<MirrorLink> links;
  bool operator==(const Mirror&) const = default;
};

/// How the camera stood when the project was saved: it orbits about `target`, z up.
struct View {
  dvec3 target{0};            ///< [m], world
  double azimuth_deg = 135;   ///< direction from target to eye, about +z from +x
  double elevation_deg = 25;  ///< above the horizon
  double distance = 0.15;     ///< from eye to target [m]
  double fov_deg = 40;        ///< vertical
  bool operator==(const View&) const = default;
};

struct Project {
  /// What is exported; carries nothing of what follows. In a document layout.mesh.file is absolute, so that it means
  /// the same wherever the document is saved to.
  Layout layout;
  Scenario scenario;
  /// Not edited: the camera is the window's. Saving puts in where it stands, opening takes it from here; undo leaves
  /// it.
  std::optional<View> view;
  std::vector<Mirror> mirrors;
  std::vector<int> hidden;  ///< ids of taxels that are not shown, ascending
  bool operator==(const Project&) const = default;
};
using ProjectPtr = std::shared_ptr<const Project>;

/// The taxel of an id, or null.
const Taxel* find_taxel(const Layout& layout, int id);
/// The same, index in layout.taxels. Throws Error naming the taxel.
std::size_t taxel_index(const Layout& layout, int id);

/// The index of each id, for many at once.
std::unordered_map<int, std::size_t> taxel_indices(const Layout& layout);

/// `count` ids that no taxel has, ascending, following the largest one. Throws Error where none is left.
std::vector<int> unused_ids(const Layout& layout, std::size_t count);

/// What a project must be beside what layout_check tells about its layout: ids unique; links and hidden ids of taxels
/// there are; no taxel linked to itself or twice across one plane; hidden ascending. Throws Error with the
/// JSON pointer of the first place where it is not.
void check_project(const Project& project);

}  // namespace taxel
