// See memory_estimate.h.
#include "render/memory_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "platform/memory.h"
#include "render/accumulator.h"
#include "scene/scene_bytes.h"

namespace ups {

namespace {

// Of the index of a meter that an iteration visits: its entry and disc, and the tree of them.
constexpr double index_bytes = 190, kept_index_bytes = 90;  // with and without the entry
// Of a pixel or meter, of a pilot that chooses techniques.
constexpr double pilot_bytes = 48;

// Passes of all pixels, as far as the desc says when the render ends.
double passes_of(const ups_render_desc& desc, const Plan& plan) {
  return desc.iteration_count ? double(desc.iteration_count) / plan.camera_subsets : batch_count;
}

void add_images(const Snapshot& scene, const TransportSettings& settings, const Plan& plan, double passes,
                MemoryEstimate& m) {
  for (const Camera& c : scene.cameras) {
    const double pixels = c.pixel_count(), visited = std::ceil(pixels / plan.camera_subsets);
    const ImageSums::Bytes one = ImageSums::bytes_per_pixel(c, settings, passes);
    m.images += pixels * one.sums;
    m.reading += pixels * one.reading;
    m.scratch = std::max(m.scratch, pixels * one.scratch);
    m.iteration += visited * (sizeof(uint32_t) + sizeof(Rgb) + sizeof(PixelMerges) +
                              (c.illuminance() ? sizeof(PixelIlluminance) : 0) +
                              (c.layers() ? sizeof(FirstHit) + sizeof(uint32_t) : 0));
  }
}

// rings: of a set whose photons land on discs; direct: some come straight from emitters.
void add_meters(const Snapshot& scene, const Plan& plan, const std::vector<uint32_t>& rings, bool direct,
                MemoryEstimate& m) {
  const double columns = double(plan.separation.columns.size());
  double indexed = 0;  // meters' discs and cells' pieces
  for (size_t s = 0; s < scene.meter_sets.size(); ++s) {
    const double meters = double(scene.meter_sets[s].meters.size()), visited = std::ceil(meters / plan.meter_subsets);
    m.meters += meters * (1 + columns) *
                (Accumulator::sum_bytes + MeterRings::bytes_per_row(rings[s], direct) +
                 (plan.seeks_caustics ? MeterRings::bytes_per_row(rings[s], false) : 0));
    const MeterSet& set = scene.meter_sets[s];
    m.reading += double(set.count()) * ((1 + columns) * Accumulator::reading_bytes + Accumulator::part_bytes +
                                        (set.kind == UPS_METER_VECTOR) * 3 * sizeof(ups_vector_part_reading));
    m.scratch = std::max(m.scratch, meters * Accumulator::scratch_bytes(rings[s] > 0));
    const double pieces = set.on_surface() ? double(set.triangles.size()) / meters : 1;  // of a meter, in the index
    m.iteration += visited * (1 + columns) * sizeof(MeterTally);
    if (rings[s] > 0 || (set.is_cell() && plan.light_paths > 0)) indexed += visited * pieces;
  }
  m.iteration += indexed * index_bytes;
  if (plan.meter_subsets == 1) m.scratch += indexed * kept_index_bytes;  // from one iteration to the next
}

void add_goniometers(const Snapshot& scene, MemoryEstimate& m) {
  for (const Goniometer& g : scene.goniometers) {
    const double nodes = double(g.node_count());
    m.goniometers += nodes * GoniometerSums::sum_bytes;
    m.iteration += nodes * GoniometerSums::tally_bytes;
    m.reading += nodes * GoniometerSums::reading_bytes;
  }
}

std::string bytes_text(double bytes) { return MemoryBudget::in_bytes(bytes); }

// A kind of thing that takes memory, and what would be right where it takes too much.
struct Part {
  double bytes;
  std::string what, fewer;
};

std::string fewer_text(const char* noun, double count, double bytes, double allowed) {
  const double fit = bytes > 0 ? std::floor(count * std::max(0.0, allowed) / bytes) : 0;
  return std::string("fewer ") + noun + (fit >= 1 ? " (" + std::to_string(uint64_t(fit)) + " would fit)" : "");
}

}  // namespace

MemoryEstimate least_memory(const Snapshot& scene, const TransportSettings& settings, const Plan& plan,
                            const ups_render_desc& desc) {
  TransportSettings certain = settings;
  if (settings.automatic)
    certain.techniques &= ~uint32_t(UPS_TECHNIQUE_MERGE | UPS_TECHNIQUE_SENSOR_CONNECT);
  const bool merges = certain.has(UPS_TECHNIQUE_MERGE);
  std::vector<uint32_t> rings;
  for (const MeterSet& set : scene.meter_sets)
    rings.push_back(merges && !set.is_cell() ? MeterDiscs::rings_for(ring_rows(scene, plan.separation)) : 0);
  MemoryEstimate m;
  m.scene = double(bytes_of(scene));
  add_images(scene, certain, plan, passes_of(desc, plan), m);
  add_meters(scene, plan, rings, false, m);
  add_goniometers(scene, m);
  return m;
}

MemoryEstimate estimate_memory(const Integrator& integrator, const ups_render_desc& desc, double pilots,
                               const StopSignal& stop) {
  const Snapshot& scene = integrator.scene();
  const Plan& plan = integrator.plan();
  std::vector<uint32_t> rings;
  for (size_t s = 0; s < scene.meter_sets.size(); ++s)
    rings.push_back(plan.lands_on(s) ? plan.meter_discs[s].ring_count() : 0);
  MemoryEstimate m;
  m.scene = double(bytes_of(scene));
  m.plan = double(integrator.bytes());
  add_images(scene, integrator.settings(), plan, passes_of(desc, plan), m);
  add_meters(scene, plan, rings, plan.merges_direct_light(), m);
  add_goniometers(scene, m);
  m.light_paths = integrator.bytes_of_light_paths(stop);
  m.pilots = m.plan + pilots +
             (integrator.settings().automatic ? pilot_bytes * double(scene.pixel_count() + scene.meter_count()) : 0);
  return m;
}

AllowedMemory allowed_memory(double scene_bytes, const ups_render_desc& desc) {
  const platform::AvailableMemory machine = platform::available_memory();  // beside the scene, which is there
  AllowedMemory allowed{scene_bytes + double(machine.bytes), machine.limit};
  if (desc.memory_limit_bytes > 0 && double(desc.memory_limit_bytes) < allowed.bytes)
    allowed = {double(desc.memory_limit_bytes), "memory_limit_bytes"};
  return allowed;
}

size_t whole_bytes(double bytes) { return size_t(std::clamp(bytes, 0.0, 0x1p62)); }

ups_memory_estimate in_bytes(const MemoryEstimate& m, const AllowedMemory& allowed) {
  ups_memory_estimate out{};
  out.struct_size = sizeof out;
  out.scene_bytes = whole_bytes(m.scene);
  out.working_bytes = whole_bytes(m.working());
  out.light_bytes = whole_bytes(m.light_paths);
  out.result_bytes = whole_bytes(m.reading);
  out.peak_bytes = whole_bytes(m.peak());
  out.allowed_bytes = whole_bytes(allowed.bytes);
  return out;
}

void check_memory(const MemoryEstimate& m, const AllowedMemory& allowed, const Snapshot& scene, const Plan& plan,
                  const ups_render_desc& desc) {
  if (m.peak() <= allowed.bytes) return;
  const double pixels = double(scene.pixel_count()), columns = double(plan.separation.columns.size());
  double meters = 0;
  for (const MeterSet& set : scene.meter_sets) meters += double(set.count());
  // What is read of a sensor counts with it where that, and not an iteration, makes the peak.
  const double read = m.reading + m.scratch > m.iteration + m.light_paths ? m.reading + m.scratch : 0,
               of_images = m.images + (m.images + m.meters > 0 ? read * m.images / (m.images + m.meters) : 0),
               of_meters = m.meters + (m.images + m.meters > 0 ? read * m.meters / (m.images + m.meters) : 0);
  const auto others = [&](double part) { return allowed.bytes - (m.peak() - part); };
  std::array<Part, 5> parts = {
      {{of_images, std::to_string(uint64_t(pixels)) + " pixels",
        pixels > 0 ? fewer_text("pixels", pixels, of_images, others(of_images)) +
                         (desc.technique_images ? ", or fewer technique_images" : "")
                   : ""},
       {of_meters, std::to_string(uint64_t(meters)) + " meters" +
                       (columns > 0 ? " of " + std::to_string(uint64_t(columns)) + " sources" : ""),
        meters > 0 ? fewer_text("meters", meters, of_meters, others(of_meters)) +
                         (columns > 0 ? ", or no separation" : "")
                   : ""},
       {m.goniometers, "the goniometers' nodes", "coarser goniometers"},
       {m.light_paths, std::to_string(plan.light_paths) + " light paths of an iteration",
        plan.light_paths > 0 ? fewer_text("light_paths_per_iteration", plan.light_paths, m.light_paths,
                                          others(m.light_paths))
                             : ""},
       {m.scene, "the scene", "a smaller scene"}}};
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.bytes > b.bytes; });
  std::string text = "the scene and its render want about " + bytes_text(m.peak()) + ", " + allowed.limit +
                     " allows " + bytes_text(allowed.bytes) + ":";
  for (size_t i = 0; i < 3; ++i)
    if (parts[i].bytes > 0)
      text += (i ? ", " : " ") + bytes_text(parts[i].bytes) + " for " + parts[i].what;
  throw Error(UPS_ERROR_OUT_OF_MEMORY, text + "; " + parts[0].fewer + ", or more memory, would be right");
}

}  // namespace ups
