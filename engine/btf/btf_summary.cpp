#include "engine/btf/btf_summary.h"

#include <utility>

#include "engine/btf/bdi.h"
#include "engine/btf/factored_btf.h"
#include "engine/btf/light_list.h"
#include "engine/btf/ptm.h"
#include "engine/btf/sparse_btf.h"

namespace vamp {
namespace {

uint64_t size_of(const fs::path& path) {
  std::error_code code;
  const auto size = fs::file_size(path, code);
  return code ? 0 : size;
}

Status describe_bdi(const fs::path& path, BtfSummary& summary) {
  VAMP_TRY(const MemoryMap map, MemoryMap::open(path, MapAccess::read));
  VAMP_TRY(const BdiHeader header, read_bdi_header(map.bytes(), path.string()));
  summary.info = info_of(header.bonn);
  summary.channels = header.bonn.channels;
  summary.colour = summary.channels.size() == 3 ? "RGB" : "spectral";
  summary.has_cosine = header.bonn.has_cosine;
  summary.rotation_count = header.rotation_count;
  summary.mapped = !why_not_mapped(header);
  return {};
}

Status describe_factored(const fs::path& path, BtfSummary& summary) {
  VAMP_TRY(const FactoredBtf btf, read_factored_btf(path));
  summary.info = btf.info;
  summary.colour = name_of(btf.colour.model);
  summary.channels = btf.channels;
  for (const Factors& factors : btf.factors) summary.components.push_back(factors.components);
  summary.has_cosine = btf.has_cosine;
  summary.rotation_count = btf.rotation_count;
  return {};
}

Status describe_images(const ImageSet& images, BtfSummary& summary) {
  VAMP_TRY(summary.info, info_of(images));
  summary.colour = "display codes of JPEG and PNG, linear light of OpenEXR and HDR";
  summary.bytes = 0;
  for (const fs::path& file : images.files) summary.bytes += size_of(file);
  return {};
}

Status describe_ptm(const fs::path& path, BtfSummary& summary) {
  VAMP_TRY(const Ptm ptm, read_ptm(path));
  summary.info = info_of(ptm, ubo81());
  summary.info.name = path.stem().string();
  summary.colour =
      ptm.has_luminance ? "display codes: luminance polynomial times colour" : "display codes: RGB polynomials";
  return {};
}

Status describe_sparse(const fs::path& path, BtfSummary& summary) {
  VAMP_TRY(const SparseBtf sparse, read_sparse_btf(path));
  summary.info = sparse.info;
  summary.channels.clear();
  for (size_t c = 0; c < 3; ++c)
    if (sparse.channels[c]) summary.channels.emplace_back(1, "YUV"[c]);
  return {};
}

Status describe(const fs::path& path, BtfSummary& summary) {
  switch (summary.format) {
    case BtfFormat::bdi:
      return describe_bdi(path, summary);
    case BtfFormat::fmf:
    case BtfFormat::dfmf:
      return describe_factored(path, summary);
    case BtfFormat::images: {
      VAMP_TRY(const ImageSet images, find_images(path));
      return describe_images(images, summary);
    }
    case BtfFormat::light_list: {
      VAMP_TRY(const ImageSet images, read_light_list(path));
      return describe_images(images, summary);
    }
    case BtfFormat::ptm:
      return describe_ptm(path, summary);
    case BtfFormat::sparse:
      return describe_sparse(path, summary);
  }
  return {};
}

}  // namespace

Result<BtfSummary> summary_of(const fs::path& path) {
  BtfSummary summary;
  VAMP_TRY(summary.format, btf_format(path));
  summary.channels = {"R", "G", "B"};
  summary.bytes = size_of(path);
  VAMP_CHECK_STATUS(describe(path, summary));
  if (summary.info.colour == BtfColour::log_yuv) summary.colour = "Y, U, V of the logarithm";
  summary.decoded_bytes = uint64_t{summary.info.texel_count()} * summary.info.values_per_texel() * sizeof(Half);
  return summary;
}

}  // namespace vamp
