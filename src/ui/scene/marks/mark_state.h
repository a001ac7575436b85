// State that lines, arrows, points and contact surfaces share when they are drawn.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/base/math.h"
#include "ui/gl/program.h"
#include "ui/gl/state.h"

namespace taxel::ui {

/// A unit normal in 127ths, or zero if the mark is visible from everywhere; and one more number, 0 to 1 in 127ths.
using MarkNormal = std::array<std::int8_t, 4>;

inline MarkNormal pack_normal(const dvec3& normal, double last) {
  const auto part = [](double x) { return static_cast<std::int8_t>(std::lround(127 * x)); };
  return {part(normal.x), part(normal.y), part(normal.z), part(std::clamp(last, 0.0, 1.0))};
}

/// The marks with a normal that are drawn: all, those that face the eye, or those that face away.
enum class Facing { all, eye, away };

/// How a batch of marks is drawn.
struct MarkState {
  glm::mat4 world_from_model{1};
  float toward_eye = 0;  ///< moves marks towards the eye by this fraction of their depth
  bool depth_test = true;
  bool hidden = false;  ///< draws only marks that are hidden by something nearer
  bool depth_write = false;
  float dim = 1;  ///< factor of alpha
  Facing facing = Facing::all;
  bool clipped = false;  ///< clips by the frame's plane
};

/// Sets whether the frame's plane clips the following draw calls.
inline void set_clipped(bool clipped) {
  (clipped ? glEnable : glDisable)(GL_CLIP_DISTANCE0);
}

/// Sends the uniforms that the shaders of all marks share, and sets depth and blending.
inline void set_mark_state(const gl::Program& program, const MarkState& state) {
  program.set("world_from_model", state.world_from_model);
  program.set("toward_eye", state.toward_eye);
  program.set("dim", state.dim);
  program.set("facing", state.facing == Facing::all ? 0.0f : state.facing == Facing::eye ? 1.0f : -1.0f);
  program.set("clipped", state.clipped ? 1.0f : 0.0f);
  set_clipped(state.clipped);
  const GLenum test = state.hidden ? GL_GREATER : GL_LEQUAL;
  gl::apply({.depth = state.depth_test ? test : GL_ALWAYS, .depth_write = state.depth_write, .blend = true});
}

/// Returns the largest fraction of marks, spread evenly over a surface with a distance of `spacing` [pixel] on the
/// screen, that can be drawn with a distance of at least `least` [pixel].
inline double part_apart(double spacing, double least) {
  return std::min(1.0, spacing * spacing / (least * least));
}

}  // namespace taxel::ui
