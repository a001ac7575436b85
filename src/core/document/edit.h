// Edits of a project as values: a tool, a panel or a script makes them, apply_edit() applies them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/document/project.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Adds taxels in this order, at the end or before the taxel `before`. Their ids must be unused (unused_ids).
struct AddTaxels {
  std::vector<Taxel> taxels;
  std::optional<int> before;
};

/// Deletes taxels with their links, calibration and hidden state. The mirrored taxel of a deleted taxel remains.
struct DeleteTaxels {
  std::vector<int> ids;
};

/// New values of one taxel. A field that is not set keeps its value.
struct TaxelChange {
  int id = 0;
  std::optional<std::string> name;
  std::optional<dvec3> center;  ///< [m], frame M
  std::optional<dvec3> normal;
  std::optional<double> radius;  ///< [m]
  /// New subtaxels. If only the centre is set, the subtaxels move with the taxel. If the normal is set as well and
  /// turns by less than 90 degrees, they turn with the normal about the centre.
  std::optional<std::vector<Subtaxel>> subtaxels;
  std::optional<double> density;  ///< [1/m^2]; 0 for the density of the layout
};

/// Changes any fields of any taxels at once; each id is listed once. Mirrored taxels follow in all fields except the
/// name; a mirrored taxel that is listed itself gets the listed values.
struct SetTaxels {
  std::vector<TaxelChange> changes;
  bool twins_follow = true;
};

/// Changes ids (from, to), all at once, so two ids can be exchanged. References to the taxels change with the ids.
struct RenumberTaxels {
  std::vector<std::pair<int, int>> ids;
};

/// Changes the order of the taxels and of the readings. Lists all ids in their new order.
struct ReorderTaxels {
  std::vector<int> ids;
};

/// Adds the mirror images of these taxels and links each pair. If a taxel is already within `tolerance` [m] of an
/// image, that taxel is linked instead. Taxels in the plane and taxels already linked across the plane do not change. A
/// taxel that would overlap with its own image by more than kLargeOverlap is moved into the plane, and its normal is
/// turned into the plane. Images get unused_ids in the order given, and the names of with_mirror_images.
struct MirrorTaxels {
  std::vector<int> ids;
  MirrorPlane plane;
  double tolerance = 1e-6;
  /// The skin of the taxels. If it is not symmetric, the image of a taxel on the skin whose normal is that of the skin
  /// is moved onto the skin. If null, images are at their mirrored places.
  std::shared_ptr<const MeshIndex> skin = nullptr;
};

/// Links pairs of existing taxels without moving them.
struct LinkTaxels {
  std::vector<MirrorLink> links;
  MirrorPlane plane;
};

/// Removes all links of these taxels.
struct UnlinkTaxels {
  std::vector<int> ids;
};

/// Hides these taxels and shows all others.
struct SetHidden {
  std::vector<int> ids;
};

/// Replaces the painted region (layout.sampling.region) by these faces, in any order.
struct SetRegion {
  std::vector<int> faces;
};

// Settings of the layout, each as a whole.
struct SetName {
  std::string name;
};
struct SetFrame {
  SensorFrame frame;
};
struct SetSampling {
  Sampling sampling;
};
struct SetReceptiveField {
  ReceptiveFieldRule rule;
};
struct SetReadout {
  Readout readout;
};
struct SetMaterial {
  Material material;
};
struct SetRepair {
  RepairRecipe repair;
};
struct SetCalibration {
  std::optional<Calibration> calibration;
};

struct SetScenario {
  Scenario scenario;
};

/// Replaces the mesh, or its unit, without moving the taxels. Face indices of the old mesh are not valid on a new mesh,
/// so `region` replaces the painted region.
struct ReplaceMesh {
  MeshRef mesh;
  std::vector<int> region;
};

/// Replaces the layout (a file read again, an import). Links and hidden taxels remain if both layouts have their ids.
/// The ids of the new layout must be unique (make_ids_unique).
struct ReplaceLayout {
  Layout layout;
};

/// Replaces the project (a file read again) except its view. Throws Error as check_project() does.
struct ReplaceProject {
  Project project;
};

/// Applies several edits as one: all of them, or none if one is refused.
struct EditList;
struct ApplyAll {
  std::string name;  ///< name in the Edit menu
  std::shared_ptr<const EditList> edits;
};

/// One of the edits above. The special members are defined in edit.cpp: inline, the code for this many alternatives
/// would take most of the compile time of every file that makes an edit.
struct Edit : std::variant<AddTaxels, DeleteTaxels, SetTaxels, RenumberTaxels, ReorderTaxels, MirrorTaxels, LinkTaxels,
                           UnlinkTaxels, SetHidden, SetRegion, SetName, SetFrame, SetSampling, SetReceptiveField,
                           SetReadout, SetMaterial, SetRepair, SetCalibration, SetScenario, ReplaceMesh, ReplaceLayout,
                           ReplaceProject, ApplyAll> {
  using variant::variant;
  Edit(const Edit&);
  Edit& operator=(const Edit&);
  Edit(Edit&&) noexcept;
  Edit& operator=(Edit&&) noexcept;
  ~Edit();
};
struct EditList {
  std::vector<Edit> edits;  ///< edits in the order of application
};

/// Returns the project after the edit. Throws Error that names the taxel ("taxel 3: radius: must be greater than 0, is
/// -1") or the setting ("/material/modulus: ...") by the rules of layout_check. An edit cannot add an error, and one
/// error of a broken layout can be repaired without the others.
Project apply_edit(const Project& project, const Edit& edit);

/// Returns the name of the edit for the Edit menu: "Move taxel 3", "Delete 6 taxels", "Change the material".
std::string edit_name(const Edit& edit);

}  // namespace taxel
