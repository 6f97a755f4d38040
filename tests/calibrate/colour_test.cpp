// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>

#include "calibrate/colour_difference.h"
#include "calibrate/colour_space.h"
#include "calibrate/reference_chart.h"

using namespace welkin::calibrate;

TEST_CASE("Ciede2000, AgreesWithThePublishedPairs") {
  // Pairs 1 to 4, 7, 9, 11, 13, 16 to 20, 25, 26, 31 and 33 to 35 of table 1 of Sharma, Wu and Dalal (2005). They
  // cross the formula's discontinuities of hue and its dark, grey and blue regions.
  struct Row {
    double l1, a1, b1, l2, a2, b2, difference;
  };
  constexpr Row kPairs[] = {{50, 2.6772, -79.7751, 50, 0, -82.7485, 2.0425},
                            {50, 3.1571, -77.2803, 50, 0, -82.7485, 2.8615},
                            {50, 2.8361, -74.0200, 50, 0, -82.7485, 3.4412},
                            {50, -1.3802, -84.2814, 50, 0, -82.7485, 1.0000},
                            {50, 0, 0, 50, -1, 2, 2.3669},
                            {50, 2.4900, -0.0010, 50, -2.4900, 0.0009, 7.1792},
                            {50, 2.4900, -0.0010, 50, -2.4900, 0.0011, 7.2195},
                            {50, -0.0010, 2.4900, 50, 0.0009, -2.4900, 4.8045},
                            {50, 2.5, 0, 50, 0, -2.5, 4.3065},
                            {50, 2.5, 0, 73, 25, -18, 27.1492},
                            {50, 2.5, 0, 61, -5, 29, 22.8977},
                            {50, 2.5, 0, 56, -27, -3, 31.9030},
                            {50, 2.5, 0, 58, 24, 15, 19.4535},
                            {60.2574, -34.0099, 36.2677, 60.4626, -34.1751, 39.4387, 1.2644},
                            {63.0109, -31.0961, -5.8663, 62.8187, -29.7946, -4.0864, 1.2630},
                            {22.7233, 20.0904, -46.6940, 23.0331, 14.9730, -42.5619, 2.0373},
                            {90.9257, -0.5406, -0.9208, 88.6381, -0.8985, -0.7239, 1.5381},
                            {6.7747, -0.2908, -2.4247, 5.8714, -0.0985, -2.2286, 0.6377},
                            {2.0776, 0.0795, -1.1350, 0.9033, -0.0636, -0.5514, 0.9082}};
  constexpr double kLastDigit = 5.001e-5;
  for (const Row& r : kPairs) {
    const Colour a(r.l1, r.a1, r.b1), b(r.l2, r.a2, r.b2);
    INFO("a pair whose difference is " << r.difference);
    CHECK(std::abs(ciede2000(a, b) - r.difference) <= kLastDigit);
    CHECK(ciede2000(a, b) == Approx(ciede2000(b, a)).margin(1e-12));
    CHECK(ciede2000(a, a) == 0.0);
  }
}

TEST_CASE("DifferenceSummary, IsOfTheSortedDifferences") {
  std::vector<double> ramp;
  for (int i = 20; i >= 1; --i) ramp.push_back(i);
  const DifferenceSummary s = summaryOf(ramp);
  CHECK(s.mean == 10.5);
  CHECK(s.p95 == 19.0);
  CHECK(s.worst == 20.0);
  CHECK(summaryOf({3.0}).p95 == 3.0);
}

TEST_CASE("ColourSpace, ThereAndBack") {
  for (const Colour& rgb :
       {Colour(0.2, 0.5, 0.9), Colour(1.0, 1.0, 1.0), Colour(0.001, 0.0, 0.002), Colour(-0.04, 0.2, 0.4)}) {
    CHECK((rgbOfLab(labOfRgb(rgb)) - rgb).norm() < 1e-12);
    CHECK((rgbOfXyz(xyzOfRgb(rgb)) - rgb).norm() < 1e-12);
    CHECK((xyzOfXyY(xyYOfXyz(xyzOfRgb(rgb))) - xyzOfRgb(rgb)).norm() < 1e-12);
  }
  CHECK((labOfRgb({1.0, 1.0, 1.0}) - Colour(100.0, 0.0, 0.0)).norm() < 1e-9);
  CHECK(xyYOfXyz(Colour::Zero()).allFinite());
}

TEST_CASE("ReferenceChart, PatchesHaveTheLinearColoursOfOpenCV") {
  // Linear sRGB of the edition before 2014 as OpenCV 4.6 tests it (modules/mcc/test/test_ccm.cpp, dst_rgbl), to five
  // digits.
  constexpr double kRounding = 5e-5;  // its white D50 has other last digits
  const ReferenceChart before = referenceChart(Edition::before_2014);
  CHECK((before[0] - Colour(0.17303, 0.08211, 0.05673)).cwiseAbs().maxCoeff() < kRounding);
  CHECK((before[9] - Colour(0.11100, 0.04231, 0.14293)).cwiseAbs().maxCoeff() < kRounding);
  CHECK((before[17] - Colour(-0.03741, 0.24700, 0.40041)).cwiseAbs().maxCoeff() < kRounding);
  CHECK((before[18] - Colour(0.91263, 0.91494, 0.89367)).cwiseAbs().maxCoeff() < kRounding);
  CHECK((before[23] - Colour(0.03032, 0.03114, 0.03275)).cwiseAbs().maxCoeff() < kRounding);
}

TEST_CASE("ReferenceChart, EditionsDifferMostInWhite") {
  // X-Rite's tables: white went from L* 96.539 to 95.19 and b* 1.186 to 2.93; the mean of all differences is 0.85.
  const ReferenceChart before = referenceChart(Edition::before_2014), after = referenceChart(Edition::after_2014);
  std::vector<double> differences;
  for (std::size_t i = 0; i < kPatches; ++i) differences.push_back(ciede2000(labOfRgb(before[i]), labOfRgb(after[i])));
  CHECK(summaryOf(differences).mean == Approx(0.85).margin(0.005));
  CHECK(summaryOf(differences).worst == Approx(differences[18]));
}
