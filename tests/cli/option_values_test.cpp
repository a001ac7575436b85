// Invalid values of options are refused before anything is computed.
#include <fmt/format.h>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {

TEST(OptionValues, AreRefusedIfTheyAreEmpty) {
  const std::filesystem::path folder = test_folder();
  const std::string layout = fingertip_layout().string();
  const std::string rule = ": must not be empty; leave the option out for its default";
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& option) {
    expect_refusal(taxel(arguments, folder), "taxel: " + arguments[0] + ": " + option + rule);
  };
  for (const char* option : {"--out", "--layout", "--mesh", "--sensor", "--scenario", "--object"})
    refused({"sweep", option, ""}, option);
  for (const char* option : {"--out", "--layout", "--mesh"}) {
    refused({"play", "press.json", option, ""}, option);
    refused({"study", "study.json", option, ""}, option);
    refused({"run", "scene.xml", option, ""}, option);
  }
  refused({"run", "scene.xml", "--plugins", ""}, "--plugins");
  refused({"samples", layout, "--out", ""}, "--out");
  refused({"mesh", "", "--out", "m.stl"}, "FILE");
  refused({"check", layout, ""}, "FILE");
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST(OptionValues, AreRefusedForSeedsThatAreNo64BitIntegers) {
  const std::string layout = fingertip_layout().string();
  for (const char* seed : {"-1", "18446744073709551616", "1.5", "1e3", "0x10", "seven", " 1"})
    expect_refusal(taxel({"samples", layout, "--seed", seed}),
                   std::string("taxel: samples: --seed: must be a whole number from 0 to 2^64 - 1, is ") + seed);
  EXPECT_EQ(taxel({"samples", layout, "--density", "1e4", "--seed", "18446744073709551615"}).status, 0);
}

TEST(OptionValues, AreRefusedForNumbersThatAreNotPlain) {
  for (const char* text : {"0x10", "  5", "5 ", "5.0", "1e1", "0", "4097"})
    for (const char* option : {"--workers", "--group"})
      expect_refusal(taxel({"batch", "jobs.jsonl", "--out", "out", option, text}),
                     fmt::format("taxel: batch: {}: must be a whole number from 1 to 4096, is {}", option, text));
  for (const char* text : {"0x1p3", " 1", "1 ", "inf", "nan"})
    expect_refusal(taxel({"sweep", "--mass", text}),
                   fmt::format("taxel: sweep: --mass: must be greater than 0, is {}", text));
}

TEST(OptionValues, AreRefusedForRunsThatAreTooLong) {
  const std::filesystem::path folder = test_folder();
  const auto scene = [](const char* timestep) {
    return std::string("<mujoco><option timestep=\"") + timestep +
           "\"/><worldbody><geom name=\"ball\" size=\"0.02\"/></worldbody></mujoco>";
  };
  write_text(folder / "fast.xml", scene("1e-8"));
  write_text(folder / "slow.xml", scene("1e-3"));
  const auto refused = [&](const char* file, const char* seconds, const std::string& line) {
    const Outcome outcome = taxel({"run", file, "--layout", fingertip_layout().string(), "--geom", "ball", "--seconds",
                                   seconds, "--out", "out", "--quiet"},
                                  folder);
    expect_refusal(outcome, "taxel: " + line);
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  };
  refused("slow.xml", "1e308",
          "1e+308 s in steps of 0.001 s would take inf steps, at most 1e+08 are made: is the time step too small?");
  refused("fast.xml", "2",
          "2 s in steps of 1e-08 s would take 2e+08 steps, at most 1e+08 are made: is the time step too small?");
  refused("slow.xml", "50000",
          "the recording of 5e+07 steps would take 23.1 GiB of memory, at most 1 GiB are taken: give fewer --seconds");
}

}  // namespace
}  // namespace taxel::test
