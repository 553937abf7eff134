/* Checkpoints with a right sum whose content is wrong: a run's own checkpoint, in which numbers are changed and pieces
 * made shorter, left out or exchanged. It is refused with a reason, or what goes on from it is judged as any run is. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/checkpoint.h"
#include "hawser/hawser.h"
#include "tests/fuzz/checkpoint_scenes.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/patches.h"

enum { STEPS_AFTER = 4, PATCHES_MAX = 6 };

/* A scene's checkpoint after some steps, and where its pieces lie; made once. */
typedef struct Base {
    hawser_case *c;
    unsigned char *bytes;
    size_t size;
    int pieces;
    size_t *piece; /* [pieces + 1] where each begins, with its head */
} Base;

enum { PIECE_HEAD = 16, SUM_AT = PIECE_HEAD + 32, SIZE_AT = PIECE_HEAD + 24, FILE_HEAD = PIECE_HEAD + 40 };

static hawser_sim *sim_of(hawser_case *c)
{
    hawser_error err = {HAWSER_OK, ""};
    hawser_sim *s = NULL;
    if (hawser_sim_new(c, &(hawser_options){.threads = 1}, &s, &err)) fuzz_failed(err.message, __FILE__, __LINE__);
    return s;
}

static void base_cut(Base *b)
{
    b->piece = malloc((b->size / PIECE_HEAD + 2) * sizeof *b->piece);
    FUZZ_MUST(b->piece);
    for (size_t at = 0; at < b->size;) {
        uint64_t size;
        b->piece[b->pieces++] = at;
        memcpy(&size, b->bytes + at + 8, sizeof size);
        at += PIECE_HEAD + (size + 7) / 8 * 8;
        FUZZ_MUST(at <= b->size);
    }
    b->piece[b->pieces] = b->size;
}

static const Base *base_of(int scene)
{
    static Base base[CHECKPOINT_SCENES];
    Base *const b = &base[scene];
    if (b->bytes) return b;
    hawser_error err = {HAWSER_OK, ""};
    void *bytes = NULL;
    if (hawser_case_parse(checkpoint_scenes[scene].text, "base.yaml", &b->c, &err))
        fuzz_failed(err.message, __FILE__, __LINE__);
    hawser_sim *const s = sim_of(b->c);
    if (hawser_sim_relax(s, NULL, &err)) fuzz_failed(err.message, __FILE__, __LINE__);
    for (int k = 0; k < checkpoint_scenes[scene].steps; ++k) {
        if (hawser_sim_advance(s, hawser_sim_end_time(s), 1, &err)) fuzz_failed(err.message, __FILE__, __LINE__);
        if (k % 4 == 0) hawser_sim_record(s);
    }
    FUZZ_MUST(!hawser_sim_save_memory(s, &bytes, &b->size, &err));
    b->bytes = bytes;
    hawser_sim_free(s);
    base_cut(b);
    return b;
}

/* ----------------------------------------------------------------------------------------------------- changes */

/* Pieces that come before the simulation are compared, and are changed as often as any other. */
static size_t change(Draws *d, const Base *b, unsigned char *bytes, size_t size)
{
    const int what = (int)(draws_take(d, 1) % 16), k = 1 + (int)(draws_take(d, 2) % (uint32_t)(b->pieces - 1));
    const size_t from = b->piece[k], to = b->piece[k + 1], inside = to - from - PIECE_HEAD;
    if (size != b->size && what >= 13) return size; /* places have moved */
    if (to > size) return size;
    switch (what) {
    case 15: /* left out */
        memmove(bytes + from, bytes + to, size - to);
        return size - (to - from);
    case 14: /* cut off here */
        return from + PIECE_HEAD;
    case 13: /* another length */
        patch_number(d, bytes + from + 8, 8, 0);
        return size;
    default:
        if (inside == 0) return size;
        patch_number(d, bytes + from + PIECE_HEAD, inside, draws_take(d, 2) % inside);
        return size;
    }
}

static void sum_mend(unsigned char *bytes, size_t size)
{
    if (size < FILE_HEAD) return;
    const uint64_t rest = size - FILE_HEAD, sum = checkpoint_hash(bytes + FILE_HEAD, rest);
    memcpy(bytes + SIZE_AT, &rest, sizeof rest);
    memcpy(bytes + SUM_AT, &sum, sizeof sum);
}

/* ---------------------------------------------------------------------------------------------------- going on */

static void go_on(hawser_sim *s)
{
    hawser_error err = {HAWSER_OK, ""};
    hawser_status status = HAWSER_OK;
    hawser_summary summary;
    char *json = NULL;
    for (int k = 0; k < STEPS_AFTER && !status; ++k) {
        status = hawser_sim_advance(s, hawser_sim_end_time(s), 1, &err);
        if (status) FUZZ_MUST(fuzz_error_is_good((int)status, err.message));
    }
    const hawser_sample *const now = hawser_sim_sample(s);
    FUZZ_MUST(now);
    for (int i = 0; !status && i < 3 * now->segments; ++i) FUZZ_MUST(!isnan(now->position[i]));
    FUZZ_MUST(status || isfinite(now->t));
    hawser_sim_record(s);
    hawser_sim_summary(s, &summary);
    status = hawser_sim_summary_json(s, &json, &err);
    FUZZ_MUST(status ? fuzz_error_is_good((int)status, err.message) : json && *json);
    hawser_text_free(json);
}

FUZZ_TARGET(checkpoint)
{
    Draws d = {data, size};
    const Base *const b = base_of((int)(draws_take(&d, 1) % CHECKPOINT_SCENES));
    unsigned char *const bytes = malloc(b->size);
    size_t n = b->size;
    FUZZ_MUST(bytes);
    memcpy(bytes, b->bytes, n);
    for (int k = 0; k < PATCHES_MAX && d.left > 0; ++k) n = change(&d, b, bytes, n);
    sum_mend(bytes, n);
    hawser_error err = {HAWSER_OK, ""};
    hawser_sim *const s = sim_of(b->c);
    const hawser_status status = hawser_sim_load_memory(s, bytes, n, &err);
    if (status) FUZZ_MUST(fuzz_error_is_good((int)status, err.message));
    if (!status) go_on(s);
    hawser_sim_free(s);
    free(bytes);
    return 0;
}
