// SPDX-License-Identifier: Apache-2.0
// Writes a level as large as in McAuley's talk (GDC 2012): 51 sectors of about 70 probes each, for `welkin bake`.
//   talk_level DIR      writes DIR/level.toml, DIR/town.obj, DIR/town.mtl and DIR/sky.toml
#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "sky/base/atomic_file.h"
#include "town.h"

namespace {

using namespace welkin;

constexpr double kEmpty = 0.68;  // share of empty squares; more houses would give more probes

std::string objText(const geometry::Surfaces& surfaces) {
  std::string text = "mtllib town.mtl\n";
  for (const auto& p : surfaces.position)
    text += fmt::format("v {} {} {}\n", static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]));
  std::optional<std::uint32_t> material;
  for (const auto& t : surfaces.triangle) {
    if (t.material != material) text += fmt::format("usemtl m{}\n", t.material);
    material = t.material;
    text += fmt::format("f {} {} {}\n", t.vertex[0] + 1, t.vertex[1] + 1, t.vertex[2] + 1);
  }
  return text;
}

std::string mtlText(const geometry::Surfaces& surfaces) {
  std::string text;
  for (std::size_t i = 0; i < surfaces.material.size(); ++i) {
    const auto& kd = surfaces.material[i].albedo;
    text += fmt::format("newmtl m{}\nKd {} {} {}\n", i, kd.x, kd.y, kd.z);
  }
  return text;
}

void write(const std::filesystem::path& folder) {
  geometry::Surfaces surfaces;
  // Seven by seven sectors and two more. The ground ends 1 m inside the borders, because a surface on a border belongs
  // to both sectors.
  bench::addTown(surfaces, {1, 447, 1, 447}, 2, kEmpty);
  bench::addTown(surfaces, {1, 127, 447, 511}, 2, kEmpty);
  base::makeFolder(folder);
  base::writeFile(folder / "town.obj", objText(surfaces));
  base::writeFile(folder / "town.mtl", mtlText(surfaces));
  base::writeFile(
      folder / "sky.toml",
      "[sky]\nluminance = \"cie-12\"\n[sun]\nlatitude_deg = 40\nday_of_year = 172\n[bake]\ncubemap_size = 0\n");
  base::writeFile(folder / "level.toml", "[level]\nsky = \"sky.toml\"\n[[geometry]]\nfile = \"town.obj\"\n");
  fmt::print("{} triangles\n", surfaces.triangle.size());
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fputs("usage: talk_level DIR\n", stderr);
    return 1;
  }
  write(argv[1]);
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "talk_level: %s\n", e.what());
  return 1;
}
