// SPDX-License-Identifier: Apache-2.0
#include "command/certificate_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "sky/bake/bake_settings.h"
#include "sky/base/message.h"

namespace welkin::command {

using Json = nlohmann::ordered_json;

std::string certificateText(const Json& c) {
  const auto percent = [](const Json& value) { return fmt::format("{:.3g} %", 100.0 * value.get<double>()); };
  const auto& n = c["normal"];
  std::string text = fmt::format(
      "irradiance within {} (at {:.2f} h, normal {:.3f},{:.3f},{:.3f}, {}), mean {}; quadrature {}, truncation {}, "
      "time {}, encoding {}",
      percent(c["max_error"]), c["time_h"].get<double>(), n[0].get<double>(), n[1].get<double>(), n[2].get<double>(),
      c["channel"].get<std::string>(), percent(c["mean_error"]), percent(c["parts"]["quadrature"]),
      percent(c["parts"]["truncation"]), percent(c["parts"]["time"]), percent(c["parts"]["encoding"]));
  if (c.contains("cubemaps"))
    text += fmt::format("; cubemaps within {} (at {:.2f} h)", percent(c["cubemaps"]["max_error"]),
                        c["cubemaps"]["time_h"].get<double>());
  return text;
}

std::string surfacesText(const Json& surfaces) {
  const auto rms = [](const Json& error) { return 100.0 * error["rms"].get<double>(); };
  const Json& s = surfaces["surface"];
  return fmt::format(
      "surfaces within {:.0f} +- {:.0f} % rms of the open sky (sky {:.0f}, bounced sun and moon {:.0f}; without any "
      "light {:.0f}), the air {:.0f} +- {:.0f} %; {:.1f} % of the surface has no probe",
      rms(s["total"]), 100.0 * s["total"]["interval"].get<double>(), rms(s["sky"]), rms(s["sun_bounce"]),
      rms(s["nothing"]), rms(surfaces["air"]["total"]), 100.0 * surfaces["air"]["total"]["interval"].get<double>(),
      100.0 * s["without"].get<double>());
}

std::string remedyText(const Json& report) {
  constexpr double kBad = 0.1;          // of the irradiance: the budget "draft"
  constexpr double kBadCubemaps = 0.3;  // a reflection that is plainly another sky's
  const Json& certificate = report["certificate"];
  std::string text;
  if (!report["table"].contains("max_error") && certificate["max_error"].get<double>() > kBad)
    text += fmt::format("; [bake] with max_error = {} and else \"auto\" keeps {:g} %", bake::kDefaultQuality.max_error,
                        100.0 * bake::kDefaultQuality.max_error);
  if (!report["cubemaps"].contains("predicted_error") && certificate.contains("cubemaps") &&
      certificate["cubemaps"]["max_error"].get<double>() > kBadCubemaps)
    text += "; --cubemaps 0.1 plans them for 10 %, --cubemaps none leaves them out";
  return text;
}

void printCertificates(const Json& report) {
  const auto print = [](const std::string& name, const Json& sky) {
    if (sky.contains("certificate"))
      std::fputs(fmt::format("welkin: {}{}{}\n", name, certificateText(sky["certificate"]), remedyText(sky)).c_str(),
                 stderr);
  };
  if (!report.contains("skies")) return print("", report);
  for (const auto& [name, sky] : report["skies"].items()) print(base::oneLine(name) + ": ", sky);
  if (!report.contains("blends")) return;
  const Json& worst = report["blends"];
  std::fputs(fmt::format("welkin: blends within {:.3g} % ({} and {}, weight {:g}, at {:.2f} h)\n",
                         100.0 * worst["max_error"].get<double>(), base::oneLine(worst["skies"][0].get<std::string>()),
                         base::oneLine(worst["skies"][1].get<std::string>()), worst["weight"].get<double>(),
                         worst["time_h"].get<double>())
                 .c_str(),
             stderr);
}

void printWarning(const std::string& message) {
  std::fputs(fmt::format("welkin: warning: {}\n", base::oneLine(message)).c_str(), stderr);
}

void printWarnings(const Json& list, const std::vector<std::string>& told) {
  for (const auto& warning : list) {
    const auto message = warning["message"].get<std::string>();
    if (std::find(told.begin(), told.end(), message) == told.end()) printWarning(message);
  }
}

}  // namespace welkin::command
