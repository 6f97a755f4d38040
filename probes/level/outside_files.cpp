// SPDX-License-Identifier: Apache-2.0
#include "probes/level/outside_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace welkin::level {
namespace {

namespace fs = std::filesystem;

/// The path with its links followed, as far as it exists.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? fs::absolute(path).lexically_normal() : whole;
}

}  // namespace

std::vector<fs::path> filesOutside(const fs::path& folder, const std::vector<fs::path>& files) {
  std::vector<fs::path> outside;
  if (folder.empty()) return outside;
  const fs::path inside = resolved(folder);
  for (const fs::path& file : files) {
    const fs::path below = resolved(file).lexically_relative(inside);
    if ((below.empty() || *below.begin() == "..") && std::find(outside.begin(), outside.end(), file) == outside.end())
      outside.push_back(file);
  }
  return outside;
}

std::string outsideText(const std::vector<fs::path>& files) {
  constexpr std::size_t kNamed = 3;
  std::string names;
  for (std::size_t i = 0; i < std::min(files.size(), kNamed); ++i) names += (i > 0 ? ", " : "") + files[i].string();
  if (files.size() > kNamed) names += fmt::format(" and {} more", files.size() - kNamed);
  return "outside of the level's folder: " + names;
}

void requireInside(const fs::path& folder, const std::vector<fs::path>& files) {
  const auto outside = filesOutside(folder, files);
  if (!outside.empty())
    throw base::Error(base::ExitStatus::content,
                      "level.outside_files = \"refuse\": the level reads files " + outsideText(outside));
}

void throwWithoutBytes(const base::Error& error, const fs::path& path, const fs::path& folder,
                       const std::vector<fs::path>& files) {
  const auto outside = filesOutside(folder, files);
  if (error.status() != base::ExitStatus::content || outside.empty() ||
      std::string_view(error.what()).starts_with("level.outside_files"))
    throw base::Error(error);
  throw base::Error(error.status(), fmt::format("{}: it, or a file that it names, is wrong; its words are left out, as "
                                                "it reads files {}",
                                                path.string(), outsideText(outside)));
}

void leaveOutWords(const fs::path& folder, const std::vector<fs::path>& files, std::vector<std::string>& warnings,
                   std::size_t first) {
  for (const fs::path& file : filesOutside(folder, files)) {
    const std::string start = file.string() + ": not read: ";
    for (std::size_t i = first; i < warnings.size(); ++i)
      if (warnings[i].starts_with(start))
        warnings[i] = start + "keywords that are left out here, as the file is outside of the level's folder";
  }
}

}  // namespace welkin::level
