#pragma once
// What the machinery makes of other laboratories' measurements (VAMP_TEST_DATA; docs/btf.md says what they are).
#include <filesystem>

#include "bench/report.h"

namespace vamp {

class Progress;

// The whole of `vamp bench measured`; `data` holds btf-ubo2014-chroma, rti-icon and brdf-raw. bad_input where one of
// them is missing; interrupted when `progress` was cancelled.
Result<Report> bench_measured(const std::filesystem::path& data, Progress& progress);

// Its parts, each a table.
// Two cloths of UBO2014 whose luminance is not public: signed logarithms of chroma, 48 x 48 texels of each. Written as
// DFMF and read back, then through clusters, truncated SVD and the residual's terms.
Status measure_chroma(const std::filesystem::path& folder, Report& report, Progress& progress);
// 72 photographs of an icon: functions and a polynomial texture map made from 54 of them predict the other 18.
Status measure_photographs(const std::filesystem::path& list, Report& report, Progress& progress);
// A retro-reflective tape as a material of one texel.
Status measure_tape(const std::filesystem::path& file, Report& report, Progress& progress);

}  // namespace vamp
