/* Theory's results for the scene: the tension at the stations and the pull, by the paper's formulas and by the
 * bend ODE. docs/theory.md, "Pulling theory". */
#ifndef HAWSER_THEORY_EXPECTED_H
#define HAWSER_THEORY_EXPECTED_H

#include "def/limits.h"
#include "theory/pulling.h"
#include "theory/setup.h"

typedef struct Expected {
    double from, to; /* m along the route: stretch of cable that theory counts in the middle of the steady window */
    double rope_to;  /* m: end of the rope ahead that lies on the route and counts; `to` if none does */
    double passed;   /* m: cable passes all stations before this during the whole window */
    double start_tension; /* N, at `from` */
    double largest_start; /* N, the largest there in the whole pull, */
    double start_fall;    /* N, largest decrease below it after the first rise */
    int n_steps;
    PullStep *step;     /* [n_steps] owned: the pushes of the setup's pushers, negative */
    double paper_total; /* N, pull on the rope: eq. 10, or without capstan terms along the route if the case has no such
                           formulas */
    double reference_total; /* N, the same by the bend ODE, rope drag included */
} Expected;

/* Fills `out`, and paper_N and reference_N of the n stations (their s must be set; stations off the cable get NAN). The
 * result must be freed with expected_free, also after an error. Errors: as pull_solve. */
hawser_status expected_fill(const Setup *setup, int n, hawser_station *station, Expected *out, hawser_error *err);

/* Computes theory's state with the cable's front at `front` m along the route and the back tension `back` (N) at the
 * tail or of the reel, which turns at full speed; the rope ahead counts as far as it lies on the route. Sets only the
 * stretch, the start tension and the steps. Errors: as pull_solve. */
hawser_status expected_at(const Setup *setup, double front, double back, Expected *out, hawser_error *err);
/* Place up to which the front is followed, m: the route's end, or the winch that takes the rope in. */
double expected_end(const Setup *setup);
/* Checks whether gravity, if any, points straight down, as theory assumes for the slopes of the route. */
int expected_weighs(const SceneDef *def);
/* Checks whether theory follows the cable's front: it does if the chain begins at a reel or is taken in, or if its tail
 * comes in from behind the route's start. */
int expected_follows(const Setup *setup);
/* The case's back tension at time t, N. */
double expected_back(const Setup *setup, double t);
/* Finds the possible places of the front for this, from..to m, by the definition alone; returns 0 if it does not move
 * along the route. */
int expected_range(const Setup *setup, double *from, double *to);

/* Solves the pull of those figures by one of the laws, with the friction of each duct and tray, and separate supports
 * where theory/setup.h finds them; NAN all along if gravity is not vertical. Errors: as pull_solve. */
hawser_status expected_pull(const Setup *setup, const Expected *e, PullLaw law, Pull *pull, hawser_error *err);
/* Tension where the pull begins for this front and back tension, as in expected_at, N. */
double expected_start(const Setup *setup, double front, double back);
/* Finds the largest relief of the winch by the weight of rope ahead of the front, N, while the front moves from its
 * first place to `to`, m along the route (LI11a). Errors: as pull_solve. */
hawser_status expected_relief(const Setup *setup, double to, double *relief, hawser_error *err);
/* Push of the pusher of that name, N; NAN if there is none. name: the definition's own text. */
double expected_push(const Setup *setup, const Expected *e, const char *name);
void expected_free(Expected *e);

/* ---------------------------------------------------------------- what holds back where the route begins */

/* Back tension of the tail or the reel, N. */
const Profile *starts_back(const Setup *setup);
/* Largest speed of winch and script, m/s. */
double starts_fastest(const Setup *setup);

/* Place of the cable's front when its end leaves the drum, m along the route; INFINITY: it never does. */
double starts_leaves(const Setup *setup);
/* Checks whether the cable has left the drum with the front at `front`. */
int starts_left(const Setup *setup, double front);

/* Length of cable behind the route's start that holds back, m, at the front's first place and with the front at the
 * route's end; slides: it lies on supports with friction. */
typedef struct Behind {
    double first, last;
    int slides;
} Behind;
Behind starts_behind(const Setup *setup);

/* Least tension where the route begins, N, if the back tension always had its value at time t. */
double starts_least_at(const Setup *setup, double t);

/* ------------------------------------------------------------------------------------------------------ findings */

/* Builds a finding for the limits: a value at s m along the route, with the place as text. At the border of two pieces
 * the place is on the piece ahead, or on the given one. */
Finding finding_at(const Route *route, double value, double s);
Finding finding_on(const Route *route, double value, double s, int piece);
/* Takes in a rated roller with its load (N) if its share of the rating exceeds the worst so far. */
void finding_load(Finding *worst, const char *roller, double load, double rating);

/* --------------------------------------------------------------------------- bending of the rope */

/* Diameter of the rope, m: as given, or of the thickest rope in the chain; NAN: unknown. */
double rope_diameter(const Setup *setup);
/* Finds the smallest ratio of bending diameter to rope diameter ahead of `head` (m along the route): bends, the map's
 * rollers on this route, and the sheave of the case. */
Finding rope_bend(const Setup *setup, const Route *route, double head, const SupportRoller *roller);

#endif
