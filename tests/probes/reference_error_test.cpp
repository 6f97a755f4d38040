// SPDX-License-Identifier: Apache-2.0
// The reference as an estimator: its standard error, order of sums and progress.
#include <tbb/global_control.h>

#include <atomic>
#include <catch2/catch.hpp>

#include "probes/geometry/directions.h"
#include "skies.h"
#include "sky/base/error.h"
#include "tests/probes/closed_forms/closed_forms.h"

namespace welkin::tests {

using f64::Number3;
namespace {

struct Place {
  geometry::Surfaces level = wellOf(4.0, 5.0, 4, {0.6, 0.5, 0.3}, {0.4, 0.6, 0.8});
  model::Sky sky = clearSky(2.0, 0.9);
  geometry::Tracer tracer{level};
  reference::DistantLight distant{sky, 0.0};
  std::vector<reference::LocalLight> lights = {{{1, 1, -2}, {4, 2, 1}}};
  Number3 position{-2.1, 0.8, 1.7};
  Number3 normal = geometry::unit({0.3, 0.5, -0.7});

  reference::ReferenceIrradiance at(const reference::ReferenceSettings& settings,
                                    const base::Progress& progress = {}) const {
    return reference::traceReference(tracer, distant, lights, position, normal, settings, progress);
  }
};

}  // namespace

TEST_CASE("Reference, ItsStandardErrorIsThatOfIndependentSeeds") {
  const Place place;
  constexpr int kSeeds = 400;
  for (const auto of : {&reference::ReferenceIrradiance::sky, &reference::ReferenceIrradiance::sun_bounce,
                        &reference::ReferenceIrradiance::local, &reference::ReferenceIrradiance::total})
    for (const int c : {0, 1, 2}) {
      double sum = 0.0;
      double squares = 0.0;
      double stated = 0.0;
      for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        const reference::Estimate e = place.at({256, 2, seed}).*of;
        sum += e.value[c];
        squares += e.value[c] * e.value[c];
        stated += e.standard_error[c] * e.standard_error[c];
      }
      const double variance = (squares - sum * sum / kSeeds) / (kSeeds - 1);
      // The variance of 400 normal values is known within 7 % (one standard error).
      CHECK(std::sqrt(stated / kSeeds / variance) == Approx(1.0).margin(0.12));
    }
}

TEST_CASE("Reference, MoreSamplesAgreeWithFewer") {
  const Place place;
  const auto few = place.at({4096, 2, 1});
  const auto many = place.at({400000, 2, 2});
  CHECK(few.samples == 4096);
  CHECK(many.samples >= 400000);
  CHECK(many.samples < 405000);
  CHECK(many.total.standard_error.y < 0.2 * few.total.standard_error.y);
  checkEstimate(few.total, many.total.value, 3.0 * many.total.standard_error.y);
  CHECK(place.at({1, 2, 1}).samples == 64);
}

TEST_CASE("Reference, ItsBitsDoNotDependOnTheThreads") {
  const Place place;
  const auto all = place.at({20000, 3, 5});
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto alone = place.at({20000, 3, 5});
  for (const auto of : {&reference::ReferenceIrradiance::sky, &reference::ReferenceIrradiance::sun_bounce,
                        &reference::ReferenceIrradiance::local, &reference::ReferenceIrradiance::total}) {
    CHECK((all.*of).value == (alone.*of).value);
    CHECK((all.*of).standard_error == (alone.*of).standard_error);
  }
  CHECK_FALSE(place.at({20000, 3, 6}).total.value == all.total.value);
}

TEST_CASE("Reference, TellsOfEveryBatchAndStopsWhenAsked") {
  const Place place;
  const reference::ReferenceSettings settings{300000, 1, 1};
  using base::Progress;
  const Progress progress([](const Progress::Stage&, Progress::Event) { return true; });
  place.at(settings, progress);
  CHECK(progress.done() == reference::referenceBatches(settings));
  CHECK(progress.done() == 74);
  try {
    place.at(settings, Progress([](const Progress::Stage&, Progress::Event) { return false; }));
    FAIL("went on");
  } catch (const base::Error& e) {
    CHECK(e.status() == base::ExitStatus::interrupted);
  }
}

}  // namespace welkin::tests
