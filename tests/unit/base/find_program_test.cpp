// Programs that are found in PATH.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "core/base/files.h"
#include "core/base/os/find_program.h"
#include "core/base/os/process.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

TEST(HasProgram, FindsOnlyFilesOfPathThatMayBeRun) {
  const test::TempFolder folder;
  const std::string before = os::variable("PATH");
  for (const char* name : {"first", "second"}) fs::create_directory(folder / name);
  write_file_atomically(folder / "second/draw", "#!/bin/sh\n");
  fs::create_directory(folder / "first/encode");
  const auto has = [&](const std::string& path, const char* name) {
    ::setenv("PATH", path.c_str(), 1);
    const bool found = os::has_program(name);
    ::setenv("PATH", before.c_str(), 1);
    return found;
  };
  const std::string both = (folder / "first").string() + ":" + (folder / "second").string();
  fs::permissions(folder / "second/draw", fs::perms::owner_read);
  EXPECT_FALSE(has(both, "draw")) << "it may not be run";
  fs::permissions(folder / "second/draw", fs::perms::owner_all);
  EXPECT_TRUE(has(both, "draw"));
  EXPECT_FALSE(has(both, "encode")) << "a folder";
  EXPECT_FALSE(has((folder / "first").string(), "draw"));
  EXPECT_FALSE(has("", "draw"));
}

}  // namespace
}  // namespace taxel
