#include "core/layout/presets.h"

#include "core/layout/generators/place.h"

namespace taxel {
namespace {

/// One taxel of the paper's +x side, in millimetres as published; the other six are its mirror images in x.
struct Published {
  const char* place;
  dvec3 center_mm, normal;
};
constexpr Published kPublished[] = {
    {"pad low", {4.1518, -6.1507, 14.6462}, {0.3739, -0.9233, 0.0878}},
    {"side low", {8.6195, 0.4629, 13.1657}, {0.9990, -0.0327, 0.0315}},
    {"side mid", {8.3022, 0.7405, 19.4511}, {0.9954, -0.0372, 0.0879}},
    {"pad mid", {3.5417, -5.0062, 23.8569}, {0.3660, -0.8935, 0.2603}},
    {"tip", {2.6699, 0.5571, 30.2862}, {0.3521, -0.1378, 0.9257}},
    {"side high", {7.1384, 0.9784, 25.8859}, {0.9230, -0.0631, 0.3795}},
};
constexpr double kMetresPerMillimetre = 1e-3;
constexpr double kRadius = 0.006;  // radius of the paper's receptive fields [m]

}  // namespace

Layout fingertip_layout(const MeshIndex& skin, const std::string& mesh_sha256) {
  Layout layout;
  layout.name = "Fingertip, 12 taxels";
  layout.mesh = {"../meshes/fingertip.obj", dvec3(1.0), mesh_sha256};
  layout.readout.max_depth = 0.004;
  for (const double side : {1.0, -1.0}) {
    for (const Published& published : kPublished) {
      const SurfacePoint at = skin.closest_point(published.center_mm * kMetresPerMillimetre);
      const dvec3 mirror(side, 1.0, 1.0);
      Taxel taxel = rounded(taxel_on(skin.mesh(), at, static_cast<int>(layout.taxels.size()), kRadius));
      taxel.name = (side > 0.0 ? "right " : "left ") + std::string(published.place);
      taxel.center *= mirror;
      taxel.normal *= mirror;
      layout.taxels.push_back(taxel);
    }
  }
  return layout;
}

}  // namespace taxel
