#include "app/studio/app/dump/live_json.h"

#include <nlohmann/json.hpp>

#include "app/studio/app/app.h"
#include "app/studio/app/dump/curves_json.h"
#include "app/studio/app/pointing/shown_scene.h"
#include "app/studio/app/reading_range.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/simulate_features.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_features.h"
#include "app/studio/features/models/models_tool.h"
#include "app/vector_json.h"
#include "ui/scene/color_map.h"

namespace taxel::studio {
namespace {

using Json = nlohmann::ordered_json;

/// Maximum number of skin points in the dump, spread evenly: enough to compare with the frame.
constexpr std::size_t kMostPoints = 400;

Json color_json(const ui::PressureRange& range, double value) {
  const glm::vec3 color = range.color(value);
  return {color.x, color.y, color.z};
}

Json tractions_json(const ui::FieldNumbers& numbers) {
  if (!numbers.tractions) return nullptr;
  const ui::TractionNumbers& t = *numbers.tractions;
  return {{"polygons", t.polygons},
          {"largest_pressure", t.largest_pressure},
          {"largest_friction", t.largest_friction},
          {"metres_per_pascal", t.metres_per_pascal},
          {"friction_known", t.friction_known}};
}

/// Returns the pixels and readings at the centers of triangles of the coloured skin.
Json skin_json(const ui::App& app) {
  const SensorModelPtr model = app.shown->model(*app.viewer);
  const SensorStep* state = app.shown->state(*app.viewer);
  if (!app.viewer->overlays().readings_on_skin || !model || state == nullptr || !app.shown->document.fields)
    return nullptr;
  const ui::SensorFields* fields = app.shown->document.fields->of(model);
  if (fields == nullptr || !fields->weights) return nullptr;
  const ui::SkinWeights& skin = *fields->weights;
  std::vector<float> values;
  skin.spread(state->readings, values);
  const Pose X_WM = ui::shown_pose(*app.viewer, *app.shown);
  const ui::PressureRange range = ui::reading_range(*app.viewer, *app.shown);
  Json points = Json::array();
  const std::size_t stride = 1 + skin.triangles.size() / kMostPoints;
  for (std::size_t t = 0; t < skin.triangles.size(); t += stride) {
    dvec3 corners[3];
    double value = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto i = static_cast<std::size_t>(skin.triangles[t][c]);
      corners[c] = X_WM * dvec3(skin.points[i]);
      value += static_cast<double>(values[i]) / 3.0;
    }
    const dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    const dvec3 pixel = app.viewer->project(middle);
    const dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    points.push_back({{"pixel",
                       {pixel.x + static_cast<double>(app.viewer->view.rect.x0),
                        pixel.y + static_cast<double>(app.viewer->view.rect.y0)}},
                      {"depth", pixel.z},
                      {"facing", glm::dot(normal, app.viewer->camera().eye() - middle) > 0},
                      {"value", value},
                      {"color", color_json(range, value)}});
  }
  return {{"triangles", skin.triangles.size()}, {"largest", range.hi}, {"points", std::move(points)}};
}

Json map_json(const ui::App& app) {
  Json discs = Json::array();
  const ui::PressureRange range = ui::reading_range(*app.viewer, *app.shown);
  for (const ui::MapDisc& disc : app.simulate->map.discs)
    discs.push_back({{"sensor", disc.sensor},
                     {"taxel", disc.taxel_id},
                     {"value", disc.value},
                     {"at", {disc.x, disc.y}},
                     {"radius", disc.radius},
                     {"color", color_json(range, disc.value)}});
  return {{"unrolled", app.simulate->map.unrolled}, {"discs", std::move(discs)}};
}

/// Returns the readings of the models at the displayed step, and their comparison over all steps that were read.
Json models_json(const ui::App& app) {
  const ui::ComparedSteps* compared =
      ui::shown_comparison(*app.viewer, *app.shown, app.simulate->models, app.window->panels.models);
  if (compared == nullptr) return nullptr;
  Json json{{"steps", compared->steps.size()}, {"due", compared->due}, {"problem", compared->problem}};
  const ui::ComparedStep* step = compared->at(app.shown->run.frame->step);
  json["step"] = step != nullptr ? Json(step->step) : Json(nullptr);
  json["models"] = Json::object();
  const int taxel = ui::compared_taxel(app.viewer->selection, *compared);
  json["taxel"] = taxel >= 0 ? Json(compared->model->layout.taxels[static_cast<std::size_t>(taxel)].id) : Json(nullptr);
  for (const ReadingModel model : kReadingModels) {
    Json& one = json["models"][to_word(model)];
    one["unit"] = unit_of(model, compared->model->layout.readout.aggregate);
    if (step != nullptr) one["values"] = step->readings[model].values;
    if (step != nullptr) one["missing"] = step->readings[model].missing;
    if (taxel < 0) continue;
    const auto curve = [&](ReadingModel m) { return ui::model_curve(*compared, m, static_cast<std::size_t>(taxel)); };
    const CurveComparison c = compare_curve(curve(model), curve(ReadingModel::exact));
    one["peak"] = c.peak;
    one["largest_step"] = c.largest_step;
    one["correlation"] = c.correlation ? Json(*c.correlation) : Json(nullptr);
    one["rms"] = c.rms ? Json(*c.rms) : Json(nullptr);
  }
  return json;
}

}  // namespace

std::string live_to_json(const ui::App& app) {
  return Json{{"tractions", tractions_json(app.window->view.numbers)},
              {"skin", skin_json(app)},
              {"map", map_json(app)},
              {"plot", Json::parse(plot_to_json(app))},
              {"heat", Json::parse(heat_to_json(app))},
              {"models", models_json(app)}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace taxel::studio
