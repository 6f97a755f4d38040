// SPDX-License-Identifier: Apache-2.0
// Edits of level.toml's text: probes by hand and rooms. All other bytes, comments too, stay as they are.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace welkin::view {

using ProbePlace = std::array<double, 3>;  ///< x y z, metres, in [-1e6, 1e6]
using RoomBox = std::array<double, 6>;     ///< the lowest corner, the highest corner, metres; each below its partner

/// What a level file places by hand.
struct HandPlaced {
  std::vector<ProbePlace> probes;  ///< [probes] add
  std::vector<RoomBox> rooms;      ///< [[room]] box
  friend bool operator==(const HandPlaced&, const HandPlaced&) = default;
};

/// Throws Error(content) for a text that is not TOML; an entry of another form is left out.
HandPlaced handPlacedOf(std::string_view text);

/// The text with one edit. Numbers are rounded to millimetres. Throw Error(content) where there is no such probe or
/// room, and where the file writes them in a way that is not edited here, such as an inline table.
std::string withProbe(const std::string& text, const ProbePlace& place);
std::string withProbeMoved(const std::string& text, std::size_t number, const ProbePlace& place);
std::string withoutProbe(const std::string& text, std::size_t number);
std::string withRoom(const std::string& text, const RoomBox& box);
std::string withoutRoom(const std::string& text, std::size_t number);

}  // namespace welkin::view
