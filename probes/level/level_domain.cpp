// SPDX-License-Identifier: Apache-2.0
#include "probes/level/level_domain.h"

namespace welkin::level {
namespace {

using base::Kind;
using base::Range;
using base::Required;

constexpr Range kMetres{-1e6, 1e6};
constexpr Range kDegrees{-36000.0, 36000.0};
constexpr Range kFraction{0.0, 1.0};
constexpr Range kScale{1e-6, 1e6};  // positive, because a mirrored level would mirror its sky
constexpr Range kSpacing{0.25, 64.0};
constexpr Range kMultiplier{0.0, 1000.0};
constexpr std::string_view kMetre = "m";

base::Domain rows() {
  return {
      {"level", "sky", "", Kind::file, "", {}, Required{}, "the sky file"},
      {"level",
       "outside_files",
       "",
       Kind::word,
       "",
       {},
       "warn",
       "files that are not below the level file's folder",
       "refused",
       {"warn", "allow", "refuse"}},
      {"[geometry]", "file", "", Kind::file, "", {}, Required{}, ""},
      {"[geometry]", "translation", "", Kind::vector, kMetre, kMetres, 0.0, ""},
      {"[geometry]", "rotation_deg", "", Kind::vector, "degrees", kDegrees, 0.0, "about x, then y, then z"},
      {"[geometry]", "scale", "", Kind::number_or_vector, "", kScale, 1.0, ""},
      {"[geometry]",
       "role",
       "",
       Kind::word,
       "",
       {},
       "static",
       "`vegetation`: its boxes get probes and block as vegetation; `ignore`: neither baked nor drawn",
       "refused",
       {"static", "vegetation", "ignore"}},
      {"[geometry]",
       "vegetation_nodes",
       "",
       Kind::names,
       "",
       {},
       "none",
       "nodes of a static file that are vegetation; `*`: any characters"},
      {"[geometry]",
       "ignore_nodes",
       "",
       Kind::names,
       "",
       {},
       "none",
       "nodes that are left out with all below them; `*`: any characters"},
      {"[geometry]", "albedo", "", Kind::colour, "", kFraction, 0.5, "for surfaces without a material"},
      {"probes", "spacing_m", "", Kind::number, kMetre, kSpacing, 4.0, "distance of the vertical rays of the lattice"},
      {"probes", "vegetation_spacing_m", "", Kind::number, kMetre, kSpacing, 8.0, "the same over vegetation's boxes"},
      {"probes",
       "minimum_separation_m",
       "",
       Kind::number,
       kMetre,
       {0.0, 64.0},
       7.0,
       "least distance of two probes of a sector that see each other"},
      {"probes",
       "height_m",
       "",
       Kind::number,
       kMetre,
       {0.01, 64.0},
       1.0,
       "above the surface; half of the free height where that is less"},
      {"probes", "headroom_m", "", Kind::number, kMetre, {0.01, 64.0}, 1.2, "free height that makes a surface ground"},
      {"probes",
       "clearance_m",
       "",
       Kind::number,
       kMetre,
       {0.001, 64.0},
       0.2,
       "least distance between a probe and any surface"},
      {"probes", "coverage_m", "", Kind::number, kMetre, kSpacing, 8.0,
       "every walkable point sees a probe within this distance"},
      {"probes",
       "walls",
       "",
       Kind::word,
       "",
       {},
       "cut",
       "`cut`: cells are cut along walls, so that no light is filtered through them; `ignore`: thin walls leak",
       "refused",
       {"cut", "ignore"}},
      {"probes", "add", "", Kind::points, kMetre, kMetres, "none", "probes by hand"},
      {"probes", "remove", "", Kind::boxes, kMetre, kMetres, "none", "only probes by hand stand in these boxes"},
      {"[room]", "box", "", Kind::box, kMetre, kMetres, Required{}, "inside and outside have probes of their own"},
      {"transfer",
       "rays",
       "",
       Kind::whole_number,
       "",
       {64.0, 16777216.0},
       1024.0,
       "paths a probe, a multiple of 8; `auto`: as many as the budget of `--max-error` takes",
       "refused",
       {"auto"}},
      {"transfer", "bounces", "", Kind::whole_number, "", {0.0, 16.0}, 2.0, "surfaces that a path may meet"},
      {"transfer",
       "sun",
       "",
       Kind::word,
       "",
       {},
       "directional",
       "bounced sun and moon: along their own paths, by four coefficients as the sky, or not at all",
       "refused",
       {"directional", "sh", "none"}},
      {"transfer",
       "local_lights",
       "",
       Kind::sectors,
       "",
       {},
       "auto",
       "sectors that get transfer for dynamic lights; `auto`: those near point and spot lights of the level",
       "refused",
       {"auto"}},
      {"transfer",
       "reach_m",
       "",
       Kind::number,
       kMetre,
       {1.0, 1e5},
       128.0,
       "range of a probe along x and z; geometry farther off neither blocks nor reflects its light"},
      {"scale", "sun_bounce", "", Kind::number, "", kMultiplier, 1.0, "factor of the bounced light of sun and moon"},
      {"scale", "sky", "", Kind::number, "", kMultiplier, 1.0, "factor of the sky's light, direct and bounced"},
  };
}

}  // namespace

const base::Domain& levelDomain() {
  static const base::Domain kRows = rows();
  return kRows;
}

}  // namespace welkin::level
