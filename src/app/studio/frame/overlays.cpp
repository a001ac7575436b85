#include "app/studio/frame/overlays.h"

#include <imgui.h>

#include <array>

#include "ui/scene/scene_input.h"

namespace taxel::ui {

namespace {

constexpr std::array kOverlayRows = {
    OverlaySpec{"sensor_transparent", "Transparent sensor", &Overlays::sensor_transparent, ImGuiKey_T},
    OverlaySpec{"wireframe", "Wireframe", &Overlays::wireframe, ImGuiKey_W},
    OverlaySpec{"rays", "Rays", &Overlays::rays, ImGuiKey_Y},
    OverlaySpec{"all_rays", "Rays of all taxels", &Overlays::all_rays},
    OverlaySpec{"contact_surface", "Contact surface", &Overlays::contact_surface, ImGuiKey_C},
    OverlaySpec{"contact_edges", "Contact edges", &Overlays::contact_edges},
    OverlaySpec{"slip_map", "Slip map of the contact", &Overlays::slip_map},
    OverlaySpec{"tractions", "Traction arrows", &Overlays::tractions, ImGuiKey_V},
    OverlaySpec{"readings_on_skin", "Readings on the skin", &Overlays::readings_on_skin, ImGuiKey_S},
    OverlaySpec{"ghost", "Onion skin (previous step)", &Overlays::ghost, 0, kSimulate},
    OverlaySpec{"filtered_polygons", "Filtered polygons", &Overlays::filtered_polygons},
    OverlaySpec{"samples", "Samples", &Overlays::samples, ImGuiKey_P},
    OverlaySpec{"sample_normals", "Sample normals", &Overlays::sample_normals, ImGuiKey_N},
    OverlaySpec{"taxels", "Taxels", &Overlays::taxels},
    OverlaySpec{"taxel_labels", "Taxel labels", &Overlays::taxel_labels},
    OverlaySpec{"all_taxels", "Marks of all taxels", &Overlays::all_taxels},
    OverlaySpec{"reading_discs", "Readings on the receptive fields", &Overlays::reading_discs},
    OverlaySpec{"receptive_fields", "Receptive fields", &Overlays::receptive_fields},
    OverlaySpec{"fields_filled", "Fields filled", &Overlays::fields_filled},
    OverlaySpec{"fields_compared", "Receptive fields: Euclidean vs. geodesic", &Overlays::fields_compared},
    OverlaySpec{"coverage", "Coverage and overlap", &Overlays::coverage},
    OverlaySpec{"normal_angles", "Normal deviation", &Overlays::normal_angles},
    OverlaySpec{"path", "Path", &Overlays::path},
    OverlaySpec{"grid", "Ground grid", &Overlays::grid},
    OverlaySpec{"constraints", "Welds and connections", &Overlays::constraints},
};

}  // namespace

std::span<const OverlaySpec> overlays() {
  return kOverlayRows;
}

}  // namespace taxel::ui
