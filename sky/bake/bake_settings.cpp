// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/bake_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sky/base/error.h"
#include "sky/cubemap/cubemap.h"

namespace welkin::bake {
namespace {

/// Returns the enumerator of a word, or `otherwise` for "auto".
template <typename T, typename Values = std::initializer_list<T>>
T valueOfWord(base::Section& section, const std::string& key, const Values& values, T otherwise) {
  const std::string word = section.word(key);
  for (const T value : values)
    if (word == nameOf(value)) return value;
  return otherwise;
}

/// Times become file names, so they must be a millisecond apart.
void checkCubemapTimes(base::TomlTable& table, const std::vector<double>& time_h) {
  for (std::size_t i = 1; i < time_h.size(); ++i)
    if (cubemap::millisecondOf(time_h[i]) == cubemap::millisecondOf(time_h[i - 1]))
      table.refuse(
          "cubemap_times", table.node("cubemap_times"),
          fmt::format("the times {} and {} must be a millisecond apart: they name files", time_h[i - 1], time_h[i]));
}

}  // namespace

double errorOf(const std::string& quality) {
  for (const Quality& q : kQualities)
    if (quality == q.name) return q.max_error;
  throw base::Error(base::ExitStatus::usage, fmt::format("quality: \"{}\" is not draft, preview or final", quality));
}

void setTarget(BakeSettings& bake, const std::string& name) {
  for (const Target& target : kTargets)
    if (name == target.name) {
      bake.target = target;
      return;
    }
  throw base::Error(
      base::ExitStatus::usage,
      fmt::format("target: \"{}\" is not modes, sh2, sh3, filament, three, unity, unreal or godot", name));
}

void setCubemapError(BakeSettings& bake, double cubemap_error) {
  bake.fixed.cubemaps = cubemap_error == 0.0;
  bake.cubemap_error = cubemap_error > 0.0 ? std::optional(cubemap_error) : std::nullopt;
  if (cubemap_error > 0.0) return;
  bake.cubemap_size = 0;
  bake.cubemap_time_h.clear();
}

BakeSettings readBake(base::Section section) {
  using format::CubemapFormat;
  base::TomlTable& table = section.table();
  BakeSettings bake;
  if (table.has("max_error")) bake.max_error = section.number("max_error", std::nullopt);
  if (section.isFixed("cubemap_error")) bake.cubemap_error = section.number("cubemap_error", std::nullopt);
  bake.fixed = {
      section.isFixed("bands"),
      section.isFixed("keys"),
      section.isFixed("cubemap_size") || section.isFixed("cubemap_times") || section.isFixed("cubemap_format"),
      section.isFixed("gradient_format"),
      section.isFixed("reconstruction"),
      section.isFixed("encoding")};
  const auto& fixed = bake.fixed;
  const bool states_nothing = !(fixed.bands || fixed.keys || fixed.cubemaps || fixed.gradients ||
                                fixed.reconstruction || fixed.encoding || section.word("window") != "off");
  if (!bake.max_error && states_nothing) bake.max_error = kDefaultQuality.max_error;
  bake.bands = section.wholeNumberIfAny("bands").value_or(bake.bands);
  bake.key_time_h = section.hours("keys", kAutoKeys);
  bake.cubemap_size = section.wholeNumberIfAny("cubemap_size").value_or(bake.cubemap_size);
  if (bake.cubemap_size == 1)
    table.refuse("cubemap_size", table.node("cubemap_size"),
                 fmt::format("must be 0 (none) or 2 to {}", section.rangeOf("cubemap_size").high));
  bake.cubemap_time_h = section.hours("cubemap_times", static_cast<int>(*section.numberWithout("cubemap_times")));
  checkCubemapTimes(table, bake.cubemap_time_h);
  if (bake.cubemap_size == 0) bake.cubemap_time_h.clear();
  bake.cubemap_format =
      valueOfWord(section, "cubemap_format", {CubemapFormat::rgba16f, CubemapFormat::rgb9e5, CubemapFormat::b10g11r11},
                  bake.cubemap_format);
  bake.gradient_format =
      section.word("gradient_format") == "rgb9e5" ? model::GradientFormat::rgb9e5 : model::GradientFormat::rgb32f;
  bake.reconstruction =
      valueOfWord(section, "reconstruction",
                  {table::Reconstruction::projected, table::Reconstruction::fitted, table::Reconstruction::modes},
                  bake.reconstruction);
  setTarget(bake, section.word("target"));
  bake.encoding = valueOfWord(section, "encoding", format::kEncodings, bake.encoding);
  bake.mildest_window = section.word("window") == "mildest";
  const double bytes =
      static_cast<double>(format::bytesOfCubemaps(bake.cubemap_format, static_cast<std::uint64_t>(bake.cubemap_size),
                                                  bake.cubemap_time_h.size())) +
      12.0 * bake.bands * bake.bands * static_cast<double>(bake.key_time_h.size());
  if (bytes > 1.5e9)
    table.refuse(
        "cubemap_size", table.node("cubemap_size"),
        fmt::format("with {} cubemaps of {} and {} keys the file would have {:.0f} bytes; at most 1.5e9 are allowed",
                    bake.cubemap_time_h.size(), bake.cubemap_size, bake.key_time_h.size(), bytes));
  table.finish();
  return bake;
}

}  // namespace welkin::bake
