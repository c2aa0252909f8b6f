/* Preloaded into the program. UPS_DISTURB=clock: the time of day runs backwards, a second with each look at it; steady
 * time does not. UPS_DISTURB=ticks: 2000 signals a second whose handler interrupts system calls (SIGALRM, SIGPROF).
 * UPS_DISTURB=full: after UPS_DISTURB_BYTES bytes of files the disk is full. UPS_DISTURB=fsync, close or rename: it is,
 * and says so no sooner than in that call. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

static atomic_long looks, ticks;
static int backwards, full;
static const char *late = ""; /* the call that fails */
static atomic_llong space; /* bytes */

static void tick(int signal_number) {
  (void)signal_number;
  atomic_fetch_add(&ticks, 1);
}

static void tell(void) {
  if (atomic_load(&ticks) > 0) (void)!write(2, "ticked\n", 7);
}

__attribute__((constructor)) static void begin(void) {
  const char *what = getenv("UPS_DISTURB");
  if (!what) return;
  backwards = strcmp(what, "clock") == 0;
  const char *bytes = getenv("UPS_DISTURB_BYTES");
  if (bytes) atomic_store(&space, atoll(bytes));
  full = strcmp(what, "full") == 0;
  late = what;
  if (strcmp(what, "ticks") != 0) return;
  struct sigaction action = {.sa_handler = tick}; /* without SA_RESTART */
  const struct itimerval each_ms = {{0, 1000}, {0, 1000}};
  sigaction(SIGALRM, &action, NULL);
  sigaction(SIGPROF, &action, NULL);
  setitimer(ITIMER_REAL, &each_ms, NULL);
  setitimer(ITIMER_PROF, &each_ms, NULL);
  atexit(tell);
}

static long stepped_back(void) { return backwards ? atomic_fetch_add(&looks, 1) + 1 : 0; }

int clock_gettime(clockid_t clock, struct timespec *time) {
  static int (*real)(clockid_t, struct timespec *);
  if (!real) *(void **)&real = dlsym(RTLD_NEXT, "clock_gettime");
  const int status = real(clock, time);
  if (status == 0 && clock == CLOCK_REALTIME) time->tv_sec -= stepped_back();
  return status;
}
int gettimeofday(struct timeval *time, void *zone) {
  (void)zone;
  struct timespec now;
  if (clock_gettime(CLOCK_REALTIME, &now) != 0) return -1;
  time->tv_sec = now.tv_sec;
  time->tv_usec = now.tv_nsec / 1000;
  return 0;
}
time_t time(time_t *out) {
  struct timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  if (out) *out = now.tv_sec;
  return now.tv_sec;
}

/* As a disk does: what there is room for is written. */
ssize_t write(int file, const void *from, size_t size) {
  static ssize_t (*real)(int, const void *, size_t);
  if (!real) *(void **)&real = dlsym(RTLD_NEXT, "write");
  struct stat about;
  if (full && fstat(file, &about) == 0 && S_ISREG(about.st_mode)) {
    const long long left = atomic_load(&space);
    if (left <= 0) {
      errno = ENOSPC;
      return -1;
    }
    if ((long long)size > left) size = (size_t)left;
    atomic_fetch_sub(&space, (long long)size);
  }
  return real(file, from, size);
}

static int finds_no_space(const char *call, int is_written) {
  if (!is_written || strcmp(late, call) != 0) return 0;
  errno = ENOSPC;
  return 1;
}
static int is_written(int file) {
  struct stat about;
  const int flags = fcntl(file, F_GETFL);
  return flags >= 0 && (flags & O_ACCMODE) != O_RDONLY && fstat(file, &about) == 0 && S_ISREG(about.st_mode);
}
int fsync(int file) {
  static int (*real)(int);
  if (!real) *(void **)&real = dlsym(RTLD_NEXT, "fsync");
  return finds_no_space("fsync", is_written(file)) ? -1 : real(file);
}
int close(int file) { /* closes it all the same */
  static int (*real)(int);
  if (!real) *(void **)&real = dlsym(RTLD_NEXT, "close");
  const int fails = is_written(file), status = real(file);
  return finds_no_space("close", fails) ? -1 : status;
}
int rename(const char *from, const char *to) {
  static int (*real)(const char *, const char *);
  if (!real) *(void **)&real = dlsym(RTLD_NEXT, "rename");
  return finds_no_space("rename", 1) ? -1 : real(from, to);
}
