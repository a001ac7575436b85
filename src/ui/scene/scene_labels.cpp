#include "ui/scene/scene_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "ui/scene/marks/marks.h"
#include "ui/scene/scene_parts.h"

namespace taxel::ui {
namespace {

constexpr double kPastTip = 9;   // [pixel]
constexpr int kManyLabels = 60;  // if there are more taxels, only those that face the eye have labels
constexpr std::size_t kMaxLabels = 250;
constexpr double kLetterWidth = 0.62;  // width of a digit as a fraction of its height
constexpr std::size_t kLettersOfTaxels = 4, kLettersOfForces = 8;
constexpr int kMaxLeaders = 24;               // more lines would cross each other
constexpr int kMaxHiddenLabels = 12;          // if there are more taxels, those behind solid bodies have no labels
constexpr dvec2 kAround(7, 3);                // background and gap around a label, both sides together [pixel]
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
  double reading = 0;
  dvec2 tip{0};  ///< pixel of the tip of the arrow
  /// Returns a number that spreads taxels evenly and is always the same, so that labels do not jump while the view
  /// turns (Knuth 6.4).
  [[nodiscard]] std::uint32_t place() const { return static_cast<std::uint32_t>(taxel) * 2654435769u; }
  [[nodiscard]] auto rank() const { return std::tuple(!selected, !facing, place(), view->index); }
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
/// cells must be searched.
class Room {
 public:
  Room(dvec2 view, dvec2 cell) : cell_(cell), columns_(static_cast<int>(view.x / cell.x) + 3) {
    cells_.resize(static_cast<std::size_t>(columns_) * (static_cast<std::size_t>(view.y / cell.y) + 3));
  }
  /// Reserves a place for a box around `at`, not wider than a cell and a half. Returns false if another box is in the
  /// place.
  bool take(const dvec2& at, const dvec2& half) {
    const int x = 1 + static_cast<int>(at.x / cell_.x), y = 1 + static_cast<int>(at.y / cell_.y);
    for (int j = y - 1; j <= y + 1; ++j) {
      for (int i = x - 1; i <= x + 1; ++i) {
        for (const Box& other : cells_[static_cast<std::size_t>(j * columns_ + i)]) {
          const dvec2 apart = glm::abs(at - other.at);
          if (apart.x < half.x + other.half.x && apart.y < half.y + other.half.y) return false;
        }
      }
    }
    cells_[static_cast<std::size_t>(y * columns_ + x)].push_back({at, half});
    return true;
  }

 private:
  struct Box {
    dvec2 at, half;
  };
  dvec2 cell_;
  int columns_;
  std::vector<std::vector<Box>> cells_;
};

std::vector<Candidate> candidates(const std::vector<SensorView>& views, const Camera& camera, const dvec2& size,
                                  const std::optional<ClipPlane>& clip) {
  std::vector<Candidate> found;
  for (const SensorView& view : views) {
    const double arrow = taxel_arrow_length(*view.model);
    const bool many = view.model->taxel_count() > kManyLabels;
    for (int k = 0; k < view.model->taxel_count(); ++k) {
      if (view.hidden(k)) continue;
      const auto c = candidate(view, k, arrow, camera, size, clip);
      if (c && (c->facing || c->selected || !many)) found.push_back(*c);
    }
  }
  std::sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) { return a.rank() < b.rank(); });
  return found;
}

/// The placed labels of one frame. A label gets a place only if no earlier label is there.
class Placed {
 public:
  Placed(dvec2 view, dvec2 letter, std::size_t longest)
      : letter_(letter), room_(view, {static_cast<double>(longest) * letter.x + kAround.x, letter.y + kAround.y}) {}
  /// Reserves the place of a label that is then to be added. Returns false if another label is in the place.
  bool take(const SceneLabel& label) {
    const dvec2 box = dvec2(static_cast<double>(label.text.size()) * letter_.x, letter_.y) + kAround;
    return labels_.size() < kMaxLabels && room_.take(label.pixel, 0.5 * box);
  }
  void add(SceneLabel label, double depth) { labels_.emplace_back(depth, std::move(label)); }
  [[nodiscard]] bool full() const { return labels_.size() >= kMaxLabels; }
  [[nodiscard]] std::vector<SceneLabel> farthest_first() {
    std::stable_sort(labels_.begin(), labels_.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<SceneLabel> out;
    for (auto& [depth, label] : labels_) out.push_back(std::move(label));
    return out;
  }

 private:
  dvec2 letter_;
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
  const std::vector<std::string>& geoms = input.frame->scene->sensor_geoms;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const auto s = static_cast<std::size_t>(views[v].index);
    names[v] = s < geoms.size() && !geoms[s].empty() ? geoms[s] + " " : fmt::format("{}/", views[v].index + 1);
  }
  return names;
}

SceneLabel label_of(const Candidate& c, const std::string& prefix) {
  SceneLabel label;
  label.text = fmt::format("{}{}", prefix, c.view->model->layout.taxels[static_cast<std::size_t>(c.taxel)].id);
  label.pixel = c.pixel;
  label.selected = c.selected;
  label.sensor = c.view->index;
  label.taxel = c.taxel;
  return label;
}

/// Moves a label to the nearest free place around its own, and gives it a leader. Tries places away from `middle`
/// first. Returns false if there is none.
bool move_aside(SceneLabel& label, const Candidate& c, const dvec2& middle, double step, const dvec2& size,
                Placed& placed) {
  constexpr int kRounds = 5, kDirections = 12;
  const dvec2 own = label.pixel;
  const double outwards = std::atan2(own.y - middle.y, own.x - middle.x);
  for (int round = 1; round <= kRounds; ++round) {
    for (int i = 0; i < kDirections; ++i) {
      const double turn = kPi / kDirections * (i + i % 2) * (i % 2 == 0 ? 1 : -1), angle = outwards + turn;
      label.pixel = own + (0.6 + round) * step * dvec2(std::cos(angle), std::sin(angle));
      const dvec2 margin(2 * step, 0.6 * step);
      if (!is_inside(label.pixel - margin, size) || !is_inside(label.pixel + margin, size)) continue;
      if (!placed.take(label)) continue;
      label.leader = c.tip;
      return true;
    }
  }
  return false;
}

std::vector<Candidate> marked_candidates(const SceneInput& input, const std::vector<SensorView>& views,
                                         const Camera& camera, const dvec2& size) {
  const std::vector<std::vector<int>> marked = marked_taxels(input, views);
  std::vector<Candidate> found;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const double arrow = taxel_arrow_length(*views[v].model);
    for (const int k : marked[v]) {
      auto c = candidate(views[v], k, arrow, camera, size, input.clip);
      if (!c) continue;
      c->hovered = is_hovered(input, views[v], k);
      found.push_back(*c);
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    return std::tuple(!a.hovered, !a.selected, -a.reading) < std::tuple(!b.hovered, !b.selected, -b.reading);
  });
  return found;
}

/// Adds the ids of the marked taxels, with leaders where they would overlap.
void add_marked(const SceneInput& input, const std::vector<SensorView>& views, const Camera& camera, const dvec2& size,
                double step, Placed& placed) {
  const std::vector<Candidate> found = marked_candidates(input, views, camera, size);
  const std::vector<std::string> names = prefixes(input, views);
  dvec2 middle(0);
  for (const Candidate& c : found) middle += c.pixel / static_cast<double>(found.size());
  int leaders = 0;
  for (const Candidate& c : found) {
    SceneLabel label = label_of(c, names[static_cast<std::size_t>(c.view - views.data())]);
    const Sighting seen = sighting(input, views, *c.view, c.taxel, camera.eye());
    const bool wanted = c.selected || c.hovered || found.size() <= kMaxHiddenLabels;
    if (seen == Sighting::hidden && !wanted) continue;
    label.occluded = seen != Sighting::clear;
    if (!placed.take(label)) {
      if (leaders == kMaxLeaders || !move_aside(label, c, middle, step, size, placed)) continue;
      ++leaders;
    }
    placed.add(std::move(label), c.depth);
  }
}

/// Adds the net forces at the tips of their arrows.
void add_forces(const SceneInput& input, const std::vector<SensorView>& views, const Camera& camera, const dvec2& size,
                Placed& placed) {
  for (const ForceMark& mark : force_marks(input, views)) {
    const int width = static_cast<int>(size.x), height = static_cast<int>(size.y);
    const dvec3 base = camera.project(mark.base_W, width, height), tip = camera.project(mark.tip_W, width, height);
    if (!(base.z > 0 && tip.z > 0)) continue;
    SceneLabel label;
    label.text = force_text(mark.force);
    const dvec2 along(tip - base);
    const double pixels = glm::length(along);
    label.pixel = dvec2(tip) + 2 * kPastTip * (pixels > 1 ? along / pixels : dvec2(0, -1));
    label.sensor = mark.sensor;
    if (is_inside(label.pixel, size) && placed.take(label)) placed.add(std::move(label), tip.z);
  }
}

void add_taxels(const SceneInput& input, const std::vector<SensorView>& views, const Camera& camera, const dvec2& size,
                Placed& placed) {
  const std::vector<std::string> names = prefixes(input, views);
  for (const Candidate& c : candidates(views, camera, size, input.clip)) {
    if (placed.full()) return;
    SceneLabel label = label_of(c, names[static_cast<std::size_t>(c.view - views.data())]);
    if (!placed.take(label)) continue;
    label.occluded = !c.facing || hidden(input, *c.view, camera, c.center_W);
    placed.add(std::move(label), c.depth);
  }
}

}  // namespace

std::vector<SceneLabel> scene_labels(const SceneInput& input, const Camera& camera, int width, int height,
                                     double text_height) {
  const dvec2 size(width, height), letter(kLetterWidth * text_height, text_height);
  const std::vector<NamedPixel> parts = named_pixels(input, camera, size);
  const std::vector<SensorView> views = sensor_views(input);
  std::size_t longest = kLettersOfForces;
  for (const std::string& name : prefixes(input, views)) longest = std::max(longest, name.size() + kLettersOfTaxels);
  for (const NamedPixel& part : parts) longest = std::max(longest, part.name->size());
  Placed placed(size, letter, longest);
  for (const NamedPixel& part : parts) {
    SceneLabel label;
    label.text = *part.name;
    label.pixel = part.pixel;
    if (placed.take(label)) placed.add(std::move(label), part.depth);
  }
  add_forces(input, views, camera, size, placed);
  if (input.overlays.taxel_labels && input.overlays.all_taxels) add_taxels(input, views, camera, size, placed);
  if (input.overlays.taxel_labels && !input.overlays.all_taxels)
    add_marked(input, views, camera, size, 1.5 * text_height, placed);
  return placed.farthest_first();
}

}  // namespace taxel::ui
