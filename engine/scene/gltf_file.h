#pragma once
// The container of a glTF model: the JSON and the bytes of its buffers, from .gltf or .glb, before anything is
// believed.
#include <span>
#include <string>
#include <vector>

#include "engine/core/files.h"
#include "engine/core/json.h"

namespace vamp {

class Progress;

inline constexpr uint64_t kMaxModelBytes = uint64_t{1} << 30;  // of each file

struct GltfFile {
  std::string file;  // for messages
  fs::path folder;
  Json json;
  std::vector<std::span<const std::byte>> buffers;  // as long as byteLength says, into `storage`
  std::vector<std::vector<std::byte>> storage;
};

// Checks the container, the version, and that every buffer is there and long enough.
Result<GltfFile> read_gltf_file(const fs::path& path);

// The bytes behind a URI: base64 data, or a file inside the model's folder. Anything else is refused.
Result<std::vector<std::byte>> read_uri(const std::string& uri, const fs::path& folder, std::string_view file,
                                        std::string_view place);

// "my%20shoe.bin" names the file "my shoe.bin". An error where % does not stand before two hexadecimal digits.
Result<std::string> percent_decoded(const std::string& uri, std::string_view file, std::string_view place);

}  // namespace vamp
