// Presses a fingertip onto a box with four targets of its slide, one thread each, and prints the force on the sensor.
#include <mujoco/mujoco.h>

#include <array>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

using Model = std::unique_ptr<mjModel, decltype(&mj_deleteModel)>;
using Data = std::unique_ptr<mjData, decltype(&mj_deleteData)>;

// Returns the force [N] on the sensor after 0.2 s. The readings come first in sensordata, then force, torque and area.
double press(const mjModel* model, double target) {
  const Data data(mj_makeData(model), mj_deleteData);
  data->ctrl[0] = target;
  for (int step = 0; step < 200; ++step) mj_step(model, data.get());
  const int force = model->sensor_adr[0] + model->sensor_dim[0] - 7;
  return mju_norm3(data->sensordata + force);
}

int main() {
  mj_loadPluginLibrary(PLUGIN);
  std::string error(1000, '\0');
  const Model model(mj_loadXML(SCENE, nullptr, error.data(), static_cast<int>(error.size())), mj_deleteModel);
  if (!model) {
    std::cerr << error << '\n';
    return 1;
  }
  const std::array<double, 4> targets{-0.001, 0, 0.001, 0.002};
  std::array<double, 4> forces{};
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < targets.size(); ++i)
      threads.emplace_back([&, i] { forces[i] = press(model.get(), targets[i]); });
  }  // the threads end here
  for (std::size_t i = 0; i < targets.size(); ++i) std::cout << targets[i] << " m: " << forces[i] << " N\n";
  return 0;
}
