// The demo that its authors released with the paper: where the box is, and how the finger is led onto it and back.
//
// World of the demo: the box is at (0.01, 0, 0.013) with half edges of 0.025; no gravity. With s = pi t / 25 s, t from
// 0 to 25 s, the mocap body is at
//
//   x = -0.020 + 0.025 sin s,  y = 0,  z = 0.070 - 0.012 sin s,  q = (0.271 0.653 0.653 0.271) normalised:
//
// a straight line there and back. The demo places the mocap body 1000 times on this path; here every step does. The
// demo leaves MuJoCo's default weld (solref 0.02 1) and density, so a finger of 5 g, as they are: it gives way until it
// presses 0.03 N, and readings jump by a third of a peak. The weld of all other scenarios holds it here, with which it
// presses 0.9 N and readings are those of the paper.
#pragma once

#include "core/document/paper_setting.h"
#include "core/layout/layout.h"

namespace taxel {

inline constexpr double kDemoSeconds = 25;
inline constexpr double kPaperFriction = 0.3;

/// R_WM, M being the frame of the finger's mesh file. The paper's finger is turned by the quaternion above; any other
/// one so that its `distal` and `pad` point where those of the paper's finger do.
dquat demo_orientation(const SensorFrame& frame);

/// Where the finger's lowest point, in the middle of its width, is at `time` [s], world. The mesh file of the paper's
/// finger is then at the pose above. On any finger the path is the same, and presses as deep: 3.4 mm.
dvec3 demo_lead(double time);

/// Length of the path up to `time` [m].
double demo_travel(double time);

}  // namespace taxel
