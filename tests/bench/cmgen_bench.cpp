// SPDX-License-Identifier: Apache-2.0
// The day's table beside the tool that a user would take instead: Filament's cmgen (Debian: libfilament-tools) on a
// cubemap of the same sky at every key. Both have the same error against a converged reference. Without cmgen the
// table's error is measured all the same.
//   cmgen_bench WELKIN [RUNS]      RUNS of each bake, of which the fastest counts: 5 when left out
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
constexpr double kError = 1e-4;  // over c0, for both
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

/// The sky's radiance at intensity 1 on a horizontal cross whose faces have N texels a side; float, uncompressed.
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

/// cmgen's coefficients of the red channel, with our signs, because cmgen has the Condon-Shortley phase.
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
  if (argc < 2 || argc > 3) return std::fputs("cmgen_bench WELKIN [RUNS]\n", stderr), 1;
  const int runs = argc > 2 ? std::max(1, std::atoi(argv[2])) : 5;
  const tests::Folder folder;
  const bake::SkyFile file = bake::readSkyFile(folder.write("sky.toml", kSky));
  const auto hours = base::evenHours(kKeys);
  const model::SkyProjector reference(file.sky.luminance, kBands, 1e-12);

  // Welkin, in process on one core and as a whole process.
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  table::DayTable table;
  const auto bake = [&] { table = table::bakeDayTable(file.sky, kBands, hours, {}, kError); };
  double in_process = 1e9;
  for (int i = 0; i < runs; ++i) in_process = std::min(in_process, seconds(bake));
  double worst = 0.0;
  const auto channels = static_cast<std::size_t>(table.channels);
  for (std::size_t k = 0; k < hours.size(); ++k) {
    const auto want = reference.projectPolar(model::SkyInstant(file.sky, hours[k])).radiance_sh;
    for (std::size_t i = 0; i < want.size(); ++i)
      worst = std::max(worst, std::abs(table.number[k * table.numbersOfKey() + i * channels] - want[i].x) / want[0].x);
  }
  if (!(worst <= kError)) throw std::runtime_error("the table's error is past what it was baked for");
  const auto wholeBake = [&](const std::string& certificate) {
    double fastest = 1e9;
    for (int i = 0; i < runs; ++i) {
      std::filesystem::remove_all(folder / "out");
      fastest = std::min(fastest, seconds([&] {
                           runOrThrow(std::string("'") + argv[1] + "' bake '" + folder / "sky.toml" + "' -o '" +
                                      folder / "out" + "' --certify " + certificate +
                                      " --progress none --threads 1 2>/dev/null");
                         }));
    }
    return fastest;
  };
  const double certified = wholeBake("fast");
  const double process = wholeBake("none");
  std::printf("welkin, error %.1e: %.3f ms a key in process; the whole bake of %d keys %.0f ms, %.0f ms certified\n",
              worst, 1e3 * in_process / kKeys, kKeys, 1e3 * process, 1e3 * certified);
  if (std::system("command -v cmgen >/dev/null") != 0) {
    std::puts("cmgen is not installed (Debian: libfilament-tools): nothing to compare with");
    return 0;
  }

  // cmgen on every eighth key: the smallest cubemap whose error is no larger.
  for (const int size : {64, 128, 256, 512}) {
    double largest = 0.0;
    double run = 0.0;
    double render = 0.0;
    int cubes = 0;
    for (std::size_t k = 0; k < hours.size(); k += 8, ++cubes) {
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
                largest, 1e3 * run / cubes, 1e3 * render / cubes);
    if (largest <= kError || size == 512) {
      std::printf("ratio: %.0f a key in process; as whole processes for the day %.0f, %.0f certified\n",
                  run / cubes / (in_process / kKeys), run / cubes * kKeys / process, run / cubes * kKeys / certified);
      break;
    }
  }
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 2;
}
