// SPDX-License-Identifier: Apache-2.0
// Bakes a sky or a level in process, for engine editors and build tools: the same work as the command `welkin bake`.
// C++17. The library and the program that links it must use the same C++ standard library.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#if defined(__GNUC__)
#define WELKIN_BAKER_API __attribute__((visibility("default")))
#else
#define WELKIN_BAKER_API
#endif

namespace welkin {

/// How a bake measures the error of its own file. `full` takes minutes.
enum class BakeCertificate { none, fast, full };

/// A request. Defaults bake the whole file as `welkin bake FILE -o FOLDER` does.
struct BakeOptions {
  std::string file;        ///< path of a sky.toml or a level.toml
  std::string folder;      ///< folder of the outputs; made when missing
  double max_error = 0.0;  ///< budget, a fraction as in docs/sky_file.md (draft 0.1, preview 0.03, final 0.01); 0: the
                           ///< sky file's own, or none
  BakeCertificate certificate = BakeCertificate::fast;
  int threads = 0;      ///< most threads, in [0, 4096]; 0: one a processor. The outputs do not depend on it.
  int shard_index = 0;  ///< of a level: bakes every shard_count-th sector from this one, in [0, shard_count)
  int shard_count = 0;  ///< 0: no shards
  std::string sectors;  ///< of a level: these sectors alone, "X_Z,X_Z,..."; empty: all. Excludes shards.
  bool force = false;   ///< bakes files that are up to date, too
};

/// The state of a bake. `stage` is a name for people, such as "plan", "certificate" or "sectors".
struct BakeProgress {
  const char* stage;    ///< valid during the call
  std::uint64_t done;   ///< finished pieces of the stage
  std::uint64_t total;  ///< all pieces of the stage; 0 where nobody knows
};

/// Called from any thread, by several at once, many times a second. Returns false to stop the bake. Must not throw.
using BakeCallback = std::function<bool(const BakeProgress&)>;

struct BakeResult {
  int exit_status = 0;  ///< as of `welkin`: 0 done, 1 request, 2 file or device, 3 content, or a budget that cannot be
                        ///< met, 4 internal, 130 stopped
  std::string error;    ///< one message when exit_status is not 0
  std::string report;   ///< the report as JSON when exit_status is 0, as in report.json

  explicit operator bool() const { return exit_status == 0; }
};

/// Bakes all outputs that are out of date, and measures them. It blocks until the end; when the callback asks to stop
/// it returns within a second, but for the time of reading the level. Every file in the folder is the old or the new
/// one, whole. Bakes into different folders may run at once, but they share the limit of threads.
WELKIN_BAKER_API BakeResult bakeFile(const BakeOptions& options, const BakeCallback& progress = {}) noexcept;

}  // namespace welkin
