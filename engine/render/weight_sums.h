#pragma once
// Sums of what a picture's samples would add if the weights at hand were larger by one: what pulls a weight in the
// finished picture without shading it again.
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/gpu/buffer.h"
#include "engine/gpu/pipeline.h"
#include "engine/render/gpu_scene.h"
#include "engine/render/weight_span.h"

namespace vamp {

class WeightSums {
 public:
  // What directions are summed in.
  using Memory = std::vector<gpu::TypedBuffer<vec4>>;

  // For a picture of so many pixels, accumulator planes and tiles. As many of the span's directions are kept as
  // `max_bytes` hold, 32 bytes a pixel and plane each, in what fits of `memory` first; throws MachineError when there
  // is no more of it.
  WeightSums(gpu::Device& device, WeightSpan span, uint64_t pixels, uint32_t planes, size_t tiles, uint64_t max_bytes,
             Memory memory);
  // For sums to come: to give back a hundred megabytes takes the machine 7 ms, to get them as long again.
  Memory take_memory() &&;

  // The tables and sums of one direction, in the place of the picture's.
  struct Direction {
    TexelTable<tables::BasisRow> bases;
    TexelTable<tables::ClusterRow> clusters;
    gpu::TypedBuffer<vec4> accumulators;
    gpu::TexelView accumulators_view;
    gpu::DescriptorSet set;
    bool cleared = false;
    std::vector<uint32_t> samples;  // of each tile
    double applied = 0;             // steps that the picture has been pulled along it
  };
  // What is gathered next: a batch of samples of one direction, for tiles that stand at the same number.
  struct Step {
    size_t direction = 0;
    uint32_t base = 0, batch = 0;
    std::vector<size_t> tiles;
    std::vector<uint32_t> pixels;  // of them, that see the group
    uint32_t at = 0;               // so many of them are done
  };

  WeightSpan span;
  std::vector<Direction> directions;
  std::optional<Step> step;
  gpu::TypedBuffer<uint32_t> list;  // pixels of the region
  std::vector<uint32_t> listed;     // what it holds

  // Before a direction's first step. A pixel that sees the group for the first time in a late sample owes nothing for
  // those before.
  void clear(gpu::Device& device, size_t direction);
  // The picture is shaded with these tables now; they differ in weights at hand alone.
  void start_from(const MaterialTables& now);
  // The first directions whose sums have as many samples as the picture's tiles.
  size_t ready(const std::vector<uint32_t>& samples) const;
};

}  // namespace vamp
