/* What theory reckons with along a scene's route: the friction of the case and that of its ducts and trays, and where
 * weight and turning force rest on supports of their own. docs/model.md, "Separate supports". */
#ifndef HAWSER_THEORY_STRETCHES_H
#define HAWSER_THEORY_STRETCHES_H

#include "theory/pulling.h"
#include "theory/supports.h"

typedef struct Stretches {
    int n;
    PullStretch *stretch; /* [n] owned, by rising `from`; the first one begins far behind the route */
} Stretches;

/* A copy with room for `more` stretches more. Errors: MEMORY. */
hawser_status stretches_copy(const Stretches *from, int more, Stretches *out, hawser_error *err);
/* Of all cables together, which weigh so much, N/m. Supports are separate where guide rollers stand in a bend to the
 * side and in trays with upright sides. Errors: MEMORY. */
hawser_status stretches_find(const Supports *map, double weight, Stretches *out, hawser_error *err);
void stretches_free(Stretches *s);
/* Makes a stretch begin at s, m, if none does; the array must have room for one more. */
void stretches_cut(Stretches *stretches, double s);

#endif
