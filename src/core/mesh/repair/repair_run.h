// One run of all steps of a repair over one mesh.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/repair/steps.h"
#include "core/mesh/repair/wrap/wrap.h"

namespace taxel {

/// The loaded mesh of a repair. Its index and its intersections are computed when they are first needed.
struct RepairSource {
  TriMeshPtr mesh;
  std::unique_ptr<const MeshIndex> index;      ///< index of the mesh, or null
  std::optional<SelfIntersections> crossings;  ///< intersections, if they were searched
};

class RepairRun {
 public:
  RepairRun(const TriMeshPtr& loaded, const RepairRecipe& recipe, const RepairLimits& limits, Progress* progress);
  /// Runs the steps. Throws as repair_mesh does.
  void run();
  /// The result with its steps and changes, but without the totals of its report. To be called once.
  RepairedMesh finish();

 private:
  /// Faces that are taken out of the draft to be wrapped.
  struct ToWrap {
    Draft faces;
    WrapKind kind;
  };

  /// Reports the step that begins, and the fraction of the repair that is done: never less than before.
  void begin(const char* step, double fraction);
  void note(RepairStep step);
  void take(const std::vector<char>& chosen, WrapKind kind);
  void close_without_filling();
  void remove_folds();
  void fill();
  void take_open_shells();
  void take_thin_shells();
  void set_sheets_aside();
  void recount_filled();
  enum class Crossed { cut, cut_or_wrap };
  void cure_crossed_shells(Crossed treatment);
  [[nodiscard]] bool is_crossed();
  void take_all();
  void check_encloses() const;
  void refuse_wrap() const;
  [[nodiscard]] double choose_edge() const;
  void wrap();
  bool unite();
  [[nodiscard]] bool is_closed() const;
  [[nodiscard]] bool is_as_loaded() const;
  [[nodiscard]] bool has_wrapped() const { return wrap_edge_ > 0; }
  void list_changes(RepairedMesh& repaired) const;

  RepairSource loaded_;
  const RepairRecipe& recipe_;
  const RepairLimits& limits_;
  Progress* progress_;
  Draft draft_;
  std::vector<ToWrap> to_wrap_;
  Draft sheets_;          ///< two-sided sheets of a rigid body
  double wrap_edge_ = 0;  ///< largest edge of a wrap; 0 if nothing was wrapped [m]
  RepairChanges changes_;
  std::vector<RepairStep> steps_;
};

}  // namespace taxel
