#include "ui/scene/paint/surfaces.h"

#include "ui/scene/color_map.h"

namespace taxel::ui {

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
