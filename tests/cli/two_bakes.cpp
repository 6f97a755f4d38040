// SPDX-License-Identifier: Apache-2.0
#include "two_bakes.h"

#include <xxhash.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <tuple>

#include "sky_text.h"

namespace welkin::tests {
namespace {

namespace fs = std::filesystem;

/// Files that a killed process may leave.
bool isTemporary(const std::string& name) {
  return name.ends_with(".tmp") || name == ".welkin.lock";
}

/// Whether the outputs have the checksums in the report.
bool reportFits(const fs::path& out) {
  const auto report = nlohmann::json::parse(readBytes(out / "report.json"), nullptr, false);
  if (!report.is_object() || report["outputs"].empty()) return false;
  for (const auto& output : report["outputs"]) {
    const std::string bytes = readBytes(out / output["file"].get<std::string>());
    const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
    char text[33];
    std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                  static_cast<unsigned long long>(hash.low64));
    if (output["xxh3_128"] != text) return false;
  }
  return true;
}

}  // namespace

TwoBakes::TwoBakes(int cubemap_size, fs::path place) : place_(place.empty() ? folder_.path() : std::move(place)) {
  for (const auto& [sky, intensity, times] : {std::tuple("old", "1", "[0, 12]"), {"new", "2", "[0, 6]"}}) {
    const std::string file = folder_.write(
        std::string(sky) + "_level/sky.toml",
        skyText(kUniform + "\nintensity = " + intensity, kStillSun,
                "keys = 3\ncubemap_size = " + std::to_string(cubemap_size) + "\ncubemap_times = " + times));
    REQUIRE(runTool({"bake", file, "-o", folder_ / sky, "--certify", "none"}).status == 0);
  }
}

std::vector<std::string> TwoBakes::command(const std::string& sky) const {
  return {"bake",       folder_ / (sky + "_level/sky.toml"),
          "-o",         out(),
          "--progress", "none",
          "--certify",  "none",
          "--depfile",  folder_ / "out.d"};
}

void TwoBakes::putOld() {
  putNothing();
  fs::copy(folder_ / "old", out(), fs::copy_options::recursive);
  had_old_ = true;
}

void TwoBakes::putNothing() {
  fs::remove_all(out());
  fs::remove(folder_ / "out.d");
  had_old_ = false;
}

bool TwoBakes::is(const std::string& sky, const std::string& name) const {
  const fs::path file = folder_.path() / sky / name;
  return fs::exists(file) && fs::exists(out() / name) && readBytes(file) == readBytes(out() / name);
}

void TwoBakes::requireWhole(bool may_have_temporaries) const {
  if (had_old_)
    for (const char* name : {"sky.welkin", "report.json", "timing.json"}) REQUIRE(fs::exists(out() / name));
  if (!fs::exists(out())) return;
  for (const auto& name : filesUnder(out())) {
    INFO(name);
    if (isTemporary(name))
      REQUIRE(may_have_temporaries);
    else if (name == "timing.json")
      REQUIRE(nlohmann::json::accept(readBytes(out() / name)));
    else
      REQUIRE((is("old", name) || is("new", name)));
  }
  const bool replaced = is("new", "sky.welkin");
  if (replaced) REQUIRE(fs::exists(folder_ / "out.d"));
  if (replaced || is("old", "sky.welkin"))
    for (const auto& name : filesUnder(folder_ / (replaced ? "new" : "old"))) {
      INFO(name);
      if (name != "report.json" && name != "timing.json") REQUIRE(fs::exists(out() / name));
    }
  // A mixture must not look like a bake. The report lists every output, so it must fit one of the two or nothing.
  if (reportFits(out())) REQUIRE((isAll("old") || isAll("new")));
}

bool TwoBakes::isAll(const std::string& sky) const {
  for (const auto& name : filesUnder(folder_ / sky))
    if (name != "timing.json" && !is(sky, name)) return false;
  return true;
}

void TwoBakes::requireIs(const std::string& sky) const {
  REQUIRE(filesUnder(out()) == filesUnder(folder_ / sky));
  for (const auto& name : filesUnder(out())) {
    INFO(name);
    if (name != "timing.json") REQUIRE(is(sky, name));
  }
  REQUIRE(reportFits(out()));
}

Setting on(const DiskFault& disk) {
  Setting setting;
  setting.environment = {
      {"LD_PRELOAD", WELKIN_FAILING_DISK}, {"WELKIN_DISK_FAULT", disk.fault}, {"WELKIN_DISK_CALL", disk.call}};
  if (!disk.log.empty()) setting.environment.emplace_back("WELKIN_DISK_LOG", disk.log);
  setting.deadline_s = 60.0;
  return setting;
}

}  // namespace welkin::tests
