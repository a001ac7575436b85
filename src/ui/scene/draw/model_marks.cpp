#include "ui/scene/draw/model_marks.h"

#include "ui/scene/color_map.h"

namespace taxel::ui {
namespace {

constexpr double kUnusedSize = 0.45, kOtherSize = 0.72;  // of a sample of the selected taxel
constexpr float kRingWidth = 1.6f, kSelectedRingWidth = 2.8f, kArrowWidth = 2.6f, kSelectedArrowWidth = 4.0f;
constexpr double kArrowPart = 0.11;  // of the mesh's diagonal

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

bool contains(const std::vector<int>& values, int value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

}  // namespace

std::vector<PointMark> sample_marks(const SensorModel& model, int selected_taxel, const Look& look) {
  std::vector<PointMark> out;
  out.reserve(model.samples.size());
  const std::uint32_t unused = pack(look.unused_sample);
  for (std::size_t i = 0; i < model.samples.size(); ++i) {
    const SurfaceSample& sample = model.samples[i];
    const bool used = i < model.taxels_of_sample.size() && !model.taxels_of_sample[i].empty();
    if (!used) {
      out.push_back(point_mark(sample.position, sample.normal, kUnusedSize, unused));
      continue;
    }
    const std::vector<int>& taxels = model.taxels_of_sample[i];
    const bool large = selected_taxel < 0 || contains(taxels, selected_taxel);
    out.push_back(point_mark(sample.position, sample.normal, large ? 1.0 : kOtherSize, pack(taxel_color(taxels[0]))));
  }
  return out;
}

ModelMarks::ModelMarks(SensorModelPtr model, int selected_taxel, const Look& look)
    : model_(std::move(model)), selected_(selected_taxel), look_(&look) {
  samples_.upload(std::span<const PointMark>(sample_marks(*model_, selected_, look)), GL_STATIC_DRAW);
  const TriMesh& skin = model_->skin->mesh();
  if (!model_->samples.empty()) spacing_ = std::sqrt(skin.area() / static_cast<double>(model_->samples.size()));
  for (int k = 0; k < model_->taxel_count(); ++k) {
    const Taxel& taxel = model_->layout.taxels[at(k)];
    for (const RingPiece& piece : taxel_rings(skin, taxel, model_->layout.receptive_field)) {
      const float width = k == selected_ ? kSelectedRingWidth : kRingWidth;
      rings_.push_back({segment(piece.a, piece.b, width, pack(taxel_color(k))), piece.face});
    }
  }
}

bool ModelMarks::is_for(const SensorModelPtr& model, int selected_taxel, const Look& look) const {
  return model == model_ && selected_taxel == selected_ && &look == look_;
}

void ModelMarks::append_rings(const dvec3& eye_M, bool towards, Segments& out) const {
  const TriMesh& skin = model_->skin->mesh();
  for (const Ring& ring : rings_) {
    const bool seen = glm::dot(skin.face_normals()[at(ring.face)], eye_M - skin.vertex(ring.face, 0)) > 0;
    if (seen == towards) out.push_back(ring.segment);
  }
}

void append_sample_normals(const SensorModel& model, double length, std::uint32_t rgba, Segments& out) {
  for (std::size_t i = 0; i < model.samples.size(); ++i) {
    if (i >= model.taxels_of_sample.size() || model.taxels_of_sample[i].empty()) continue;
    const SurfaceSample& sample = model.samples[i];
    out.push_back(segment(sample.position, sample.position + length * sample.normal, 1.0f, rgba));
  }
}

double taxel_arrow_length(const SensorModel& model) {
  return kArrowPart * model.mesh->bounds().diagonal();
}

TaxelMarks taxel_marks(const SensorView& view, const dvec3& eye_M, bool towards, float size) {
  TaxelMarks out;
  const double length = taxel_arrow_length(*view.model);
  for (int k = 0; k < view.model->taxel_count(); ++k) {
    const Taxel& taxel = view.model->layout.taxels[at(k)];
    const dvec3 normal = glm::normalize(taxel.normal);
    if ((glm::dot(normal, eye_M - taxel.center) > 0) != towards) continue;
    const std::uint32_t color = pack(taxel_color(k));
    const bool selected = view.selected(k);
    (selected ? out.selected_center : out.centers).push_back(point_mark(taxel.center, dvec3(0), 1.0, color));
    out.arrows.push_back(segment(taxel.center, taxel.center + length * normal,
                                 size * (selected ? kSelectedArrowWidth : kArrowWidth), color));
  }
  return out;
}

}  // namespace taxel::ui
