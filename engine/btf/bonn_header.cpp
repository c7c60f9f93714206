#include "engine/btf/bonn_header.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "engine/btf/btf_xml.h"

namespace vamp {
namespace {

struct Signature {
  std::string_view text;
  BonnKind kind;
  bool has_rotations, has_extra;
};
// Those that begin alike: the longer one first.
constexpr Signature kSignatures[] = {
    {"!FMF12FCER", BonnKind::fmf, true, true}, {"!FMF06FCR", BonnKind::fmf, true, false},
    {"!FMF06FC", BonnKind::fmf, false, false}, {"!DFMF08FCR", BonnKind::dfmf, true, false},
    {"!PVF06FCR", BonnKind::pvf, true, false}, {"!PVF06FC", BonnKind::pvf, false, false},
    {"!BDIF06R2!", BonnKind::bdi, true, true},
};

constexpr uint32_t kMaxChannels = 1024;
constexpr size_t kNameBytes = 80;
// Angles at the horizon are written as floats a little above pi / 2.
constexpr double kHorizon = std::numbers::pi / 2 + 1e-4;

const Signature* signature_of(std::string_view text) {
  for (const Signature& signature : kSignatures)
    if (text.starts_with(signature.text)) return &signature;
  return nullptr;
}

std::string up_to_zero(std::string_view text) { return std::string(text.substr(0, text.find('\0'))); }

void read_description(Cursor& cursor, BonnHeader& header) {
  const uint64_t start = cursor.at();
  const auto size = cursor.number<uint32_t>("size of the description");
  const uint32_t version = cursor.count("version of the description", 1, 4);
  header.setup = up_to_zero(cursor.text(kNameBytes, "measurement setup"));
  header.sensor = up_to_zero(cursor.text(kNameBytes, "image sensor"));
  header.light = up_to_zero(cursor.text(kNameBytes, "light source"));
  const uint64_t place = cursor.at();
  header.pixels_per_mm = cursor.number<float>("pixels per mm");
  if (!std::isfinite(header.pixels_per_mm) || header.pixels_per_mm < 0)
    cursor.refuse(place, "pixels per mm", "a number from 0", fmt::format("{}", header.pixels_per_mm));
  for (float& scale : header.rgb_scale) scale = cursor.number<float>("RGB scale");
  header.has_cosine = version > 1 && cursor.number<uint32_t>("cosine flag") != 0;
  if (version > 2) {
    const auto bytes = cursor.number<uint32_t>("size of the XML");
    header.xml_place = cursor.at();
    header.xml = cursor.text(bytes, "XML");
  }
  if (version > 3) {
    header.channels.resize(cursor.count("number of channels", 1, kMaxChannels));
    for (std::string& name : header.channels)
      name = up_to_zero(cursor.text(cursor.number<uint32_t>("size of a channel's name"), "channel's name"));
  }
  if (cursor.status() && cursor.at() - start != size)
    cursor.refuse(start, "size of the description", fmt::format("{} bytes", cursor.at() - start), std::to_string(size));
}

dvec3 read_direction(Cursor& cursor, std::string_view what) {
  const uint64_t place = cursor.at();
  const double theta = cursor.number<float>(what), phi = cursor.number<float>(what);
  if (!(theta >= 0 && theta <= kHorizon && std::abs(phi) <= 100))
    cursor.refuse(place, what, "theta from 0 to pi / 2 and an azimuth in radians", fmt::format("{}, {}", theta, phi));
  dvec3 direction = direction_of({theta, phi});
  direction.z = std::max(direction.z, 0.0);
  return direction;
}

void read_sampling(Cursor& cursor, BonnHeader& header) {
  const uint32_t views = cursor.count("number of views", 1, kMaxBtfDirections);
  std::vector<dvec3> view_directions, light_directions;
  std::span<const std::byte> first_list;
  for (uint32_t v = 0; v < views && cursor.status(); ++v) {
    view_directions.push_back(read_direction(cursor, "view"));
    const uint64_t place = cursor.at();
    const uint32_t lights = cursor.count("number of lights", 1, kMaxBtfDirections);
    Cursor ahead = cursor;
    const auto list = cursor.take(lights * 2 * sizeof(float), "lights");
    if (v == 0) {
      first_list = list;
      for (uint32_t l = 0; l < lights && ahead.status(); ++l)
        light_directions.push_back(read_direction(ahead, "light"));
      if (!ahead.status()) cursor = ahead;
    } else if (!std::ranges::equal(first_list, list)) {
      cursor.refuse(place, "lights", "the same lights for every view", fmt::format("others for view {}", v));
    }
  }
  header.views = named_direction_set(std::move(view_directions));
  header.lights = named_direction_set(std::move(light_directions));
}

void write_direction(ByteWriter& writer, const dvec3& direction) {
  const SphericalAngles angles = angles_of(direction);
  writer.number(static_cast<float>(angles.theta));
  writer.number(static_cast<float>(angles.phi));
}

// Beside the XML element a second sign of our own files, so that damage to one does not make a file another's.
constexpr const char* kOurSensor = "Vamp";
constexpr const char* kLogYuv[] = {"log Y", "log U", "log V"};

}  // namespace

bool is_bonn_btf(std::span<const std::byte> bytes) {
  return signature_of({reinterpret_cast<const char*>(bytes.data()), std::min<size_t>(bytes.size(), 16)}) != nullptr;
}

Result<BonnHeader> read_bonn_header(Cursor& cursor) {
  BonnHeader header;
  const auto start = cursor.bytes().first(std::min<size_t>(cursor.bytes().size(), 16));
  const Signature* signature = signature_of({reinterpret_cast<const char*>(start.data()), start.size()});
  if (signature == nullptr)
    return fail(ErrorKind::bad_input, cursor.file(), "byte 0, signature", "a Bonn BTF (!FMF, !DFMF, !PVF or !BDIF)",
                "other bytes");
  header.signature = cursor.text(signature->text.size(), "signature");
  header.kind = signature->kind;
  header.has_rotations = signature->has_rotations;
  header.has_extra = signature->has_extra;
  read_description(cursor, header);
  read_sampling(cursor, header);
  header.width = cursor.count("width", 1, kMaxBtfSide);
  header.height = cursor.count("height", 1, kMaxBtfSide);
  VAMP_CHECK_STATUS(cursor.status());
  return header;
}

bool is_ours(const BonnHeader& header) { return header.sensor == kOurSensor || has_btf_xml(header.xml); }

void write_bonn_header(ByteWriter& writer, BonnHeader& header, size_t further, size_t alignment) {
  size_t names = 0;
  for (const std::string& name : header.channels) names += sizeof(uint32_t) + name.size();
  const size_t lights = header.lights.size() * 2 * sizeof(float);
  const size_t sampling = sizeof(uint32_t) + header.views.size() * (3 * sizeof(float) + lights) + 2 * sizeof(uint32_t);
  size_t description = 2 * sizeof(uint32_t) + 3 * kNameBytes + 4 * sizeof(float) + 3 * sizeof(uint32_t) + names;
  description += header.xml.size();
  const size_t end = writer.size() + header.signature.size() + description + sampling + further;
  const size_t padding = (alignment - end % alignment) % alignment;

  writer.text(header.signature);
  writer.number(static_cast<uint32_t>(description + padding));
  writer.number(uint32_t{4});
  for (const std::string* name : {&header.setup, &header.sensor, &header.light}) writer.text(*name, kNameBytes);
  writer.number(header.pixels_per_mm);
  for (const float scale : header.rgb_scale) writer.number(scale);
  writer.number(uint32_t{header.has_cosine});
  writer.number(static_cast<uint32_t>(header.xml.size() + padding));
  header.xml_place = writer.size();
  writer.text(header.xml + std::string(padding, ' '));
  writer.number(static_cast<uint32_t>(header.channels.size()));
  for (const std::string& name : header.channels) {
    writer.number(static_cast<uint32_t>(name.size()));
    writer.text(name);
  }

  ByteWriter list;
  list.number(static_cast<uint32_t>(header.lights.size()));
  for (const dvec3& light : header.lights.directions) write_direction(list, light);
  writer.number(static_cast<uint32_t>(header.views.size()));
  for (const dvec3& view : header.views.directions) {
    write_direction(writer, view);
    writer.raw(list.bytes());
  }
  writer.number(header.width);
  writer.number(header.height);
}

BtfInfo info_of(const BonnHeader& header) {
  BtfInfo info;
  info.width = header.width;
  info.height = header.height;
  info.views = header.views;
  info.lights = header.lights;
  if (header.pixels_per_mm > 0) info.mm_per_texel = 1 / header.pixels_per_mm;
  if (std::ranges::equal(header.channels, kLogYuv)) info.colour = BtfColour::log_yuv;
  if (read_btf_xml(header.xml, info)) return info;
  for (const std::string* part : {&header.setup, &header.sensor, &header.light})
    if (!part->empty()) info.provenance += (info.provenance.empty() ? "" : "; ") + *part;
  return info;
}

BonnHeader bonn_header_of(const BtfInfo& info, BonnKind kind) {
  BonnHeader header;
  header.kind = kind;
  for (const Signature& signature : kSignatures)
    if (signature.kind == kind) header.signature = signature.text;
  header.setup = info.provenance;
  header.sensor = kOurSensor;
  header.xml = btf_xml(info);
  if (info.mm_per_texel > 0) header.pixels_per_mm = 1 / info.mm_per_texel;
  header.has_cosine = true;
  if (info.colour == BtfColour::log_yuv) header.channels.assign(std::begin(kLogYuv), std::end(kLogYuv));
  header.views = info.views;
  header.lights = info.lights;
  header.width = info.width;
  header.height = info.height;
  return header;
}

}  // namespace vamp
