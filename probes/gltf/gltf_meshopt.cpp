// SPDX-License-Identifier: Apache-2.0
#include "probes/gltf/gltf_meshopt.h"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include "sky/base/error.h"
#include "sky/base/message.h"

namespace welkin::gltf {
namespace {

using Json = nlohmann::json;
using Bytes = std::vector<unsigned char>;

constexpr const char* kMeshopt = "EXT_meshopt_compression";

/// The extension's object of one bufferView.
class Packed {
 public:
  Packed(const Json& extension, const std::string& what) : extension_(extension), what_(what) {
    for (const char* key : {"buffer", "byteLength", "byteStride", "count", "mode"})
      if (!extension.contains(key)) refuse(fmt::format("{} is missing", key));
    stride_ = number("byteStride");
    count_ = number("count");
    mode_ = text("mode");
    filter_ = text("filter");
  }

  Bytes unpacked(const GltfBuffers& buffers) const {
    const std::span<const unsigned char> from = source(buffers);
    // No mode packs tighter, so that few bytes cannot ask for much memory.
    constexpr std::size_t kMostPerByte = 1024;
    if (count_ * stride_ > kMostPerByte * from.size())
      refuse(fmt::format("{} elements of {} bytes cannot be packed into {}", count_, stride_, from.size()));
    Bytes bytes(count_ * stride_);
    if (decode(bytes, from) != 0) refuse("its bytes are damaged");
    filter(bytes);
    return bytes;
  }

  bool holdsAttributes() const { return mode_ == "ATTRIBUTES"; }
  std::size_t stride() const { return stride_; }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw base::Error(base::ExitStatus::content, fmt::format("{}: {}: {}", what_, kMeshopt, why));
  }

  std::size_t number(const char* key) const { return extension_.value(key, std::size_t{0}); }
  std::string text(const char* key) const { return extension_.value(key, std::string()); }

  std::span<const unsigned char> source(const GltfBuffers& buffers) const {
    const std::size_t buffer = number("buffer");
    const std::size_t offset = number("byteOffset");
    const std::size_t length = number("byteLength");
    if (buffer >= buffers.size()) refuse(fmt::format("buffer {} is none of the {}", buffer, buffers.size()));
    const Bytes& bytes = buffers[buffer];
    if (offset > bytes.size() || length > bytes.size() - offset)
      refuse(fmt::format("{} bytes from byte {} of a buffer of {}", length, offset, bytes.size()));
    return std::span(bytes).subspan(offset, length);
  }

  int decode(Bytes& into, std::span<const unsigned char> from) const {
    const bool index = stride_ == 2 || stride_ == 4;
    if (mode_ == "ATTRIBUTES" && stride_ % 4 == 0 && stride_ <= 256)
      return meshopt_decodeVertexBuffer(into.data(), count_, stride_, from.data(), from.size());
    if (mode_ == "TRIANGLES" && index && count_ % 3 == 0)
      return meshopt_decodeIndexBuffer(into.data(), count_, stride_, from.data(), from.size());
    if (mode_ == "INDICES" && index)
      return meshopt_decodeIndexSequence(into.data(), count_, stride_, from.data(), from.size());
    refuse(fmt::format("mode = \"{}\" with {} elements of {} bytes is not one that it has", base::shortened(mode_, 20),
                       count_, stride_));
  }

  void filter(Bytes& bytes) const {
    if (filter_.empty() || filter_ == "NONE") return;
    if (mode_ == "ATTRIBUTES" && filter_ == "OCTAHEDRAL" && (stride_ == 4 || stride_ == 8))
      return meshopt_decodeFilterOct(bytes.data(), count_, stride_);
    if (mode_ == "ATTRIBUTES" && filter_ == "QUATERNION" && stride_ == 8)
      return meshopt_decodeFilterQuat(bytes.data(), count_, stride_);
    if (mode_ == "ATTRIBUTES" && filter_ == "EXPONENTIAL" && stride_ % 4 == 0)
      return meshopt_decodeFilterExp(bytes.data(), count_, stride_);
    refuse(fmt::format("filter = \"{}\" for elements of {} bytes is not one that it has", base::shortened(filter_, 20),
                       stride_));
  }

  const Json& extension_;
  std::string what_;
  std::size_t stride_ = 0;
  std::size_t count_ = 0;
  std::string mode_;
  std::string filter_;
};

}  // namespace

void unpackMeshopt(Json& gltf, GltfBuffers& buffers, const std::string& file) {
  const auto views = gltf.find("bufferViews");
  if (views == gltf.end()) return;
  for (std::size_t i = 0; i < views->size(); ++i) {
    Json& view = (*views)[i];
    if (!view.contains("extensions") || !view["extensions"].contains(kMeshopt)) continue;
    const Packed packed(view["extensions"][kMeshopt], fmt::format("{}: bufferViews[{}]", file, i));
    Bytes bytes = packed.unpacked(buffers);
    const std::size_t length = bytes.size();
    Json plain = {{"buffer", buffers.size()}, {"byteLength", length}};
    constexpr std::size_t kLargestStride = 252;  // of glTF
    if (packed.holdsAttributes() && packed.stride() <= kLargestStride) plain["byteStride"] = packed.stride();
    view = std::move(plain);
    gltf["buffers"].push_back({{"byteLength", length}});
    buffers.push_back(std::move(bytes));
  }
}

}  // namespace welkin::gltf
