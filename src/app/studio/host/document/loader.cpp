#include "app/studio/host/document/loader.h"

#include <fmt/format.h>

#include <utility>

#include "app/studio/host/episodes/episode_document.h"
#include "app/studio/host/examples/examples.h"
#include "core/base/error.h"
#include "core/base/text/shown_message.h"

namespace taxel::studio {

Loader::Loader(JobExecutor& executor, SensorCache& cache)
    : slot_(executor, Priority::background,
            [&cache](const std::shared_ptr<const Task>& task, LoadResult& out, Progress& progress) {
              run(*task, cache, out, progress);
            }) {}

void Loader::run(const Task& task, SensorCache& cache, LoadResult& out, Progress& progress) {
  SensorBuild how(&progress);
  how.cache = &cache;
  try {
    if (task.document) {
      out = Polished{task.document->model, task.document->compile(how)};
    } else {
      how.quality = SampleQuality::preview;
      out = task.episode             ? load_episode(*task.episode, how)
            : is_built_in(task.file) ? load_built_in(task.file, how)
                                     : load_document(task.file, task.skin, how);
    }
  } catch (const std::exception& error) {
    out = task.document ? LoadResult(PolishFailed{shown_message(error)}) : LoadResult(LoadFailed{shown_message(error)});
  }
}

void Loader::begin(Task task, int frames) {
  close();
  slot_.post(std::make_shared<const Task>(std::move(task)), Superseded::finish, frames);
  began_ = std::chrono::steady_clock::now();
}

void Loader::start(const std::string& file, const SkinChoice& skin, int frames) {
  begin({file, skin, std::nullopt, std::nullopt}, frames);
  file_ = file;
}

void Loader::start(const EpisodeChoice& episode) {
  begin({"", {}, episode, std::nullopt}, 0);
  file_ = fmt::format("episode {} of {}", episode.episode, episode.folder);
}

void Loader::polish(const LoadedDocument& document) {
  begin({"", {}, std::nullopt, document}, kPreviewFrames);
}

void Loader::cancel() {
  if (!slot_.posted()) return;
  LoadResult report = polishing() ? LoadResult(PolishCancelled{}) : LoadResult(LoadCancelled{});
  close();
  cancelled_ = std::move(report);
}

void Loader::close() {
  slot_.post(std::nullopt, Superseded::cancel);
  cancelled_.reset();
}

void Loader::wait() const {
  if (slot_.posted()) slot_.wait();
}

std::optional<LoadResult> Loader::take() {
  if (cancelled_) return std::exchange(cancelled_, std::nullopt);
  const auto result = slot_.take();
  if (!result) return std::nullopt;
  const auto* document = std::get_if<LoadedDocument>(result.get());
  if (document != nullptr && document->previewed()) {
    const Task polish{"", {}, std::nullopt, *document};
    slot_.post(std::make_shared<const Task>(polish), Superseded::finish, kPreviewFrames - 1);  // this frame counts
  }
  return *result;
}

bool Loader::loading() const {
  const auto task = slot_.posted();
  return task && !(*task)->document;
}

bool Loader::polishing() const {
  const auto task = slot_.posted();
  return task && (*task)->document;
}

double Loader::seconds() const {
  return busy() ? std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count() : 0.0;
}

}  // namespace taxel::studio
