// SPDX-License-Identifier: Apache-2.0
// Two bakes of which one is to replace the other, and whether what is there instead is whole.
#pragma once

#include "run_tool.h"

namespace welkin::tests {

/// The folder `out` holds the bake of an old sky; a bake of a new sky shall replace it. No file of the two is the same,
/// and each has a cubemap that the other has not.
class TwoBakes {
 public:
  /// `place`, where `out` is; this object's own folder when empty.
  explicit TwoBakes(int cubemap_size, std::filesystem::path place = {});

  std::filesystem::path out() const { return place_ / "out"; }
  std::string file(const std::string& name) const { return folder_ / name; }
  /// The command line that bakes a sky, "old" or "new", into `out`; its make rule is `out.d`.
  std::vector<std::string> command(const std::string& sky) const;
  /// Makes `out` the old bake; or nothing.
  void putOld();
  void putNothing();

  /// Requires every file of `out` to be the old or the new one, none to be missing that the sky there needs, none at
  /// all after putOld() but stale cubemaps, and all to be of one bake if report.json fits them. *.tmp must not be there
  /// unless they may.
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

/// What a disk of tests/cli/failing_disk.c does.
struct DiskFault {
  std::string fault, call, log;
};
Setting on(const DiskFault& disk);

}  // namespace welkin::tests
