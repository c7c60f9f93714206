#include "engine/render/weight_sums.h"

#include <algorithm>
#include <utility>

#include "engine/gpu/command_list.h"
#include "engine/gpu/device.h"

namespace vamp {

WeightSums::WeightSums(gpu::Device& device, WeightSpan of, uint64_t pixels, uint32_t planes, size_t tiles,
                       uint64_t max_bytes, Memory memory)
    : span(std::move(of)), list(device, "pixels of the weights at hand", pixels) {
  const uint64_t bytes = pixels * 2 * planes * sizeof(vec4);
  const size_t fit = static_cast<size_t>(max_bytes / bytes);
  std::erase_if(memory, [&](const auto& buffer) { return buffer.count() != pixels * 2 * planes; });
  for (size_t k = 0; k < std::min(fit, span.directions().size()); ++k) {
    const WeightSpan::Direction& tables = span.directions()[k];
    Direction direction;
    const auto send = [&](auto& table, const char* name, const auto& rows, VkFormat format) {
      using Row = typename std::remove_cvref_t<decltype(rows)>::value_type;
      table.rows = gpu::TypedBuffer<Row>(device, name, rows.size(), gpu::Usage::uniform_texel);
      table.view = gpu::TexelView(device, table.rows, format);
      device.upload_rows<Row>(table.rows, 0, rows);
    };
    send(direction.bases, "weights at hand", tables.bases, VK_FORMAT_R32G32B32A32_SFLOAT);
    send(direction.clusters, "their residual", tables.clusters, VK_FORMAT_R32G32B32A32_SFLOAT);
    if (k < memory.size())
      direction.accumulators = std::move(memory[k]);
    else
      direction.accumulators =
          gpu::TypedBuffer<vec4>(device, "sums of the weights at hand", pixels * 2 * planes, gpu::Usage::storage_texel);
    direction.accumulators_view = gpu::TexelView(device, direction.accumulators, VK_FORMAT_R32G32B32A32_SFLOAT);
    direction.samples.assign(tiles, 0);
    directions.push_back(std::move(direction));
  }
}

WeightSums::Memory WeightSums::take_memory() && {
  Memory memory;
  for (Direction& direction : directions) memory.push_back(std::move(direction.accumulators));
  return memory;
}

void WeightSums::clear(gpu::Device& device, size_t direction) {
  if (std::exchange(directions[direction].cleared, true)) return;
  gpu::CommandList clear = device.begin("clear sums of weights");
  clear.fill(directions[direction].accumulators, 0);
  device.submit(std::move(clear));
}

void WeightSums::start_from(const MaterialTables& now) {
  span.start_from(now);
  for (Direction& direction : directions) direction.applied = 0;
}

size_t WeightSums::ready(const std::vector<uint32_t>& samples) const {
  size_t count = 0;
  while (count < directions.size() && directions[count].samples == samples) ++count;
  return count;
}

}  // namespace vamp
