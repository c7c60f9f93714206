// Measured BTFs from one format to another.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <numeric>

#include "app/commands/command.h"
#include "app/commands/info.h"
#include "app/commands/interrupt.h"
#include "app/commands/option_values.h"
#include "engine/btf/factored_btf.h"
#include "engine/btf/load_btf.h"
#include "engine/btf/ptm.h"
#include "engine/btf/sparse_btf.h"

namespace vamp {
namespace {

struct Options {
  std::string input, output, part, mm_per_texel, curve = "srgb";
  bool factors = false, png = false;
};

Result<TexelRect> part_option(std::string_view text) {
  constexpr uint32_t kMost = 16384;
  const auto numbers = list_option(text);
  if (numbers.size() != 4) return fail(ErrorKind::usage, "", "--part", "x,y,width,height in texels", std::string(text));
  TexelRect part;
  VAMP_TRY(part.x, count_option(numbers[0], "--part", 0, kMost));
  VAMP_TRY(part.y, count_option(numbers[1], "--part", 0, kMost));
  VAMP_TRY(part.width, count_option(numbers[2], "--part", 1, kMost));
  VAMP_TRY(part.height, count_option(numbers[3], "--part", 1, kMost));
  return part;
}

Result<LoadBtfOptions> load_options(const Options& options) {
  constexpr float kSmallest = 1e-6f, kLargest = 1e3f;
  LoadBtfOptions load;
  load.curve = options.curve == "linear"    ? PictureCurve::linear
               : options.curve == "gamma22" ? PictureCurve::gamma22
                                            : PictureCurve::srgb;
  if (!options.part.empty()) {
    VAMP_TRY(load.part, part_option(options.part));
  }
  if (!options.mm_per_texel.empty()) {
    VAMP_TRY(load.mm_per_texel, number_option(options.mm_per_texel, "--mm-per-texel", kSmallest, kLargest));
  }
  return load;
}

// Factors stay factors: nothing is multiplied out and nothing is lost.
Status convert_factors(const fs::path& input, const fs::path& output, const LoadBtfOptions& load) {
  VAMP_TRY(const BtfFormat format, btf_format(input));
  FactoredBtf btf;
  if (format == BtfFormat::sparse) {
    VAMP_TRY(const SparseBtf sparse, read_sparse_btf(input));
    const TexelRect part = load.part.value_or(TexelRect{0, 0, sparse.info.width, sparse.info.height});
    if (!part.inside(sparse.info))
      return fail(ErrorKind::usage, input.string(), "--part",
                  fmt::format("inside {} x {} texels", sparse.info.width, sparse.info.height));
    btf = factored(sparse, part);
  } else if (load.part) {
    return fail(ErrorKind::usage, "", "--factors", "no --part, but for SparseBTF");
  } else {
    VAMP_TRY(btf, read_factored_btf(input));
  }
  if (load.mm_per_texel) btf.info.mm_per_texel = *load.mm_per_texel;
  return write_factored_btf(output, btf);
}

// Written under another name and renamed when it is whole.
Status convert_to_btf(const fs::path& input, const fs::path& output, LoadBtfOptions load, Progress& progress) {
  const fs::path unfinished = output.string() + ".part";
  load.output = unfinished;
  {
    VAMP_TRY(const Btf btf, load_btf(input, load, &progress));
    VAMP_CHECK_STATUS(btf.flush());
  }
  std::error_code code;
  fs::rename(unfinished, output, code);
  if (code) return fail(ErrorKind::io, output.string(), "", "cannot be written: " + code.message());
  return {};
}

Status convert_to_ptm(const fs::path& input, const fs::path& output, const LoadBtfOptions& load, Progress& progress) {
  VAMP_TRY(const Btf btf, load_btf(input, load, &progress));
  if (!btf.info().fixed_view())
    return fail(ErrorKind::bad_input, input.string(), "views", "one, for a polynomial texture map",
                std::to_string(btf.view_count()));
  std::vector<size_t> lights(btf.light_count());
  std::iota(lights.begin(), lights.end(), size_t{0});
  VAMP_TRY(const Ptm ptm, fit_ptm(btf, lights, true, load.curve));
  return write_ptm(output, ptm);
}

Status convert(const Options& options, Progress& progress) {
  const fs::path input = options.input, output = options.output;
  VAMP_TRY(const LoadBtfOptions load, load_options(options));
  std::error_code code;
  if (fs::equivalent(input, output, code))
    return fail(ErrorKind::usage, output.string(), "", "another file than the one that is read");
  const std::string extension = output.extension().string();
  if (options.factors && extension != ".btf") return fail(ErrorKind::usage, "", "--factors", "a .btf to write");
  if (options.factors) return convert_factors(input, output, load);
  if (extension == ".btf") return convert_to_btf(input, output, load, progress);
  if (extension == ".ptm") return convert_to_ptm(input, output, load, progress);
  if (!extension.empty())
    return fail(ErrorKind::usage, output.string(), "", "a .btf, a .ptm or a folder to write", "\"" + extension + "\"");
  VAMP_TRY(const Btf btf, load_btf(input, load, &progress));
  return write_images(btf, output, options.png ? PictureFormat::png : PictureFormat::exr, &progress);
}

}  // namespace

void add_convert(CLI::App& app, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("convert", "Turn a measured BTF into another format");
  verb->add_option("input", options->input, "Bonn .btf, folder of pictures, .lp, .ptm, SparseBTF")
      ->type_name("FILE")
      ->required();
  verb->add_option("output", options->output, ".btf (Bonn BDI), .ptm (of one view), or a folder for OpenEXR pictures")
      ->type_name("OUT")
      ->required();
  verb->add_option("--part", options->part, "Only these texels")->type_name("X,Y,WIDTH,HEIGHT");
  verb->add_option("--mm-per-texel", options->mm_per_texel, "Size of a texel, where the file does not say it")
      ->type_name("MM");
  verb->add_option("--curve", options->curve, "What the codes of JPEG, PNG and .ptm mean")
      ->check(CLI::IsMember({"srgb", "gamma22", "linear"}))
      ->capture_default_str();
  verb->add_flag("--factors", options->factors, "Write a factorised .btf from a factorised one, bit for bit");
  verb->add_flag("--png", options->png, "8-bit PNG instead of OpenEXR pictures");
  verb->add_flag("--json", common.json, "Print what was written as JSON");
  verb->callback([options, &common, &action] {
    action = [options, &common]() -> Status {
      catch_interrupts();
      Progress progress;
      Status status;
      run_with_progress("converting", progress, [&] { status = convert(*options, progress); });
      if (!status && interrupted())
        return fail(ErrorKind::interrupted, options->output, "", "stopped; nothing is left");
      VAMP_CHECK_STATUS(status);
      return print_info(options->output, common.json);
    };
  });
}

}  // namespace vamp
