// SPDX-License-Identifier: Apache-2.0
// Bakes a sky or a level in process, for engine editors and build tools. It does the same work as the command `welkin
// bake`. C++17. The library and the program that links it must use the same C++ standard library.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#if defined(__GNUC__)
#define WELKIN_BAKER_API __attribute__((visibility("default")))
#else
#define WELKIN_BAKER_API
#endif

namespace welkin {

/// Measurement of the baked file's error: none, fast, or full, which takes minutes.
enum class BakeCertificate { none, fast, full };

/// A request to bake. The defaults bake the whole file, as `welkin bake FILE -o FOLDER` does.
struct BakeOptions {
  std::string file;        ///< path of a sky.toml or a level.toml
  std::string folder;      ///< folder of the outputs; made if missing
  double max_error = 0.0;  ///< error budget, a fraction as in docs/sky_file.md (draft 0.1, preview 0.03, final 0.01);
                           ///< 0: the budget of the sky file
  BakeCertificate certificate = BakeCertificate::fast;
  int threads = 0;      ///< most threads, in [0, 4096]; 0: one per processor. The outputs do not depend on it.
  int shard_index = 0;  ///< levels only: bakes every shard_count-th sector from this one, in [0, shard_count)
  int shard_count = 0;  ///< levels only; 0: no shards
  std::string sectors;  ///< levels only: bakes these sectors alone, "X_Z,X_Z,..."; empty: all. Excludes shards.
  bool force = false;   ///< also bakes files that are up to date
  std::string target;   ///< reader of the ambient light: "modes", "sh2", "sh3", "filament", "three", "unity", "unreal"
                        ///< or "godot"; budget and certificate are of what it shows. Empty: the target of the sky file.
  /// Error budget of the cubemaps, a fraction in the domain of cubemap_error (docs/sky_file.md), in place of the sky
  /// file's settings of them; 0: no cubemaps. Absent: those settings.
  std::optional<double> cubemap_error;
  /// Error budget of a level on surfaces and in the air, in the domain of max_surface_error (docs/level_file.md), in
  /// place of the level file's. Absent: the level file's.
  std::optional<double> max_surface_error;
};

/// The state of a bake. `stage` is a name for people, such as "plan", "certificate" or "sectors".
struct BakeProgress {
  const char* stage;    ///< valid during the call
  std::uint64_t done;   ///< finished pieces of the stage
  std::uint64_t total;  ///< all pieces of the stage; 0 if unknown
};

/// Called many times a second, from any thread, even from several at once. Returns false to stop the bake. Must not
/// throw.
using BakeCallback = std::function<bool(const BakeProgress&)>;

struct BakeResult {
  int exit_status = 0;  ///< as of the program welkin: 0 done, 1 bad request, 2 file or device, 3 bad content or a
                        ///< budget that cannot be met, 4 internal, 130 stopped
  std::string error;    ///< one message when exit_status is not 0
  std::string report;   ///< the JSON of report.json when exit_status is 0

  explicit operator bool() const { return exit_status == 0; }
};

/// Bakes all outputs that are out of date, and measures them. It blocks until the end. When the callback asks to stop,
/// it returns within a second, except while it reads the level. Every file in the folder is then complete, either old
/// or new. Bakes into different folders may run at once, but they share the limit on threads.
WELKIN_BAKER_API BakeResult bakeFile(const BakeOptions& options, const BakeCallback& progress = {}) noexcept;

}  // namespace welkin
