// Contact surfaces coloured by pressure: exact colours, looked up per fragment.
#pragma once

#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "ui/gl/buffer.h"
#include "ui/gl/texture.h"
#include "ui/scene/marks/mark_state.h"
#include "ui/scene/paint/segments.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

/// From which side triangles are seen.
enum class Seen { both, front };

struct SurfaceVertex {
  glm::vec3 position{0};
  float pressure = 0;  ///< [Pa]
};

/// Fans of all polygons as plain triangles; the pressure, linear on each polygon, stays exact under interpolation.
void append_triangles(const ContactSurface& surface, std::vector<SurfaceVertex>& out);
/// The outline of one polygon, or of each.
void append_edges(const ContactSurface& surface, const ContactPolygon& polygon, float width, std::uint32_t rgba,
                  Segments& out);
void append_edges(const ContactSurface& surface, float width, std::uint32_t rgba, Segments& out);
/// The rim, where a soft body's pressure ends at nothing, as lines in the colours of their pressures: drawn before the
/// triangles, which cover their inner half, they smooth its steps.
void append_rim(const ContactSurface& surface, const PressureRange& range, Segments& out);

class SurfacePass {
 public:
  explicit SurfacePass(const gl::ShaderReader& read);
  /// Draws triangles in the colours that `range` gives to their pressures.
  void draw(std::span<const SurfaceVertex> triangles, const PressureRange& range, const MarkState& state,
            Seen from = Seen::both);

 private:
  gl::Program program_;
  gl::Texture table_;
  const ColorMap* uploaded_ = nullptr;  ///< map whose colours are in `table_`
  gl::Buffer buffer_;
  gl::VertexArray array_;
};

}  // namespace taxel::ui
