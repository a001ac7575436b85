#include "ui/scene/paint/paint.h"

#include "core/base/math.h"
#include "core/mesh/repair/repaired_mesh.h"
#include "ui/scene/color_map.h"
#include "ui/scene/paint/mark_pass.h"

namespace taxel::ui {

PaintBuffer::PaintBuffer() {
  array_.attribute(0, buffer_, 3, GL_FLOAT, sizeof(PaintVertex), offsetof(PaintVertex, position));
  array_.attribute(1, buffer_, 4, GL_UNSIGNED_BYTE, sizeof(PaintVertex), offsetof(PaintVertex, rgba));
}

void PaintBuffer::draw() const {
  if (buffer_.count() == 0) return;
  array_.bind();
  glDrawArrays(GL_TRIANGLES, 0, buffer_.count());
}

void PaintPass::draw(const PaintBuffer& triangles, const MarkState& state) const {
  set_mark_state(program_, state);
  program_.use();
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  triangles.draw();
  glDisable(GL_CULL_FACE);
}

namespace {

constexpr float kRegionArrowWidth = 3.0f, kSkinWidth = 1.4f;
constexpr double kSkinPart = 1.15;  // of the arrow's length

}  // namespace

const PaintBuffer& FieldPaint::map(const ShownFieldsPtr& fields) {
  if (fields_ != fields) map_.upload(fields->of(model_)->triangles);
  fields_ = fields;
  return map_;
}

const FieldPaint::Normals& FieldPaint::normals(double length, std::uint32_t skin_rgba) {
  if (normals_ && normals_rgba_ == skin_rgba) return *normals_;
  NormalNumbers numbers;
  numbers.limit_deg = model_->layout.receptive_field.max_angle_deg;
  Segments arrows, skin;
  for (int k = 0; k < model_->taxel_count(); ++k) {
    const Taxel& taxel = model_->layout.taxels[static_cast<std::size_t>(k)];
    const SurfacePoint nearest = model_->skin->closest_point(taxel.center);
    const dvec3& below = model_->skin->mesh().face_normals()[static_cast<std::size_t>(nearest.face)];
    const dvec3 normal = glm::normalize(taxel.normal);
    const double angle = angle_deg(normal, below);
    numbers.mean_deg += angle / model_->taxel_count();
    if (numbers.largest_taxel < 0 || angle > numbers.largest_deg) {
      numbers.largest_deg = angle;
      numbers.largest_taxel = k;
    }
    const std::uint32_t color = pack(normal_color(angle, numbers.limit_deg));
    arrows.push_back(segment(taxel.center, taxel.center + length * normal, kRegionArrowWidth, color, normal));
    skin.push_back(segment(taxel.center, taxel.center + kSkinPart * length * below, kSkinWidth, skin_rgba, normal));
  }
  normal_numbers_ = numbers;
  normals_.emplace();
  normals_->arrows.upload(std::span<const Segment>(arrows), GL_STATIC_DRAW);
  normals_->skin.upload(std::span<const Segment>(skin), GL_STATIC_DRAW);
  normals_rgba_ = skin_rgba;
  return *normals_;
}

namespace {
constexpr glm::vec4 kTint{0.10f, 0.62f, 0.78f, 0.45f};
}

const PaintBuffer& RegionPaint::take(const RepairedMeshPtr& repaired, const FaceSet& region) {
  if (repaired == mesh_ && region.identity() == region_.identity()) return triangles_;
  std::vector<PaintVertex> vertices;
  const TriMesh& mesh = *repaired->mesh;
  for (const int face : repaired_faces(*repaired, *region)) {
    if (face < 0 || face >= mesh.face_count()) continue;
    append_piece({mesh.vertex(face, 0), mesh.vertex(face, 1), mesh.vertex(face, 2), face}, pack(kTint), vertices);
  }
  triangles_.upload(vertices);
  mesh_ = repaired;
  region_ = region;
  return triangles_;
}

std::vector<double> slip_values(const ContactSurface& surface, const StickingFriction& friction) {
  std::vector<double> values;
  values.reserve(surface.vertices.size());
  for (const dvec3& vertex : surface.vertices) values.push_back(friction.slip_at(vertex));
  return values;
}

void append_triangles(const ContactSurface& surface, std::span<const double> values, std::vector<SurfaceVertex>& out) {
  const auto vertex = [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    return SurfaceVertex{glm::vec3(surface.vertices[k]), static_cast<float>(values[k])};
  };
  for (const ContactPolygon& polygon : surface.polygons) {
    for (int i = 2; i < polygon.count; ++i) {
      out.push_back(vertex(polygon.first));
      out.push_back(vertex(polygon.first + i - 1));
      out.push_back(vertex(polygon.first + i));
    }
  }
}

void append_edges(const ContactSurface& surface, const ContactPolygon& polygon, float width, std::uint32_t rgba,
                  Segments& out) {
  const auto vertex = [&](int i) { return surface.vertices[static_cast<std::size_t>(polygon.first + i)]; };
  for (int i = 0; i < polygon.count; ++i)
    out.push_back(segment(vertex(i), vertex(i + 1 < polygon.count ? i + 1 : 0), width, rgba));
}

void append_edges(const ContactSurface& surface, float width, std::uint32_t rgba, Segments& out) {
  for (const ContactPolygon& polygon : surface.polygons) append_edges(surface, polygon, width, rgba, out);
}

void append_rim(const ContactSurface& surface, std::span<const double> values, const PressureRange& range,
                Segments& out) {
  constexpr double kLow = 0.05;      // of the largest pressure: edges below may belong to the rim
  constexpr float kRimWidth = 1.6f;  // [pixel]
  const double low = kLow * surface.max_pressure();
  for (const ContactPolygon& polygon : surface.polygons) {
    for (int i = 0; i < polygon.count; ++i) {
      const auto a = static_cast<std::size_t>(polygon.first + i);
      const auto b = static_cast<std::size_t>(polygon.first + (i + 1 < polygon.count ? i + 1 : 0));
      if (surface.pressure[a] > low || surface.pressure[b] > low) continue;
      const double value = 0.5 * (values[a] + values[b]);
      out.push_back(segment(surface.vertices[a], surface.vertices[b], kRimWidth, pack(range.color(value))));
    }
  }
}

SurfacePass::SurfacePass(const gl::ShaderReader& read) : program_(read, "surface"), table_(GL_RGB8, 256, 1) {
  array_.attribute(0, buffer_, 3, GL_FLOAT, sizeof(SurfaceVertex), offsetof(SurfaceVertex, position));
  array_.attribute(1, buffer_, 1, GL_FLOAT, sizeof(SurfaceVertex), offsetof(SurfaceVertex, value));
}

void SurfacePass::draw(std::span<const SurfaceVertex> triangles, const PressureRange& range, const MarkState& state,
                       Seen from) {
  if (triangles.empty()) return;
  buffer_.upload(triangles, GL_STREAM_DRAW);
  set_mark_state(program_, state);
  const double scale = range.hi > range.lo ? 1.0 / (range.hi - range.lo) : 0.0;
  program_.set("range", glm::vec2(range.lo, scale));
  if (uploaded_ != range.colors) table_.upload(GL_RGB, GL_UNSIGNED_BYTE, range.colors->table.data());
  uploaded_ = range.colors;
  program_.use();
  table_.bind(0);
  array_.bind();
  if (from == Seen::front) {
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
  }
  glDrawArrays(GL_TRIANGLES, 0, buffer_.count());
  glDisable(GL_CULL_FACE);
}

}  // namespace taxel::ui
