// The cut of the clip plane through bodies.
#include "ui/scene/passes/passes.h"

#include <cmath>

#include "core/mesh/tri_mesh.h"
#include "ui/gl/program.h"
#include "ui/scene/paint/mark_pass.h"
#include "ui/scene/section.h"

namespace taxel::ui {
namespace {

constexpr float kRimWidth = 2.0f;          // [pixel]
constexpr float kRimTowardEye = 0.004f;    // draws the rim in front of its cap
constexpr float kCapTowardEye = 1e-4f;     // before the edge of the skin that it ends at
constexpr double kHatchOfDistance = 0.03;  // the distance of hatch lines, at most, parts of the camera's

SectionPlane plane_of(const ClipPlane& clip) {
  SectionPlane plane;
  plane.origin_W = clip.offset * clip.normal;
  plane.z = clip.normal;
  plane.x = any_perpendicular(clip.normal);
  plane.y = glm::cross(plane.z, plane.x);
  return plane;
}

glm::mat4 plane_matrix(const SectionPlane& plane) {
  return {glm::vec4(glm::vec3(plane.x), 0), glm::vec4(glm::vec3(plane.y), 0), glm::vec4(glm::vec3(plane.z), 0),
          glm::vec4(glm::vec3(plane.origin_W), 1)};
}

/// Returns triangles from one point of each closed outline to all its edges.
std::vector<glm::vec2> fans_of(const std::vector<Section::Outline>& outlines) {
  std::vector<glm::vec2> out;
  for (const Section::Outline& outline : outlines) {
    if (!outline.closed) continue;
    for (std::size_t i = 2; i < outline.points.size(); ++i) {
      for (const std::size_t corner : {std::size_t{0}, i - 1, i}) out.emplace_back(outline.points[corner]);
    }
  }
  return out;
}

/// Returns the distance of hatch lines, rounded to a power of two: while the user zooms, lines do not move, and only
/// every second line appears or disappears.
double hatch_distance(const Camera& camera) {
  return std::exp2(std::floor(std::log2(kHatchOfDistance * camera.distance)));
}

}  // namespace

CutColors cut_colors(const glm::vec3& albedo, const Look& look) {
  return {srgb_from_linear(look.cut_light.x * albedo), srgb_from_linear(look.cut_light.y * albedo)};
}

CutPass::CutPass(const gl::ShaderReader& read) : program_(read, "cut") {}

CutPass::Cut& CutPass::cut_of(const MeshItem& item, const ClipPlane& clip) {
  const PlacedMesh body{item.mesh->shared_mesh(), item.X_WM};
  for (Cut& cut : cuts_) {
    if (!(cut.body == body && cut.clip == clip)) continue;
    cut.used = true;
    return cut;
  }
  Cut& cut = cuts_.emplace_back();
  cut.body = body;
  cut.clip = clip;
  const Pose X_MW = item.X_WM.inverse();
  const auto pieces = slice_mesh(*body.mesh, X_MW * (clip.offset * clip.normal), X_MW.rotate(clip.normal));
  const std::uint32_t color = pack(glm::vec4(glm::vec3(item.outline), 1));
  for (const auto& [a, b] : pieces) cut.rim.push_back(segment(a, b, kRimWidth, color));
  const std::vector<glm::vec2> fans = fans_of(join_outlines(pieces, plane_of(clip), item.X_WM));
  cut.fans.upload(std::span<const glm::vec2>(fans), GL_STATIC_DRAW);
  cut.array.attribute(0, cut.fans, 2, GL_FLOAT, sizeof(glm::vec2), 0);
  return cut;
}

/// Counts in the stencil how often the fans wind around each pixel, then fills where that is not 0. A cavity's outline
/// runs the other way round, so it is left out; where shells overlap, the body is filled as well.
void CutPass::draw_cap(const Cut& cut) const {
  cut.array.bind();
  glEnable(GL_STENCIL_TEST);
  gl::apply({.depth = GL_ALWAYS, .depth_write = false});
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glStencilFunc(GL_ALWAYS, 0, 0xff);
  glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
  glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
  glDrawArrays(GL_TRIANGLES, 0, cut.fans.count());
  gl::apply({.depth_write = false, .blend = true});
  glStencilFunc(GL_NOTEQUAL, 0, 0xff);
  glStencilOp(GL_ZERO, GL_ZERO, GL_ZERO);  // resets the stencil, so that each pixel is filled once
  glDrawArrays(GL_TRIANGLES, 0, cut.fans.count());
  glDisable(GL_STENCIL_TEST);
}

void CutPass::draw(const std::vector<MeshItem>& items, float alpha, const ClipPlane& clip, const Camera& camera,
                   const Look& look, SegmentPass& segments) {
  set_clipped(false);
  const double part = std::sqrt(0.5) / hatch_distance(camera);
  double side = alpha < 1 ? -1 : 1;
  for (const MeshItem& item : items) {
    Cut& cut = cut_of(item, clip);
    const CutColors colors = cut_colors(item.albedo, look);
    program_.set("world_from_plane", plane_matrix(plane_of(clip)));
    program_.set("toward_eye", kCapTowardEye);
    program_.set("fill", colors.fill);
    program_.set("line", colors.line);
    program_.set("across", glm::vec2(part, side * part));
    program_.set("alpha", alpha);
    program_.use();
    draw_cap(cut);
    side = -side;  // successive bodies are hatched in different directions
    segments.draw_lines(cut.rim, {.world_from_model = ui::matrix(item.X_WM), .toward_eye = kRimTowardEye});
  }
}

void CutPass::end_frame() {
  std::erase_if(cuts_, [](const Cut& cut) { return !cut.used; });
  for (Cut& cut : cuts_) cut.used = false;
}

}  // namespace taxel::ui
