// SPDX-License-Identifier: Apache-2.0
#include "welkin/bake.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <optional>

#include "probes/build/bake_file.h"
#include "sky/base/error.h"
#include "sky/base/failure.h"
#include "sky/base/message.h"
#include "sky/base/progress.h"

namespace welkin {
namespace {

base::Error refused(const char* option, const std::string& value, const char* allowed) {
  return {base::ExitStatus::usage, fmt::format("{}: {} must be {}", option, value, allowed)};
}

build::BakeRequest requestOf(const BakeOptions& options) {
  if (options.file.empty()) throw refused("file", "an empty path", "a sky file or a level file");
  if (options.folder.empty()) throw refused("folder", "an empty path", "the folder of the outputs");
  if (options.threads < 0 || options.threads > 4096)
    throw refused("threads", std::to_string(options.threads), "in 0 to 4096");
  build::BakeRequest request;
  request.file = options.file;
  request.folder = options.folder;
  if (options.max_error != 0.0) request.max_error = options.max_error;
  request.cubemap_error = options.cubemap_error;
  request.max_surface_error = options.max_surface_error;
  request.target = options.target;
  request.certify = options.certificate == BakeCertificate::none   ? bake::Certify::none
                    : options.certificate == BakeCertificate::full ? bake::Certify::full
                                                                   : bake::Certify::fast;
  if (options.shard_count != 0) {
    if (!options.sectors.empty()) throw refused("sectors", options.sectors, "empty beside shards");
    request.shard = build::parseShard(fmt::format("{}/{}", options.shard_index, options.shard_count));
  }
  request.sectors = options.sectors;
  request.force = options.force;
  return request;
}

/// Reports the stages of the whole bake. For a stage within a stage it reports the outer one, and asks whether to go
/// on.
base::Progress progressFor(const BakeCallback& callback) {
  if (!callback) return {};
  return base::Progress([&callback](const base::Progress::Stage& stage, base::Progress::Event) {
    const base::Progress::Stage* shown = &stage;
    while (shown->around() != nullptr && shown->around()->around() != nullptr) shown = shown->around();
    return callback({shown->name().c_str(), shown->done(), shown->total()});
  });
}

}  // namespace

BakeResult bakeFile(const BakeOptions& options, const BakeCallback& progress) noexcept {
  BakeResult result;
  try {
    const build::BakeRequest request = requestOf(options);
    std::optional<tbb::global_control> limit;
    if (options.threads > 0)
      limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options.threads));
    result.report = build::reportText(build::bakeFile(request, progressFor(progress)));
  } catch (const std::exception& e) {
    const base::Error error = base::errorOf(e);
    result.exit_status = static_cast<int>(error.status());
    result.error = base::oneLine(error.what());
  }
  return result;
}

}  // namespace welkin
