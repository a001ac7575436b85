// A cut through the scene: the plane of the section view, and everything in it as flat lines.
#pragma once

#include <string>

#include "ui/scene/scene_input.h"
#include "ui/scene/scene_parts.h"

namespace taxel::ui {

/// A plane with axes: x to the right (the way the sensor travels), y upward, z towards the viewer.
struct SectionPlane {
  dvec3 origin_W{0};
  dvec3 x{1, 0, 0}, y{0, 0, 1}, z{0, -1, 0};
  [[nodiscard]] dvec2 flat(const dvec3& p_W) const {
    return {glm::dot(p_W - origin_W, x), glm::dot(p_W - origin_W, y)};
  }
  [[nodiscard]] double height(const dvec3& p_W) const { return glm::dot(p_W - origin_W, z); }
};

/// All positions in the plane [m].
struct Section {
  struct Line {
    dvec2 a{0}, b{0};
  };
  struct Outline {
    std::vector<dvec2> points;  ///< corners in order, with the body on the left
    bool closed = false;
    double area = 0;  ///< enclosed area [m^2]; negative for a hole, 0 if open
  };
  struct ContactPiece {
    dvec2 a{0}, b{0};
    double pressure_a = 0, pressure_b = 0;  ///< [Pa]
  };
  struct RayPiece {
    dvec2 from{0}, to{0};
    bool hit = false;
    double pressure = 0;  ///< [Pa]
  };
  struct SamplePoint {
    dvec2 at{0};
    int color = -1;  ///< colour of the nearest taxel, or -1 if unused
  };

  SectionPlane plane;
  std::string title;
  std::vector<Outline> skin, objects;
  std::vector<ContactPiece> contact;
  std::vector<RayPiece> rays;  ///< rays of samples near the plane, projected into it
  std::vector<SamplePoint> samples;
  std::vector<dvec2> path;     ///< path of the finger: two points, or empty
  int color = 0;               ///< colour of the taxel
  int taxel = -1;              ///< taxel whose centre is in the plane, in layout order, or -1
  dvec2 center{0}, normal{0};  ///< centre and normal of the taxel
  double radius = 0;           ///< radius of its receptive field [m]
  dvec2 focus{0};              ///< point to look at: the taxel, otherwise the contact or the skin's middle
  double spacing = 0;          ///< approximate distance of samples [m]
  double size = 0;             ///< half width of the section around the focus [m]
};

/// Computes the section of a sensor: through the selected taxel along its normal, or, if none is selected, through the
/// pressure centroid of the contact along the finger. Rays and samples within `slab` [m] of the plane are included.
Section make_section(const SceneInput& input, const SensorView& view, double slab);

/// Joins pieces whose ends are equal bit by bit into outlines; the pieces of a closed mesh's cut become closed ones.
std::vector<Section::Outline> join_outlines(std::vector<std::pair<dvec3, dvec3>> pieces, const SectionPlane& plane,
                                            const Pose& X_WG);

}  // namespace taxel::ui
