#include "engine/project/job.h"

#include "engine/project/limits.h"
#include "engine/project/project_file.h"
#include "engine/project/schema.h"

namespace vamp {
namespace {

constexpr Schema kSchema{"vamp-job", 1, 0};
constexpr size_t kMaxJobBytes = 64 << 20;

}  // namespace

Result<std::string> job_to_text(const Job& job, const std::filesystem::path& folder) {
  Json json = kSchema.head();
  json["size"] = {job.width, job.height};
  json["samples"] = job.samples;
  if (job.noise_goal > 0) json["noise_goal"] = job.noise_goal;
  json["complete"] = job.complete;
  json["device"] = job.device;
  json["driver"] = job.driver;
  VAMP_TRY(json["project"], project_to_json(job.project, folder, PathUse::job));
  return print_json(json);
}

Result<Job> job_from_text(std::string_view text, const std::filesystem::path& folder, std::string_view file) {
  if (text.size() > kMaxJobBytes)
    return fail(ErrorKind::bad_input, file, kJobKey, "at most 64 MiB", std::to_string(text.size()) + " bytes");
  VAMP_TRY(const Json json, parse_json(text, file));
  const JsonReader reader(json, file);
  VAMP_CHECK_STATUS(kSchema.check(reader, file));
  Job job;
  const JsonReader size = reader.member("size");
  job.width = static_cast<uint32_t>(size.element(0).integer(1, kMaxPictureSide));
  job.height = static_cast<uint32_t>(size.element(1).integer(1, kMaxPictureSide));
  job.samples = static_cast<uint32_t>(reader.member("samples").integer(1, kMaxSamples));
  if (reader.has("noise_goal")) job.noise_goal = static_cast<float>(reader.member("noise_goal").number(0, 1));
  job.complete = reader.member("complete").boolean();
  job.device = reader.member("device").text(256);
  job.driver = reader.member("driver").text(256);
  VAMP_CHECK_STATUS(reader.status());
  VAMP_TRY(job.project, project_from_json(reader.member("project"), folder, file, PathUse::job));
  return job;
}

}  // namespace vamp
