/* What theory says of the scene: the tension at the stations and the pull, by the paper's formulas and by the
 * bend ODE. docs/model.md, "Pulling theory". */
#ifndef HAWSER_THEORY_EXPECTED_H
#define HAWSER_THEORY_EXPECTED_H

#include "def/limits.h"
#include "theory/pulling.h"
#include "theory/setup.h"

typedef struct Expected {
    double from, to;      /* m along the route: the stretch of cable that theory counts, in mid steady window */
    double rope_to;       /* m: up to there rope lies ahead of it on the route and counts; `to` if it does not */
    double passed;        /* m: cable passes all stations before this during the whole window */
    double start_tension; /* N, at `from` */
    double largest_start; /* N, the largest that comes there in the whole pull, whenever that is, */
    double start_fall;    /* N, and by how much that is less at times, once it has risen from where it begins */
    int n_steps;
    PullStep *step;     /* [n_steps] owned: the pushes of the setup's pushers, negative */
    double paper_total; /* N, pull on the rope: eq. 10, or without capstan terms along the route if the case has none */
    double reference_total; /* N, the same by the bend ODE, rope drag included */
} Expected;

/* Fills `out` (to be given back by expected_free, also after an error), and paper_N and reference_N of the n stations
 * (their s must be set; those off the cable get NAN). Errors: as pull_solve. */
hawser_status expected_fill(const Setup *setup, int n, hawser_station *station, Expected *out, hawser_error *err);

/* What theory says with the cable's front at `front` m along the route and the back tension `back` (N) at the tail or
 * of the reel, which turns at the full speed; the rope ahead counts as far as it lies on the route. Only the
 * stretch, the start tension and the steps are set. Errors: as pull_solve. */
hawser_status expected_at(const Setup *setup, double front, double back, Expected *out, hawser_error *err);
/* How far along the route a front is followed, m: to its end, or to the winch that takes the rope in. */
double expected_end(const Setup *setup);
/* Whether gravity, if there is any, points straight down, as theory takes it: its slopes are those of the route. */
int expected_weighs(const SceneDef *def);
/* Whether theory follows the cable's front, as it does where the chain begins at a reel or is taken in, and where its
 * tail comes in from behind the route's start. */
int expected_follows(const Setup *setup);
/* The case's back tension at time t, N. */
double expected_back(const Setup *setup, double t);
/* Where the front may be for that, as far as the definition goes: from..to m; 0 if it does not move along the route. */
int expected_range(const Setup *setup, double *from, double *to);

/* The pull behind those figures by one of the laws, each duct and tray with its own friction, separate supports where
 * theory/setup.h finds them; NAN all along where gravity is aslant. Errors: as pull_solve. */
hawser_status expected_pull(const Setup *setup, const Expected *e, PullLaw law, Pull *pull, hawser_error *err);
/* The tension where the pull begins with the front at `front` and that back tension, as expected_at has it, N. */
double expected_start(const Setup *setup, double front, double back);
/* N, by which rope ahead of the front takes its tension off the winch by its own weight, while the front goes from
 * where it begins to `to`, m along the route: the most of it (LI11a). Errors: as pull_solve. */
hawser_status expected_relief(const Setup *setup, double to, double *relief, hawser_error *err);
/* What the pusher of that name, the definition's own text, is reckoned to push with, N; NAN if there is none. */
double expected_push(const Setup *setup, const Expected *e, const char *name);
void expected_free(Expected *e);

/* ---------------------------------------------------------------- what holds back where the route begins */

/* Of the tail or the reel, N. */
const Profile *starts_back(const Setup *setup);
/* The fastest that winch and script pull, m/s. */
double starts_fastest(const Setup *setup);

/* Where the cable's front is when its end leaves the drum, m along the route; INFINITY: it never does. */
double starts_leaves(const Setup *setup);
/* Whether it has left it with the front there. */
int starts_left(const Setup *setup, double front);

/* How much cable lies behind the route's start, m, when the front begins to move and when it is at the route's end, of
 * what holds the cable back at all; and whether on supports with friction. */
typedef struct Behind {
    double first, last;
    int slides;
} Behind;
Behind starts_behind(const Setup *setup);

/* The least tension where the route begins, N, were the back tension always what it is at time t. */
double starts_least_at(const Setup *setup, double t);

/* ------------------------------------------------------------------------------------------------------ findings */

/* For limits: a value that was found at s m along the route, with the place in words; at the end of a piece that of the
 * piece ahead, or of the one that is meant. */
Finding finding_at(const Route *route, double value, double s);
Finding finding_on(const Route *route, double value, double s, int piece);
/* Takes the rated roller with this load (N) in, if it has more of its rating than the worst so far. */
void finding_load(Finding *worst, const char *roller, double load, double rating);

/* --------------------------------------------------------------------------- what bends the rope: rope_bend.c */

/* The rope's diameter, m: as the case says, or of the thickest rope in the chain, which may be one; NAN: nobody knows.
 */
double rope_diameter(const Setup *setup);
/* The smallest diameter that the rope is bent round ahead of `head` (m along the route), over its own: of bends, of the
 * map's rollers, where they are on this route, of the sheave that the case names. */
Finding rope_bend(const Setup *setup, const Route *route, double head, const SupportRoller *roller);

#endif
