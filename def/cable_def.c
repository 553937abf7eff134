#include "def/cable_def.h"

#include <math.h>

/* Moment of a table at first bending to a curvature, and the work done up to there. */
typedef struct Bent {
    double moment, work; /* N m; N m per metre */
} Bent;

static Bent bent_to(const BendingTable *t, double curvature)
{
    double before = 0;
    Bent b = {0, 0};
    for (int k = 0; k < t->rows && before < curvature; ++k) {
        const int last = k == t->rows - 1;
        const double slope = (t->moment[k] - b.moment) / (t->curvature[k] - before);
        const double by = (last ? curvature : fmin(curvature, t->curvature[k])) - before;
        b.work += by * (b.moment + by * slope / 2);
        b.moment += by * slope;
        before += by;
    }
    return b;
}

double cable_def_moment(const CableDef *cable, double curvature)
{
    if (cable->bending.rows == 0) return fmax(cable->ei_y, cable->ei_z) * curvature;
    return bent_to(&cable->bending, curvature).moment;
}

/* Energy that unbending does not return. It returns all of k M less the doubled curve below it: W(k) - (k M(k) - 4
 * W(k/2)). */
double cable_def_loop(const CableDef *cable, double curvature)
{
    if (cable->bending.rows == 0) return 0;
    const Bent all = bent_to(&cable->bending, curvature), half = bent_to(&cable->bending, curvature / 2);
    return fmax(0, all.work - (curvature * all.moment - 4 * half.work));
}

static const double PI = 3.14159265358979323846;

/* Moduli of copper and aluminium wire, Pa, in the order of ConductorMetal. */
static const double WIRE_MODULUS[] = {115e9, 69e9};

/* Ratio of a stranded conductor's modulus to its wire's, due to the lay angle and settling strands. */
static const double STRANDING = 0.85;

/* Metal over the circle around a compacted conductor; number of its wires (IEC 60228, 400 mm2 to 800 mm2). */
static const double FILLING = 0.9, WIRES = 61;

/* Insulation and sheath: modulus, Pa, and mean density of everything that is not metal, kg/m3. */
static const double PLASTIC_MODULUS = 0.3e9, PLASTIC_DENSITY = 1100;

/* Density of copper, kg/m3, assumed for unknown metal. */
static const double METAL_DENSITY = 8890;

static const double POISSON = 0.35;

/* Least uncertainty factors of EA and EI: without the conductors, and with them. The stiffness of plastic doubles or
 * halves on a cold or a hot day, and metal screens, sheaths and armour are not included. */
static const double AXIAL_FACTOR[] = {2, 1.3}, BENDING_FACTOR[] = {3, 2};

/* Metal of all conductors, m2: as given, or from the mean density. (CS1) */
static double metal_area(const CableMake *c, double section)
{
    if (c->area > 0) return fmin(c->area * c->cores, FILLING * section);
    const double metal = (c->mass - PLASTIC_DENSITY * section) / (METAL_DENSITY - PLASTIC_DENSITY);
    return fmin(fmax(metal, 0), FILLING * section);
}

/* Estimates rigidities. Strands that slip bend one by one, strands that stick bend as one bar; real bending is between
 * the two. */
StiffnessEstimate stiffness_estimate(const CableMake *c)
{
    const int known = c->area > 0, cores = known ? c->cores : 1;
    const double d2 = c->diameter * c->diameter, section = PI * d2 / 4, metal = metal_area(c, section);
    const double modulus = STRANDING * WIRE_MODULUS[known ? c->metal : 0];
    const double core2 = 4 * metal / cores / (PI * FILLING); /* square of a conductor's diameter (CS3) */
    const double bar = modulus * metal * core2 / 16, wires = bar * FILLING / WIRES;
    const double plastic = PLASTIC_MODULUS * PI * (d2 * d2 - cores * core2 * core2) / 64;
    const double stuck = bar + plastic, slipping = wires + plastic; /* (CS4) */
    StiffnessEstimate e = {.metal = metal,
                           .ea = modulus * metal + PLASTIC_MODULUS * (section - metal), /* (CS2) */
                           .ei = sqrt(stuck * slipping),                                /* (CS5) */
                           .ei_factor = fmax(BENDING_FACTOR[known], sqrt(stuck / slipping)),
                           .ea_factor = AXIAL_FACTOR[known]};
    e.gj = e.ei / (1 + POISSON);       /* (CS6) */
    e.ga = e.ea / (2 * (1 + POISSON)); /* (CS7) */
    return e;
}
