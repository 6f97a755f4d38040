// SPDX-License-Identifier: Apache-2.0
// Settings of the viewer are read as they were written, and nothing damages them for good.
#include "view/settings.h"

#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/folder.h"
#include "view/user_folder.h"

using namespace welkin;
using namespace welkin::tests;
using view::Settings;

TEST_CASE("Settings, AreReadAsTheyWereWritten") {
  const Folder folder;
  CHECK(view::readSettings(folder.path()) == Settings{});
  const Settings settings{1920, 1080, -2.5, true, 64, 2};
  const std::filesystem::path deep = folder.path() / "a" / "b";
  view::writeSettings(deep, settings);
  CHECK(view::readSettings(deep) == settings);
  view::writeSettings({}, settings);
  CHECK(view::readSettings({}) == Settings{});
}

TEST_CASE("Settings, WhatIsNoneOrOutOfRangeIsTheDefault") {
  const Folder folder;
  for (const char* text : {"", "{", "[]", "{\"width\": \"x\", \"bounds\": 3}", "{\"width\": 1e9, \"truth_paths\": -1}",
                           "{\"exposure\": null, \"pixel_paths\": 0}", "\xff\xfe"}) {
    INFO(text);
    folder.write("view.json", text);
    CHECK(view::readSettings(folder.path()) == Settings{});
  }
  folder.write("view.json", "{\"width\": 800, \"height\": 1e9}");
  CHECK(view::readSettings(folder.path()).width == 800);
  CHECK(view::readSettings(folder.path()).height == Settings{}.height);
}

TEST_CASE("UserFolder, FollowsXdgAndIgnoresRelativePaths") {
  setenv("HOME", "/home/someone", 1);
  for (const char* variable : {"XDG_CACHE_HOME", "XDG_CONFIG_HOME"}) unsetenv(variable);
  CHECK(view::cacheFolder() == "/home/someone/.cache/welkin");
  CHECK(view::configFolder() == "/home/someone/.config/welkin");
  setenv("XDG_CACHE_HOME", "relative", 1);
  CHECK(view::cacheFolder() == "/home/someone/.cache/welkin");
  setenv("XDG_CACHE_HOME", "/var/tmp", 1);
  CHECK(view::cacheFolder() == "/var/tmp/welkin");
  unsetenv("HOME");
  CHECK(view::configFolder().empty());
}
