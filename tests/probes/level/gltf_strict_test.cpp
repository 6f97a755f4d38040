// SPDX-License-Identifier: Apache-2.0
// glTF whose JSON is deep, doubled or of wrong types is refused before the model is read.
#include <sys/resource.h>

#include <thread>

#include "gltf_level.h"

namespace welkin::tests {
namespace {

std::string withExtras(const std::string& extras) {
  std::string text = squareText([](json&) {});
  text.back() = ',';
  return text + "\"extras\":" + extras + "}";
}

std::string repeated(const std::string& text, std::size_t times) {
  std::string whole;
  for (std::size_t i = 0; i < times; ++i) whole += text;
  return whole;
}

/// Runs the work in a thread with a stack of 256 KiB, as `ulimit -s 256` gives, or a larger one under sanitizers.
void onASmallStack(const std::function<void()>& work) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, std::size_t{WELKIN_SMALL_STACK_KIB} << 10);
  pthread_t thread{};
  const auto run = [](void* what) -> void* {
    (*static_cast<const std::function<void()>*>(what))();
    return nullptr;
  };
  REQUIRE(pthread_create(&thread, &attributes, run, const_cast<std::function<void()>*>(&work)) == 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
}

}  // namespace

TEST_CASE("GltfStrict, DeepJsonIsRefusedOnASmallStack") {
  onASmallStack([] {
    for (const std::size_t depth : {64U, 20000U, 1000000U}) {
      checkRefused(withExtras(repeated("[", depth) + repeated("]", depth)), base::ExitStatus::content,
                   "deeper than 64");
      checkRefused(withExtras(repeated("{\"a\":", depth) + "1" + repeated("}", depth)), base::ExitStatus::content,
                   "deeper than 64");
    }
    CHECK(sceneOf(withExtras(repeated("[", 63) + repeated("]", 63))).draws.size() == 1);
  });
}

TEST_CASE("GltfStrict, NodesMayBe256Deep") {
  const auto chain = [](std::size_t nodes) {
    GltfText gltf;
    gltf.addNode(gltf.addMesh(squareMesh()));
    for (std::size_t i = 1; i < nodes; ++i) {
      gltf.json["nodes"].push_back({{"mesh", 0}, {"translation", {0, 1, 0}}});
      gltf.json["nodes"][i - 1]["children"] = {i};
    }
    return gltf.text();
  };
  onASmallStack([&] {
    CHECK(sceneOf(chain(257)).bounds.high.y == 256.0);
    checkRefused(chain(258), base::ExitStatus::content, "256 nodes deep");
    checkRefused(chain(20000), base::ExitStatus::content, "256 nodes deep");
  });
}

TEST_CASE("GltfStrict, AnotherVersionIsNamedBeforeItsTypes") {
  const auto ofVersion = [](const json& version) {
    return squareText([&](json& gltf) {
      gltf["asset"]["version"] = version;
      gltf["scene"] = "defaultScene";  // as in glTF 1.0
    });
  };
  checkRefused(ofVersion("1.0"), base::ExitStatus::content, "asset.version = \"1.0\": must be 2.0");
  checkRefused(ofVersion("2.0"), base::ExitStatus::content, "scene = \"defaultScene\"");
  checkRefused(ofVersion(2), base::ExitStatus::content, "asset.version = 2: must be a string");
}

TEST_CASE("GltfStrict, AKeyIsThereOnce") {
  const std::string text = squareText([](json&) {});
  checkRefused("{\"scene\":0," + text.substr(1), base::ExitStatus::content, "the key \"scene\" twice");
  CHECK(sceneOf(withExtras("{\"a\":{\"a\":1},\"b\":{\"a\":1}}")).draws.size() == 1);  // of other objects
  checkRefused(withExtras("[{\"a\":1,\"b\":2,\"a\":1}]"), base::ExitStatus::content, "the key \"a\" twice");
}

TEST_CASE("GltfStrict, TypesAndRangesAreChecked") {
  checkWrong([](json& j) { j["accessors"][0]["bufferView"] = 4294967296; },
             "accessors[0].bufferView = 4294967296: must be a whole number of 0 to 2147483647");
  checkWrong([](json& j) { j["accessors"][0]["bufferView"] = -1; }, "accessors[0].bufferView = -1");
  checkWrong([](json& j) { j["bufferViews"][1]["byteOffset"] = -1; }, "bufferViews[1].byteOffset = -1");
  checkWrong([](json& j) { j["bufferViews"][1]["byteLength"] = 1e30; }, "bufferViews[1].byteLength = 1e+30");
  checkWrong([](json& j) { j["accessors"][0]["count"] = 3.5; }, "accessors[0].count = 3.5");
  checkWrong([](json& j) { j["accessors"][0]["normalized"] = 1; },
             "accessors[0].normalized = 1: must be true or false");
  checkWrong([](json& j) { j["accessors"][0].erase("type"); }, "accessors[0].type is missing");
  checkWrong([](json& j) { j["nodes"][0]["scale"] = "10"; }, "nodes[0].scale = \"10\": must be an array of 3 numbers");
  checkWrong([](json& j) { j["nodes"][0]["scale"] = {1, 1}; }, "nodes[0].scale = [1,1]");
  checkWrong([](json& j) { j["nodes"][0]["scale"] = {1, "1", 1}; }, "nodes[0].scale = [1,\"1\",1]");
  checkWrong([](json& j) { j["nodes"][0]["name"] = 5; }, "nodes[0].name = 5: must be a string");
  checkWrong([](json& j) { j["nodes"][0]["mesh"] = "0"; }, "nodes[0].mesh = \"0\"");
  checkWrong([](json& j) { j["nodes"][0]["children"] = 1; }, "nodes[0].children = 1: must be an array of indices");
  checkWrong([](json& j) { j["nodes"] = json::object(); }, "nodes = {}: must be an array of objects");
  checkWrong([](json& j) { j["nodes"][0] = 0; }, "nodes = [0]");
  checkWrong([](json& j) { j["scenes"] = 7; }, "scenes = 7");
  checkWrong([](json& j) { j["scene"] = "0"; }, "scene = \"0\"");
  checkWrong([](json& j) { j["meshes"][0]["primitives"][0]["mode"] = "x"; }, "primitives[0].mode = \"x\"");
  checkWrong([](json& j) { j["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = "0"; }, "an object of indices");
  checkWrong([](json& j) { j["extensionsRequired"] = "KHR_a"; }, "extensionsRequired = \"KHR_a\"");
  checkWrong([](json& j) { j["nodes"][0]["extensions"] = json::array(); }, "nodes[0].extensions = []");
  checkWrong([](json& j) { j["nodes"][0]["extensions"]["KHR_a"] = 1; }, "nodes[0].extensions.KHR_a = 1");
  checkWrong([](json& j) { j["asset"] = "2.0"; }, "asset = \"2.0\"");
  checkWrong(
      [](json& j) {
        j["buffers"] = 1;
        j["images"] = "none";
      },
      "images = \"none\"");
  checkWrong([](json& j) { j["nodes"][0]["matrix"] = {1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; },
             "is projective");
  checkWrong([](json& j) { j["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2}; },
             "is projective");
  checkWrong(
      [](json& j) {
        j["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"}}};
      },
      "extensions.KHR_lights_punctual.lights[0].spot is missing");
  // Whole numbers may be written with a point (JSON has one type of number).
  CHECK(sceneOf(squareText([](json& j) { j["nodes"][0]["mesh"] = 0.0; })).draws.size() == 1);
  std::string text = squareText([](json&) {});
  text.replace(text.find("\"count\":4"), 9, "\"count\":4e999");
  checkRefused(text, base::ExitStatus::content, "not a whole glTF file");
}

TEST_CASE("GltfStrict, DataUrisAreBase64") {
  const auto broken = [](const std::function<void(std::string&)>& change) {
    json j = json::parse(squareText([](json&) {}));
    std::string uri = j["buffers"][0]["uri"];
    change(uri);
    j["buffers"][0]["uri"] = uri;
    return j.dump();
  };
  const std::size_t first = std::string("data:application/octet-stream;base64,").size();
  const auto refused = [&](const std::function<void(std::string&)>& change, const std::string& says) {
    checkRefused(broken(change), base::ExitStatus::content, "buffers[0]: " + says);
  };
  refused([&](std::string& uri) { uri[first + 2] = '*'; }, "character 2 of the base64 in its data URI is \"*\"");
  refused([&](std::string& uri) { uri[first + 3] = '\n'; }, "character 3");
  refused([&](std::string& uri) { uri[first + 3] = '='; }, "character 3");
  refused([](std::string& uri) { uri.resize(uri.size() - 4); }, "is cut");
  refused([](std::string& uri) { uri += "A"; }, "its data URI is cut: base64 has no such length");
  refused([](std::string& uri) { uri = "data:text/plain,abc"; }, "its data URI begins \"data:text/plain,abc\"");
  const auto bounds = sceneOf(broken([](std::string& uri) {
                        while (uri.back() == '=') uri.pop_back();
                        uri.replace(0, uri.find(','), "data:;base64");
                      })).bounds;
  CHECK(bounds.high.x == 1.0);
}

}  // namespace welkin::tests
