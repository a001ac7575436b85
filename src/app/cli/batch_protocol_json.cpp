// The replies to a group of jobs and to an observation, read from their lines of JSON.
#include <nlohmann/json.hpp>

#include "app/cli/batch_protocol.h"
#include "app/cli/policy_dispatch.h"
#include "core/base/files.h"
#include "core/base/text/json.h"

namespace taxel::cli {

GroupReply parse_group_reply(const std::string& line) {
  using Json = nlohmann::ordered_json;
  const std::string file;
  const Json json = parse_json<Json>(line, file);
  const JsonNode<Json> root(json, file);
  root.only({"group", "bytes", "error"});
  GroupReply reply;
  reply.group = root.at("group").text();
  if (const auto error = root.find("error")) {
    reply.error = error->text();
    if (reply.error.empty()) error->fail("must not be empty");
    return reply;
  }
  const std::uint64_t bytes = root.at("bytes").natural();
  if (bytes == 0 || bytes > kMaxFileBytes) root.fail_at("bytes", fmt::format("must be from 1 to {}", kMaxFileBytes));
  reply.bytes = static_cast<std::size_t>(bytes);
  return reply;
}

PolicyReply parse_policy_reply(const std::string& line) {
  using Json = nlohmann::ordered_json;
  const std::string file;
  const Json json = parse_json<Json>(line, file);
  const JsonNode<Json> root(json, file);
  root.only({"job", "action"});
  PolicyReply reply;
  reply.job = root.at("job").text();
  const JsonNode<Json> action = root.at("action");
  for (std::size_t i = 0; i < action.length(); ++i) reply.action.push_back(action.item(i).number());
  return reply;
}

}  // namespace taxel::cli
