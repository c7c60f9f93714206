#include "engine/btf/load_btf.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <fstream>
#include <utility>

#include "engine/btf/bdi.h"
#include "engine/btf/factored_btf.h"
#include "engine/btf/light_list.h"
#include "engine/btf/ptm.h"
#include "engine/btf/sparse_btf.h"
#include "engine/core/jobs.h"

namespace vamp {
namespace {

constexpr uint64_t kMostInMemory = uint64_t{1} << 30;

// Half floats whose exponent is all ones are infinities and NaN.
bool is_finite(Half value) { return (value & 0x7c00u) != 0x7c00u; }

// Without a branch a value, so that a compiler can do many at once.
bool all_finite(std::span<const Half> values) {
  unsigned bad = 0;
  for (const Half value : values) bad |= static_cast<unsigned>(!is_finite(value));
  return bad == 0;
}

Result<Btf> load_bdi(const fs::path& path, const LoadBtfOptions& options, Progress* progress) {
  VAMP_TRY(const MemoryMap map, MemoryMap::open(path, MapAccess::read));
  VAMP_TRY(const BdiHeader header, read_bdi_header(map.bytes(), path.string()));
  if (why_not_mapped(header) || !options.output.empty() || options.mm_per_texel) {
    VAMP_TRY(Btf btf, make_btf(info_of(header.bonn), options));
    VAMP_CHECK_STATUS(decode(header, map.bytes(), btf, path.string(), progress));
    return btf;
  }
  VAMP_TRY(Btf btf, Btf::open(path));
  VAMP_CHECK_STATUS(check_finite(btf, path.string(), progress));
  return btf;
}

Result<Btf> load_factored(const fs::path& path, const LoadBtfOptions& options, Progress* progress) {
  VAMP_TRY(const FactoredBtf factored, read_factored_btf(path));
  VAMP_TRY(Btf btf, make_btf(factored.info, options));
  VAMP_CHECK_STATUS(decode(factored, btf, path.string(), progress));
  return btf;
}

Result<Btf> load_images(const ImageSet& images, const LoadBtfOptions& options, Progress* progress) {
  VAMP_TRY(BtfInfo info, info_of(images));
  VAMP_TRY(Btf btf, make_btf(std::move(info), options));
  VAMP_CHECK_STATUS(read_images(images, btf, options.curve, progress));
  return btf;
}

Status check_part(const std::optional<TexelRect>& part, const BtfInfo& info, const fs::path& path) {
  if (!part || part->inside(info)) return {};
  return fail(ErrorKind::bad_input, path.string(), "texels", fmt::format("a part of {} x {}", info.width, info.height),
              fmt::format("{} x {} from ({}, {})", part->width, part->height, part->x, part->y));
}

Result<Btf> load_sparse(const fs::path& path, const LoadBtfOptions& options, Progress* progress) {
  VAMP_TRY(const SparseBtf sparse, read_sparse_btf(path));
  VAMP_CHECK_STATUS(check_part(options.part, sparse.info, path));
  const TexelRect part = options.part.value_or(TexelRect{0, 0, sparse.info.width, sparse.info.height});
  VAMP_TRY(Btf btf, make_btf(info_of(sparse, part), options));
  VAMP_CHECK_STATUS(decode(sparse, part, btf, progress));
  return btf;
}

Result<Btf> copy_part(const Btf& whole, const TexelRect& part, const LoadBtfOptions& options) {
  BtfInfo info = whole.info();
  info.width = part.width;
  info.height = part.height;
  VAMP_TRY(Btf btf, make_btf(std::move(info), options));
  for (uint32_t y = 0; y < part.height; ++y)
    for (uint32_t x = 0; x < part.width; ++x)
      std::ranges::copy(whole.texel(size_t{part.y + y} * whole.info().width + part.x + x),
                        btf.writable_texel(size_t{y} * part.width + x).begin());
  return btf;
}

Result<Btf> load_any(const fs::path& path, BtfFormat format, const LoadBtfOptions& options, Progress* progress) {
  switch (format) {
    case BtfFormat::bdi:
      return load_bdi(path, options, progress);
    case BtfFormat::fmf:
    case BtfFormat::dfmf:
      return load_factored(path, options, progress);
    case BtfFormat::images: {
      VAMP_TRY(const ImageSet images, find_images(path));
      return load_images(images, options, progress);
    }
    case BtfFormat::light_list: {
      VAMP_TRY(const ImageSet images, read_light_list(path));
      return load_images(images, options, progress);
    }
    case BtfFormat::sparse:
      return load_sparse(path, options, progress);
    case BtfFormat::ptm:
      break;
  }
  VAMP_TRY(const Ptm ptm, read_ptm(path));
  VAMP_TRY(Btf btf, make_btf(info_of(ptm, ubo81()), options));
  decode(ptm, btf, options.curve);
  return btf;
}

}  // namespace

std::string name_of(BtfFormat format) {
  switch (format) {
    case BtfFormat::bdi:
      return "Bonn BDI";
    case BtfFormat::fmf:
      return "Bonn FMF";
    case BtfFormat::dfmf:
      return "Bonn DFMF";
    case BtfFormat::images:
      return "folder of pictures";
    case BtfFormat::light_list:
      return "photographs under known lights";
    case BtfFormat::ptm:
      return "polynomial texture map";
    case BtfFormat::sparse:
      return "SparseBTF";
  }
  return {};
}

Result<BtfFormat> btf_format(const fs::path& path) {
  std::error_code code;
  if (fs::is_directory(path, code)) return BtfFormat::images;
  if (!fs::exists(path, code))
    return fail(ErrorKind::bad_input, path.string(), "", "a file or folder", "nothing there");
  std::array<char, 16> first{};
  std::ifstream stream(path, std::ios::binary);
  stream.read(first.data(), first.size());
  const std::string_view start(first.data(), static_cast<size_t>(stream.gcount()));
  if (start.starts_with("!BDIF")) return BtfFormat::bdi;
  if (start.starts_with("!DFMF")) return BtfFormat::dfmf;
  if (start.starts_with("!FMF")) return BtfFormat::fmf;
  if (start.starts_with("PTM_")) return BtfFormat::ptm;
  if (path.extension() == ".lp") return BtfFormat::light_list;
  if (is_sparse_btf_name(path)) return BtfFormat::sparse;
  return fail(ErrorKind::bad_input, path.string(), "byte 0", "a BTF: Bonn .btf, .ptm, .lp or a folder of pictures",
              start.starts_with("!PVF") ? "Bonn PVF, which is not read" : "another kind of file");
}

Result<Btf> make_btf(BtfInfo info, const LoadBtfOptions& options) {
  info.mm_per_texel = options.mm_per_texel.value_or(info.mm_per_texel);
  if (!options.output.empty()) return Btf::create(options.output, std::move(info));
  if (info.texel_count() * info.values_per_texel() * sizeof(Half) < kMostInMemory)
    return Btf::in_memory(std::move(info));
  // The map holds on to the file after its name is gone, and the room is free again whatever becomes of this program.
  static std::atomic<unsigned> counter{0};
  std::error_code code;
  const fs::path path = fs::temp_directory_path(code) / fmt::format("vamp-{}-{}.btf", ::getpid(), counter++);
  VAMP_TRY(Btf btf, Btf::create(path, std::move(info)));
  fs::remove(path, code);
  return btf;
}

Status check_finite(const Btf& btf, std::string_view file, Progress* progress) {
  if (progress != nullptr) progress->stage("Looking through the values");
  for (size_t t = 0; t < btf.texel_count(); ++t) {
    const auto values = btf.texel(t);
    if (!all_finite(values)) {
      const auto bad = std::ranges::find_if_not(values, is_finite);
      const auto direction = static_cast<size_t>(bad - values.begin()) / 3;
      return fail(ErrorKind::bad_input, file, place_of(btf.info(), t, direction), "a finite value", "none");
    }
    btf.forget(t, 1);
    if (progress != nullptr && progress->cancelled()) return JobQueue::cancelled_error();
  }
  return {};
}

Result<Btf> load_btf(const fs::path& path, const LoadBtfOptions& options, Progress* progress) {
  VAMP_TRY(const BtfFormat format, btf_format(path));
  // SparseBTF takes its part itself; of all others it is copied out of the whole.
  const bool copies = options.part && format != BtfFormat::sparse;
  LoadBtfOptions whole = options;
  if (copies) whole.output.clear();
  auto loaded = load_any(path, format, whole, progress);
  if (loaded && copies) {
    VAMP_CHECK_STATUS(check_part(options.part, loaded->info(), path));
    loaded = copy_part(*loaded, *options.part, options);
  }
  // What a failure or the user stopped halfway is not left behind as a whole file.
  std::error_code code;
  if (!loaded && !options.output.empty()) fs::remove(options.output, code);
  return loaded;
}

}  // namespace vamp
