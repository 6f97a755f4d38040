// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/mildest_window.h"

#include "sh/spiral.h"
#include "sh/window.h"

namespace welkin::bake {

double applyMildestWindow(table::DayTable& table) {
  constexpr int kNormals = 642;
  std::vector<det::Number3> normals;
  for (int i = 0; i < kNormals; ++i) {
    const det::Number3 d = sh::onSpiral(1.0 - (2.0 * i + 1.0) / kNormals, i);
    normals.push_back({d.z, d.x, d.y});
  }
  const auto channels = static_cast<std::size_t>(table.channels);
  const auto count = static_cast<std::size_t>(table.bands * table.bands);
  std::vector<double> sets;  // the frame's pole as the basis' own: a rotation changes no irradiance
  for (std::size_t key = 0; key < table.key_time_h.size(); ++key)
    for (std::size_t c = 0; c < channels; ++c) {
      std::vector<double> set(count);
      for (int l = 0; l < table.bands; ++l)
        for (int m = 0; m <= l; ++m)
          set[static_cast<std::size_t>(sh::indexOf(l, m))] =
              table.number[key * table.numbersOfKey() + model::polarIndex(l, m) * channels + c];
      sets.insert(sets.end(), set.begin(), set.end());
    }
  const sh::Window window = sh::mildestWindow(sets, table.bands, normals);
  for (std::size_t key = 0; key < table.key_time_h.size(); ++key)
    for (int l = 0; l < table.bands; ++l)
      for (int m = 0; m <= l; ++m)
        for (std::size_t c = 0; c < channels; ++c)
          table.number[key * table.numbersOfKey() + model::polarIndex(l, m) * channels + c] *=
              window.factor[static_cast<std::size_t>(l)];
  return window.strength;
}

}  // namespace welkin::bake
