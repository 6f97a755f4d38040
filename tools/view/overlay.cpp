// SPDX-License-Identifier: Apache-2.0
#include "view/overlay.h"

#include <imgui.h>

#include <cmath>

#include "probes/geometry/sector_name.h"

namespace welkin::view {
namespace {

using f64::Number3;

constexpr ImU32 kPoint = IM_COL32(255, 255, 60, 255);
constexpr ImU32 kLighting = IM_COL32(80, 255, 110, 220);
constexpr ImU32 kWalled = IM_COL32(255, 80, 60, 220);
constexpr ImU32 kOther = IM_COL32(190, 190, 190, 130);
constexpr ImU32 kHand = IM_COL32(90, 220, 255, 230);
constexpr ImU32 kSelected = IM_COL32(255, 120, 255, 255);
constexpr ImU32 kSector = IM_COL32(255, 160, 40, 200);

/// Lines of the world on the picture.
class Lines {
 public:
  explicit Lines(const Session& session)
      : draw_(*ImGui::GetBackgroundDrawList()),
        eye_(session.state().eye),
        size_(static_cast<double>(session.width()), static_cast<double>(session.height()), 0.0) {
    const double yaw = eye_.yaw_deg * f64::kDegree;
    forward_ = f64::directionOf(yaw, eye_.pitch_deg * f64::kDegree);
    right_ = f64::directionOf(yaw + f64::kHalfPi, 0.0);
    up_ = cross(right_, forward_);
    pixels_ = 0.5 * size_.y / std::tan(0.5 * eye_.fov_deg * f64::kDegree);
  }

  void line(const Number3& a, const Number3& b, ImU32 colour, float width) const {
    constexpr double kNear_m = 0.1;
    Number3 from = inView(a), to = inView(b);
    if (from.z < kNear_m && to.z < kNear_m) return;
    if (from.z < kNear_m) from = from + (to - from) * ((kNear_m - from.z) / (to.z - from.z));
    if (to.z < kNear_m) to = to + (from - to) * ((kNear_m - to.z) / (from.z - to.z));
    draw_.AddLine(pixel(from), pixel(to), colour, width);
  }

  void box(const geometry::Box& b, ImU32 colour, float width) const {
    const auto corner = [&](int i) {
      return Number3((i & 1) != 0 ? b.high.x : b.low.x, (i & 2) != 0 ? b.high.y : b.low.y,
                     (i & 4) != 0 ? b.high.z : b.low.z);
    };
    for (int i = 0; i < 8; ++i)
      for (const int axis : {1, 2, 4})
        if ((i & axis) == 0) line(corner(i), corner(i | axis), colour, width);
  }

  void words(const Number3& at, const char* text, ImU32 colour) const {
    const Number3 v = inView(at);
    if (v.z > 0.1) draw_.AddText(pixel(v), colour, text);
  }

 private:
  Number3 inView(const Number3& p) const {
    const Number3 v = p - eye_.position;
    return {dot(v, right_), dot(v, up_), dot(v, forward_)};
  }
  ImVec2 pixel(const Number3& v) const {
    return {static_cast<float>(0.5 * size_.x + pixels_ * v.x / v.z),
            static_cast<float>(0.5 * size_.y - pixels_ * v.y / v.z)};
  }

  ImDrawList& draw_;
  const Eye eye_;
  Number3 size_, forward_{0.0}, right_{0.0}, up_{0.0};
  double pixels_ = 1.0;
};

/// A box a little smaller, so that neighbours' lines do not fall together.
geometry::Box shrunk(const geometry::Box& box) {
  constexpr double kBy_m = 0.06;
  return {box.low + Number3(kBy_m), box.high - Number3(kBy_m)};
}

/// A probe by hand: an octahedron of the size of a probe's sphere.
void drawHand(const Lines& lines, const ProbePlace& place, ImU32 colour, float width) {
  constexpr double kRadius_m = 0.35;
  const Number3 p(place[0], place[1], place[2]);
  const Number3 x(kRadius_m, 0.0, 0.0), y(0.0, kRadius_m, 0.0), z(0.0, 0.0, kRadius_m);
  for (const Number3& pole : {y, -y})
    for (const Number3& side : {x, -x, z, -z}) lines.line(p + pole, p + side, colour, width);
  const Number3 ring[] = {x, z, -x, -z};
  for (std::size_t i = 0; i < 4; ++i) lines.line(p + ring[i], p + ring[(i + 1) % 4], colour, width);
}

void drawEdits(const Lines& lines, const Session& session) {
  const State& s = session.state();
  const HandPlaced& placed = session.edits().placed();
  for (std::size_t i = 0; i < placed.probes.size(); ++i) {
    const bool selected = s.hand == i;
    drawHand(lines, placed.probes[i], selected ? kSelected : kHand, selected ? 2.5F : 1.5F);
  }
  for (const RoomBox& b : placed.rooms) lines.box({{b[0], b[1], b[2]}, {b[3], b[4], b[5]}}, kHand, 1.5F);
  if (!s.corner) return;
  const Number3 c = *s.corner;
  lines.line(c, c + Number3(0.0, 3.0, 0.0), kSelected, 2.0F);
  if (!s.point) return;
  const Number3 other(s.point->position.x, std::min(c.y, s.point->position.y), s.point->position.z);
  const Number3 low(std::min(c.x, other.x), other.y, std::min(c.z, other.z));
  lines.box({low, {std::max(c.x, other.x), other.y + 3.0, std::max(c.z, other.z)}}, kSelected, 1.5F);
}

}  // namespace

void drawOverlay(Session& session) {
  const State& s = session.state();
  if (s.compare && s.compare->beside != Beside::wipe) return;
  const Lines lines(session);
  if (s.bounds)
    for (const sectors::SectorFile& sector : session.level().sectors()) {
      const Number3 low = geometry::cornerOf(sector.id) + Number3(0.0, sector.low_y, 0.0);
      const double height_m = geometry::kCells * sector.cell_height_m;
      lines.box(shrunk({low, low + Number3(geometry::kSector_m, std::min(height_m, 16.0), geometry::kSector_m)}),
                kSector, 1.5F);
      lines.words(low + Number3(2.0, 1.0, 2.0), nameOf(sector.id).c_str(), kSector);
    }
  if (s.edit) drawEdits(lines, session);
  const Answer* a = session.answer();
  if (a == nullptr) return;
  for (std::size_t i = 0; i < a->cell_count; ++i) {
    const CellOfPoint& cell = a->cells[i];
    if (cell.part == "too far") continue;
    const ImU32 colour = cell.share > 0.0 ? kLighting : cell.part == "behind a wall" ? kWalled : kOther;
    lines.box(shrunk(cell.box), colour, cell.share > 0.0 ? 1.5F : 1.0F);
    if (cell.share > 0.0) lines.line(a->point.position, session.level().placeOf(*cell.probe), kLighting, 1.0F);
  }
  constexpr double kCross_m = 0.25;
  for (const Number3& axis : {Number3(kCross_m, 0.0, 0.0), Number3(0.0, kCross_m, 0.0), Number3(0.0, 0.0, kCross_m)})
    lines.line(a->point.position - axis, a->point.position + axis, kPoint, 2.0F);
  lines.line(a->point.position, a->point.position + a->point.normal, kPoint, 2.0F);
}

}  // namespace welkin::view
