// SPDX-License-Identifier: Apache-2.0
// Two bakes, one of which replaces the other, and checks that the result is whole.
#pragma once

#include "run_tool.h"

namespace welkin::tests {

/// The folder `out` holds the bake of an old sky. A bake of a new sky replaces it. The two share no equal file, and
/// each has a cubemap that the other lacks.
class TwoBakes {
 public:
  /// `place` is the parent of `out`; if empty, this object's own folder.
  explicit TwoBakes(int cubemap_size, std::filesystem::path place = {});

  std::filesystem::path out() const { return place_ / "out"; }
  std::string file(const std::string& name) const { return folder_ / name; }
  /// The command line that bakes a sky, "old" or "new", into `out`; its make rule is `out.d`.
  std::vector<std::string> command(const std::string& sky) const;
  /// Makes `out` the old bake, or leaves it absent.
  void putOld();
  void putNothing();

  /// Requires every file of `out` to be the old or the new one. No file that the sky there needs may be missing. After
  /// putOld() only stale cubemaps may be missing. If report.json fits the files, all must be of one bake. *.tmp files
  /// and a lock are allowed only with `may_have_temporaries`.
  void requireWhole(bool may_have_temporaries = false) const;
  /// Requires `out` to be one of the bakes, "old" or "new", and nothing else.
  void requireIs(const std::string& sky) const;

 private:
  bool is(const std::string& sky, const std::string& name) const;
  bool isAll(const std::string& sky) const;

  Folder folder_;
  std::filesystem::path place_;
  bool had_old_ = false;
};

/// A fault of the disk simulated by tests/cli/failing_disk.c.
struct DiskFault {
  std::string fault, call, log;
};
Setting on(const DiskFault& disk);

}  // namespace welkin::tests
