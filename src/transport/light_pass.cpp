// See light_pass.h: blocks of light paths on all threads, and what blocks found put in order.
#include "transport/light_pass.h"

#include <bit>
#include <cmath>

#include "transport/light_walk.h"
#include "transport/photon_index.h"
#include "transport/selection.h"

namespace ups {

LightPass::LightPass() = default;
LightPass::~LightPass() = default;
void LightPass::clear() { blocks_ = std::vector<Block>(); }

namespace {

using Block = LightPass::Block;
constexpr size_t paths_per_block = LightPaths::paths_per_block;

void run_blocks(const Iteration& in, const SensorIndex& sensors, ThreadPool& pool, uint32_t paths,
                std::vector<Block>& blocks) {
  const size_t count = (paths + paths_per_block - 1) / paths_per_block;
  while (blocks.size() < count) blocks.emplace_back().share = MemoryShare(in.settings.memory);
  blocks.erase(blocks.begin() + ptrdiff_t(count), blocks.end());
  pool.for_blocks(paths, paths_per_block, [&](size_t b, size_t begin, size_t end) {
    Block& block = blocks[b];
    block.clear();
    if (in.stop.is_set()) return;
    block.counts.reserve(end - begin);
    for (size_t path = begin; path < end; ++path) {
      block.counts.push_back(0);
      LightWalk(in, sensors, block, uint32_t(path)).run();
    }
  });
}

LightPaths paths_of(const Iteration& in, const std::vector<Block>& blocks) {
  LightPaths paths;
  paths.share = MemoryShare(in.settings.memory);
  paths.share.take((in.plan.light_paths + 1) * sizeof(uint32_t) +
                   blocks.size() * (sizeof(paths.blocks[0]) + sizeof(paths.photons[0])));
  paths.blocks.reserve(blocks.size());
  paths.photons.reserve(blocks.size());
  paths.begin.reserve(in.plan.light_paths + 1);
  uint32_t at = 0;
  for (const Block& b : blocks) {
    paths.blocks.push_back(b.vertices), paths.photons.push_back(b.photons), paths.merged += b.photons.size();
    for (uint32_t n : b.counts) paths.begin.push_back(at), at += n;
  }
  paths.begin.push_back(at);
  paths.number_places();
  return paths;
}

// For what the blocks found: as much as they did, and no more.
void reserve(const std::vector<Block>& blocks, const SensorIndex& sensors, IterationTally& tally) {
  std::vector<size_t> splats(tally.splats.size()), landings(tally.landings.size());
  for (const Block& b : blocks) {
    for (const Block::CameraSplat& s : b.splats) ++splats[s.camera];
    for (const Block::Landing& l : b.landings) landings[sensors.entry(l.disc).set] += l.ring != none;
  }
  size_t bytes = 0;
  for (const size_t n : splats) bytes += n * sizeof(Splat);
  for (const size_t n : landings) bytes += n * sizeof(MeterLanding);
  tally.share.take(bytes);
  for (size_t c = 0; c < splats.size(); ++c) tally.splats[c].reserve(splats[c]);
  for (size_t s = 0; s < landings.size(); ++s) tally.landings[s].reserve(landings[s]);
}

// Of an array that push_back() grew.
double grown_bytes(double size, size_t of_one) {
  return size > 0 ? double(std::bit_ceil(uint64_t(std::ceil(size)))) * double(of_one) : 0;
}

}  // namespace

LightPaths LightPass::trace(const Iteration& in, const SensorIndex& sensors, ThreadPool& pool, IterationTally& tally) {
  run_blocks(in, sensors, pool, in.plan.light_paths, blocks_);
  LightPaths paths = paths_of(in, blocks_);
  tally.share = MemoryShare(in.settings.memory);
  reserve(blocks_, sensors, tally);
  const size_t columns = in.plan.separation.columns.size();
  for (const Block& b : blocks_) {
    if (in.stop.is_set()) break;
    for (const Block::CameraSplat& s : b.splats) {
      tally.splats[s.camera].push_back(s.splat);
      if (in.moments) {
        const size_t tile = in.plan.units.of_pixel(s.camera, s.splat.pixel) - in.plan.units.begin(s.camera);
        in.moments->add_light_path(luminance(s.splat.value), s.relative, true,
                                   &tally.excess_of_splats[s.camera][tile * in.moments->row()]);
      }
      if (!tally.techniques.empty())
        tally.techniques[s.camera].add({Family::path_integration, s.edges, s.edges}, s.splat.pixel, s.splat.value,
                                       s.unweighted);
    }
    for (const Block::Landing& l : b.landings) {
      const SensorIndex::Entry& e = sensors.entry(l.disc);
      const uint32_t column = columns ? in.plan.separation.column_of_emitter[l.emitter] : 0;
      if (l.ring != none && !in.moments) {
        tally.landings[e.set].push_back({e.visited, column, uint8_t(l.ring), l.value.direct != 0, l.octant,
                                         l.value.largest.number(), l.lm, l.value.caustics > 0});
        continue;
      }
      // A pilot takes whole discs: its photons are too few to choose by.
      tally.meters[e.set][e.visited].add(l.value);
      if (in.moments)
        in.moments->add_light_path(l.value.value, l.relative, false,
                                   &tally.excess_of_meters[e.set][e.visited * in.moments->row()]);
      if (columns) tally.separated[e.set][e.visited * columns + column].add(l.value);
    }
    for (size_t g = 0; g < tally.goniometers.size(); ++g)
      for (const Block::Escape& e : b.escapes)
        in.scene.goniometers[g].add(e.direction, double(e.flux) / in.plan.light_paths, tally.goniometers[g]);
    tally.starts.insert(tally.starts.end(), b.starts.begin(), b.starts.end());
    tally.work.merges += b.landings.size();
    tally.work.add(b.work);
  }
  return paths;
}

void retrace_light_path(const Iteration& in, const SensorIndex& sensors, uint32_t path) {
  Block block;
  block.counts.push_back(0);
  LightWalk(in, sensors, block, path).run();
}

LightPaths LightPass::trace_pilot(const Iteration& in, ThreadPool& pool) {
  run_blocks(in, {}, pool, in.plan.light_paths, blocks_);
  return paths_of(in, blocks_);
}

LightPassCounts count_light_pass(const Iteration& in, const SensorIndex& sensors, ThreadPool& pool, uint32_t paths) {
  paths = std::clamp(paths, 1u, in.plan.light_paths);
  LightPassCounts n;
  std::vector<Block> blocks;
  run_blocks(in, sensors, pool, paths, blocks);
  for (const Block& b : blocks) {
    n.vertices += double(b.vertices.size()) / paths;
    n.merged += double(b.photons.size()) / paths;
    n.splats += double(b.splats.size()) / paths;
    n.landings += double(b.landings.size()) / paths;
    n.escapes += double(b.escapes.size()) / paths;
  }
  return n;
}

double LightPassCounts::bytes(uint32_t paths) const {
  const double blocks = std::ceil(double(paths) / paths_per_block), of_block = paths / blocks;
  const double tracing = blocks * (sizeof(Block) + of_block * sizeof(uint32_t) +
                                   grown_bytes(of_block * vertices, sizeof(LightVertex)) +
                                   grown_bytes(of_block * merged, sizeof(StoredPhoton)) +
                                   grown_bytes(of_block * splats, sizeof(Block::CameraSplat)) +
                                   grown_bytes(of_block * landings, sizeof(Block::Landing)) +
                                   grown_bytes(of_block * escapes, sizeof(Block::Escape))),
               begin = paths * sizeof(uint32_t),
               found = paths * (splats * sizeof(Splat) + landings * sizeof(MeterLanding)),
               indices = 2 * double(PhotonIndex::bytes(size_t(paths * merged)));
  return found + begin + tracing + indices;
}

}  // namespace ups
