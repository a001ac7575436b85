#include "core/sensor/contact_case/case_objects.h"

#include <filesystem>
#include <optional>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/memo.h"
#include "core/base/text/table.h"

namespace taxel {
namespace {

constexpr double kSharedBodies = 16;

/// Equal for two bodies only if make_case_body() makes the same of both.
struct BodyContent {
  std::string name;
  CaseShape shape;
  Material material;
  std::string path, sha256;  ///< absolute path and content of the file, or empty

  bool operator==(const BodyContent&) const = default;
};

/// Returns the content of a body, or nothing for bodies that are not shared.
std::optional<BodyContent> content_of(const ContactCase& contact_case, const CaseBody& body, const std::string& name) {
  if (!body.shape) return std::nullopt;
  BodyContent content{name, *body.shape, body.material, "", ""};
  if (body.shape->file.empty()) return content;
  const std::filesystem::path path = std::filesystem::absolute(beside_case(contact_case, body.shape->file));
  if (lower_case(path.extension().string()) == ".gltf") return std::nullopt;
  try {
    content.path = path.string();
    content.sha256 = sha256_hex(read_file(path));
  } catch (const Error&) {
    return std::nullopt;  // make_case_body() reports the file
  }
  return content;
}

}  // namespace

MadeBodyPtr share_case_body(const ContactCase& contact_case, const CaseBody& body, const std::string& name) {
  const auto make = [&] { return std::make_shared<const MadeBody>(make_case_body(contact_case, body, name)); };
  const std::optional<BodyContent> content = content_of(contact_case, body, name);
  if (!content) return make();
  static Memo<BodyContent, MadeBodyPtr> memo(kSharedBodies);
  return memo.get(*content, [&]() -> MadeBodyPtr { return make(); });
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
