// The result of `taxel contact` as plain values, and as text, JSON and polygon files.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/sensor/contact_case/contact_case.h"

namespace taxel::cli {

struct ContactReport {
  const ContactResult& result;
  Pose X_WA;  ///< of body a
  std::vector<std::string> warnings;
  std::vector<std::pair<std::string, FieldReport>> fields;  ///< of each soft body that has tets: "a" or "b", its report
  double microseconds = 0;                                  ///< median time of one surface and its wrench
  int repeats = 1;
};

std::string contact_text(const ContactReport& report);
std::string contact_json(const ContactReport& report);
/// All polygons, world frame: vertices, pressures, normal, area, tet, face.
std::string polygons_json(const ContactReport& report);
/// The same with one line per polygon corner: polygon,x,y,z,pressure,nx,ny,nz,area,tet,face.
std::string polygons_csv(const ContactReport& report);

}  // namespace taxel::cli
