// The rows of layout_formats(), each defined in the file of its format.
#pragma once

#include "core/layout/formats/layout_format.h"

namespace taxel {

LayoutFormat own_format();            ///< `*.taxels.json` (docs/layout_format.md)
LayoutFormat csv_format();            ///< tables of taxels, GenTact's among them
LayoutFormat sensor_yaml_format();    ///< sensor descriptions of mujoco_contact_surfaces
LayoutFormat icub_format();           ///< iCub's positions of taxels
LayoutFormat genesis_format();        ///< Genesis' probes
LayoutFormat npz_format();            ///< NumPy poses
LayoutFormat urdf_format();           ///< URDF with the tactile sensors of tactile_toolbox
LayoutFormat mjcf_format();           ///< MuJoCo scenes with the plugin or touch sites
LayoutFormat mjcf_sites_format();     ///< the same, written with a site and a touch sensor for each taxel
LayoutFormat tactile_state_format();  ///< readings of ROS, which are refused

}  // namespace taxel
