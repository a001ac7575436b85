#include "ui/scene/paint/field_pass.h"

namespace taxel::ui {

FieldBuffer::FieldBuffer() {
  const auto read = [&](GLuint location, GLint components, std::size_t offset) {
    array_.attribute(location, vertices_, components, GL_FLOAT, sizeof(FieldVertex), offset);
  };
  read(0, 3, offsetof(FieldVertex, position));
  read(1, 3, offsetof(FieldVertex, from_center));
  read(2, 3, offsetof(FieldVertex, normal));
  read(3, 1, offsetof(FieldVertex, taxel));
  array_.elements(corners_);
}

void FieldBuffer::take(const std::shared_ptr<const FieldDiscs>& discs) {
  if (discs == discs_) return;
  discs_ = discs;
  if (!discs) return;
  vertices_.upload(std::span<const FieldVertex>(discs->shape.vertices), GL_STATIC_DRAW);
  corners_.upload(std::span<const std::uint32_t>(discs->shape.corners), GL_STATIC_DRAW);
}

void FieldBuffer::draw(std::span<const int> taxels) const {
  std::vector<GLsizei> counts;
  std::vector<const void*> begins;  // OpenGL passes offsets as pointers
  int end = -1;
  for (const int k : taxels) {
    const auto i = static_cast<std::size_t>(k);
    if (i + 1 >= discs_->first.size()) continue;
    const int first = discs_->first[i], count = discs_->first[i + 1] - first;
    if (first == end) {
      counts.back() += count;
    } else {
      counts.push_back(count);
      begins.push_back(reinterpret_cast<const void*>(sizeof(std::uint32_t) * static_cast<std::size_t>(first)));
    }
    end = first + count;
  }
  if (counts.empty()) return;
  array_.bind();
  glMultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, begins.data(), static_cast<GLsizei>(counts.size()));
}

void FieldPass::draw(const FieldBuffer& fields, std::span<const int> taxels, std::span<const FieldStyle> styles,
                     const FieldDraw& how) {
  if (fields.discs() == nullptr || taxels.empty()) return;
  styles_.upload(styles, GL_STREAM_DRAW);
  set_mark_state(program_, how.state);
  program_.set("min_cosine", static_cast<float>(fields.discs()->min_cosine));
  program_.set("at_rim", how.at_rim);
  program_.set("casing", how.casing);
  program_.set("multiply", how.multiplies ? 1.0f : 0.0f);
  if (how.multiplies) glBlendFunc(GL_DST_COLOR, GL_ZERO);
  program_.use();
  texture_.bind(styles_, 0);
  glEnable(GL_CULL_FACE);
  glCullFace(how.side == Side::front ? GL_BACK : GL_FRONT);
  fields.draw(taxels);
  glDisable(GL_CULL_FACE);
}

}  // namespace taxel::ui
