// The jobs of all features: a result is taken once, and at rest too.
#include <gtest/gtest.h>

#include <memory>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/job_executor.h"
#include "app/studio/nouns/study/study_state.h"
#include "core/sensor/sensor_model.h"

namespace taxel::studio {
namespace {

void send_nothing(const SimCommand& /*command*/) {}

TEST(FeatureJobs, AreIdleAtFirst) {
  InlineExecutor executor;
  FeatureJobs jobs(executor);
  EXPECT_FALSE(jobs.busy());
  EXPECT_FALSE(jobs.take_about_layout(nullptr, true));
  EXPECT_FALSE(jobs.take_about_run(nullptr, {}, send_nothing));
  HostEvents events;
  jobs.report(events);
  EXPECT_TRUE(events.empty());
}

TEST(FeatureJobs, AreMadeByTheRowsThatHaveOne) {
  InlineExecutor executor;
  int count = 0;
  for (const ui::Feature* row : ui::features()) {
    if (row->make_job == nullptr) continue;
    ++count;
    const std::unique_ptr<FeatureJob> job = row->make_job(executor);
    ui::App app;
    job->request_about_layout(app, nullptr);
    job->request_about_run(app, nullptr, send_nothing);
    job->fill(app);
    EXPECT_FALSE(job->busy()) << row->title;
  }
  EXPECT_GT(count, 0);
}

/// A study ends while nothing else happens: its result is new once.
TEST(FeatureJobs, TakeAStudyThatEndsAtRest) {
  InlineExecutor executor;
  FeatureJobs jobs(executor);
  ui::App app;
  app.get<ui::StudyState>().request = ui::StudyRequest{1, {}, "/no/such/folder"};
  jobs.request_about_run(app, std::make_shared<const SensorModel>(), send_nothing);
  EXPECT_TRUE(jobs.busy());
  executor.begin_frame(true);
  executor.run_posted();
  EXPECT_TRUE(jobs.take_about_run(nullptr, {}, send_nothing));
  EXPECT_FALSE(jobs.take_about_run(nullptr, {}, send_nothing));
  jobs.fill(app);
  ASSERT_NE(app.get<ui::StudyState>().shown.curves, nullptr);
  EXPECT_NE(app.get<ui::StudyState>().shown.curves->problem, "");
}

TEST(FeatureJobs, ReportAStudyThatCannotBeReadWithoutALayout) {
  InlineExecutor executor;
  FeatureJobs jobs(executor);
  ui::App app;
  app.get<ui::StudyState>().request = ui::StudyRequest{1, {}, "/no/such/folder"};
  jobs.request_about_run(app, nullptr, send_nothing);
  executor.begin_frame(true);
  executor.run_posted();
  EXPECT_TRUE(jobs.take_about_run(nullptr, {}, send_nothing));
  HostEvents events;
  jobs.report(events);
  ASSERT_EQ(events.size(), 1U);
  const auto* message = std::get_if<HostMessage>(&events.front());
  ASSERT_NE(message, nullptr);
  EXPECT_EQ(message->severity, Severity::error);
  events.clear();
  jobs.report(events);
  EXPECT_TRUE(events.empty()) << "once";
}

}  // namespace
}  // namespace taxel::studio
