// SPDX-License-Identifier: Apache-2.0
#include "format/check_parts.h"
#include "format/domain_check.h"

namespace welkin::format {

bool isPlace(std::int32_t x, std::int32_t z) {
  return x >= -kFarthestSector && x <= kFarthestSector && z >= -kFarthestSector && z <= kFarthestSector;
}

Fault levelFaultOf(const File& file) {
  Check check;
  const auto* level = file.level();
  if (!check.that(level != nullptr, "level", "is missing") ||
      !check.that(level->all_sectors() != nullptr, "the hash of all sectors", "is missing"))
    return check.fault;
  check.that(file.settings() != nullptr, "settings", "are missing");
  check.that(level->sun() <= SunTransfer::MAX, "sun", "must be none, sh or directional");
  if (const Rgb* a = level->ground_albedo(); a != nullptr)
    check.that(within(double{a->r()}, 0.0, 1.0) && within(double{a->g()}, 0.0, 1.0) && within(double{a->b()}, 0.0, 1.0),
               "the ground's albedo", "must be in [0, 1]");
  check.that(within(level->sun_bounce_scale(), 0.0, kAny) && within(level->sky_scale(), 0.0, kAny), "scale",
             "has a value out of its domain");
  for (const auto& [path, name] : {std::pair(level->sun_path(), "sun"), std::pair(level->moon_path(), "moon")})
    if (path != nullptr) {
      const char* fault = faultOf(*path);
      check.that(fault == nullptr, name, fault);
    }
  check.that((level->sun_path() != nullptr) == (level->sun() == SunTransfer::directional), "sun",
             "must have a path where its transfer is directional, and only there");
  if (check.fault.what != nullptr || level->sectors() == nullptr) return check.fault;
  if (!check.that(reinterpret_cast<std::uintptr_t>(level->sectors()->Data()) % alignof(SectorEntry) == 0, "the sectors",
                  "are misaligned"))
    return check.fault;
  const SectorEntry* before = nullptr;
  for (const auto* s : *level->sectors()) {
    check.that(isPlace(s->x(), s->z()) && s->probes() <= kMostProbes, "a sector", "has a number out of its domain");
    check.that(before == nullptr || before->x() < s->x() || (before->x() == s->x() && before->z() < s->z()),
               "the sectors", "must ascend");
    before = s;
  }
  return check.fault;
}

}  // namespace welkin::format
