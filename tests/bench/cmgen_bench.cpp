// SPDX-License-Identifier: Apache-2.0
// The day's table beside what a user would take instead: Filament's cmgen (Debian: libfilament-tools) on a cubemap of
// the same sky at every key. Both at the same error against a converged reference.
//   cmgen_bench WELKIN
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <stdexcept>

#include "sky/bake/sky_file.h"
#include "sky/base/toml_table.h"
#include "sky/cubemap/cubemap.h"
#include "sky/table/day_table.h"
#include "tests/folder.h"

namespace {

using namespace welkin;

constexpr int kBands = 3;
constexpr int kKeys = 96;
constexpr double kError = 1e-4;  // of c0, for both
const char* const kSky = R"([sky]
luminance = "far-cry-3"
[sun]
latitude_deg = 17
day_of_year = 172
[bake]
bands = 3
keys = 96
cubemap_size = 0
)";

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void runOrThrow(const std::string& command) {
  if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
}

/// The sky's radiance at intensity 1 on a horizontal cross of faces of N texels, float, uncompressed.
void writeCross(const std::string& path, const model::SkyInstant& instant, int size) {
  static const int kPlace[6][2] = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}};
  const auto width = static_cast<std::size_t>(4 * size);
  std::vector<float> rgb(3 * width * 3 * static_cast<std::size_t>(size));
  tbb::parallel_for(0, 6 * size, [&](int row) {
    const int face = row / size;
    for (int column = 0; column < size; ++column) {
      const auto radiance = instant.shape(cubemap::directionOfTexel(cubemap::Layout::vulkan_cube, size, column, row));
      const auto x = static_cast<std::size_t>(kPlace[face][0] * size + column);
      const auto y = static_cast<std::size_t>(kPlace[face][1] * size + row % size);
      for (int c = 0; c < 3; ++c)
        rgb[3 * (y * width + x) + static_cast<std::size_t>(c)] = static_cast<float>(radiance[c]);
    }
  });
  Imf::Header header(4 * size, 3 * size);
  header.compression() = Imf::NO_COMPRESSION;
  Imf::FrameBuffer frame;
  const char* names[3] = {"R", "G", "B"};
  for (std::size_t c = 0; c < 3; ++c) {
    header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
    frame.insert(names[c], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(rgb.data()) + 4 * c, 12, 12 * width));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame);
  file.writePixels(3 * size);
}

/// cmgen's coefficients of the red channel, with our signs: it has the Condon-Shortley phase.
std::vector<double> readCmgen(const std::string& path) {
  std::ifstream file(path);
  std::vector<double> red;
  for (std::string line; std::getline(file, line);) {
    double r, g, b;
    if (std::sscanf(line.c_str(), "(%lf,%lf,%lf)", &r, &g, &b) == 3)
      red.push_back(red.size() % 2 == 1 && red.size() < 9 ? -r : r);
  }
  if (red.size() != 9) throw std::runtime_error("not nine coefficients: " + path);
  return red;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) return std::fputs("cmgen_bench WELKIN\n", stderr), 1;
  const tests::Folder folder;
  const bake::SkyFile file = bake::readSkyFile(folder.write("sky.toml", kSky));
  const auto hours = base::evenHours(kKeys);
  const model::SkyProjector reference(file.sky.luminance, kBands, 1e-12);

  // Welkin, in process on one core and as a whole process.
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  table::DayTable table;
  const auto bake = [&] {
    table = table::bakeDayTable(
        file.sky, kBands, hours, [] { return true; }, kError);
  };
  double in_process = 1e9;
  for (int i = 0; i < 5; ++i) in_process = std::min(in_process, seconds(bake));
  double worst = 0.0;
  const auto channels = static_cast<std::size_t>(table.channels);
  for (std::size_t k = 0; k < hours.size(); ++k) {
    const auto want = reference.projectPolar(model::SkyInstant(file.sky, hours[k])).radiance_sh;
    for (std::size_t i = 0; i < want.size(); ++i)
      worst = std::max(worst, std::abs(table.number[k * table.numbersOfKey() + i * channels] - want[i].x) / want[0].x);
  }
  const std::string bake_command = std::string("'") + argv[1] + "' bake '" + folder / "sky.toml" + "' -o '" +
                                   folder / "out" + "' --progress none --threads 1 2>/dev/null";
  double process = 1e9;
  for (int i = 0; i < 5; ++i) {
    std::filesystem::remove_all(folder / "out");
    process = std::min(process, seconds([&] { runOrThrow(bake_command); }));
  }
  if (!(worst <= kError)) throw std::runtime_error("the table's error is past what it was baked for");
  std::printf("welkin, error %.1e: %.3f ms a key in process, %.0f ms the whole bake of %d keys\n", worst,
              1e3 * in_process / kKeys, 1e3 * process, kKeys);

  // cmgen on every eighth key: the smallest cubemap whose error is no larger.
  for (const int size : {64, 128, 256, 512}) {
    double largest = 0.0;
    double run = 0.0;
    double render = 0.0;
    int runs = 0;
    for (std::size_t k = 0; k < hours.size(); k += 8, ++runs) {
      const model::SkyInstant instant(file.sky, hours[k]);
      render += seconds([&] { writeCross(folder / "cross.exr", instant, size); });
      run += seconds([&] {
        runOrThrow("cmgen -q --sh=3 --sh-window=no --no-mirror -s " + std::to_string(size) + " --sh-output='" +
                   folder / "sh.txt" + "' '" + folder / "cross.exr" + "'");
      });
      const auto got = readCmgen(folder / "sh.txt");
      const auto want = reference.project(instant).radiance_sh;
      for (std::size_t i = 0; i < 9; ++i) largest = std::max(largest, std::abs(got[i] - want[i].x) / want[0].x);
    }
    std::printf("cmgen at 6 x %d^2, error %.1e: %.1f ms a key (and %.1f ms to render and write its cubemap)\n", size,
                largest, 1e3 * run / runs, 1e3 * render / runs);
    if (largest <= kError || size == 512) {
      std::printf("ratio: %.0f a key in process, %.0f as whole processes for the day\n",
                  run / runs / (in_process / kKeys), run / runs * kKeys / process);
      break;
    }
  }
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 2;
}
