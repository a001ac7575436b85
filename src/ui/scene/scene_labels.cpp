#include "ui/scene/scene_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "ui/scene/marks/model_marks.h"
#include "ui/scene/scene_cast.h"
#include "ui/scene/scene_places.h"
#include "ui/scene/sensor_view.h"

namespace taxel::ui {
namespace {

constexpr double kPastTip = 9;   // [pixel]
constexpr int kManyLabels = 60;  // if there are more taxels, only those that face the eye have labels
constexpr std::size_t kMaxLabels = 250;
constexpr double kLetterWidth = 0.62;  // width of a digit as a fraction of its height
constexpr std::size_t kLettersOfTaxels = 4;
constexpr dvec2 kAround(7, 3);                // background and gap around a label, both sides together [pixel]
constexpr double kOcclusionTolerance = 4e-3;  // a point this close to a body, as a fraction of its distance, is visible

bool hidden(const SceneInput& input, const SensorView& view, const dvec3& eye_W, const dvec3& p_W) {
  const double distance = glm::length(p_W - eye_W);
  const Ray ray{eye_W, (p_W - eye_W) / distance, (1 - kOcclusionTolerance) * distance};
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
  bool facing = false, selected = false;
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
  return Candidate{&view, k, center, at, tip.z, facing, view.selected(k)};
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

void add_taxels(const SceneInput& input, const Camera& camera, const dvec2& size, Placed& placed) {
  const std::vector<SensorView> views = sensor_views(input);
  for (const Candidate& c : candidates(views, camera, size, input.clip)) {
    if (placed.full()) return;
    SceneLabel label;
    label.text = fmt::format("{}", c.view->model->layout.taxels[static_cast<std::size_t>(c.taxel)].id);
    label.pixel = c.pixel;
    if (!placed.take(label)) continue;
    label.occluded = !c.facing || hidden(input, *c.view, camera.eye(), c.center_W);
    label.selected = c.selected;
    label.sensor = c.view->index;
    label.taxel = c.taxel;
    placed.add(std::move(label), c.depth);
  }
}

}  // namespace

std::vector<SceneLabel> scene_labels(const SceneInput& input, const Camera& camera, int width, int height,
                                     double text_height) {
  const dvec2 size(width, height), letter(kLetterWidth * text_height, text_height);
  const std::vector<NamedPixel> parts = named_pixels(input, camera, size);
  std::size_t longest = kLettersOfTaxels;
  for (const NamedPixel& part : parts) longest = std::max(longest, part.name->size());
  Placed placed(size, letter, longest);
  for (const NamedPixel& part : parts) {
    SceneLabel label;
    label.text = *part.name;
    label.pixel = part.pixel;
    if (placed.take(label)) placed.add(std::move(label), part.depth);
  }
  if (input.overlays.taxel_labels) add_taxels(input, camera, size, placed);
  return placed.farthest_first();
}

}  // namespace taxel::ui
