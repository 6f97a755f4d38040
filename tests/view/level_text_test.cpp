// SPDX-License-Identifier: Apache-2.0
// Edits of level.toml change their entry alone: comments and every other byte stay, whatever the file looks like.
#include "view/level_text.h"

#include <catch2/catch.hpp>
#include <random>
#include <string>

#include "sky/base/error.h"

using namespace welkin;
using namespace welkin::view;

namespace {

const std::string kLevel =
    "# a level\n[level]\nsky = \"sky # not a comment.toml\"\n\n[[geometry]]\nfile = 'a.gltf'  # [probes]\n";

}  // namespace

TEST_CASE("LevelText, ProbesAreAddedWhereTheFileHasThem") {
  const ProbePlace place{1.0, 2.5, -30.0004};
  CHECK(withProbe(kLevel, place) == kLevel + "\n[probes]\nadd = [[1.0, 2.5, -30.0]]\n");
  CHECK(withProbe(kLevel + "[probes] # here\nspacing_m = 4\n", place) ==
        kLevel + "[probes] # here\nadd = [[1.0, 2.5, -30.0]]\nspacing_m = 4\n");
  CHECK(withProbe(kLevel + "[probes]\nadd=[ [0,0,0] ]# end", place) ==
        kLevel + "[probes]\nadd=[ [0,0,0], [1.0, 2.5, -30.0] ]# end");
  CHECK(withProbe(kLevel + "[probes]\nadd = [\n  [0, 1, 2],  # cave\n  [3, 4, 5]  # hut\n]\n", place) ==
        kLevel + "[probes]\nadd = [\n  [0, 1, 2],  # cave\n  [3, 4, 5],  # hut\n  [1.0, 2.5, -30.0]\n]\n");
  CHECK(withProbe(kLevel + "[probes]\nadd = [\n\t[0, 1, 2], # cave\n]\n", place) ==
        kLevel + "[probes]\nadd = [\n\t[0, 1, 2], # cave\n\t[1.0, 2.5, -30.0],\n]\n");
  CHECK(withProbe("probes.spacing_m = 4\n", place) == "probes.spacing_m = 4\nprobes.add = [[1.0, 2.5, -30.0]]\n");
  CHECK(withProbe("[probes]\r\nadd = []\r\n", place) == "[probes]\r\nadd = [[1.0, 2.5, -30.0]]\r\n");
  CHECK_THROWS_AS(withProbe("probes = {spacing_m = 4}\n", place), base::Error);
}

TEST_CASE("LevelText, ProbesAreMovedAndDeleted") {
  const std::string text = "[probes]\nadd = [\n  [0, 1, 2],  # cave\n  [ 3.5 ,4, 5 ]  # hut\n]\nspacing_m = 4 # m\n";
  CHECK(withProbeMoved(text, 1, {7.0, -8.25, 0.0}) ==
        "[probes]\nadd = [\n  [0, 1, 2],  # cave\n  [ 7.0 ,-8.25, 0.0 ]  # hut\n]\nspacing_m = 4 # m\n");
  CHECK(withoutProbe("[probes]\nadd = [[0, 1, 2], [3, 4, 5], [6, 7, 8]]\n", 1) ==
        "[probes]\nadd = [[0, 1, 2], [6, 7, 8]]\n");
  CHECK(withoutProbe("[probes]\nadd = [[0, 1, 2], [3, 4, 5]]\n", 1) == "[probes]\nadd = [[0, 1, 2]]\n");
  CHECK(withoutProbe("[probes]\nadd = [[0, 1, 2]]\n", 0) == "[probes]\nadd = []\n");
  CHECK(withoutProbe("[probes]\nadd = [\n  [0, 1, 2],\n  [3, 4, 5],\n]\n", 0) ==
        "[probes]\nadd = [\n  [3, 4, 5],\n]\n");
  const std::string kept = withoutProbe(text, 1);
  CHECK(kept.find("# hut") != std::string::npos);
  CHECK_THROWS_AS(withoutProbe(text, 2), base::Error);
  CHECK_THROWS_AS(withProbeMoved(kLevel, 0, {}), base::Error);
}

TEST_CASE("LevelText, RoomsAreAddedAndDeleted") {
  const RoomBox box{4.0, 0.0, 4.0, 12.0, 3.0, 9.5};
  const std::string one = withRoom(kLevel, box);
  CHECK(one == kLevel + "\n[[room]]\nbox = [4.0, 0.0, 4.0, 12.0, 3.0, 9.5]\n");
  CHECK(withoutRoom(one, 0) == kLevel + "\n");
  const std::string two =
      "[[room]] # a\nbox = [0, 0, 0, 1, 1, 1]\n# between\n[[room]]\nbox = [2, 0, 0, 3, 1, 1] # b\n\n[transfer]\nrays = "
      "64\n";
  CHECK(withoutRoom(two, 0) == "# a\n# between\n[[room]]\nbox = [2, 0, 0, 3, 1, 1] # b\n\n[transfer]\nrays = 64\n");
  CHECK(withoutRoom(two, 1) == "[[room]] # a\nbox = [0, 0, 0, 1, 1, 1]\n# between\n# b\n\n[transfer]\nrays = 64\n");
  CHECK(handPlacedOf(withRoom(two, box)).rooms.size() == 3);
  CHECK_THROWS_AS(withoutRoom(two, 2), base::Error);
  CHECK_THROWS_AS(withRoom("room = [{box = [0, 0, 0, 1, 1, 1]}]\n", box), base::Error);
}

TEST_CASE("LevelText, RandomFilesAndEditsKeepEveryComment") {
  // A model, a plain list, is edited beside random texts. Comments are counted: none may go.
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const auto one = [&](std::initializer_list<const char*> of) { return std::string(of.begin()[below(of.size())]); };
  const auto metres = [&] { return static_cast<double>(below(20001)) / 10.0 - 1000.0; };
  std::size_t edits = 0;
  for (int file = 0; file < 400; ++file) {
    HandPlaced model;
    const std::string nl = one({"\n", "\n", "\r\n"});
    const auto comment = [&] { return one({"", "", " # [probes] add = [", "# \"quoted", "\t#'''"}); };
    std::string text =
        one({"", "# start"}) + nl + "[level]" + comment() + nl + "sky = \"a]#\\\"b.toml\"" + comment() + nl;
    const bool has_probes = below(3) > 0;
    if (has_probes) {
      text += one({"[probes]", "[ probes ]", "[\"probes\"]"}) + comment() + nl + one({"", "spacing_m = 4\n"});
      if (below(3) > 0) {
        text += one({"add = [", "add=[", "  add =  [ "});
        const bool lines = below(2) == 0;
        const std::size_t count = below(5);
        for (std::size_t i = 0; i < count; ++i) {
          const ProbePlace p{std::round(metres()), std::round(metres()), std::round(metres())};
          model.probes.push_back(p);
          if (lines) text += (i == 0 ? comment() : std::string()) + nl + one({"  ", "\t", ""});
          text += "[" + std::to_string(static_cast<int>(p[0])) + "," + one({"", " "}) +
                  std::to_string(static_cast<int>(p[1])) + ", " + std::to_string(static_cast<int>(p[2])) + "]";
          if (i + 1 < count || below(2) == 0) text += one({",", " ,", ", "});
          if (lines) text += comment();
        }
        text += (lines ? nl : std::string()) + "]" + comment() + nl;
      }
    }
    text += one({"", "[transfer]\nrays = 64\ntext = '''\n[[room]]\n'''\n"});
    const auto comments = [](const std::string& t) { return std::count(t.begin(), t.end(), '#'); };
    const auto hashes = comments(text);
    REQUIRE(handPlacedOf(text) == model);
    for (int i = 0; i < 12; ++i, ++edits) {
      const std::string before = text;
      INFO(before);
      const ProbePlace place{metres(), metres(), metres()};
      switch (below(5)) {
        case 0:
          text = withProbe(text, place);
          model.probes.push_back(place);
          break;
        case 1:
          if (model.probes.empty()) break;
          model.probes[model.probes.size() - 1] = place;
          text = withProbeMoved(text, model.probes.size() - 1, place);
          break;
        case 2: {
          if (model.probes.empty()) break;
          const std::size_t number = below(model.probes.size());
          model.probes.erase(model.probes.begin() + static_cast<std::ptrdiff_t>(number));
          text = withoutProbe(text, number);
          break;
        }
        case 3:
          model.rooms.push_back({place[0], place[1], place[2], place[0] + 1.0, place[1] + 2.0, place[2] + 3.5});
          text = withRoom(text, model.rooms.back());
          break;
        default: {
          if (model.rooms.empty()) break;
          const std::size_t number = below(model.rooms.size());
          model.rooms.erase(model.rooms.begin() + static_cast<std::ptrdiff_t>(number));
          text = withoutRoom(text, number);
        }
      }
      INFO(text);
      const HandPlaced now = handPlacedOf(text);
      REQUIRE(now.probes.size() == model.probes.size());
      REQUIRE(now.rooms.size() == model.rooms.size());
      for (std::size_t p = 0; p < now.probes.size(); ++p)
        for (std::size_t c = 0; c < 3; ++c)
          REQUIRE(now.probes[p][c] == Approx(model.probes[p][c]).margin(6e-4));  // half a millimetre
      REQUIRE(comments(text) == hashes);
    }
  }
  CHECK(edits == 4800);
}
