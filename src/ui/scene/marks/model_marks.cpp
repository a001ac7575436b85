// Marks of one sensor model that do not change with the simulation.
#include "ui/scene/marks/marks.h"

#include <numeric>

#include "core/base/math.h"
#include "ui/scene/color_map.h"

namespace taxel::ui {
namespace {

constexpr double kUnusedSize = 0.45, kOtherSize = 0.72;  // sizes relative to a sample of the selected taxel
constexpr float kHoveredRingWidth = 2.6f, kSelectedRingWidth = 2.8f, kHaloWidth = 5.4f, kArrowWidth = 2.6f,
                kSelectedArrowWidth = 4.0f;
constexpr double kArrowOfDiagonal = 0.11;  // fraction of the mesh's diagonal
constexpr double kArrowOfSpacing = 1.2;    // multiple of the distance between evenly spread taxels
constexpr double kNormalPart = 0.8;        // fraction of the distance between samples

/// Returns the numbers 0 ... count - 1 in an order in which near numbers are far apart, by multiplicative hashing
/// (Knuth 6.4).
std::vector<std::uint32_t> spread_order(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  const auto place = [](std::uint32_t i) { return i * 2654435769u; };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
  return order;
}

/// Returns true if two lists share a value. `sorted` is ascending.
bool share(const std::vector<int>& values, const std::vector<int>& sorted) {
  return std::any_of(values.begin(), values.end(),
                     [&](int v) { return std::binary_search(sorted.begin(), sorted.end(), v); });
}

}  // namespace

std::vector<PointMark> sample_marks(const SensorModel& model, const std::vector<int>& selected, const Look& look) {
  std::vector<PointMark> out;
  out.reserve(model.samples.size());
  const std::uint32_t unused = pack(look.unused_sample);
  for (const std::uint32_t i : spread_order(model.samples.size())) {
    const SurfaceSample& sample = model.samples[i];
    const std::vector<int>& taxels = model.taxels_of_sample[i];
    if (taxels.empty()) {
      out.push_back(point_mark(sample.position, sample.normal, kUnusedSize, unused));
      continue;
    }
    const bool large = selected.empty() || share(taxels, selected);
    out.push_back(point_mark(sample.position, sample.normal, large ? 1.0 : kOtherSize,
                             pack(taxel_color(model.color(taxels[0])))));
  }
  return out;
}

ModelMarks::ModelMarks(SensorModelPtr model, std::vector<int> hidden, const Look& look,
                       std::shared_ptr<const FieldRings> rings_of)
    : model_(std::move(model)), hidden_(std::move(hidden)), look_(&look), ring_pieces_(std::move(rings_of)) {
  if (!model_->samples.empty())
    spacing_ = std::sqrt(model_->sampled_area / static_cast<double>(model_->samples.size()));
  Segments arrows;
  std::vector<PointMark> centers;
  for (int k = 0; k < model_->taxel_count(); ++k) {
    if (hides(k)) continue;
    arrows.push_back(arrow_segment(k, kArrowWidth));
    centers.push_back(center_mark(k));
  }
  arrows_.upload(std::span<const Segment>(arrows), GL_STATIC_DRAW);
  centers_.upload(std::span<const PointMark>(centers), GL_STATIC_DRAW);
}

void ModelMarks::select(const std::vector<int>& taxels) {
  if (selected_ == taxels) return;
  selected_ = taxels;
  samples_.upload(sample_marks(*model_, taxels, *look_));
  Segments rings, arrows;
  std::vector<PointMark> centers;
  for (const int k : taxels) {
    if (hides(k)) continue;
    append_ring(k, kHaloWidth, pack(look_->selection), rings);
    append_ring(k, kSelectedRingWidth, pack(taxel_color(model_->color(k))), rings);
    arrows.push_back(arrow_segment(k, kSelectedArrowWidth));
    centers.push_back(center_mark(k));
  }
  selected_marks_.rings.upload(std::span<const Segment>(rings), GL_STATIC_DRAW);
  selected_marks_.arrows.upload(std::span<const Segment>(arrows), GL_STATIC_DRAW);
  selected_marks_.centers.upload(std::span<const PointMark>(centers), GL_STATIC_DRAW);
}

void ModelMarks::append_ring(int taxel, float width, std::uint32_t color, Segments& out) const {
  if (!ring_pieces_) return;
  const std::vector<dvec3>& normals = model_->skin->mesh().face_normals();
  for (const RingPiece& piece : (*ring_pieces_)[at(taxel)]) {
    out.push_back(segment(piece.a, piece.b, width, color, normals[at(piece.face)]));
  }
}

void ModelMarks::append_taxel(int taxel, Segments& arrows, std::vector<PointMark>& centers) const {
  arrows.push_back(arrow_segment(taxel, kArrowWidth));
  centers.push_back(center_mark(taxel));
}

void ModelMarks::append_rim(int taxel, Segments& rims) const {
  append_ring(taxel, kHoveredRingWidth, pack(taxel_color(model_->color(taxel))), rims);
}

Segment ModelMarks::arrow_segment(int taxel, float width) const {
  const Taxel& t = model_->layout.taxels[at(taxel)];
  const dvec3 normal = glm::normalize(t.normal);
  const dvec3 tip = t.center + taxel_arrow_length(*model_) * normal;
  return segment(t.center, tip, width, pack(taxel_color(model_->color(taxel))), normal);
}

PointMark ModelMarks::center_mark(int taxel) const {
  const Taxel& t = model_->layout.taxels[at(taxel)];
  return point_mark(t.center, glm::normalize(t.normal), 1.0, pack(taxel_color(model_->color(taxel))));
}

const gl::Buffer& ModelMarks::sample_normals() {
  if (sample_normals_) return *sample_normals_;
  Segments lines;
  for (std::size_t i = 0; i < model_->samples.size(); ++i) {
    if (model_->taxels_of_sample[i].empty()) continue;
    const SurfaceSample& sample = model_->samples[i];
    const dvec3 end = sample.position + kNormalPart * spacing_ * sample.normal;
    lines.push_back(segment(sample.position, end, 1.0f, pack(look_->wire), sample.normal));
  }
  sample_normals_.emplace();
  sample_normals_->upload(std::span<const Segment>(lines), GL_STATIC_DRAW);
  return *sample_normals_;
}

double taxel_arrow_length(const SensorModel& model) {
  const double apart = std::sqrt(model.skin->mesh().area() / std::max(1, model.taxel_count()));
  return std::min(kArrowOfDiagonal * model.mesh->bounds().diagonal(), kArrowOfSpacing * apart);
}

}  // namespace taxel::ui
