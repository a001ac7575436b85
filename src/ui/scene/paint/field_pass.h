// Receptive fields in GPU memory, and the pass that draws them: fills and thin rings whose borders are found in each
// pixel.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ui/gl/objects.h"
#include "ui/gl/program.h"
#include "ui/scene/geometry/field_discs.h"
#include "ui/scene/paint/mark_pass.h"

namespace taxel::ui {

/// The sides from which triangles of the skin are drawn.
enum class Side { front, back };

/// The colours of one taxel's field, which shaders/field.vert reads as one texel of four words.
struct FieldStyle {
  std::uint32_t fill = 0, ring = 0;  ///< sRGB, straight alpha, red in the lowest byte; 0 draws nothing
  float ring_width = 0;              ///< [pixel of marks]
  std::uint32_t unused = 0;
};

/// The fields of one model in GPU memory.
class FieldBuffer {
 public:
  FieldBuffer();
  /// Uploads the fields if they are not those of the last call.
  void take(const std::shared_ptr<const FieldDiscs>& discs);
  [[nodiscard]] const FieldDiscs* discs() const { return discs_.get(); }
  /// Draws the triangles of the taxels, in this order, by one call.
  void draw(std::span<const int> taxels) const;

 private:
  std::shared_ptr<const FieldDiscs> discs_;
  gl::Buffer vertices_, corners_;
  gl::VertexArray array_;
};

/// How the fields of one call are drawn.
struct FieldDraw {
  MarkState state;
  Side side = Side::front;
  float at_rim = 1;         ///< opacity of fills at the rim as a fraction of that in the middle
  glm::vec4 casing{0};      ///< line at the inner side of rings, sRGB, straight alpha
  bool multiplies = false;  ///< the colours of fills multiply those of the skin, and there are no rings
};

class FieldPass {
 public:
  explicit FieldPass(const gl::ShaderReader& read) : program_(read, "field") {}
  /// Draws the fields of the listed taxels, the last one above the others. `styles` has the style of each taxel in
  /// layout order.
  void draw(const FieldBuffer& fields, std::span<const int> taxels, std::span<const FieldStyle> styles,
            const FieldDraw& how);

 private:
  gl::Program program_;
  gl::Buffer styles_;
  gl::BufferTexture texture_;
};

}  // namespace taxel::ui
