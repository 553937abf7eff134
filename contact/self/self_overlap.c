#include "contact/self/self_overlap.h"

/* Half a turn about the line's own surface, in radii: a cable that is bent that sharply touches itself. */
static const double HALF_TURN = 3.14159265358979323846;

/* What is looked for: the segments of one line near segment i of another one, or of the same. */
typedef struct Search {
    const SelfLine *mine, *other;
    int i, first;    /* the other's segments from `first` on */
    double longest;  /* m: of the other's half segments */
    double stride;   /* m: the largest distance of two neighbours' centres there */
    double thickest; /* m: its largest radius */
} Search;

static Chord segment_chord(const SelfLine *line, int i)
{
    const double half = line->chain->half[i];
    const Vec3 axis = v3_load(line->kin->a, i);
    return (Chord){v3_axpy(v3_load(line->kin->p, i), -half, axis), v3_scale(2 * half, axis)};
}

/* Goes along the other line; as far as nothing can be near it is passed over. */
static void search(const Search *s, SelfOverlap *deepest)
{
    const Chain *const mine = s->mine->chain, *const other = s->other->chain;
    const Chord chord = segment_chord(s->mine, s->i);
    const Vec3 here = v3_load(s->mine->kin->p, s->i);
    const double reach = mine->half[s->i] + s->longest + mine->radius[s->i] + s->thickest;
    for (int j = s->first; j < other->n;) {
        const double free = v3_norm(v3_sub(v3_load(s->other->kin->p, j), here)) - reach;
        if (free > 0) {
            const double skip = free / s->stride;
            j += skip > 1 && skip < other->n ? (int)skip : 1;
            continue;
        }
        const Chord there = segment_chord(s->other, j);
        const double share = 1 - chords_apart(&chord, &there) / (mine->radius[s->i] + other->radius[j]);
        if (share > deepest->share) {
            deepest->share = share;
            deepest->segment = s->i;
            deepest->opposite = j;
            deepest->at = here;
        }
        ++j;
    }
}

/* The first segment behind i of the same line that may touch it: half a turn lies between their ends. */
static int first_behind(const Chain *chain, int i)
{
    double between = 0;
    int j = i + 2;
    for (; j < chain->n; ++j) {
        between += 2 * chain->half[j - 1];
        if (between >= HALF_TURN * fmax(chain->radius[i], chain->radius[j])) break;
    }
    return j;
}

/* Whether the last segments of both lines are held by one eye: they meet there. */
static int share_eye(const SelfLine *a, const SelfLine *b) { return a->eye > 0 && a->eye == b->eye; }

static void lines_search(const SelfLines *lines, int l, int m, SelfOverlap *deepest)
{
    const SelfLine *const mine = &lines->line[l], *const other = &lines->line[m];
    SelfOverlap of = *deepest;
    Search s = {.mine = mine, .other = other};
    for (int j = 0; j < other->chain->n; ++j) {
        const Vec3 here = v3_load(other->kin->p, j);
        if (j > 0) s.stride = fmax(s.stride, v3_norm(v3_sub(here, v3_load(other->kin->p, j - 1))));
        s.longest = fmax(s.longest, other->chain->half[j]);
        s.thickest = fmax(s.thickest, other->chain->radius[j]);
    }
    const int last = mine->chain->n - (l != m && share_eye(mine, other));
    for (s.i = 0; s.i < last; ++s.i) {
        s.first = l == m ? first_behind(mine->chain, s.i) : 0;
        search(&s, &of);
    }
    if (!(of.share > deepest->share)) return;
    *deepest = of;
    deepest->line = l;
    deepest->other = m;
}

SelfOverlap self_overlap(const SelfLines *lines)
{
    SelfOverlap deepest = {.share = -INFINITY, .line = -1, .other = -1};
    for (int l = 0; l < lines->n; ++l) {
        for (int m = lines->within ? l : l + 1; m < lines->n; ++m) lines_search(lines, l, m, &deepest);
    }
    return deepest;
}
