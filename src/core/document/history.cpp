#include "core/document/history.h"

#include <algorithm>
#include <set>

#include "core/document/edit.h"

namespace taxel {
namespace {

std::size_t heap(const std::string& text) {
  const std::size_t inside = std::string().capacity();  // short texts are stored in the object
  return text.capacity() > inside ? text.capacity() + 1 : 0;
}

template <class T>
std::size_t heap(const std::vector<T>& items) {
  return items.capacity() * sizeof(T);
}

std::size_t heap(const Layout& layout) {
  std::size_t bytes = heap(layout.name) + heap(layout.mesh.file) + heap(layout.mesh.sha256) + heap(layout.taxels);
  for (const Taxel& taxel : layout.taxels) bytes += heap(taxel.name) + heap(taxel.subtaxels);
  if (layout.calibration) {
    const Calibration& calibration = *layout.calibration;
    bytes += heap(calibration.unit) + heap(calibration.curve) + heap(calibration.taxels);
    for (const TaxelCalibration& taxel : calibration.taxels) bytes += heap(taxel.curve);
    for (const std::vector<double>& row : calibration.crosstalk_matrix) bytes += heap(row);
  }
  const std::size_t node = 4 * sizeof(void*);  // node of a red-black tree: parent, children, colour
  for (const auto& item : layout.unknown) bytes += node + sizeof(item) + heap(item.first) + heap(item.second);
  return bytes;
}

}  // namespace

std::size_t bytes_of(const Project& project) {
  std::size_t bytes = sizeof(Project) + heap(project.layout) + heap(project.scenario.object) + heap(project.mirrors) +
                      heap(project.hidden);
  visit_fields(project.scenario, [&](const FieldSpec&, const auto& value) {
    if constexpr (!std::is_same_v<decltype(value), const double&>) bytes += heap(value);
  });
  for (const Mirror& mirror : project.mirrors) bytes += heap(mirror.links);
  return bytes;
}

std::size_t bytes_of(const FaceSet& region) {
  return region.identity() != nullptr ? sizeof(*region) + heap(*region) : 0;
}

History::History(Project project, HistoryLimits limits) : limits_(limits) {
  const std::size_t bytes = bytes_of(project);
  last_revision_ = saved_revision_ = 1;
  steps_.push_back({std::make_shared<const Project>(std::move(project)), 1, "", 0, bytes});
}

bool History::continues(std::uint64_t gesture) const {
  return gesture != 0 && now_ > 0 && !can_redo() && steps_[now_].gesture == gesture;
}

bool History::apply(const Edit& edit, Gesture gesture) {
  const bool merge = continues(gesture.number);
  const ProjectPtr& from = merge && gesture.from_start ? steps_[now_ - 1].project : steps_[now_].project;
  Project edited = apply_edit(*from, edit);
  if (edited == *steps_[now_].project) return false;
  if (merge && edited == *steps_[now_ - 1].project) {  // dragged back to the start: no step
    cancel(gesture.number);
    return true;
  }
  const std::size_t bytes = bytes_of(edited);
  Step step{std::make_shared<const Project>(std::move(edited)), ++last_revision_, edit_name(edit), gesture.number,
            bytes};
  if (merge) {
    steps_[now_] = std::move(step);
  } else {
    undone_.assign(steps_.begin() + static_cast<std::ptrdiff_t>(now_) + 1, steps_.end());
    steps_.resize(now_ + 1);
    steps_.push_back(std::move(step));
    ++now_;
  }
  drop_oldest();
  return true;
}

void History::cancel(std::uint64_t gesture) {
  if (!continues(gesture)) return;
  steps_.pop_back();
  --now_;
  steps_.insert(steps_.end(), undone_.begin(), undone_.end());
  undone_.clear();
}

void History::end_gesture() {
  steps_[now_].gesture = 0;
  undone_.clear();
}

void History::undo() {
  end_gesture();
  if (can_undo()) --now_;
}

void History::redo() {
  if (can_redo()) ++now_;
}

void History::go_to(std::uint64_t revision) {
  const auto step = std::find_if(steps_.begin(), steps_.end(), [&](const Step& s) { return s.revision == revision; });
  if (step == steps_.end()) return;
  end_gesture();
  now_ = static_cast<std::size_t>(step - steps_.begin());
}

std::vector<HistoryStep> History::steps() const {
  std::vector<HistoryStep> listed;
  listed.reserve(steps_.size());
  for (const Step& step : steps_) listed.push_back({step.revision, step.name});
  return listed;
}

std::string History::undo_name() const {
  return can_undo() ? "Undo " + steps_[now_].name : "Undo";
}

std::string History::redo_name() const {
  return can_redo() ? "Redo " + steps_[now_ + 1].name : "Redo";
}

std::size_t History::bytes() const {
  std::size_t bytes = 0;
  std::set<const void*> regions;
  const auto add = [&](const Step& step) {
    bytes += step.bytes;
    if (regions.insert(step.project->layout.sampling.region.identity()).second)
      bytes += bytes_of(step.project->layout.sampling.region);
  };
  std::for_each(steps_.begin(), steps_.end(), add);
  std::for_each(undone_.begin(), undone_.end(), add);
  return bytes;
}

void History::drop_oldest() {
  if (bytes() > limits_.bytes) undone_.clear();
  // apply() has made the present step the last one. It and the previous step remain.
  while (now_ > 1 && (now_ > limits_.steps || bytes() > limits_.bytes)) {
    steps_.pop_front();
    --now_;
  }
}

}  // namespace taxel
