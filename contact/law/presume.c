#include "contact/law/contact_law.h"

#include <math.h>

/* m: so far off its equipment a contact is still the one that pressed in the equilibrium nearby. */
static const double NEARBY = 0.02;
static const double LIGHTEST = 1; /* N: a contact that closes without weight */

double presume_force(const Presume *how, const ImpactLaw *law, double before, double gap, double mass)
{
    const double pressed = gap < 0 ? law->k * pow(-gap, law->e) : 0;
    if (how->from == PRESUME_GAPS) return pressed;
    const double closed = fmin(pressed, fmax(LIGHTEST, how->gravity * mass));
    if (!(before > 0)) return closed;
    if (how->from == PRESUME_LAST) return gap < NEARBY ? before : closed;
    const double depth = pow(before / law->k, 1 / law->e), line = before - law->e * before / depth * (gap + depth);
    return line > 0 ? line : fmax(closed, how->keep * before);
}
