// SPDX-License-Identifier: Apache-2.0
// accuracy SKY.toml PAGE.md [STEP_MINUTES]: writes docs/accuracy.md anew. From the root of the sources:
//   build/release/tools/study/accuracy examples/island/sky.toml docs/accuracy.md
#include <fmt/format.h>

#include <cstdlib>
#include <exception>

#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "study/accuracy.h"

namespace {

constexpr double kStep_min = 10.0;  // the sun moves by 2.3 degrees, near the horizon 3
constexpr double kIslandStep_h = 2.5 / 60.0;

int run(const std::string& sky_file, const std::string& page_file, const std::string& step) {
  using namespace welkin;
  const double step_min = step.empty() ? kStep_min : std::atof(step.c_str());
  if (!(step_min >= 0.5 && step_min <= 60.0))
    throw base::Error(base::ExitStatus::usage, fmt::format("STEP_MINUTES: {} is not in 0.5 to 60", step));
  const bake::SkyFile file = bake::readSkyFile(sky_file);
  study::StudyOptions options;
  options.progress = base::Progress([](const base::Progress::Stage& stage, base::Progress::Event event) {
    if (stage.around() == nullptr && event == base::Progress::Event::went_on)
      std::fputs(fmt::format("accuracy: {} of {} skies\n", stage.done(), 2 * model::namedLuminances().size()).c_str(),
                 stderr);
    return true;
  });
  const auto models = study::measureModels(file.sky, step_min / 60.0, options);
  options.progress = {};
  const study::StudyDay day(file.sky, kIslandStep_h, {});
  std::string command = fmt::format("build/release/tools/study/accuracy {} {}", sky_file, page_file);
  if (!step.empty()) command += " " + step;
  const std::string page = accuracyPage(models, study::measureSky(day, options), step_min / 60.0, command);
  base::writeFile(page_file, page);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3 || argc > 4) {
    std::fputs("usage: accuracy SKY.toml PAGE.md [STEP_MINUTES]\n", stderr);
    return 1;
  }
  try {
    return run(argv[1], argv[2], argc > 3 ? argv[3] : "");
  } catch (const welkin::base::Error& e) {
    std::fputs(fmt::format("accuracy: {}\n", e.what()).c_str(), stderr);
    return static_cast<int>(e.status());
  } catch (const std::exception& e) {
    std::fputs(fmt::format("accuracy: {}\n", e.what()).c_str(), stderr);
    return 4;
  }
}
