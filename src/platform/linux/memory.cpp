// See memory.h: /proc/meminfo, then each control group from the process's own up to the root of its hierarchy.
// Paths are strings: std::filesystem::path does not survive an allocation that fails.
#include "platform/memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "platform/linux/machine_memory.h"

namespace ups::platform {

namespace {

using View = std::string_view;

// Empty where it cannot be read.
std::string text_of(const std::string& file) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(file.c_str(), "re"), &std::fclose);
  std::string text;
  char part[4096];
  for (size_t n; in && (n = std::fread(part, 1, sizeof part, in.get())) > 0;) text.append(part, n);
  return text;
}

// What is before the separator, which both lose; of the last part, the rest.
View next(View& rest, View separator) {
  const size_t at = rest.find(separator);
  const View part = rest.substr(0, at);
  rest = at == View::npos ? View() : rest.substr(at + separator.size());
  return part;
}

std::optional<uint64_t> number_in(View text) {
  text.remove_prefix(std::min(text.size(), text.find_first_not_of(' ')));
  uint64_t value = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
  return parsed.ec == std::errc() ? std::optional(value) : std::nullopt;
}

// Of a table "key value" or "key: value"; none where it has no such line.
std::optional<uint64_t> entry_of(View table, View key) {
  while (!table.empty()) {
    View line = next(table, "\n"), name = next(line, " ");
    if (name.ends_with(':')) name.remove_suffix(1);
    if (name == key) return number_in(line);
  }
  return {};
}

bool has_word(View list, View word) {
  while (!list.empty())
    if (next(list, ",") == word) return true;
  return false;
}

// How the two versions name the same things.
struct Version {
  View type, controller;  // of the file system; in /proc/self/cgroup, of version 2 it is empty
  // Above the second limit, which only version 2 has, a group is slowed down until next to nothing gets done.
  const char *limit, *slow_limit, *usage;
  View active_files, inactive_files;
  const char *swap_limit, *swap_usage;  // of version 2
};
constexpr Version versions[] = {
    {"cgroup2", "", "/memory.max", "/memory.high", "/memory.current", "active_file", "inactive_file",
     "/memory.swap.max", "/memory.swap.current"},
    {"cgroup", "memory", "/memory.limit_in_bytes", nullptr, "/memory.usage_in_bytes", "total_active_file",
     "total_inactive_file", nullptr, nullptr}};

// The process's own group: "4:memory:/a/b", of version 2 "0::/a/b".
std::optional<View> group_in(View table, const Version& v) {
  while (!table.empty()) {
    View line = next(table, "\n");
    next(line, ":");
    const View controllers = next(line, ":");
    if (v.controller.empty() ? controllers.empty() : has_word(controllers, v.controller)) return line;
  }
  return std::nullopt;
}

struct Mount {
  View group, place;  // the group that is seen at the place
};
// "31 23 0:28 GROUP PLACE options ... - TYPE source superoptions"
std::vector<Mount> mounts_in(View table, const Version& v) {
  std::vector<Mount> out;
  while (!table.empty()) {
    View back = next(table, "\n"), front = next(back, " - ");
    const View type = next(back, " ");
    next(back, " ");
    if (type != v.type || (!v.controller.empty() && !has_word(back, v.controller))) continue;
    for (int k = 0; k < 3; ++k) next(front, " ");
    const View group = next(front, " ");
    out.push_back({group, next(front, " ")});
  }
  return out;
}

// The group's path below the mount; none where the group is not seen there, as in some containers.
View below(const Mount& mount, View group) {
  const View root = mount.group == "/" ? View() : mount.group;
  if (group.find("..") != View::npos || !group.starts_with(root)) return {};
  group.remove_prefix(root.size());
  return group.starts_with('/') && group != "/" ? group : View();
}

void take_less(AvailableMemory& out, uint64_t bytes, std::string limit) {
  if (bytes < out.bytes) out = {bytes, std::move(limit)};
}

uint64_t less(uint64_t all, uint64_t used) { return all > used ? all - used : 0; }

void look_at_memory(const std::string& root, const std::string& place, const Version& v, AvailableMemory& out) {
  const std::string folder = root + place;
  for (const char* limit : {v.limit, v.slow_limit}) {
    const std::optional<uint64_t> most = limit ? number_in(text_of(folder + limit)) : std::nullopt;
    if (!most) continue;
    const std::string statistics = text_of(folder + "/memory.stat");
    const uint64_t used = number_in(text_of(folder + v.usage)).value_or(0),
                   files = entry_of(statistics, v.active_files).value_or(0) +
                           entry_of(statistics, v.inactive_files).value_or(0);
    take_less(out, less(*most, less(used, files)), "the control group's limit, " + place + limit + ",");
  }
}

void look_at_swap(const std::string& folder, const Version& v, uint64_t& free) {
  if (!v.swap_limit) return;
  if (const std::optional<uint64_t> most = number_in(text_of(folder + v.swap_limit)))
    free = std::min(free, less(*most, number_in(text_of(folder + v.swap_usage)).value_or(0)));
}

void look_at_groups(const std::string& root, const Version& v, AvailableMemory& out, uint64_t& free_swap) {
  const std::string groups = text_of(root + "/proc/self/cgroup"), mounts = text_of(root + "/proc/self/mountinfo");
  const std::optional<View> group = group_in(groups, v);
  if (!group) return;
  for (const Mount& mount : mounts_in(mounts, v))
    for (View at = below(mount, *group);; at = at.substr(0, at.rfind('/'))) {
      const std::string place = std::string(mount.place) + std::string(at);
      look_at_memory(root, place, v, out);
      look_at_swap(root + place, v, free_swap);
      if (at.empty()) break;
    }
}

}  // namespace

AvailableMemory available_memory_below(const std::string& root) {
  AvailableMemory out;
  constexpr uint64_t kb = 1024;
  const std::string machine = text_of(root + "/proc/meminfo");
  uint64_t free_swap = entry_of(machine, "SwapFree").value_or(0) * kb;
  for (const Version& v : versions) look_at_groups(root, v, out, free_swap);
  if (const std::optional<uint64_t> available = entry_of(machine, "MemAvailable"))
    take_less(out, *available * kb + free_swap, "what the machine has free");
  return out;
}

AvailableMemory available_memory() { return available_memory_below(""); }

uint64_t resident_bytes() {
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  if (!file) return 0;
  unsigned long long pages = 0;
  const bool read = std::fscanf(file, "%*s %llu", &pages) == 1;
  std::fclose(file);
  return read ? pages * uint64_t(sysconf(_SC_PAGESIZE)) : 0;
}

uint64_t peak_resident_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return uint64_t(usage.ru_maxrss) * 1024;
}

}  // namespace ups::platform
