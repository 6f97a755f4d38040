// SPDX-License-Identifier: Apache-2.0
#include "command/certificate_text.h"

#include <fmt/format.h>

#include <cstdio>

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
  if (c.contains("cubemaps")) text += fmt::format("; cubemaps within {}", percent(c["cubemaps"]["max_error"]));
  return text;
}

void printWarnings(const Json& list) {
  for (const auto& warning : list)
    std::fputs(fmt::format("welkin: warning: {}\n", base::oneLine(warning["message"].get<std::string>())).c_str(),
               stderr);
}

}  // namespace welkin::command
