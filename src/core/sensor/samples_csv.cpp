#include "core/sensor/samples_csv.h"

#include <fmt/format.h>

#include <iterator>

namespace taxel {

std::string samples_to_csv(const SensorModel& model, const std::vector<int>& file_face_of) {
  std::string text = "x,y,z,nx,ny,nz,face,area,id,used\n";
  auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < model.samples.size(); ++i) {
    const SurfaceSample& s = model.samples[i];
    const int loaded = model.repaired->loaded_face(model.skin_face_of[static_cast<std::size_t>(s.face)]);
    const int face = loaded < 0 ? -1 : file_face_of[static_cast<std::size_t>(loaded)];
    fmt::format_to(out, "{},{},{},{},{},{},{},{},{},{}\n", s.position.x, s.position.y, s.position.z, s.normal.x,
                   s.normal.y, s.normal.z, face, s.area, i, model.taxels_of_sample[i].empty() ? 0 : 1);
  }
  return text;
}

std::string fields_to_csv(const SensorModel& model) {
  std::string text = "sample,taxel,distance,weight\n";
  auto out = std::back_inserter(text);
  for (std::size_t k = 0; k < model.layout.taxels.size(); ++k) {
    for (int e = model.fields.first[k]; e < model.fields.first[k + 1]; ++e) {
      const ReceptiveFields::Entry& entry = model.fields.entries[static_cast<std::size_t>(e)];
      fmt::format_to(out, "{},{},{},{}\n", entry.sample, model.layout.taxels[k].id, entry.distance, entry.weight);
    }
  }
  return text;
}

}  // namespace taxel
