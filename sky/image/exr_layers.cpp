// SPDX-License-Identifier: Apache-2.0
#include "sky/image/exr_layers.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "sky/base/error.h"

namespace welkin::image {
namespace {

/// The layer's name, or the words for the one without.
std::string shown(const ExrLayer& layer) {
  return layer.name.empty() ? "the one without a name" : "'" + layer.name + "'";
}

std::string listOf(const std::vector<ExrLayer>& layers) {
  std::vector<std::string> names;
  for (const ExrLayer& layer : layers) names.push_back(shown(layer));
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::vector<ExrLayer> exrLayers(const Imf::MultiPartInputFile& file) {
  std::vector<ExrLayer> layers;
  for (int part = 0; part < file.parts(); ++part) {
    const Imf::Header& header = file.header(part);
    std::set<std::string> prefixes;
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
      const std::string name = channel.name();
      prefixes.insert(name.substr(0, name.rfind('.') + 1));  // without a dot npos + 1 is 0
    }
    for (const std::string& prefix : prefixes) {
      const auto has = [&](const char* name) { return header.channels().findChannel(prefix + name) != nullptr; };
      ExrLayer layer{part, prefix, "", ExrColours::rgb};
      if (has("R") && has("G") && has("B"))
        layer.colours = ExrColours::rgb;
      else if (has("Y") && has("RY") == has("BY") && !(has("X") && has("Z")))  // X, Y, Z: places, normals or CIE XYZ
        layer.colours = has("RY") ? ExrColours::chroma : ExrColours::grey;
      else
        continue;
      layer.name = prefix.substr(0, prefix.size() - (prefix.empty() ? 0 : 1));
      if (file.parts() > 1 && header.hasName())
        layer.name = header.name() + (layer.name.empty() ? "" : "." + layer.name);
      layers.push_back(layer);
    }
  }
  return layers;
}

ExrLayer chooseLayer(const std::string& file, const std::vector<ExrLayer>& layers, const std::string& name) {
  const auto refuse = [&](const std::string& why) {
    return base::Error(base::ExitStatus::content, fmt::format("{}: {}", file, why));
  };
  if (layers.empty()) throw refuse("no channels R, G and B in any layer, and no Y that is alone or with RY and BY");
  const auto only = [&](auto&& fits) -> const ExrLayer* {
    const auto found = std::find_if(layers.begin(), layers.end(), fits);
    const bool alone = found != layers.end() && std::none_of(std::next(found), layers.end(), fits);
    return alone ? &*found : nullptr;
  };
  if (!name.empty()) {
    const ExrLayer* layer = only([&](const ExrLayer& l) { return l.name == name; });
    if (layer == nullptr) layer = only([&](const ExrLayer& l) { return l.prefix == name + "."; });
    if (layer == nullptr)
      throw refuse(fmt::format("no layer '{}' with colours, or several; the layers are {}", name, listOf(layers)));
    return *layer;
  }
  const auto plain = [](const ExrLayer& l) { return l.prefix.empty(); };
  if (const auto first = std::find_if(layers.begin(), layers.end(), plain); first != layers.end()) return *first;
  if (layers.size() == 1) return layers[0];
  if (const ExrLayer* combined = only([](const ExrLayer& l) { return l.prefix.ends_with("Combined."); }))
    return *combined;
  throw refuse(fmt::format("several layers with colours and none to prefer: {}", listOf(layers)));
}

std::string leftOutNote(const std::vector<ExrLayer>& layers, const ExrLayer& chosen) {
  std::vector<ExrLayer> others;
  std::copy_if(layers.begin(), layers.end(), std::back_inserter(others),
               [&](const ExrLayer& l) { return l.part != chosen.part || l.prefix != chosen.prefix; });
  if (others.empty()) return {};
  return fmt::format("layer read: {}; layers left out: {}", shown(chosen), listOf(others));
}

}  // namespace welkin::image
