// The document that the window edits, as a plain value. It holds all values that a user saves, each once. Values
// computed from it (mesh, samples, fields) are not part of it.
//
// The id of a taxel is unique in a project. Its index changes with the order of the taxels.
#pragma once

#include <filesystem>
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

/// Two taxels that remain mirror images of each other: an edit of one changes the other.
struct MirrorLink {
  int taxel = 0, image = 0;  ///< ids of the taxels
  bool operator==(const MirrorLink&) const = default;
};

/// A plane and the links across it. A taxel has at most one link across each plane.
struct Mirror {
  MirrorPlane plane;
  std::vector<MirrorLink> links;
  bool operator==(const Mirror&) const = default;
};

/// The camera when the project was saved. It orbits about `target`, with z up.
struct View {
  dvec3 target{0};            ///< centre of the orbit, frame W [m]
  double azimuth_deg = 135;   ///< direction from target to eye, about +z from +x
  double elevation_deg = 25;  ///< above the horizon
  double distance = 0.15;     ///< distance between eye and target [m]
  double fov_deg = 40;        ///< vertical field of view
  bool operator==(const View&) const = default;
};

struct Project {
  /// The exported layout. In a document, layout.mesh.file is absolute, so it remains valid when the document is saved
  /// to another folder.
  Layout layout;
  Scenario scenario;
  /// The saved camera, or empty. Edits and undo do not change it: saving writes the window's camera here, and opening
  /// restores it.
  std::optional<View> view;
  std::vector<Mirror> mirrors;
  std::vector<int> hidden;  ///< ids of hidden taxels, ascending
  bool operator==(const Project&) const = default;
};
using ProjectPtr = std::shared_ptr<const Project>;

/// Returns the taxel with this id, or null.
const Taxel* find_taxel(const Layout& layout, int id);
/// Returns the index of the taxel in layout.taxels. Throws Error that names the taxel if there is none.
std::size_t taxel_index(const Layout& layout, int id);

/// Returns the index of each id, for many look-ups.
std::unordered_map<int, std::size_t> taxel_indices(const Layout& layout);

/// Returns `count` ascending ids that follow the largest id of the layout. Throws Error if no id is left.
std::vector<int> unused_ids(const Layout& layout, std::size_t count);

/// Gives each taxel whose id is negative, or equal to the id of an earlier taxel, an unused id. Returns a note for each
/// change. Call it before a layout from another source becomes a project.
std::vector<std::string> make_ids_unique(Layout& layout);

/// Returns taxels from another source (pasted, duplicated, generated) with ids for adding to the layout. A taxel keeps
/// its id if no taxel in the layout or earlier in the list has it; the others get unused ids.
std::vector<Taxel> with_unused_ids(std::vector<Taxel> taxels, const Layout& layout);

/// Checks the rules of a project that layout_check does not check: ids are unique, links and hidden ids refer to
/// existing taxels, no taxel is linked to itself or twice across one plane, and hidden ids ascend. Throws Error with
/// the JSON pointer of the first violation.
void check_project(const Project& project);

// Reads and writes project files, `*.taxelproj`, version 1 (docs/project_format.md).

/// Parses the text of a project without changing its paths. Throws Error(file, JSON pointer, message) for wrong JSON, a
/// wrong type, word or version, an unknown key outside of the layout, and a violation of check_project.
Project parse_project(const std::string& text, const std::string& file = "");

/// Returns the text of a project file: fixed key order, shortest round-trip numbers, two-space indent, newline at the
/// end, unchanged paths. Throws Error with the JSON pointer of a number that is not finite.
std::string project_to_json(const Project& project);

/// Reads a project file and makes its paths (mesh, files of the scenario) absolute. Throws Error as parse_project()
/// does.
Project read_project(const std::filesystem::path& path);

/// Reads a layout file as a new project with absolute paths and unique ids, and a note for each changed id.
struct ProjectOfLayout {
  Project project;
  std::vector<std::string> notes;
};
ProjectOfLayout read_layout_as_project(const std::filesystem::path& path);

/// Writes a project file atomically, with paths relative to its folder. Throws Error that names the file and leaves an
/// existing file unchanged.
void write_project(const std::filesystem::path& path, const Project& project);

/// Writes the layout of the project to a layout file atomically, with the mesh's path relative to its folder.
void export_layout(const std::filesystem::path& path, const Project& project);

}  // namespace taxel
