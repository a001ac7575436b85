// From drafts to solids of the Manifold library and back.
#pragma once

#include <manifold/manifold.h>

#include "core/mesh/repair/draft.h"

namespace taxel {

/// How make_solid takes faces.
enum class SolidFaces {
  numbered,    ///< each carries its number through all operations, and no two are merged
  inside_out,  ///< numbered and turned: the faces of a cavity become those of a body
  mergeable    ///< coplanar ones may be merged
};

/// The solid within some faces of a draft, which are closed.
manifold::Manifold make_solid(const Draft& draft, const std::vector<int>& faces, SolidFaces kind);

/// Appends the faces of a solid with points of their own. The loaded face of each is that of the
/// numbered face whose number it has.
void append_solid(Draft& draft, const manifold::Manifold& solid, const std::vector<int>& source_loaded);
/// Appends the faces of a solid without numbers, marked kWrappedFace.
void append_wrapped(Draft& draft, const manifold::Manifold& solid);

}  // namespace taxel
