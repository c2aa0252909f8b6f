// See separation.h: a column for each source of the snapshot, or for each group that one of them names.
#include "scene/separation.h"

#include <map>

namespace ups {

namespace {

ups_source_info info_of(ups_source_kind kind, uint32_t id) {
  ups_source_info info{};
  info.struct_size = sizeof info;
  info.kind = kind;
  info.id = id;
  return info;
}

}  // namespace

Separation separate(const Snapshot& scene, ups_separation separation) {
  Separation out;
  if (separation == UPS_SEPARATE_NOTHING) return out;
  std::vector<uint32_t> column_of_source;
  if (separation == UPS_SEPARATE_LUMINAIRES) {
    for (const Source& s : scene.sources) {
      column_of_source.push_back(uint32_t(out.columns.size()));
      out.columns.push_back(info_of(s.kind, s.id));
    }
  } else {
    std::map<uint32_t, uint32_t> column_of_group;  // in the order of the groups' numbers
    for (const Source& s : scene.sources) column_of_group[s.group] = 0;
    for (auto& [group, column] : column_of_group) {
      column = uint32_t(out.columns.size());
      out.columns.push_back(info_of(UPS_SOURCE_GROUP, group));
    }
    for (const Source& s : scene.sources) column_of_source.push_back(column_of_group[s.group]);
  }
  for (size_t i = 0; i < scene.emitters.size(); ++i) {
    const uint32_t column = column_of_source[scene.source_of_emitter[i]];
    out.column_of_emitter.push_back(column);
    out.columns[column].flux_lm += scene.emitters[i].flux_lm();
  }
  return out;
}

}  // namespace ups
