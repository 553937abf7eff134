/* A file of HDF5 in memory as results.h5: a run's own with numbers, addresses and pieces changed, without its sum, so
 * that HDF5 does see it; or, if the input begins like one, the input itself. It is opened by what opens results, and
 * all is read of it that a page reads; then a run goes on in it. What comes out is JSON, or a reason. */
#define _GNU_SOURCE /* memfd_create, dladdr */
#include <dlfcn.h>
#include <execinfo.h>
#include <jansson.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include "io/report/report.h"
#include "io/results/results_h5.h"
#include "tests/fuzz/base_run.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/patches.h"

static const char text[] = "cables: {c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}}\n"
                           "chain: [{cable: c, length: 4 m, segment: 1 m}]\n"
                           "route: {head_at: 4 m, pieces: [{straight: 6 m}]}\n"
                           "rollers: {along: {from: 0 m, to: 6 m, spacing: 2 m}}\n"
                           "conveyors: [{name: c, from: 1 m, to: 3 m, clamp: 200 N}]\n"
                           "surfaces: {planes: [{name: ground, point: [0, 0, -50 mm], normal: [0, 0, 1]}]}\n"
                           "drive: {winch: {speed: 0.5 m/s, to: 100 ms}, tail: {tension: 1 kN, ramp: none}}\n"
                           "run: {duration: 200 ms, steady_from: 100 ms}\n"
                           "output: {interval: 50 ms, states: 50 ms}\n"
                           "solver: {passes: 1}\n";

enum { SEAL = 32, CHANGES_MAX = 8, SEGMENTS = 4, ROLLERS = 4, FRAMES = 3, ROOM = 4096 };

static char dir[BASE_PATH];
static unsigned char *image;
static size_t image_size;
/* Where bytes are not 0: few of them are numbers of states, most say where things are and how long. */
static uint32_t *busy;
static size_t busies;

/* HDF5 does not survive every file, so it is opened and read as the program does it, in a process of its own (apart.c).
 * That HDF5 ends that process is no finding; that anything else does is one, and this number, which both share, says
 * so. Behind the rehearsal of a run that goes on (results_h5.c) nothing may end it. */
static volatile int *own_fault;
static int rehearsed;

static void image_make(void)
{
    base_make(dir);
    base_run(text, dir);
    image = base_read(dir, "results.h5", &image_size);
    FUZZ_MUST(image_size > SEAL);
    image_size -= SEAL;
    own_fault = mmap(NULL, sizeof *own_fault, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    FUZZ_MUST(own_fault != MAP_FAILED);
    busy = malloc(image_size * sizeof *busy);
    FUZZ_MUST(busy);
    for (size_t k = 0; k < image_size; ++k)
        if (image[k]) busy[busies++] = (uint32_t)k;
}

/* A number of 1, 2, 4 or 8 bytes becomes another one: none, all, a little more or less, another place of the file. */
static void number_change(Draws *d, unsigned char *bytes, size_t size, size_t at)
{
    const uint32_t how = draws_take(d, 1);
    const size_t width = (size_t)1 << how % 4;
    uint64_t x = 0;
    at -= at % width;
    if (at + width > size) return;
    memcpy(&x, bytes + at, width);
    switch (how / 4 % 8) {
    case 0:
        x = 0;
        break;
    case 1:
        x = UINT64_MAX;
        break;
    case 2:
        x += draws_take(d, 1) + 1;
        break;
    case 3:
        x -= draws_take(d, 1) + 1;
        break;
    case 4:
        x ^= (uint64_t)1 << draws_take(d, 1) % 64;
        break;
    case 5:
        x = draws_take(d, 4);
        break;
    case 6:
        x = draws_take(d, 3) % size / 8 * 8;
        break;
    default:
        x = size - draws_take(d, 1);
        break;
    }
    memcpy(bytes + at, &x, width);
}

/* Returns how many bytes there are then. */
static size_t change(Draws *d, unsigned char *bytes, size_t size)
{
    const uint32_t what = draws_take(d, 1) % 8;
    size_t at = draws_take(d, 3);
    at = what % 2 ? busy[at % busies] : at % image_size;
    if (size < 16 || at >= size) return size;
    if (what < 5) {
        number_change(d, bytes, size, at);
    } else if (what == 5) {
        bytes[at] = (unsigned char)draws_take(d, 1);
    } else if (what == 6) { /* so many bytes again, in another place */
        size_t n = 1 + draws_take(d, 2) % 1024, to = draws_take(d, 3) % size;
        n = n < size - at ? n : size - at;
        n = n < size - to ? n : size - to;
        memmove(bytes + to, bytes + at, n);
    } else if (draws_take(d, 1) % 8 == 0) { /* cut off */
        return at;
    }
    return size;
}

/* ----------------------------------------------------------------------------------------------------- readers */

static void is_json(const char *before, const Text *t, const char *after)
{
    Text whole = {0};
    text_add(&whole, before);
    text_add(&whole, t->at ? t->at : "");
    text_add(&whole, after);
    FUZZ_MUST(!t->failed && !whole.failed);
    json_t *const back = json_loadb(whole.at, whole.size, JSON_DECODE_INT_AS_REAL, NULL);
    FUZZ_MUST(back);
    json_decref(back);
    text_clear(&whole);
}

enum { SECONDS_MOST = 20, STACK_MOST = 64 };

#if defined(__has_feature)
#define SANITIZED __has_feature(address_sanitizer)
#elif defined(__SANITIZE_ADDRESS__)
#define SANITIZED 1
#else
#define SANITIZED 0
#endif
#if SANITIZED
void __sanitizer_set_death_callback(void (*callback)(void));
#endif

/* Whose code has ended the process: HDF5's if that stands on the stack before any of ours. */
static void fault_place(void)
{
    static const char *const nobody[] = {"libasan", "libubsan", "libc.so", "libclang_rt"};
    void *stack[STACK_MOST];
    Dl_info here, at;
    const int n = backtrace(stack, STACK_MOST);
    dladdr(__extension__(void *) fault_place, &here);
    for (int k = 1; k < n; ++k) {
        int skip = !dladdr(stack[k], &at) || !at.dli_fname;
        for (size_t i = 0; i < sizeof nobody / sizeof *nobody && !skip; ++i) skip = !!strstr(at.dli_fname, nobody[i]);
#ifdef HAWSER_FUZZER
        /* the sanitizer's functions are within the program, ours in libraries and above the program's */
        skip |= at.dli_fname == here.dli_fname;
#endif
        if (skip) continue;
        *own_fault = rehearsed || !strstr(at.dli_fname, "libhdf5");
        return;
    }
    *own_fault = 1;
}

static void fault_signal(int number)
{
    fault_place();
    _exit(128 + number);
}

static void faults_watch(void)
{
    static const int ends[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU};
    const struct rlimit time = {SECONDS_MOST, RLIM_INFINITY};
    void *first[1];
    (void)backtrace(first, 1); /* loads what it needs */
    setrlimit(RLIMIT_CPU, &time);
    for (size_t k = 0; k < sizeof ends / sizeof *ends; ++k) signal(ends[k], fault_signal);
#if SANITIZED
    __sanitizer_set_death_callback(fault_place);
#endif
}

static void page_read(hid_t file)
{
    Folder folder = {.dir = "fuzz", .home.at = -1};
    Text out = {0};
    States states;
    hawser_error err = {HAWSER_OK, ""};
    (void)states_belong(file, "run", NULL);
    geometry_add(&out, file, &folder);
    is_json("{\"is\":1", &out, "}");
    text_clear(&out);
    const hawser_status status = states_read(file, FRAMES, &states, &err);
    if (status) FUZZ_MUST(fuzz_error_is_good((int)status, err.message));
    for (int k = 0; k < FIELDS && !status; ++k) {
        const Field *const f = &states.field[k];
        if (!f->value) continue;
        FUZZ_MUST(!pack_field(states.frames, f->items, f->components, f->step, f->value, &out, &err));
    }
    text_clear(&out);
    states_clear(&states);
}

static hawser_status page_apart(void *user, FILE *out, hawser_error *err)
{
    StatesFile s;
    (void)out, (void)err;
    faults_watch();
    states_open_descriptor(&s, *(const int *)user, -1);
    if (s.file >= 0) page_read(s.file);
    states_close(&s);
    return HAWSER_OK;
}

/* A run goes on behind two states of the file, as those of its chain would be. */
static hawser_status run_apart(void *user, FILE *printed, hawser_error *error)
{
    (void)user, (void)printed, (void)error;
    static const double zeros[4 * (SEGMENTS + 1) + 3 * ROLLERS];
    const ResultsDef def = {.segments = SEGMENTS, .rollers = ROLLERS, .states = 4};
    const hawser_sample sample = {
        .segments = SEGMENTS,
        .joints = SEGMENTS + 1,
        .rollers = ROLLERS,
        .position = zeros,
        .quaternion = zeros,
        .velocity = zeros,
        .omega = zeros,
        .tension = zeros,
        .axial_speed = zeros,
        .roller_load = zeros,
        .field = {.curvature = zeros, .sidewall = zeros, .contact_line_load = zeros, .roller_force = zeros}};
    OutDir out;
    H5File *h = NULL;
    hawser_error err = {HAWSER_OK, ""};
    faults_watch();
    FUZZ_MUST(!out_enter(&out, dir, &err));
    hawser_status status = h5_can_resume(&out, &def, 2, &err);
    rehearsed = !status;
    if (!status) status = h5_resume(&h, &out, &def, 2, &err);
    if (!status) status = h5_append(h, &sample, &err);
    if (status) FUZZ_MUST(fuzz_error_is_good((int)status, err.message));
    (void)h5_close(&h, &err);
    out_leave(&out);
    H5close(); /* as the program ends */
    return HAWSER_OK;
}

static void is_survived(ApartWork *work, void *user)
{
    char *printed;
    size_t length;
    int died;
    hawser_error err;
    *own_fault = 0;
    FUZZ_MUST(!apart_do(work, user, &printed, &length, &died, &err));
    FUZZ_MUST(!*own_fault);
    free(printed);
}

FUZZ_TARGET(states)
{
    Draws d = {data, size};
    if (!image) image_make();
    const int itself = size > 8 && !memcmp(data, image, 8);
    unsigned char *const bytes = malloc(image_size + size + ROOM);
    size_t n = itself ? size : image_size;
    FUZZ_MUST(bytes);
    memcpy(bytes, itself ? data : image, n);
    const uint32_t goes_on = itself ? data[size - 1] : draws_take(&d, 1);
    for (int k = 0; k < CHANGES_MAX && d.left > 0 && !itself; ++k) n = change(&d, bytes, n);

    int fd = memfd_create("results.h5", MFD_CLOEXEC);
    FUZZ_MUST(fd >= 0 && whole_write(fd, bytes, n));
    is_survived(page_apart, &fd);
    close(fd);
    if (goes_on % 4 == 0) {
        base_write(dir, "results.h5", bytes, n);
        is_survived(run_apart, NULL);
    }
    free(bytes);
    return 0;
}
