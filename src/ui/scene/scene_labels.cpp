#include "ui/scene/scene_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "ui/scene/marks/marks.h"
#include "ui/scene/scene_parts.h"

namespace taxel::ui {
namespace {

constexpr double kPastTip = 9;   // [pixel]
constexpr int kManyLabels = 60;  // if there are more taxels, only those that face the eye have labels
constexpr std::size_t kMaxLabels = 250;
constexpr double kLetterWidth = 0.62;  // width of a digit as a fraction of its height
constexpr int kMaxLeaders = 24;        // more lines would cross each other
constexpr int kMaxHiddenLabels = 12;   // if there are more taxels, those behind solid bodies have no labels in X-ray
constexpr dvec2 kAround(7, 3);         // background and gap around a label, both sides together [pixel]
constexpr double kKeptReading = 1.33;  // a label yields to a reading that is larger by this factor
constexpr double kFreeMargin = 6;      // more room that a label with a leader needs to return to its own place [pixel]
constexpr double kSmallForce = 0.01;   // forces below this part of the largest force have no label
constexpr double kOcclusionTolerance = 4e-3;  // a point this close to a body, as a fraction of its distance, is visible

bool hidden(const SceneInput& input, const SensorView& view, const Camera& camera, const dvec3& p_W) {
  const dvec3 eye_W = camera.eye();
  const double distance = glm::length(p_W - eye_W);
  const Ray ray{eye_W, (p_W - eye_W) / distance, distance - kOcclusionTolerance * camera.depth_scale(distance)};
  if (cast_geoms(input, ray)) return true;
  return !input.overlays.sensor_transparent && view.model->skin->cast(in_frame(view.X_WM, ray)).has_value();
}

/// Returns true if a pixel is inside the view. Returns false for a pixel that is not finite: only this check bounds the
/// index that class Room computes from a pixel.
bool is_inside(const dvec2& pixel, const dvec2& size) {
  return pixel.x >= 0 && pixel.y >= 0 && pixel.x <= size.x && pixel.y <= size.y;
}

/// A taxel that could have a label.
struct Candidate {
  const SensorView* view = nullptr;
  int taxel = 0;
  dvec3 center_W{0};
  dvec2 pixel{0};
  double depth = 0;
  bool facing = false, selected = false, hovered = false;
  double reading = 0;                    ///< reading, or that of the previous label while both are close
  const SceneLabel* previous = nullptr;  ///< label of the previous frame, or null
  dvec2 tip{0};                          ///< pixel of the tip of the arrow
  [[nodiscard]] bool is_first() const { return hovered || selected; }
  /// Returns the reading by which candidates are sorted, raised if the taxel had a label in the previous frame.
  [[nodiscard]] double weight() const { return previous != nullptr ? kKeptReading * reading : reading; }
  /// Returns a number that spreads taxels evenly and is always the same, so that labels do not jump while the view
  /// turns (Knuth 6.4).
  [[nodiscard]] std::uint32_t place() const { return static_cast<std::uint32_t>(taxel) * 2654435769u; }
  [[nodiscard]] auto rank() const { return std::tuple(!hovered, !selected, !facing, -weight(), place(), view->index); }
};

std::optional<Candidate> candidate(const SensorView& view, int k, double arrow, const Camera& camera, dvec2 size,
                                   const std::optional<ClipPlane>& clip) {
  const Taxel& taxel = view.model->layout.taxels[static_cast<std::size_t>(k)];
  const int width = static_cast<int>(size.x), height = static_cast<int>(size.y);
  const dvec3 center = view.X_WM * taxel.center, normal = view.X_WM.rotate(glm::normalize(taxel.normal));
  if (clip && clip->hides(center)) return std::nullopt;
  const dvec3 base = camera.project(center, width, height);
  const dvec3 tip = camera.project(center + arrow * normal, width, height);
  if (!(base.z > 0 && tip.z > 0)) return std::nullopt;  // NaN fails every comparison
  const dvec2 along(tip - base);
  const double pixels = glm::length(along);
  const dvec2 at = dvec2(tip) + kPastTip * (pixels > 1 ? along / pixels : dvec2(0, -1));
  if (!is_inside(at, size)) return std::nullopt;
  const bool facing = glm::dot(normal, camera.eye() - center) > 0;
  Candidate found{&view, k, center, at, tip.z, facing, view.selected(k)};
  found.tip = dvec2(tip);
  if (view.state != nullptr && static_cast<std::size_t>(k) < view.state->readings.size())
    found.reading = view.state->readings[static_cast<std::size_t>(k)];
  return found;
}

/// The places of existing labels, in a grid whose cells are as large as the longest label, so that only neighbouring
/// cells must be searched, and the covered boxes.
class Room {
 public:
  Room(dvec2 view, dvec2 cell, std::span<const LabelBox> covered)
      : view_(view), cell_(cell), covered_(covered), columns_(static_cast<int>(view.x / cell.x) + 3) {
    cells_.resize(static_cast<std::size_t>(columns_) * (static_cast<std::size_t>(view.y / cell.y) + 3));
  }

  /// Returns the place nearest to `at` at which a box is inside of the view.
  [[nodiscard]] dvec2 inside(const dvec2& at, const dvec2& half) const {
    return glm::max(glm::min(at, view_ - half), glm::min(half, 0.5 * view_));
  }

  /// Returns whether no other box overlaps a box around `at`, not wider than a cell and a half.
  [[nodiscard]] bool is_free(const dvec2& at, const dvec2& half) const {
    for (const LabelBox& box : covered_)
      if (at.x + half.x > box.lo.x && at.x - half.x < box.hi.x && at.y + half.y > box.lo.y && at.y - half.y < box.hi.y)
        return false;
    const int x = column(at), y = row(at);
    for (int j = y - 1; j <= y + 1; ++j) {
      for (int i = x - 1; i <= x + 1; ++i) {
        for (const Box& other : cells_[static_cast<std::size_t>(j * columns_ + i)]) {
          const dvec2 apart = glm::abs(at - other.at);
          if (apart.x < half.x + other.half.x && apart.y < half.y + other.half.y) return false;
        }
      }
    }
    return true;
  }
  void reserve(const dvec2& at, const dvec2& half) {
    cells_[static_cast<std::size_t>(row(at) * columns_ + column(at))].push_back({at, half});
  }

 private:
  struct Box {
    dvec2 at, half;
  };
  [[nodiscard]] int column(const dvec2& at) const { return 1 + static_cast<int>(at.x / cell_.x); }
  [[nodiscard]] int row(const dvec2& at) const { return 1 + static_cast<int>(at.y / cell_.y); }

  dvec2 view_, cell_;
  std::span<const LabelBox> covered_;
  int columns_;
  std::vector<std::vector<Box>> cells_;
};

/// The labels of the previous frame by their taxels.
class PreviousLabels {
 public:
  explicit PreviousLabels(std::span<const SceneLabel> labels) {
    for (const SceneLabel& label : labels)
      if (label.taxel >= 0) labels_.emplace(std::pair(label.sensor, label.taxel), &label);
  }
  /// Finds the label of a candidate. Its reading replaces that of the candidate unless they differ by more than a
  /// third, so that labels do not change their order while readings vary.
  void find(Candidate& c) const {
    const auto found = labels_.find(std::pair(c.view->index, c.taxel));
    if (found == labels_.end()) return;
    c.previous = found->second;
    const double before = found->second->reading;
    if (c.reading <= kKeptReading * before && before <= kKeptReading * c.reading) c.reading = before;
  }

 private:
  std::map<std::pair<int, int>, const SceneLabel*> labels_;
};

/// Returns the candidates if all taxels have marks, the first ones first.
std::vector<Candidate> all_candidates(const SceneInput& input, const std::vector<SensorView>& views,
                                      const Camera& camera, const dvec2& size, const PreviousLabels& previous) {
  std::vector<Candidate> found;
  for (const SensorView& view : views) {
    const double arrow = taxel_arrow_length(*view.model);
    const bool many = view.model->taxel_count() > kManyLabels;
    for (int k = 0; k < view.model->taxel_count(); ++k) {
      if (view.hidden(k)) continue;
      auto c = candidate(view, k, arrow, camera, size, input.clip);
      if (!c || !(c->facing || c->selected || !many)) continue;
      c->hovered = is_hovered(input, view, k);
      previous.find(*c);
      found.push_back(*c);
    }
  }
  std::sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) { return a.rank() < b.rank(); });
  return found;
}

/// The placed labels of one frame. A label gets a place only if no earlier label is there.
class Placed {
 public:
  Placed(dvec2 view, const LabelRoom& room, double widest)
      : text_(room), room_(view, dvec2(widest, room.text_height) + kAround, room.covered) {}

  /// Sets the box of a label, and moves it into the view.
  void measure(SceneLabel& label) const {
    label.half = 0.5 * dvec2(width_of(text_, label.text), text_.text_height);
    label.pixel = room_.inside(label.pixel, label.half + 0.5 * kAround);
  }
  /// Reserves the place of a measured label that is then to be added. Returns false if another label is in the place,
  /// or closer than `margin`.
  bool take(const SceneLabel& label, double margin = 0) {
    const dvec2 half = label.half + 0.5 * kAround;
    if (full() || !room_.is_free(label.pixel, half + margin)) return false;
    room_.reserve(label.pixel, half);
    return true;
  }
  void add(SceneLabel label, double depth) { labels_.emplace_back(depth, std::move(label)); }
  [[nodiscard]] bool full() const { return labels_.size() >= kMaxLabels; }
  [[nodiscard]] std::vector<SceneLabel> farthest_first() {
    std::stable_sort(labels_.begin(), labels_.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<SceneLabel> out;
    for (auto& [depth, label] : labels_) out.push_back(std::move(label));
    return out;
  }
  /// Returns the width of a text.
  [[nodiscard]] static double width_of(const LabelRoom& room, const std::string& text) {
    return room.width ? room.width(text) : kLetterWidth * room.text_height * static_cast<double>(text.size());
  }

 private:
  const LabelRoom& text_;
  Room room_;
  std::vector<std::pair<double, SceneLabel>> labels_;
};

/// A part of the scene at a pixel of the frame.
struct NamedPixel {
  const std::string* name = nullptr;
  dvec2 pixel{0};
  double depth = 0;
};

/// Returns the named parts, the nearest first.
std::vector<NamedPixel> named_pixels(const SceneInput& input, const Camera& camera, const dvec2& size) {
  std::vector<NamedPixel> found;
  for (const NamedPlace& place : labelled_places(input)) {
    if (input.clip && input.clip->hides(place.p_W)) continue;
    const dvec3 pixel = camera.project(place.p_W, static_cast<int>(size.x), static_cast<int>(size.y));
    if (pixel.z > 0 && is_inside(dvec2(pixel), size)) found.push_back({place.name, dvec2(pixel), pixel.z});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const NamedPixel& a, const NamedPixel& b) { return a.depth < b.depth; });
  return found;
}

/// Returns the name of each sensor with a space, or empty names if there is only one sensor.
std::vector<std::string> prefixes(const SceneInput& input, const std::vector<SensorView>& views) {
  const auto count =
      std::count_if(views.begin(), views.end(), [](const SensorView& v) { return v.model->taxel_count() > 0; });
  std::vector<std::string> names(views.size());
  if (count < 2 || !input.frame || !input.frame->scene) return names;
  for (std::size_t v = 0; v < views.size(); ++v)
    names[v] = label_of_sensor(*input.frame->scene, static_cast<std::size_t>(views[v].index)) + " ";
  return names;
}

SceneLabel label_of(const Candidate& c, const std::string& prefix) {
  SceneLabel label;
  label.text = fmt::format("{}{}", prefix, c.view->model->layout.taxels[static_cast<std::size_t>(c.taxel)].id);
  label.pixel = c.pixel;
  label.selected = c.selected;
  label.sensor = c.view->index;
  label.taxel = c.taxel;
  label.reading = c.reading;
  return label;
}

constexpr int kRounds = 5, kDirections = 12;  // of the places around a label's own place

/// Returns a place around the own one: slots count from 1, round by round, each from the right downwards.
dvec2 slot_place(const SceneLabel& label, const dvec2& own, int slot, double step) {
  const int round = 1 + (slot - 1) / kDirections;
  const double angle = 2 * kPi / kDirections * ((slot - 1) % kDirections);
  const double stretch = std::clamp(label.half.x / step, 1.0, 2.5);  // a wide label must move farther to the side
  return own + (0.6 + round) * step * dvec2(stretch * std::cos(angle), std::sin(angle));
}

/// Moves a label to a free place around its own, and gives it a leader: to its slot of the previous frame, or to the
/// nearest free one, away from `middle` if several are as near. Returns false if there is none.
bool move_aside(SceneLabel& label, const Candidate& c, const dvec2& middle, double step, const dvec2& size,
                Placed& placed) {
  const dvec2 own = label.pixel;
  const auto try_slot = [&](int slot) {
    label.pixel = slot_place(label, own, slot, step);
    const dvec2 half = label.half + 0.5 * kAround;
    if (!is_inside(label.pixel - half, size) || !is_inside(label.pixel + half, size)) return false;
    if (!placed.take(label)) return false;
    label.slot = slot;
    label.leader = c.tip;
    return true;
  };
  if (c.previous != nullptr && c.previous->slot > 0 && try_slot(c.previous->slot)) return true;
  const double outwards = std::atan2(own.y - middle.y, own.x - middle.x);
  const int first = static_cast<int>(std::lround(outwards * kDirections / (2 * kPi))) + kDirections;
  for (int round = 0; round < kRounds; ++round) {
    for (int i = 0; i < kDirections; ++i) {
      const int turn = (i + 1) / 2 * (i % 2 == 0 ? 1 : -1);
      if (try_slot(1 + round * kDirections + (first + turn + kDirections) % kDirections)) return true;
    }
  }
  return false;
}

/// Returns the candidates among the marked taxels, the first ones first.
std::vector<Candidate> marked_candidates(const SceneInput& input, const std::vector<SensorView>& views,
                                         const Camera& camera, const dvec2& size, const PreviousLabels& previous) {
  const std::vector<std::vector<int>> marked = marked_taxels(input, views);
  std::vector<Candidate> found;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const double arrow = taxel_arrow_length(*views[v].model);
    for (const int k : marked[v]) {
      auto c = candidate(views[v], k, arrow, camera, size, input.clip);
      if (!c) continue;
      c->hovered = is_hovered(input, views[v], k);
      previous.find(*c);
      found.push_back(*c);
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    return std::tuple(!a.hovered, !a.selected, -a.weight()) < std::tuple(!b.hovered, !b.selected, -b.weight());
  });
  return found;
}

/// The taxels that may get labels in this frame, the first ones first, and the names of their sensors.
struct TaxelLabels {
  const SceneInput& input;
  const std::vector<SensorView>& views;
  const Camera& camera;
  dvec2 size;       ///< size of the view [pixel]
  double step = 0;  ///< distance of the places around a label's own place [pixel]
  std::vector<Candidate> candidates;
  std::vector<std::string> prefixes;  ///< parallel to `views`
  int leaders = 0;                    ///< number of placed labels with leaders

  [[nodiscard]] SceneLabel label(const Candidate& c) const {
    return label_of(c, prefixes[static_cast<std::size_t>(c.view - views.data())]);
  }
};

/// Adds the ids of the marked taxels that are hovered or selected (`first`), or of the other ones, with leaders where
/// they would overlap.
void add_marked(TaxelLabels& taxels, bool first, Placed& placed) {
  dvec2 middle(0);
  const auto count = static_cast<double>(taxels.candidates.size());
  for (const Candidate& c : taxels.candidates) middle += c.pixel / count;
  for (const Candidate& c : taxels.candidates) {
    if (c.is_first() != first) continue;
    SceneLabel label = taxels.label(c);
    placed.measure(label);
    const Sighting seen = sighting(taxels.input, taxels.views, *c.view, c.taxel, taxels.camera.eye());
    const bool wanted =
        c.is_first() || (taxels.input.overlays.sensor_transparent && taxels.candidates.size() <= kMaxHiddenLabels);
    if (seen == Sighting::hidden && !wanted) continue;
    label.occluded = seen != Sighting::clear;
    const bool was_moved = c.previous != nullptr && c.previous->slot > 0;
    if (!placed.take(label, was_moved ? kFreeMargin : 0.0)) {
      if (taxels.leaders == kMaxLeaders || !move_aside(label, c, middle, taxels.step, taxels.size, placed)) continue;
      ++taxels.leaders;
    }
    placed.add(std::move(label), c.depth);
  }
}

/// Returns whether an opaque skin, or a body, hides a taxel.
bool is_behind_opaque_skin(const TaxelLabels& taxels, const Candidate& c) {
  return !taxels.input.overlays.sensor_transparent &&
         sighting(taxels.input, taxels.views, *c.view, c.taxel, taxels.camera.eye()) == Sighting::hidden;
}

/// Adds the ids of taxels at their own places: those that are hovered or selected (`first`), or the other ones.
void add_all(const TaxelLabels& taxels, bool first, Placed& placed) {
  for (const Candidate& c : taxels.candidates) {
    if (placed.full()) return;
    if (c.is_first() != first) continue;
    if (!c.is_first() && is_behind_opaque_skin(taxels, c)) continue;
    SceneLabel label = taxels.label(c);
    placed.measure(label);
    if (!placed.take(label)) continue;
    label.occluded = !c.facing || hidden(taxels.input, *c.view, taxels.camera, c.center_W);
    placed.add(std::move(label), c.depth);
  }
}

void add_taxels(TaxelLabels& taxels, bool first, Placed& placed) {
  if (taxels.input.overlays.all_taxels) return add_all(taxels, first, placed);
  add_marked(taxels, first, placed);
}

/// Adds the net forces at the tips of their arrows, the largest first.
void add_forces(const SceneInput& input, const std::vector<SensorView>& views, const Camera& camera, const dvec2& size,
                Placed& placed) {
  std::vector<ForceMark> marks = force_marks_aside(input, views, camera);
  std::stable_sort(marks.begin(), marks.end(),
                   [](const ForceMark& a, const ForceMark& b) { return a.force > b.force; });
  for (const ForceMark& mark : marks) {
    if (mark.force < kSmallForce * marks.front().force) return;
    const int width = static_cast<int>(size.x), height = static_cast<int>(size.y);
    const dvec3 base = camera.project(mark.base_W, width, height), tip = camera.project(mark.tip_W, width, height);
    if (!(base.z > 0 && tip.z > 0)) continue;
    SceneLabel label;
    label.text = force_text(mark.force);
    const dvec2 along(tip - base);
    const double pixels = glm::length(along);
    const dvec2 ahead = pixels > 1 ? along / pixels : dvec2(0, -1);
    label.sensor = mark.sensor;
    placed.measure(label);
    // The box ends before the tip in each direction of the arrow.
    label.pixel = dvec2(tip) + (kPastTip + glm::dot(label.half, glm::abs(ahead))) * ahead;
    if (!is_inside(label.pixel, size)) continue;
    placed.measure(label);
    if (placed.take(label)) placed.add(std::move(label), tip.z);
  }
}

/// Adds the names of parts of the scene.
void add_parts(const std::vector<NamedPixel>& parts, Placed& placed) {
  for (const NamedPixel& part : parts) {
    SceneLabel label;
    label.text = *part.name;
    label.pixel = part.pixel;
    placed.measure(label);
    if (placed.take(label)) placed.add(std::move(label), part.depth);
  }
}

/// Returns the width of the widest possible label.
double widest_label(const LabelRoom& room, const std::vector<SensorView>& views,
                    const std::vector<std::string>& prefixes, const std::vector<NamedPixel>& parts) {
  double widest = Placed::width_of(room, "00000.00 N");
  for (std::size_t v = 0; v < views.size(); ++v) {
    int largest = 0;
    for (const Taxel& taxel : views[v].model->layout.taxels) largest = std::max(largest, taxel.id);
    const std::string digits(std::to_string(largest).size(), '0');
    widest = std::max(widest, Placed::width_of(room, prefixes[v] + digits));
  }
  for (const NamedPixel& part : parts) widest = std::max(widest, Placed::width_of(room, *part.name));
  return widest;
}

}  // namespace

std::vector<SceneLabel> scene_labels(const SceneInput& input, const Camera& camera, int width, int height,
                                     const LabelRoom& room) {
  const dvec2 size(width, height);
  const std::vector<NamedPixel> parts = named_pixels(input, camera, size);
  const std::vector<SensorView> views = sensor_views(input);
  TaxelLabels taxels{input, views, camera, size, 1.5 * room.text_height, {}, prefixes(input, views)};
  const PreviousLabels previous(room.previous);
  if (input.overlays.taxel_labels)
    taxels.candidates = input.overlays.all_taxels ? all_candidates(input, views, camera, size, previous)
                                                  : marked_candidates(input, views, camera, size, previous);
  Placed placed(size, room, widest_label(room, views, taxels.prefixes, parts));
  add_taxels(taxels, true, placed);
  add_parts(parts, placed);
  add_forces(input, views, camera, size, placed);
  add_taxels(taxels, false, placed);
  return placed.farthest_first();
}

}  // namespace taxel::ui
