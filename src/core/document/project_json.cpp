#include "core/document/project.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/base/text/json.h"
#include "core/document/scenario/scenario.h"
#include "core/layout/file/layout_json.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;
using Node = JsonNode<Json>;
namespace fs = std::filesystem;

constexpr int kVersion = 1;

void read_head(const Node& root) {
  root.must_be_object();
  if (root.at("format").text() != "taxel-project") root.at("format").wrong("\"taxel-project\"");
  const double version = root.at("version").number();
  if (version != kVersion)
    root.fail_at("version", fmt::format("{} is unknown, this program reads version {}", version, kVersion));
  root.only({"format", "version", "layout", "scenario", "view", "mirrors", "hidden"});
}

/// Calls a reader of a part and adds the place of the part in the project to its errors.
template <class Read>
auto read_part(const std::string& file, const std::string& pointer, const Read& read) {
  try {
    return read();
  } catch (const Error& e) {
    throw Error(file, pointer + e.where(), e.message());
  }
}

int whole_number(const Node& node) {
  const double v = node.number();
  if (!(v == std::floor(v) && v >= 0.0 && v <= std::numeric_limits<int>::max()))
    node.wrong("a whole number from 0, of at most 31 bits");
  return static_cast<int>(v);
}

/// Returns a number of a camera. Throws Error beyond the limit: a value of 1e308 would make pixels infinite.
double bounded_number(const Node& node, double largest) {
  const double value = node.number();
  if (!(std::abs(value) <= largest)) node.wrong(fmt::format("between -{0} and {0}", largest));
  return value;
}

View read_view(const Node& node) {
  constexpr double kFarthest = 1e6;      // [m]; the camera resolves 1 mm at this distance
  constexpr double kNearest = 1e-6;      // [m]
  constexpr double kLargestTurn = 36e6;  // degrees
  node.only({"target", "azimuth_deg", "elevation_deg", "distance", "fov_deg"});
  View view;
  const Node target = node.at("target");
  view.target = target.vector3();
  for (std::size_t i = 0; i < 3; ++i) bounded_number(target.item(i), kFarthest);
  view.azimuth_deg = bounded_number(node.at("azimuth_deg"), kLargestTurn);
  view.elevation_deg = node.at("elevation_deg").number();
  if (!(std::abs(view.elevation_deg) <= 90.0)) node.at("elevation_deg").wrong("between -90 and 90");
  view.distance = bounded_number(node.at("distance"), kFarthest);
  must_be_positive(node.at("distance"), view.distance);
  if (!(view.distance >= kNearest)) node.at("distance").wrong(fmt::format("at least {}", kNearest));
  view.fov_deg = node.at("fov_deg").number();
  if (!(view.fov_deg > 0.0 && view.fov_deg < 180.0)) node.at("fov_deg").wrong("between 0 and 180");
  return view;
}

Mirror read_mirror(const Node& node) {
  node.only({"plane", "links"});
  const Node plane = node.at("plane"), links = node.at("links");
  plane.only({"point", "normal"});
  Mirror mirror{{plane.at("point").vector3(), plane.at("normal").vector3()}, {}};
  for (std::size_t i = 0; i < links.length(); ++i) {
    const Node link = links.item(i);
    if (link.length() != 2) link.wrong("an array of 2 ids");
    mirror.links.push_back({whole_number(link.item(0)), whole_number(link.item(1))});
  }
  return mirror;
}

Json view_json(const View& view) {
  return {{"target", json_vector<Json>(view.target, "/view/target")},
          {"azimuth_deg", json_number<Json>(view.azimuth_deg, "/view/azimuth_deg")},
          {"elevation_deg", json_number<Json>(view.elevation_deg, "/view/elevation_deg")},
          {"distance", json_number<Json>(view.distance, "/view/distance")},
          {"fov_deg", json_number<Json>(view.fov_deg, "/view/fov_deg")}};
}

Json mirror_json(const Mirror& mirror, const std::string& pointer) {
  Json links = Json::array();
  for (const MirrorLink& link : mirror.links) links.push_back({link.taxel, link.image});
  return {{"plane",
           {{"point", json_vector<Json>(mirror.plane.point, pointer + "/plane/point")},
            {"normal", json_vector<Json>(mirror.plane.normal, pointer + "/plane/normal")}}},
          {"links", links}};
}

/// Throws Error if a path is not valid UTF-8: a JSON file would change it.
void expect_utf8(const fs::path& file, const std::string& pointer, const std::string& path) {
  if (!is_utf8(path))
    throw Error(file.string(), pointer,
                "the path is not UTF-8, which a JSON file cannot hold: rename the folder or file");
}

/// Returns a path of the document relative to the folder of the file that will hold it.
std::string relative_to(const fs::path& folder, const std::string& file) {
  const fs::path path(file);
  if (file.empty() || !path.is_absolute()) return file;
  const fs::path relative = path.lexically_relative(folder);
  return relative.empty() ? file : relative.generic_string();
}

std::string absolute_from(const fs::path& folder, const std::string& file) {
  return file.empty() ? file : (folder / file).lexically_normal().string();
}

fs::path folder_of(const fs::path& file) {
  return fs::absolute(file).lexically_normal().parent_path();
}

/// Writes the result of `text_of()` to the file. Errors get the name of the file.
template <class Text>
void write_text(const fs::path& path, const Text& text_of) {
  const std::string text = read_part(path.string(), "", text_of);
  write_file_atomically(path, text);
}

}  // namespace

Project parse_project(const std::string& text, const std::string& file) {
  const Json json = parse_json<Json>(text, file, kMaxJsonNesting + 1);
  const Node root(json, file);
  read_head(root);
  Project project;
  const Node layout = root.at("layout");
  layout.must_be_object();
  project.layout = read_part(file, "/layout", [&] { return parse_layout(json_line(layout.json())); });
  project.scenario = parse_scenario("{}");
  if (const auto node = root.find("scenario")) {
    node->must_be_object();
    if (node->find("scenario")) node->fail_at("scenario", "unknown key");
    project.scenario = read_part(file, "/scenario", [&] { return parse_scenario(json_line(node->json())); });
  }
  if (const auto node = root.find("view")) project.view = read_view(*node);
  if (const auto node = root.find("mirrors"))
    for (std::size_t i = 0; i < node->length(); ++i) project.mirrors.push_back(read_mirror(node->item(i)));
  if (const auto node = root.find("hidden"))
    for (std::size_t i = 0; i < node->length(); ++i) project.hidden.push_back(whole_number(node->item(i)));
  read_part(file, "", [&] { check_project(project); });
  return project;
}

std::string project_to_json(const Project& project) {
  Json json = {{"format", "taxel-project"}, {"version", kVersion}};
  json["layout"] = read_part("", "/layout", [&] { return Json::parse(layout_to_json(project.layout)); });
  read_part("", "/scenario", [&] { check_scenario(project.scenario); });
  json["scenario"] = Json::parse(scenario_to_json(project.scenario));
  if (project.view) json["view"] = view_json(*project.view);
  json["mirrors"] = Json::array();
  for (std::size_t i = 0; i < project.mirrors.size(); ++i)
    json["mirrors"].push_back(mirror_json(project.mirrors[i], fmt::format("/mirrors/{}", i)));
  json["hidden"] = project.hidden;
  return json_text(json);
}

Project read_project(const fs::path& path) {
  Project project = parse_project(read_file(path), path.string());
  project.layout.mesh.file = absolute_from(folder_of(path), project.layout.mesh.file);
  for (const auto& [key, file] : files_of(project.scenario)) *file = absolute_from(folder_of(path), *file);
  return project;
}

ProjectOfLayout read_layout_as_project(const fs::path& path) {
  ProjectOfLayout opened;
  Layout& layout = opened.project.layout;
  layout = read_layout(path);
  layout.mesh.file = absolute_from(folder_of(path), layout.mesh.file);
  for (const std::string& note : make_ids_unique(layout)) opened.notes.push_back(path.string() + ": " + note);
  return opened;
}

void write_project(const fs::path& path, const Project& project) {
  Project written = project;
  written.layout.mesh.file = relative_to(folder_of(path), project.layout.mesh.file);
  expect_utf8(path, "/layout/mesh/file", written.layout.mesh.file);
  for (const auto& [key, file] : files_of(written.scenario)) {
    *file = relative_to(folder_of(path), *file);
    expect_utf8(path, "/scenario/" + key, *file);
  }
  write_text(path, [&] { return project_to_json(written); });
}

void export_layout(const fs::path& path, const Project& project) {
  Layout layout = project.layout;
  layout.mesh.file = relative_to(folder_of(path), layout.mesh.file);
  expect_utf8(path, "/mesh/file", layout.mesh.file);
  write_layout(path, layout);
}

}  // namespace taxel
