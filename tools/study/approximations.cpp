// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "study/accuracy.h"

namespace welkin::study {
namespace {

/// The largest of a number over the wanted rows.
template <typename Rows, typename Wanted, typename Number>
double largest(const Rows& rows, const Wanted& wanted, const Number& number) {
  double most = 0.0;
  for (const auto& row : rows)
    if (wanted(row)) most = std::max(most, number(row));
  return most;
}

}  // namespace

std::string approximationsTable(const Study& study) {
  Table table({{"approximation"}, {"domain"}, {"largest error"}, {"cost"}, {"slow reference"}, {"test"}});
  const auto add = [&](std::vector<Cell> cells) { table.addRow(std::move(cells)); };
  const auto encoding = [&](table::Encoding e) {
    return largest(
        study.tables.encodings, [&](const EncodingRow& r) { return r.encoding == e; },
        [](const EncodingRow& r) { return r.encoding_error; });
  };
  const auto format = [&](format::CubemapFormat f) {
    return largest(
        study.cubemaps.sizes, [&](const CubemapSizeRow& r) { return r.format == f; },
        [](const CubemapSizeRow& r) { return r.encoding; });
  };
  add({"exp(d theta) of the indicatrix from a table (IndicatrixTable)", "-16 <= d < 0, theta in [0, pi]",
       fmt::format("{:.0e}, absolute", model::IndicatrixTable::kError), "half of exp and atan",
       "det::exp(d det::angleBetween)", "tests/sky/luminance_test.cpp"});
  for (const QuadratureRow& row : study.quadrature.quadrature)
    if (row.tolerance > 1e-12)
      add({fmt::format("SH coefficients under a tolerance of {:.0e} (SkyProjector)", row.tolerance),
           "every model and sun elevation", fmt::format("{:.0e} of c0 promised, {:.0e} here", row.tolerance, row.error),
           fmt::format("{:.0f} evaluations a key", row.evaluations), "the quadrature under 1e-12",
           "tests/sky/projection_test.cpp"});
  if (!study.quadrature.irradiance.empty())
    add({"irradiance of every normal from circles (IrradianceProjector)", "every named model and sun elevation",
         fmt::format("{} of the mean promised, {} here", share(model::IrradianceProjector::kError),
                     share(study.quadrature.irradiance.front().error)),
         "one quadrature for all normals", "SkyProjector::irradiance, one integral a normal",
         "tests/sky/irradiance_test.cpp"});
  for (std::size_t i = 1; i < std::size(model::kIrradianceRules); ++i)
    add({fmt::format("the same in {} panels of elevation, where a plan's budget allows it",
                     model::kIrradianceRules[i].panels),
         "every named model and sun elevation",
         fmt::format("{} of the mean promised", share(model::kIrradianceRules[i].error)),
         fmt::format("down from {} panels", model::kIrradianceRules[0].panels), "48 panels",
         "tests/sky/irradiance_test.cpp"});
  for (const auto& e : format::kEncodingFacts) {
    const std::string bound = e.encoding == table::Encoding::float32 ? "2^-24 of a number"
                              : e.encoding == table::Encoding::float16
                                  ? "2^-11 of a number, 2^-25 of its key's largest"
                                  : fmt::format("1/{} of key's times row's largest", 2 * e.largest_integer);
    add({fmt::format("numbers as {}", nameOf(e.encoding)), "finite tables",
         fmt::format("{}; {} of the irradiance here", bound, share(encoding(e.encoding))),
         fmt::format("{} {} a number", e.bytes, e.bytes == 1 ? "byte" : "bytes"), "the numbers in double",
         "tests/runtime/day_table_test.cpp"});
  }
  for (const MapSize map : {kSmallMap, kMiddleMap, kLargeMap, kLargestMap})
    for (const Candidate& candidate : study.candidates)
      if (candidate.isModes() && candidate.numbers() == 8 && candidate.fit == Fit::projected &&
          candidate.representation.modes->columns == map.columns && candidate.representation.modes->rows == map.rows)
        add({fmt::format("8 modes from a map of {} x {}", map.columns, map.rows), "every normal",
             fmt::format("{} with the modes left out, here", share(candidate.error)),
             inWords(static_cast<double>(candidate.representation.fixedBytes()), Quantity::bytes, 3),
             "the modes' own series", "tests/runtime/modes_test.cpp"});
  for (const auto f : {format::CubemapFormat::rgba16f, format::CubemapFormat::rgb9e5, format::CubemapFormat::b10g11r11})
    add({fmt::format("cubemaps in {}", format::nameOf(f)), "0 to the format's largest value",
         fmt::format("{} of the mean radiance here, root mean square", share(format(f))),
         fmt::format("{} bytes a texel", format::texelBytes(f)), "texels in double",
         "tests/sky/cubemap_format_test.cpp"});
  for (const DomeRow& row : study.cubemaps.dome)
    if (row.error > 0.0)
      add({fmt::format("gradients in {}", nameOf(row.format)), "every gradient",
           fmt::format("2^-9 of a texel's largest; {} of the dome here", share(row.error)), "4 bytes a texel, for 12",
           "gradients as floats", "tests/sky/dome_error_test.cpp"});
  add({"a GPU's filter of the map of modes", "subTexelPrecisionBits b, 8 on common devices",
       "2^-b of the differences to the next column and row, of each mode", "none: it is the hardware's",
       "the same product in double", "tests/runtime/modes_test.cpp"});
  return table.markdown(3);
}

}  // namespace welkin::study
