// Triangles on a skin in flat colours, visible from one side: maps of the receptive fields and the painted region; and
// contact surfaces coloured by pressure or slip, in exact colours that are looked up for each fragment.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/shared_value.h"
#include "core/hydro/bristles.h"
#include "core/hydro/contact_surface.h"
#include "core/mesh/repair/repair.h"
#include "ui/gl/framebuffer.h"
#include "ui/gl/objects.h"
#include "ui/scene/geometry/field_patch.h"
#include "ui/scene/geometry/shown_fields.h"
#include "ui/scene/paint/mark_pass.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

/// Triangles in GPU memory.
class PaintBuffer {
 public:
  PaintBuffer();
  void upload(std::span<const PaintVertex> triangles, GLenum usage = GL_STATIC_DRAW) {
    buffer_.upload(triangles, usage);
  }
  void draw() const;

 private:
  gl::Buffer buffer_;
  gl::VertexArray array_;
};

class PaintPass {
 public:
  explicit PaintPass(const gl::ShaderReader& read) : program_(read, "paint") {}
  /// Draws the front of the triangles.
  void draw(const PaintBuffer& triangles, const MarkState& state) const;

 private:
  gl::Program program_;
};

/// Map of the receptive fields on the skin, and taxel normals compared with the skin's normals; stored in GPU memory.
class FieldPaint {
 public:
  explicit FieldPaint(SensorModelPtr model) : model_(std::move(model)) {}
  [[nodiscard]] const SensorModelPtr& model() const { return model_; }

  /// Returns the map of the model in `fields`.
  const PaintBuffer& map(const ShownFieldsPtr& fields);
  /// Taxel normals in the colour of their angle to the skin's normals, and the skin's normals.
  struct Normals {
    gl::Buffer arrows, skin;
  };
  const Normals& normals(double length, std::uint32_t skin_rgba);

  [[nodiscard]] const std::optional<NormalNumbers>& normal_numbers() const { return normal_numbers_; }

 private:
  SensorModelPtr model_;
  ShownFieldsPtr fields_;
  PaintBuffer map_;  // fields of `map_`
  std::optional<Normals> normals_;
  std::uint32_t normals_rgba_ = 0;
  std::optional<NormalNumbers> normal_numbers_;
};

/// The painted region as a tint on the skin, in GPU memory.
class RegionPaint {
 public:
  /// Returns the triangles of the region, and rebuilds them if the mesh or the region has changed since the last call.
  /// `region` has faces of the loaded mesh; faces that the mesh does not have are left out.
  const PaintBuffer& take(const RepairedMeshPtr& mesh, const FaceSet& region);

 private:
  RepairedMeshPtr mesh_;
  FaceSet region_;
  PaintBuffer triangles_;
};

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
