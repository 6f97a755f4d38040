// SPDX-License-Identifier: Apache-2.0
// welkin init: writes a commented starting sky and the images that it names.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "command/commands.h"
#include "command/paint.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

namespace welkin::command {
namespace {

constexpr const char* kSky =
    R"(# A sky over one day. Every key is optional but [sun]'s latitude_deg and day_of_year (or its path).
[sky]
luminance  = "far-cry-3"          # or "cie-1" .. "cie-15", "cie-overcast", or [a, b, c, d, e]
normalise  = "sun"                # intensity is the radiance in the sun's direction; "zenith": at the zenith
intensity  = [[4.5, 0.004], [5.3, 0.08], [6.5, 0.8], [9.0, 1.9], [12.0, 2.0], [15.5, 1.9], [18.0, 0.8], [18.9, 0.08], [20.0, 0.004]]
# With normalise = "zenith" use instead, since the zenith does not darken by itself as the sun sinks:
# intensity = [[4.5, 0.0004], [5.5, 0.01], [7.0, 0.1], [12.0, 0.3], [17.5, 0.1], [18.9, 0.01], [20.0, 0.0004]]
gradient_sun  = "gradient_sun.png"     # colour towards the sun: time of day to the right, horizon at the bottom
gradient_anti = "gradient_anti.png"    # and away from it
polarising_tint    = [1.0, 1.0, 1.0]   # on the dome and the cubemaps only
ambient_saturation = 1.0               # on the ambient light only
ground_albedo      = [0.1, 0.1, 0.1]   # radiance below the horizon

[sun]
latitude_deg  = 17.0
longitude_deg = 0.0
year          = 2012
day_of_year   = 172
illuminance = [[5.4, 0.0], [6.5, 1.2], [9.0, 2.7], [12.0, 3.0], [15.5, 2.7], [18.0, 1.2], [18.8, 0.0]]
colour      = [[5.4, [1.0, 0.45, 0.2]], [7.0, [1.0, 0.8, 0.6]], [9.0, [1.0, 0.95, 0.9]], [16.0, [1.0, 0.95, 0.9]], [18.0, [1.0, 0.7, 0.45]], [18.8, [1.0, 0.4, 0.15]]]

[moon]
path = [[0.0, 180.0, 62.0], [6.0, 268.0, -4.0], [12.0, 0.0, -60.0], [18.5, 92.0, -2.0]]   # time_h, azimuth_deg, elevation_deg
illuminance = [[4.0, 0.012], [5.0, 0.0], [19.5, 0.0], [20.5, 0.012]]
colour = [0.75, 0.85, 1.0]

[stars]
image = "stars.png"      # turns with the day; an equirectangular map, the celestial north pole on top
intensity = 0.01         # radiance of its white; a brighter sky hides the stars

[bake]
max_error = 0.03         # 3 %, as --quality preview: the largest error of the ambient light; the bake chooses each "auto"
bands = "auto"           # 2, 3, 4 or 5 bands of spherical harmonics: 4, 9, 16 or 25 coefficients
keys = "auto"            # or a number of keys spread over the day, or a list of hours
cubemap_error = "auto"   # the largest error of the cubemaps; "auto": max_error, or the least within 64 MB
cubemap_size = "auto"    # texels along a face; 0: no cubemaps
cubemap_times = "auto"   # a number spread over the day, or a list of hours
cubemap_format = "auto"  # "rgba16f", or "rgb9e5", "b10g11r11": half the bytes, coarser
gradient_format = "auto" # "rgb32f", or "rgb9e5": a third of the bytes, coarser
reconstruction = "auto"  # "projected", "fitted" coefficients, or "modes" of the day's irradiance, which need a budget
encoding = "auto"        # of the day's table: "float32", "float16", "fixed16" or "fixed8"
window = "off"           # "mildest": no negative irradiance from coefficients, at the price of a larger error
)";

void init(const std::filesystem::path& folder) {
  for (const char* name : {"sky.toml", "gradient_sun.png", "gradient_anti.png", "stars.png"}) {
    std::error_code error;
    if (std::filesystem::exists(folder / name, error))
      throw base::Error(base::ExitStatus::file,
                        fmt::format("{}: exists already; init does not overwrite", (folder / name).string()));
  }
  base::makeFolder(folder);
  writeStartingGradient(GradientSide::sun, folder / "gradient_sun.png");
  writeStartingGradient(GradientSide::anti, folder / "gradient_anti.png");
  writeStartingStars(folder / "stars.png");
  base::writeFile(folder / "sky.toml", kSky);
  fmt::print("{}\n", (folder / "sky.toml").string());
}

}  // namespace

void addInit(CLI::App& app) {
  auto folder = std::make_shared<std::string>();
  auto* command = app.add_subcommand("init", "Write a commented starting sky");
  command->add_option("DIR", *folder, "Folder; made when missing")->required();
  command->callback([folder] { init(*folder); });
}

}  // namespace welkin::command
