// See failing_memory.h.
#include "failing_memory.h"

#include <dlfcn.h>
#include <errno.h>
#include <link.h>
#include <malloc.h>
#include <pthread.h>
#include <sys/mman.h>

#include <atomic>
#include <cstdint>
#include <cstring>
#include <new>

// Those that ours stand before.
#ifdef UPS_SANITIZE
#define REAL(name) __interceptor_##name
#else
#define REAL(name) __libc_##name
#endif
extern "C" {
#ifdef UPS_SANITIZE
int __sanitizer_get_ownership(const volatile void*);
#endif
void* REAL(malloc)(size_t);
void* REAL(calloc)(size_t, size_t);
void* REAL(realloc)(void*, size_t);
void* REAL(memalign)(size_t, size_t);
void REAL(free)(void*);
}

namespace {

// ---- which calls fail ----

std::atomic<bool> counting{false}, no_threads{false};
std::atomic<long> calls{0};
long first_failure = 0, failures = 0;  // set while not counting

#ifdef UPS_SANITIZE
// Calls from the C library do not fail: a sanitizer ends the process if those for its own ends do, of new threads.
uintptr_t libc_begin = 0, libc_end = 0;
int find_libc(dl_phdr_info* info, size_t, void*) {
  if (std::strstr(info->dlpi_name, "/libc.so"))
    for (int i = 0; i < info->dlpi_phnum; ++i)
      if (const ElfW(Phdr)& part = info->dlpi_phdr[i]; part.p_type == PT_LOAD && (part.p_flags & PF_X))
        libc_begin = info->dlpi_addr + part.p_vaddr, libc_end = libc_begin + part.p_memsz;
  return 0;
}
bool spared(const void* caller) {
  const auto at = reinterpret_cast<uintptr_t>(caller);
  return at >= libc_begin && at < libc_end;
}
bool ready = false;  // the sanitizer, which takes memory before that, too, and knows nothing of it
__attribute__((constructor)) void get_ready() {
  dl_iterate_phdr(&find_libc, nullptr);
  ready = true;
}
#else
bool spared(const void*) { return false; }
#endif

bool fails(const void* caller) {
  if (!counting.load(std::memory_order_acquire) || spared(caller)) return false;
  const long n = calls.fetch_add(1, std::memory_order_relaxed) + 1;
  if (n < first_failure || n - first_failure >= failures) return false;
  errno = ENOMEM;
  return true;
}

// ---- how much there is ----

std::atomic<long> live_bytes{0}, peak_bytes{0};

void grow(long bytes) {
  const long now = live_bytes.fetch_add(bytes, std::memory_order_relaxed) + bytes;
  long peak = peak_bytes.load(std::memory_order_relaxed);
  while (now > peak && !peak_bytes.compare_exchange_weak(peak, now, std::memory_order_relaxed)) {}
}
long size_of(void* p) {
#ifdef UPS_SANITIZE
  if (!ready || !__sanitizer_get_ownership(p)) return 0;
#endif
  return long(malloc_usable_size(p));
}
void* counted(void* p) {
  if (p) grow(size_of(p));
  return p;
}
void discount(void* p) {
  if (p) grow(-size_of(p));
}

// ---- what the library holds ----

struct Range {
  uintptr_t begin, end;
};
constexpr int max_ranges = 16;
Range ranges[max_ranges];
std::atomic<int> range_count{0};

int add_range(dl_phdr_info* info, size_t, void*) {
  for (const char* name : {"libups", "libstdc++"})
    if (std::strstr(info->dlpi_name, name))
      for (int i = 0; i < info->dlpi_phnum; ++i) {
        const ElfW(Phdr)& part = info->dlpi_phdr[i];
        const int n = range_count.load();
        if (part.p_type != PT_LOAD || !(part.p_flags & PF_X) || n == max_ranges) continue;
        const uintptr_t begin = info->dlpi_addr + part.p_vaddr;
        ranges[n] = {begin, begin + part.p_memsz};
        range_count.store(n + 1);
      }
  return 0;
}

// Open addressing without tombstones. Pointers are multiples of 16.
constexpr size_t table_size = size_t(1) << 20;
void* table[table_size];
std::atomic<long> held{0};
std::atomic_flag table_lock = ATOMIC_FLAG_INIT;

struct TableLock {
  TableLock() {
    while (table_lock.test_and_set(std::memory_order_acquire)) {}
  }
  ~TableLock() { table_lock.clear(std::memory_order_release); }
};

size_t home_of(const void* p) { return (reinterpret_cast<uintptr_t>(p) >> 4) * 0x9e3779b97f4a7c15u >> 44; }

void* keep(void* p, const void* caller) {
  const auto at = reinterpret_cast<uintptr_t>(caller);
  bool of_library = false;
  for (int i = 0; i < range_count.load(); ++i) of_library |= at >= ranges[i].begin && at < ranges[i].end;
  if (!p || !of_library) return p;
  const TableLock lock;
  size_t i = home_of(p);
  while (table[i]) i = (i + 1) % table_size;
  table[i] = p;
  held.fetch_add(1);
  return p;
}

void drop(void* p) {
  if (!p || held.load(std::memory_order_relaxed) == 0) return;
  const TableLock lock;
  size_t i = home_of(p);
  while (table[i] && table[i] != p) i = (i + 1) % table_size;
  if (!table[i]) return;
  held.fetch_sub(1);
  for (size_t j = (i + 1) % table_size; table[j]; j = (j + 1) % table_size) {  // close the gap
    const size_t home = home_of(table[j]);
    if ((j - home) % table_size >= (j - i) % table_size) {
      table[i] = table[j];
      i = j;
    }
  }
  table[i] = nullptr;
}

void* allocate(size_t size, size_t alignment, const void* caller) {
  if (fails(caller)) return nullptr;
  return keep(counted(alignment > 16 ? REAL(memalign)(alignment, size) : REAL(malloc)(size)), caller);
}

void* allocate_or_throw(size_t size, size_t alignment, const void* caller) {
  void* p = allocate(size ? size : 1, alignment, caller);
  if (!p) throw std::bad_alloc();
  return p;
}

// The next library's function of the same type, without a guarded static: the thread sanitizer asks for memory before it
// can guard one.
template <class Function>
class Next {
 public:
  constexpr explicit Next(const char* name) : name_(name) {}
  template <class... Arguments>
  auto operator()(Arguments... arguments) {
    return reinterpret_cast<Function*>(find())(arguments...);
  }
  void* find() {
    void* at = at_.load(std::memory_order_relaxed);
    if (!at) at_.store(at = dlsym(RTLD_NEXT, name_), std::memory_order_relaxed);
    return at;
  }

 private:
  const char* name_;
  std::atomic<void*> at_{nullptr};
};
constinit Next<void*(void*, size_t, int, int, int, off_t)> next_mmap("mmap");
constinit Next<int(void*, size_t)> next_munmap("munmap");
constinit Next<int(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*)> next_pthread_create("pthread_create");

// Before a sanitizer unmaps what it has read for a report's stacks: within that, dlsym() ends the process.
[[gnu::constructor]] void find_next() { next_mmap.find(), next_munmap.find(), next_pthread_create.find(); }

}  // namespace

namespace ups::test {

void fail_memory(long first, long count) {
  first_failure = first;
  failures = count;
  calls.store(0);
  counting.store(true, std::memory_order_release);
}
long end_of_failing() {
  counting.store(false);
  return calls.load();
}
void fail_threads(bool fail) { no_threads.store(fail); }
void watch_library() {
  if (range_count.load() == 0) dl_iterate_phdr(&add_range, nullptr);
}
long allocations_held() { return held.load(); }
long bytes_allocated() { return live_bytes.load(); }
void begin_peak() { peak_bytes.store(live_bytes.load()); }
long peak_allocated() { return peak_bytes.load(); }

}  // namespace ups::test

// ---- in place of the C and C++ libraries' ----

#define CALLER __builtin_return_address(0)

extern "C" {
void* malloc(size_t size) { return allocate(size, 0, CALLER); }
void* calloc(size_t count, size_t size) {
  return fails(CALLER) ? nullptr : keep(counted(REAL(calloc)(count, size)), CALLER);
}
void* realloc(void* old, size_t size) {
  if (fails(CALLER)) return nullptr;
  drop(old);
  discount(old);
  return keep(counted(REAL(realloc)(old, size)), CALLER);
}
void* memalign(size_t alignment, size_t size) { return allocate(size, alignment, CALLER); }
void* aligned_alloc(size_t alignment, size_t size) { return allocate(size, alignment, CALLER); }
int posix_memalign(void** out, size_t alignment, size_t size) {
  void* p = allocate(size, alignment, CALLER);
  if (!p) return ENOMEM;
  *out = p;
  return 0;
}
void free(void* p) {
  drop(p);
  discount(p);
  REAL(free)(p);
}
void* mmap(void* address, size_t size, int protection, int flags, int file, off_t offset) {
  void* p = fails(CALLER) ? MAP_FAILED : next_mmap(address, size, protection, flags, file, offset);
  if (p != MAP_FAILED && (flags & MAP_ANONYMOUS)) grow(long(size));
  return p;
}
int munmap(void* address, size_t size) {
  const int status = next_munmap(address, size);
  if (status == 0) grow(-long(size));  // of a file, too: no test maps any
  return status;
}
int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*start)(void*), void* argument) {
  return no_threads.load() || fails(CALLER) ? EAGAIN : next_pthread_create(thread, attributes, start, argument);
}
}

void* operator new(size_t size) { return allocate_or_throw(size, 0, CALLER); }
void* operator new[](size_t size) { return allocate_or_throw(size, 0, CALLER); }
void* operator new(size_t size, std::align_val_t a) { return allocate_or_throw(size, size_t(a), CALLER); }
void* operator new[](size_t size, std::align_val_t a) { return allocate_or_throw(size, size_t(a), CALLER); }
void* operator new(size_t size, const std::nothrow_t&) noexcept { return allocate(size ? size : 1, 0, CALLER); }
void* operator new[](size_t size, const std::nothrow_t&) noexcept { return allocate(size ? size : 1, 0, CALLER); }
void operator delete(void* p) noexcept { free(p); }
void operator delete[](void* p) noexcept { free(p); }
void operator delete(void* p, size_t) noexcept { free(p); }
void operator delete[](void* p, size_t) noexcept { free(p); }
void operator delete(void* p, std::align_val_t) noexcept { free(p); }
void operator delete[](void* p, std::align_val_t) noexcept { free(p); }
void operator delete(void* p, size_t, std::align_val_t) noexcept { free(p); }
void operator delete[](void* p, size_t, std::align_val_t) noexcept { free(p); }
