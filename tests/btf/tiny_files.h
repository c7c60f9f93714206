#pragma once
// The smallest sound file of each measured format, for tests that damage it: 2 x 2 texels, 2 views, 3 lights where the
// format has a choice. Each is written into a folder of its own.
#include <filesystem>

#include "engine/btf/factored_btf.h"

namespace vamp::test {

BtfInfo tiny_info();
FactoredBtf tiny_factors(bool decorrelated, ColourModel model, int scalar_bytes);

void write_tiny_bdi(const std::filesystem::path& folder);           // a.btf
void write_tiny_dfmf(const std::filesystem::path& folder);          // a.btf
void write_tiny_fmf(const std::filesystem::path& folder);           // a.btf
void write_tiny_foreign_bdi(const std::filesystem::path& folder);   // a.btf
void write_tiny_foreign_dfmf(const std::filesystem::path& folder);  // a.btf
void write_tiny_pictures(const std::filesystem::path& folder);      // tl000_pl000_tv000_pv000.png and five more
void write_tiny_lights(const std::filesystem::path& folder);        // a.lp
void write_tiny_map(const std::filesystem::path& folder);           // a.ptm, LRGB
void write_tiny_rgb_map(const std::filesystem::path& folder);       // a.ptm, RGB
void write_tiny_alta(const std::filesystem::path& folder);          // a.dat
// Channel U of "cloth01": 400 x 400 texels, as the format will have it. Atom a of patch p is row 3 + a of the first
// dictionary, row p % 10 of the second, light p % 151, view 150 - p % 151; dictionaries are unit vectors.
void write_tiny_sparse(const std::filesystem::path& folder);

}  // namespace vamp::test
