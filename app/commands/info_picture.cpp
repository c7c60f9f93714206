// Pictures, and what they were made of.
#include "app/commands/info.h"
#include "engine/image/load.h"
#include "engine/image/metadata.h"
#include "engine/project/job.h"

namespace vamp {
namespace {

constexpr const char* kFormatNames[] = {"PNG", "JPEG", "OpenEXR", "Radiance HDR"};  // by ImageFormat

// The head of a job. The files that it names are not opened: they may lie on another machine.
Result<Json> job_info(const std::string& text, const std::string& file) {
  VAMP_TRY(const Json job, parse_json(text, file));
  Json json;
  for (const char* key : {"size", "samples", "complete", "device", "driver"})
    if (job.contains(key)) json[key] = job[key];
  return json;
}

}  // namespace

Result<Json> picture_info(const fs::path& path) {
  const std::string file = path.string();
  VAMP_TRY(const auto bytes, read_file(path, ImageLimits{}.bytes));
  VAMP_TRY(const ImageInfo info, image_info(bytes, file));
  VAMP_TRY(const Metadata metadata, read_metadata(bytes, file));
  Json json;
  json["file"] = file;
  json["kind"] = "picture";
  json["format"] = kFormatNames[static_cast<int>(info.format)];
  json["width"] = info.width;
  json["height"] = info.height;
  json["channels"] = info.channels;
  json["bits"] = info.bits;
  json["job"] = Json();
  if (const auto job = metadata.find(std::string(kJobKey)); job != metadata.end()) {
    VAMP_TRY(json["job"], job_info(job->second, file));
  }
  return json;
}

}  // namespace vamp
