#include "ui/scene/draw/segments.h"

namespace taxel::ui {

std::uint32_t pack(const glm::vec4& rgba) {
  std::uint32_t out = 0;
  for (int i = 0; i < 4; ++i) {
    const float level = std::round(255.0f * std::clamp(rgba[i], 0.0f, 1.0f));
    out |= static_cast<std::uint32_t>(level) << (8 * i);
  }
  return out;
}

void SegmentPass::draw(const gl::Program& program, const gl::Buffer& segments, const MarkState& state) const {
  if (segments.count() == 0) return;
  set_mark_state(program, state);
  program.use();
  empty_.bind();
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, segments.id());
  glDrawArrays(GL_TRIANGLES, 0, 6 * segments.count());
}

void SegmentPass::draw_lines(std::span<const Segment> segments, const MarkState& state) {
  stream_.upload(segments, GL_STREAM_DRAW);
  draw(lines_, stream_, state);
}

void SegmentPass::draw_lines(const gl::Buffer& segments, const MarkState& state) const {
  draw(lines_, segments, state);
}

void SegmentPass::draw_arrows(std::span<const Segment> segments, const MarkState& state, const glm::vec4& outline) {
  stream_.upload(segments, GL_STREAM_DRAW);
  arrows_.set("outline", outline);
  draw(arrows_, stream_, state);
}

}  // namespace taxel::ui
