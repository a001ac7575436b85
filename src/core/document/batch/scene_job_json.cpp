// Reads and writes the scene of a job (docs/many_runs.md).
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

#include "core/base/text/json.h"
#include "core/document/batch/scene_job.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;
using Node = JsonNode<Json>;

constexpr std::array<const char*, 3> kShifts{"x", "y", "z"}, kTurns{"turn_x_deg", "turn_y_deg", "turn_z_deg"};
constexpr std::array<const char*, 5> kGeomTypes{"sphere", "capsule", "ellipsoid", "cylinder", "box"};

std::string text_that_is_set(const Node& node) {
  const std::string text = node.text();
  if (text.empty()) node.fail("must not be empty");
  return text;
}

std::string path_of(const Node& node, const std::filesystem::path& folder) {
  return (folder / text_that_is_set(node)).lexically_normal().string();
}

double finite_number(const Node& node) {
  const double value = node.number();
  if (!std::isfinite(value)) node.wrong("a finite number");
  return value;
}

double positive_number(const Node& node) {
  const double value = finite_number(node);
  if (!(value > 0)) node.wrong("a number greater than 0");
  return value;
}

JobAttachment read_attachment(const Node& node, const std::filesystem::path& folder) {
  node.only({"layout", "geom", "body", "others", "sisters"});
  JobAttachment made;
  made.layout = path_of(node.at("layout"), folder);
  if (const auto geom = node.find("geom")) made.geom = text_that_is_set(*geom);
  if (const auto body = node.find("body")) made.body = text_that_is_set(*body);
  if (!made.geom.empty() && !made.body.empty()) node.fail_at("body", "excludes geom: name one of the two");
  if (const auto others = node.find("others")) made.others = text_that_is_set(*others);
  if (const auto sisters = node.find("sisters")) {
    const std::string word = sisters->text();
    if (word != "replace" && word != "keep") sisters->wrong("\"replace\" or \"keep\"");
    made.keeps_sisters = word == "keep";
  }
  return made;
}

BodyMove read_move(const std::string& body, const Node& node) {
  node.only({"x", "y", "z", "turn_x_deg", "turn_y_deg", "turn_z_deg"});
  BodyMove move;
  move.body = body;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (const auto shift = node.find(kShifts[k])) move.shift_W[i] = finite_number(*shift);
    if (const auto turn = node.find(kTurns[k])) move.turn_W_deg[i] = finite_number(*turn);
  }
  return move;
}

GeomChange read_geom(const std::string& geom, const Node& node) {
  node.only({"type", "size", "mass", "friction"});
  GeomChange change;
  change.geom = geom;
  if (const auto type = node.find("type")) {
    change.type = type->text();
    if (std::ranges::find(kGeomTypes, change.type) == kGeomTypes.end())
      type->wrong("sphere, capsule, ellipsoid, cylinder or box");
  }
  if (const auto size = node.find("size")) {
    if (size->length() == 0 || size->length() > 3) size->fail("must have 1 to 3 numbers, as in MJCF");
    for (std::size_t i = 0; i < size->length(); ++i) change.size.push_back(positive_number(size->item(i)));
  }
  if (!change.type.empty() && change.size.empty()) node.fail("must have a size with the type");
  if (const auto mass = node.find("mass")) change.mass = positive_number(*mass);
  if (const auto friction = node.find("friction")) {
    change.friction = finite_number(*friction);
    if (!(*change.friction >= 0)) friction->wrong("a number of at least 0");
  }
  return change;
}

std::vector<double> read_numbers(const Node& node) {
  std::vector<double> values;
  for (std::size_t i = 0; i < node.length(); ++i) values.push_back(finite_number(node.item(i)));
  return values;
}

ControlTable read_table(const Node& node) {
  ControlTable table;
  const Node time = node.at("time");
  table.times = read_numbers(time);
  if (table.times.empty()) time.fail("must have at least one time");
  for (std::size_t i = 0; i < table.times.size(); ++i) {
    if (table.times[i] < 0) time.item(i).wrong("a time of at least 0 s");
    if (i > 0 && !(table.times[i] > table.times[i - 1])) time.item(i).fail("must be later than the time before");
  }
  for (const auto& [name, unused] : node.json().items()) {
    if (name == "time") continue;
    const Node column = node.at(name);
    table.values[name] = read_numbers(column);
    if (table.values[name].size() != table.times.size())
      column.fail(fmt::format("must have a value for each of the {} times, has {}", table.times.size(),
                              table.values[name].size()));
  }
  if (table.values.empty()) node.fail("must have a list of values for at least one actuator, by its name");
  return table;
}

void read_start(const Node& node, const std::filesystem::path& folder, SceneJob& scene) {
  if (const auto attach = node.find("attach"))
    for (std::size_t i = 0; i < attach->length(); ++i) scene.attach.push_back(read_attachment(attach->item(i), folder));
  if (const auto keyframe = node.find("keyframe"))
    scene.keyframe = keyframe->is_text() ? text_that_is_set(*keyframe) : std::to_string(keyframe->natural());
  if (const auto moves = node.find("moves")) {
    moves->must_be_object();
    for (const auto& [body, unused] : moves->json().items()) scene.moves.push_back(read_move(body, moves->at(body)));
  }
  if (const auto geoms = node.find("geoms")) {
    geoms->must_be_object();
    for (const auto& [geom, unused] : geoms->json().items()) scene.geoms.push_back(read_geom(geom, geoms->at(geom)));
  }
}

void read_lead_of(const Node& node, const std::filesystem::path& folder, SceneJob& scene) {
  if (const auto controls = node.find("controls")) {
    if (controls->is_text()) {
      scene.controls = path_of(*controls, folder);
    } else {
      controls->must_be_object();
      scene.table = read_table(*controls);
    }
  }
  if (const auto mocap = node.find("mocap")) scene.mocap = path_of(*mocap, folder);
  if (const auto replay = node.find("replay")) scene.replay = path_of(*replay, folder);
  if (!scene.mocap.empty() && !scene.replay.empty()) node.fail_at("replay", "excludes mocap: both lead mocap bodies");
  if (const auto policy = node.find("policy")) scene.policy = text_that_is_set(*policy);
  if (!scene.policy.empty() && (scene.table || !scene.controls.empty()))
    node.fail_at("policy", "excludes controls: both set the controls of actuators");
}

Json number(double value) {
  return json_number<Json>(value, "");
}

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

Json attachment_json(const JobAttachment& one) {
  Json json{{"layout", one.layout}};
  if (!one.geom.empty()) json["geom"] = one.geom;
  if (!one.body.empty()) json["body"] = one.body;
  if (!one.others.empty()) json["others"] = one.others;
  if (one.keeps_sisters) json["sisters"] = "keep";
  return json;
}

Json move_json(const BodyMove& move) {
  Json json = Json::object();
  for (int i = 0; i < 3; ++i)
    if (move.shift_W[i] != 0) json[kShifts[static_cast<std::size_t>(i)]] = number(move.shift_W[i]);
  for (int i = 0; i < 3; ++i)
    if (move.turn_W_deg[i] != 0) json[kTurns[static_cast<std::size_t>(i)]] = number(move.turn_W_deg[i]);
  return json;
}

Json geom_json(const GeomChange& change) {
  Json json = Json::object();
  if (!change.type.empty()) json["type"] = change.type;
  if (!change.size.empty()) json["size"] = numbers(change.size);
  if (change.mass) json["mass"] = number(*change.mass);
  if (change.friction) json["friction"] = number(*change.friction);
  return json;
}

}  // namespace

SceneJob parse_scene_job(const std::string& text, const std::filesystem::path& folder) {
  const std::string file;
  Json json = parse_json<Json>(text, file);
  if (json.is_string()) json = Json{{"file", json}};
  const Node root(json, file);
  root.only({"file", "attach", "keyframe", "moves", "geoms", "controls", "mocap", "replay", "policy", "seconds",
             "record_interval"});
  SceneJob scene;
  scene.file = path_of(root.at("file"), folder);
  read_start(root, folder, scene);
  read_lead_of(root, folder, scene);
  if (const auto seconds = root.find("seconds")) scene.seconds = positive_number(*seconds);
  if (const auto interval = root.find("record_interval")) scene.record_interval = positive_number(*interval);
  const bool has_end = scene.table || !scene.controls.empty() || !scene.mocap.empty() || !scene.replay.empty();
  if (scene.seconds == 0 && !has_end) root.fail_at("seconds", "is missing: no table of controls or poses ends the run");
  return scene;
}

std::string scene_job_to_json(const SceneJob& scene) {
  Json json{{"file", scene.file}};
  for (const JobAttachment& one : scene.attach) json["attach"].push_back(attachment_json(one));
  if (!scene.keyframe.empty()) json["keyframe"] = scene.keyframe;
  for (const BodyMove& move : scene.moves) json["moves"][move.body] = move_json(move);
  for (const GeomChange& change : scene.geoms) json["geoms"][change.geom] = geom_json(change);
  if (!scene.controls.empty()) json["controls"] = scene.controls;
  if (scene.table) {
    json["controls"]["time"] = numbers(scene.table->times);
    for (const auto& [name, values] : scene.table->values) json["controls"][name] = numbers(values);
  }
  if (!scene.mocap.empty()) json["mocap"] = scene.mocap;
  if (!scene.replay.empty()) json["replay"] = scene.replay;
  if (!scene.policy.empty()) json["policy"] = scene.policy;
  if (scene.seconds > 0) json["seconds"] = number(scene.seconds);
  json["record_interval"] = number(scene.record_interval);
  return json_line(json);
}

std::vector<std::pair<std::string, std::string*>> files_of(SceneJob& scene) {
  std::vector<std::pair<std::string, std::string*>> files;
  for (std::size_t i = 0; i < scene.attach.size(); ++i)
    files.emplace_back(fmt::format("/attach/{}/layout", i), &scene.attach[i].layout);
  for (const auto& [pointer, file] : {std::pair{"/controls", &scene.controls}, std::pair{"/mocap", &scene.mocap},
                                      std::pair{"/replay", &scene.replay}})
    if (!file->empty()) files.emplace_back(pointer, file);
  return files;
}

}  // namespace taxel
