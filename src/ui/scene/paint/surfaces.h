// Draws contact surfaces coloured by pressure or slip. Colours are exact, because they are looked up for each fragment.
#pragma once

#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/hydro/friction/sticking_friction.h"
#include "ui/gl/buffer.h"
#include "ui/gl/texture.h"
#include "ui/scene/marks/mark_state.h"
#include "ui/scene/paint/segments.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

/// The sides from which triangles are visible.
enum class Seen { both, front };

struct SurfaceVertex {
  glm::vec3 position{0};
  float value = 0;  ///< coloured value: pressure [Pa], or share that slips
};

/// Returns the share that slips at each vertex of a surface, from 0 to 1.
std::vector<double> slip_values(const ContactSurface& surface, const StickingFriction& friction);
/// Appends all polygons as triangle fans with the values of their vertices. The pressure is linear on each polygon, so
/// its interpolation is exact.
void append_triangles(const ContactSurface& surface, std::span<const double> values, std::vector<SurfaceVertex>& out);
/// Appends the outline of one polygon, or of all polygons.
void append_edges(const ContactSurface& surface, const ContactPolygon& polygon, float width, std::uint32_t rgba,
                  Segments& out);
void append_edges(const ContactSurface& surface, float width, std::uint32_t rgba, Segments& out);
/// Appends the rim, where the pressure of a soft body ends at 0, as lines in the colours of the vertices' values. They
/// must be drawn before the triangles, which cover their inner half; the outer half smooths the steps of the rim.
void append_rim(const ContactSurface& surface, std::span<const double> values, const PressureRange& range,
                Segments& out);

class SurfacePass {
 public:
  explicit SurfacePass(const gl::ShaderReader& read);
  /// Draws triangles in the colours that `range` gives to their values.
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
