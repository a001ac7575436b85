// Computes the contact surface of two bodies at given poses.
#pragma once

#include <memory>

#include "core/hydro/contact_surface.h"
#include "core/hydro/hydro_body.h"

namespace taxel {

struct KernelMemory;

/// Memory of intersect(). No step allocates memory after the first steps, except where bodies reach new places beyond
/// the tets of a pad. Each thread needs its own; the content has no meaning between calls.
struct IntersectWorkspace {
  IntersectWorkspace();
  IntersectWorkspace(const IntersectWorkspace&) : IntersectWorkspace() {}  ///< copies no content
  ~IntersectWorkspace();
  std::unique_ptr<KernelMemory> kernel;
};

/// Fills `out` (frame of A; normals push A). At least one body must be soft. Faces of tets are half-open, so a point
/// exactly between two tets counts once. Throws Error naming the bodies if both are rigid or both are half-spaces, or
/// if a pose is not finite or its quaternion is not of unit length.
void intersect(const HydroBody& a, const HydroBody& b, const Pose& X_WA, const Pose& X_WB, ContactSurface& out,
               IntersectWorkspace& workspace);

}  // namespace taxel
