#include "ui/scene/scene_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "ui/scene/draw/model_marks.h"
#include "ui/scene/scene_cast.h"
#include "ui/scene/sensor_view.h"

namespace taxel::ui {
namespace {

constexpr double kPastTip = 9;   // [pixel]
constexpr int kManyTaxels = 60;  // more are labelled only where they face the eye
constexpr std::size_t kMostLabels = 250;
constexpr double kLetterWidth = 0.62;  // of a digit, parts of its height
constexpr dvec2 kAround(7, 3);         // background and gap around a label, both sides together [pixel]
constexpr double kTolerance = 4e-3;    // of the distance: what lies on a body is not hidden by it

bool hidden(const SceneInput& input, const SensorView& view, const dvec3& eye_W, const dvec3& p_W) {
  const double distance = glm::length(p_W - eye_W);
  const Ray ray{eye_W, (p_W - eye_W) / distance, (1 - kTolerance) * distance};
  if (cast_geoms(input, ray)) return true;
  return !input.overlays.sensor_transparent && view.model->skin->cast(in_frame(view.X_WM, ray)).has_value();
}

/// A taxel that could have a label.
struct Candidate {
  const SensorView* view = nullptr;
  int taxel = 0;
  dvec3 center_W{0};
  dvec2 pixel{0};
  double depth = 0;
  bool facing = false, selected = false;
  /// Spread over all numbers and always the same, so that labels do not jump while the view turns (Knuth 6.4).
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
  if (base.z <= 0 || tip.z <= 0) return std::nullopt;
  const dvec2 along(tip - base);
  const double pixels = glm::length(along);
  const dvec2 at = dvec2(tip) + kPastTip * (pixels > 1 ? along / pixels : dvec2(0, -1));
  if (at.x < 0 || at.y < 0 || at.x > size.x || at.y > size.y) return std::nullopt;
  const bool facing = glm::dot(normal, camera.eye() - center) > 0;
  return Candidate{&view, k, center, at, tip.z, facing, view.selected(k)};
}

/// Where labels stand already: cells as large as a label of three digits, so that only neighbours need be looked at.
class Room {
 public:
  Room(dvec2 view, dvec2 cell) : cell_(cell), columns_(static_cast<int>(view.x / cell.x) + 3) {
    cells_.resize(static_cast<std::size_t>(columns_) * (static_cast<std::size_t>(view.y / cell.y) + 3));
  }
  /// Takes a place for a box around `at`, not wider than a cell and a half. False where another stands in it.
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
    const bool many = view.model->taxel_count() > kManyTaxels;
    for (int k = 0; k < view.model->taxel_count(); ++k) {
      if (view.hidden(k)) continue;
      const auto c = candidate(view, k, arrow, camera, size, clip);
      if (c && (c->facing || c->selected || !many)) found.push_back(*c);
    }
  }
  std::sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) { return a.rank() < b.rank(); });
  return found;
}

}  // namespace

std::vector<SceneLabel> scene_labels(const SceneInput& input, const Camera& camera, int width, int height,
                                     double text_height) {
  if (!input.overlays.taxel_labels) return {};
  const std::vector<SensorView> views = sensor_views(input);
  const dvec2 size(width, height), letter(kLetterWidth * text_height, text_height);
  Room room(size, {4 * letter.x + kAround.x, letter.y + kAround.y});
  std::vector<std::pair<double, SceneLabel>> found;
  for (const Candidate& c : candidates(views, camera, size, input.clip)) {
    if (found.size() >= kMostLabels) break;
    SceneLabel label;
    label.text = fmt::format("{}", c.view->model->layout.taxels[static_cast<std::size_t>(c.taxel)].id);
    const dvec2 box = dvec2(static_cast<double>(label.text.size()) * letter.x, letter.y) + kAround;
    if (!room.take(c.pixel, 0.5 * box)) continue;
    label.pixel = c.pixel;
    label.occluded = !c.facing || hidden(input, *c.view, camera.eye(), c.center_W);
    label.selected = c.selected;
    label.sensor = c.view->index;
    label.taxel = c.taxel;
    found.emplace_back(c.depth, std::move(label));
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<SceneLabel> out;
  for (auto& [depth, label] : found) out.push_back(std::move(label));
  return out;
}

}  // namespace taxel::ui
