// The open document, its simulation, the jobs and the files around them: what commands change.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "app/studio/frame/app.h"
#include "app/studio/host/document/document.h"
#include "app/studio/host/document/document_files.h"
#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/run/host_event.h"
#include "app/studio/host/run/run.h"
#include "ui/gl/rgb_image.h"

namespace taxel::ui {
class SceneRenderer;
}

namespace taxel::studio {

/// How the simulation and the jobs run.
struct HostParts {
  std::unique_ptr<SimHost> simulation;
  JobExecutor& executor;               ///< must live longer than the host
  SensorCache& cache;                  ///< parts of compiled sensors; must live longer than the host
  bool is_real_time = true;            ///< false for a script, which gets the same frames every time
  std::filesystem::path kept_in = {};  ///< folder of the files that are left for the next start
  double autosave_every = 30;          ///< interval between autosaves [s]
};

/// The pictures and the texts that only the window can make.
struct Screen {
  ui::SceneRenderer* renderer = nullptr;
  std::function<gl::RgbImage()> picture;  ///< the whole window as it was laid out last
  std::function<std::string()> state;     ///< the state of the window as JSON
};

/// In a script every request has its result in the next update().
struct Host {
  Host(ui::App& shown_in, HostParts parts);
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;
  ~Host() = default;

  ui::App& app;
  bool is_real_time;
  JobExecutor& executor;
  FeatureJobs jobs;  ///< before the document, whose worker uses the jobs
  Document document;
  Run run;
  Handover handover;
  DocumentFiles files;
  LeadRequest next_lead;         ///< leads the scene that is opened next, and each time when it is compiled again
  HostEvents events;             ///< for the next update()
  bool rests_in_layout = false;  ///< the run was paused because LAYOUT is displayed
  Screen screen;

  void report(Severity severity, std::string text, ui::Holds holds = ui::Holds::always);
  /// Whether update() will report nothing unless something is requested.
  [[nodiscard]] bool is_idle() const;
  /// The scenario that SIMULATE would run: that of the document, or the last one.
  [[nodiscard]] const Scenario& scenario() const;
  [[nodiscard]] EditSession& edits() { return document.edits; }
  [[nodiscard]] const EditSession& edits() const { return document.edits; }
};

/// Takes the results of the jobs and the replies of the simulation. A script sees a preview for some frames, unless
/// `without_delay`.
HostEvents update(Host& host, bool without_delay = false);
/// Sets everything in host.app that is displayed of the document and of the run, but rates.
void fill(Host& host);
/// Posts the requests of the open panels about the run.
void request_about_run(Host& host);
/// To be called after each edit. In SIMULATE, the simulation is displayed and reads by the edited layout.
void after_edit(Host& host);
/// Drops the scene of the simulation.
void drop_scene(Host& host);
/// Polishes the displayed samples, if they are a preview's.
void polish(Host& host);

}  // namespace taxel::studio
