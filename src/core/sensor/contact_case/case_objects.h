// Objects that sensors touch, prepared once: the body of a shape in a contact case, without its pose.
#pragma once

#include <memory>
#include <string>

#include "core/sensor/contact_case/contact_case.h"

namespace taxel {

using MadeBodyPtr = std::shared_ptr<const MadeBody>;

/// Builds a body of a case like make_case_body(), or returns the body that an earlier call has built from the same
/// content: equal shape, material and name, and for a file equal bytes. The 16 bodies that were used last are kept. A
/// layout, and a .gltf file, whose buffers are other files, are built each time. May be called from any thread. Throws
/// Error as make_case_body() does.
MadeBodyPtr share_case_body(const ContactCase& contact_case, const CaseBody& body, const std::string& name);

/// Parses a body of a contact case from its own JSON object, as {"shape": ..., "material": ..., "resolution": ...}.
/// Pose and velocities are allowed and have no effect on the prepared body. Returns a case whose body b is the object.
/// Throws Error as parse_contact_case() does, with pointers from the object on, and if the object has no shape.
ContactCase parse_case_object(const std::string& text, const std::string& file = "");

/// Returns the name of the body of a case that is a shape for a layout to touch: "b", or "a" if b is the layout. The
/// other body must be a layout or bare. Throws Error naming the file and the body.
std::string object_of_case(const ContactCase& contact_case);

}  // namespace taxel
