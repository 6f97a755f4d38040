// SPDX-License-Identifier: Apache-2.0
// A game's editor, which bakes a sky in process. It stops a first bake midway and lets a second one end, for an engine
// that reads spherical harmonics.
//   editor SKY.toml FOLDER STOPPED_FOLDER      exit status 0 when both bakes end as they should
#include <atomic>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <welkin/bake.hpp>

namespace {

int fail(const char* what, const welkin::BakeResult& result) {
  std::fprintf(stderr, "%s: exit status %d, \"%s\"\n", what, result.exit_status, result.error.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 1;
  welkin::BakeOptions options;
  options.file = argv[1];

  options.folder = argv[3];
  std::atomic<int> measured = 0;
  const welkin::BakeResult stopped = welkin::bakeFile(options, [&](const welkin::BakeProgress& progress) {
    return std::strcmp(progress.stage, "certificate") != 0 || ++measured < 50;
  });
  if (stopped.exit_status != 130 || stopped.error.empty() || !stopped.report.empty() || measured < 50)
    return fail("a bake that is stopped midway", stopped);
  for (const char* name : {"/sky.welkin", "/sky.json", "/report.json"})
    if (std::ifstream(options.folder + name)) return fail(name, stopped);

  options.folder = argv[2];
  options.target = "unity";
  options.cubemap_error = 0.0;
  std::atomic<bool> ended = false;
  const welkin::BakeResult baked = welkin::bakeFile(options, [&](const welkin::BakeProgress& progress) {
    if (progress.total > 0 && progress.done == progress.total) ended = true;
    return true;
  });
  if (!baked || !ended || baked.report.find("\"certificate\"") == std::string::npos) return fail("a bake", baked);
  if (baked.report.find("\"target\": \"unity\"") == std::string::npos) return fail("the target", baked);
  if (std::ifstream(options.folder + "/cubemaps/")) return fail("cubemaps that were not asked for", baked);

  options.target = "lumen";
  const welkin::BakeResult unknown = welkin::bakeFile(options);
  if (unknown.exit_status != 1 || unknown.error.find("\"lumen\"") == std::string::npos)
    return fail("a target that is none", unknown);
  options.target.clear();
  options.cubemap_error = 7.0;
  const welkin::BakeResult coarse = welkin::bakeFile(options);
  if (coarse.exit_status != 1 || coarse.error.find("cubemap_error") == std::string::npos)
    return fail("a budget of cubemaps above 1", coarse);
  options.cubemap_error.reset();

  options.max_error = -1.0;
  const welkin::BakeResult refused = welkin::bakeFile(options);
  if (refused.exit_status != 1 || refused.error.find("-1") == std::string::npos)
    return fail("a budget below 0", refused);
  std::printf("baked: %zu bytes of report\n", baked.report.size());
  return 0;
}
