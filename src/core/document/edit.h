// Edits are values: what a tool, a panel or a script wants done to a project.
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

/// At the end, in this order; or before the taxel `before`. Their ids must be unused (unused_ids).
struct AddTaxels {
  std::vector<Taxel> taxels;
  std::optional<int> before;
};

/// Their links, calibration and hidden state go with them; the twin of a deleted taxel stays, on its own.
struct DeleteTaxels {
  std::vector<int> ids;
};

/// New values of one taxel; what is not set stays.
struct TaxelChange {
  int id = 0;
  std::optional<std::string> name;
  std::optional<dvec3> center;  ///< [m], frame M
  std::optional<dvec3> normal;
  std::optional<double> radius;  ///< [m]
  /// Where only the centre is set, subtaxels move with it; where the normal is set too and turns by less than 90
  /// degrees, they turn with it about the centre.
  std::optional<std::vector<Subtaxel>> subtaxels;
};

/// Move, turn, resize, rename, subtaxels: any fields of any taxels at once, each id once. Twins follow in all but
/// names; one that is listed itself keeps what is listed.
struct SetTaxels {
  std::vector<TaxelChange> changes;
  bool twins_follow = true;
};

/// New ids (from, to), all at once, so that two can be exchanged. Everything that names the taxel follows.
struct RenumberTaxels {
  std::vector<std::pair<int, int>> ids;
};

/// All ids in their new order, which is that of the readings.
struct ReorderTaxels {
  std::vector<int> ids;
};

/// Adds the mirror images of these taxels and links each pair. Where a taxel already lies within `tolerance` [m] of an
/// image, it is linked instead; taxels in the plane and those already linked across it stay as they are. One that would
/// overlap with its own image by more than kLargeOverlap is moved into the plane instead, and its normal turned into
/// it. Images get unused_ids in the order given, and with_mirror_images' names.
struct MirrorTaxels {
  std::vector<int> ids;
  MirrorPlane plane;
  double tolerance = 1e-6;
  /// The skin that the taxels are on. Where it is not symmetric, the image of a taxel that lies on it and looks along
  /// its normal is put onto it as well. Null: images are where the mirror puts them.
  std::shared_ptr<const MeshIndex> skin = nullptr;
};

/// Links pairs that are there; moves nothing.
struct LinkTaxels {
  std::vector<MirrorLink> links;
  MirrorPlane plane;
};

/// Ends all links of these taxels.
struct UnlinkTaxels {
  std::vector<int> ids;
};

/// The hidden taxels: these and no others.
struct SetHidden {
  std::vector<int> ids;
};

/// The painted region (layout.sampling.region): these faces and no others, in any order.
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

/// Another mesh, or the same in another unit, under the taxels, which stay where they are. Faces of the old mesh mean
/// nothing on a new one: `region` is what is painted from now on.
struct ReplaceMesh {
  MeshRef mesh;
  std::vector<int> region;
};

/// Another layout in this project (a file read again, an import). Links and hidden taxels stay where both know the
/// id. Its ids must be unique (make_ids_unique).
struct ReplaceLayout {
  Layout layout;
};

/// Another project in place of this one (a file read again). Throws what check_project throws. The view is not edited:
/// it stays.
struct ReplaceProject {
  Project project;
};

/// Several edits as one: all of them, or none where one is refused.
struct EditList;
struct ApplyAll {
  std::string name;  ///< for the Edit menu
  std::shared_ptr<const EditList> edits;
};

/// One of these. Copied, moved and destroyed in one place: the code for that, of so many kinds, in every file that
/// makes one takes most of its compile time.
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
  std::vector<Edit> edits;  ///< one after the other
};

/// The project after the edit. Pure. Throws Error that names the taxel ("taxel 3: radius: must be greater than 0, is
/// -1") or the setting ("/material/modulus: ..."), by the rules of layout_check: an edit cannot bring in what could not
/// be used, and one place of a broken layout can be mended without the others.
Project apply_edit(const Project& project, const Edit& edit);

/// For the Edit menu: "Move taxel 3", "Delete 6 taxels", "Change the material".
std::string edit_name(const Edit& edit);

/// Gives taxels whose id is negative, or that of an earlier one, an unused id; says so for each. What a file from
/// elsewhere needs before it becomes a project.
std::vector<std::string> make_ids_unique(Layout& layout);

/// Taxels from elsewhere (pasted, duplicated, generated) for adding to the layout: each keeps its id where no taxel has
/// it, in the layout or before it in the list; the others get unused ones.
std::vector<Taxel> with_unused_ids(std::vector<Taxel> taxels, const Layout& layout);

}  // namespace taxel
