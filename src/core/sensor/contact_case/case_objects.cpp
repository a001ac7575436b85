#include "core/sensor/contact_case/case_objects.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/memo.h"
#include "core/base/text/table.h"

namespace taxel {
namespace {

constexpr double kSharedBodies = 16;

/// Returns a text that two bodies share only if make_case_body() makes the same of both; empty for bodies that are not
/// shared.
std::string content_key(const ContactCase& contact_case, const CaseBody& body, const std::string& name) {
  if (!body.shape) return "";
  const CaseShape& shape = *body.shape;
  const Material& material = body.material;
  std::string key = fmt::format("{} {} {} {} {} {} {} {} {} {} ", name, static_cast<int>(shape.type), shape.size.x,
                                shape.size.y, shape.size.z, shape.scale.x, shape.scale.y, shape.scale.z,
                                shape.resolution, static_cast<int>(shape.repair));
  key += fmt::format("{} {} {} {} {} {} {} {} ", static_cast<int>(material.field), material.modulus, material.thickness,
                     material.dissipation, material.friction, static_cast<int>(material.faces),
                     material.tangential_stiffness, material.bristles);
  if (shape.height_field) {
    const HeightField& field = *shape.height_field;
    key += fmt::format("{} {} {} {} {} {} {}", field.rows, field.columns, field.size.x, field.size.y, field.size.z,
                       field.base, fmt::join(field.elevation, " "));
  }
  if (!shape.file.empty()) {
    const std::filesystem::path path = beside_case(contact_case, shape.file);
    if (lower_case(path.extension().string()) == ".gltf") return "";
    try {
      key += path.string() + " " + sha256_hex(read_file(path));
    } catch (const Error&) {
      return "";  // make_case_body() reports the file
    }
  }
  return key;
}

}  // namespace

MadeBodyPtr share_case_body(const ContactCase& contact_case, const CaseBody& body, const std::string& name) {
  const auto make = [&] { return std::make_shared<const MadeBody>(make_case_body(contact_case, body, name)); };
  const std::string key = content_key(contact_case, body, name);
  if (key.empty()) return make();
  static Memo<std::string, MadeBodyPtr> memo(kSharedBodies);
  return memo.get(key, [&]() -> MadeBodyPtr { return make(); });
}

std::string object_of_case(const ContactCase& contact_case) {
  const auto is_sensor = [](const CaseBody& body) { return !body.shape; };
  const std::string object = is_sensor(contact_case.b) && !is_sensor(contact_case.a) ? "a" : "b";
  const CaseBody& body = object == "a" ? contact_case.a : contact_case.b;
  const CaseBody& other = object == "a" ? contact_case.b : contact_case.a;
  if (!body.shape) throw Error(contact_case.file, "/" + object, "must be a shape: it is the touched object");
  if (!is_sensor(other))
    throw Error(contact_case.file, object == "a" ? "/b" : "/a",
                "must be the layout, without a shape: it is the sensor");
  return object;
}

}  // namespace taxel
