// A second layout for a sensor of a run: another layout file, or the paper's released model.
#pragma once

#include <filesystem>
#include <string>

#include "core/sensor/sensor_model.h"

namespace taxel {

/// Returns the paper's released model for the taxels of a layout: as_in_the_paper(), Euclidean fields, and the mean
/// with the weights of the field.
[[nodiscard]] Layout released_model_of(const Layout& layout);

/// Reads a layout of any format, or the layout of a project, for the mesh of `first`. A layout without a mesh is put on
/// the mesh file of `first`. Throws Error: the file cannot be read, has no taxels, or is made for another mesh.
[[nodiscard]] Layout read_second_layout(const std::filesystem::path& file, const SensorModel& first);

/// Returns whether both layouts have the same contact surfaces in the same poses: the same pressure field on the same
/// repaired mesh. Friction and dissipation change no surface.
[[nodiscard]] bool has_equal_contact(const Layout& first, const Layout& second);

/// Returns `second` with the pressure field of `first`, so that it reads the surfaces of `first`.
[[nodiscard]] Layout on_contact_of(const Layout& first, Layout second);

}  // namespace taxel
