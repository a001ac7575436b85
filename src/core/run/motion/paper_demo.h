// The demo that the authors of the paper released: the path of the finger onto a box and back.
//
// World of the demo: the box is at (0.01, 0, 0.013) with half edges of 0.025; no gravity. With s = pi t / 25 s, t from
// 0 to 25 s, the mocap body is at
//
//   x = -0.020 + 0.025 sin s,  y = 0,  z = 0.070 - 0.012 sin s,  q = (0.271 0.653 0.653 0.271) normalised:
//
// a straight line there and back. The demo moves the mocap body 1000 times along this path; here it moves in every
// step. The demo uses MuJoCo's default weld (solref 0.02 1) and density (a finger of 5 g): the finger yields until it
// presses with 0.03 N, and readings jump by a third of a peak. Here the weld is that of all other scenarios: the finger
// presses with 0.9 N, and readings are those of the paper.
#pragma once

#include "core/document/paper_setting.h"
#include "core/layout/layout.h"

namespace taxel {

inline constexpr double kDemoSeconds = 25;
inline constexpr double kPaperFriction = 0.3;

/// Returns R_WM; M is the frame of the finger's mesh file. The orientation of the paper's finger is the quaternion
/// above. Any other finger is turned until its `distal` and `pad` are parallel to those of the paper's finger.
dquat demo_orientation(const SensorFrame& frame);

/// Returns the lowest point in the middle of the finger's width at `time` [s], frame W. The mesh file of the paper's
/// finger is then at the pose above. All fingers have the same path and the same depth: 3.4 mm.
dvec3 demo_lead(double time);

/// Returns the length of the path up to `time` [m].
double demo_travel(double time);

}  // namespace taxel
