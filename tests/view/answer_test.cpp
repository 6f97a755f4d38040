// SPDX-License-Identifier: Apache-2.0
// Verdicts about a point, from its light and the truth.
#include "view/answer.h"

#include <catch2/catch.hpp>

using namespace welkin;
using view::Answer;
using view::Verdict;

namespace {

constexpr double kOpenGround = 2.0;

/// Grey light of probes and truth, the truth all of the sky.
Answer judged(float light, double truth, double noise = 0.0) {
  Answer answer;
  answer.light.emplace();
  answer.light->irradiance = {light, light, light};
  answer.truth.sky = answer.truth.total = {f64::Number3(truth), f64::Number3(noise)};
  view::judge(answer, {}, kOpenGround);
  return answer;
}

}  // namespace

TEST_CASE("Answer, LightInASealedRoomIsALeak") {
  const Answer full = judged(1.0F, 0.0);
  CHECK(full.verdict == Verdict::leak);
  CHECK(full.error == Approx(500.0));  // of the floor, a thousandth of open ground
  CHECK(full.words.find("bright where the truth is dark: ") == 0);
  CHECK(judged(1.0F, 1e-9).verdict == Verdict::leak);
  CHECK(judged(0.0F, 0.0).verdict == Verdict::right);
  CHECK(judged(0.0019F, 0.0).verdict == Verdict::right);
  CHECK(judged(0.0021F, 0.0).verdict == Verdict::leak);
}

TEST_CASE("Answer, ATinyTruthIsNoLeakByItself") {
  CHECK(judged(1e-4F, 1e-5).verdict == Verdict::right);
  CHECK(judged(0.0F, 1e-3).verdict == Verdict::right);
  CHECK(judged(1e-4F, 1e-5).words == "right: dark, as the truth is");
}

TEST_CASE("Answer, ErrorsAreJudgedByTruthAndNoise") {
  CHECK(judged(1.1F, 1.0).verdict == Verdict::right);
  CHECK(judged(1.3F, 1.0).verdict == Verdict::too_bright);
  CHECK(judged(1.3F, 1.0).error == Approx(0.3));
  CHECK(judged(1.3F, 1.0, 0.11).verdict == Verdict::right);  // 3 of the noise
  CHECK(judged(0.7F, 1.0).verdict == Verdict::too_dark);
  CHECK(judged(2.5F, 1.0).verdict == Verdict::leak);
  Answer unlit;
  view::judge(unlit, {}, kOpenGround);
  CHECK(unlit.verdict == Verdict::unlit);
}

TEST_CASE("Answer, TheTruthIsScaledAsTheLightIs") {
  Answer answer;
  answer.light.emplace();
  answer.light->irradiance = {6.5F, 6.5F, 6.5F};
  answer.truth.sky.value = f64::Number3(2.0);
  answer.truth.sun_bounce.value = f64::Number3(1.0);
  answer.truth.local.value = f64::Number3(2.0);
  answer.truth.total.value = f64::Number3(5.0);
  transfer::RelightScale scale;
  scale.sky = 2.0;
  scale.sun_bounce = 0.5;
  view::judge(answer, scale, kOpenGround);
  CHECK(answer.expected.x == 6.5);
  CHECK(answer.verdict == Verdict::right);
  CHECK(answer.error == Approx(0.0).margin(1e-6));  // the luminance of floats
  view::judge(answer, {}, kOpenGround);
  CHECK(answer.expected.x == 5.0);
  CHECK(answer.verdict == Verdict::too_bright);
}
