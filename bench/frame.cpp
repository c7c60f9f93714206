#include "bench/frame.h"

#include <fmt/format.h>

#include "bench/ready_rays.h"
#include "bench/sample_cost.h"
#include "bench/scene.h"
#include "engine/gpu/device.h"

namespace vamp {

Result<Report> bench_frame(gpu::Device& device, Project project, const FrameBench& options) {
  VAMP_CHECK_STATUS(keep_one_light(project));

  const EmbreeScene embree(project.scene->positions, project.scene->triangles, EmbreeScene::Edges::fast);
  const ReadyRays rays = draw_rays(embree, project, options.side, 1);
  VAMP_TRY(const auto cost, SampleCost::make(device, std::move(project), options.side, options.side));
  Series primary, shadow, ambient;
  const Series &single = cost->single, &batch = cost->batch;
  for (int round = 0; round < options.rounds; ++round) {
    primary.add(embree_time(embree, RayQuestion::nearest, rays.primary));
    shadow.add(embree_time(embree, RayQuestion::any, rays.shadow));
    ambient.add(embree_time(embree, RayQuestion::any, rays.ambient));
    VAMP_CHECK_STATUS(cost->round());
  }

  const double all = primary.cpu() + shadow.cpu() + ambient.cpu();
  const double reused = primary.cpu() / SAMPLES_PER_HIT + shadow.cpu() + ambient.cpu();
  Report report(options.name, fmt::format("{}, {} x {}, medians of {} rounds, {}.", options.scene_words, options.side,
                                          options.side, options.rounds, device.info().name));
  report.table({"", "a sample", "of Embree's time"});
  const auto peer = [&](const char* name, const Series& series, size_t count) {
    report.row({std::string("Embree, ") + name, series.text(),
                fmt::format("{:.1f} Mrays/s", static_cast<double>(count) / series.cpu() * 1e-3)});
    report.data()["embree"][name] = series.json();
  };
  peer("primary", primary, rays.primary.size());
  peer("shadow", shadow, rays.shadow.size());
  peer("ambient", ambient, rays.ambient.size());
  report.row({"a single sample with a primary ray of its own", single.text(),
              fmt::format("{:.2f} of the same rays", single.cpu() / all)});
  report.row(
      {"four samples a primary ray, four a dispatch", batch.text(),
       fmt::format("{:.2f} of tracing every ray, {:.2f} of the same rays", batch.cpu() / all, batch.cpu() / reused)});
  report.data()["single"] = single.json();
  report.data()["single"]["of_embree"] = single.cpu() / all;
  report.data()["batch"] = batch.json();
  report.data()["batch"]["of_embree"] = batch.cpu() / all;
  report.data()["batch"]["of_embree_same_rays"] = batch.cpu() / reused;
  return report;
}

}  // namespace vamp
