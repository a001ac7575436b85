#include "ui/contrast.h"

#include <algorithm>

#include "ui/scene/passes/look.h"

namespace taxel::ui {
namespace {

// Rows of the matrices of Machado, Oliveira and Fernandes (2009) for linear RGB at severity 1.
const glm::mat3 kProtanopia = glm::transpose(glm::mat3(0.152286f, 1.052583f, -0.204868f,  //
                                                       0.114503f, 0.786281f, 0.099216f,   //
                                                       -0.003882f, -0.048116f, 1.051998f));
const glm::mat3 kDeuteranopia = glm::transpose(glm::mat3(0.367322f, 0.860646f, -0.227968f,  //
                                                         0.280085f, 0.672501f, 0.047413f,   //
                                                         -0.011820f, 0.042940f, 0.968881f));

/// Returns the relative luminance of an sRGB colour, 0 to 1 (WCAG 2.2).
double luminance(const glm::vec3& srgb) {
  const glm::dvec3 linear(linear_from_srgb(srgb));
  return 0.2126 * linear.r + 0.7152 * linear.g + 0.0722 * linear.b;
}

}  // namespace

glm::vec3 as_seen(const glm::vec3& srgb, Sight sight) {
  if (sight == Sight::usual) return srgb;
  const glm::mat3& cones = sight == Sight::protanopia ? kProtanopia : kDeuteranopia;
  return srgb_from_linear(glm::clamp(cones * linear_from_srgb(srgb), 0.0f, 1.0f));
}

double contrast(const glm::vec3& a, const glm::vec3& b) {
  constexpr double kFlare = 0.05;  // light that every screen reflects
  const double first = luminance(a), second = luminance(b);
  return (std::max(first, second) + kFlare) / (std::min(first, second) + kFlare);
}

double least_contrast(const glm::vec3& a, const glm::vec3& b) {
  double least = contrast(a, b);
  for (const Sight sight : {Sight::protanopia, Sight::deuteranopia})
    least = std::min(least, contrast(as_seen(a, sight), as_seen(b, sight)));
  return least;
}

glm::vec3 with_contrast(const glm::vec3& color, const glm::vec3& background, double least) {
  constexpr int kSteps = 32;
  const glm::vec3 end = ink_on(background);
  for (int i = 0; i < kSteps; ++i) {
    const glm::vec3 mixed = glm::mix(color, end, static_cast<float>(i) / kSteps);
    if (least_contrast(mixed, background) >= least) return mixed;
  }
  return end;
}

glm::vec3 ink_on(const glm::vec3& background) {
  const glm::vec3 black(0), white(1);
  return contrast(black, background) > contrast(white, background) ? black : white;
}

}  // namespace taxel::ui
