#pragma once
// Small letters, as far as ASCII goes: names of files and devices are compared without regard to case.
#include <filesystem>
#include <string>
#include <string_view>

namespace vamp {

std::string lower(std::string_view text);

// ".glb" of "Shoe.GLB"; empty where there is none.
std::string lower_extension(const std::filesystem::path& path);

}  // namespace vamp
