/* Pulling tensions in closed form: straights, slopes, bends in a level and in a vertical plane, rollers. Each
 * says where it holds and refuses, with a reason, where it does not. docs/theory.md, "Pulling theory",
 * (T9)-(T17). T1, T2: tension in and out, N; w: weight, N/m; mu: friction; R: radius, m; angles rad. *T2 is
 * written only on HAWSER_OK; every error is HAWSER_ERR_INPUT. */
#ifndef HAWSER_THEORY_CLOSED_FORM_H
#define HAWSER_THEORY_CLOSED_FORM_H

#include "core/route.h"
#include "def/output_def.h"

/* T1 + w L (mu cos + sin), slope up positive; the level straight is slope 0. (T9) Never refuses: T2 < 0 means
 * that the cable has to be held back. */
double slope_tension(double T1, double w, double mu, double length, double slope);
/* T1 exp(mu turn): a bend whose weight does not count. (T10) */
double capstan_tension(double T1, double mu, double turn);
/* A level bend: T1 cosh(mu turn) + sinh(mu turn) sqrt(T1^2 + (w R)^2). Refuses T1 < 0. (T11) */
hawser_status bend_level_tension(double T1, double w, double mu, double R, double turn, double *T2, hawser_error *err);
/* A level bend whose weight and turning force rest on separate supports: (T1 + w R) exp(mu turn) - w R. Refuses T1 < 0.
 * (LI2) */
hawser_status bend_separate_tension(double T1, double w, double mu, double R, double turn, double *T2,
                                    hawser_error *err);
/* Bends in a vertical plane that begin or end level. */
typedef enum VerticalBend { SAG_LEVEL_UP, CREST_UP_LEVEL, CREST_LEVEL_DOWN, SAG_DOWN_LEVEL } VerticalBend;

/* (T12)-(T15). Refuse: turn > pi/2, T1 < 0 or T2 < 0, and sags in which the cable does not bear on the inner
 * side throughout, T > w R cos(slope). */
hawser_status bend_vertical_tension(VerticalBend kind, double T1, double w, double mu, double R, double turn,
                                    double *T2, hawser_error *err);
/* (T16): any bend in a vertical plane, from slope a to slope b (rad, within +-pi/2; b > a is a sag),
 * whichever side the cable bears on; where a sag's normal force changes sign the arc is cut there. Refuses T
 * < 0 at either end. */
hawser_status bend_any_vertical_tension(double T1, double w, double mu, double R, double a, double b, double *T2,
                                        hawser_error *err);
/* The same part by part: a sag's normal force changes sign at most twice. Sets slopes, the side on which the cable
 * bears (1: the inner one) and tensions in and out, whatever their signs. Returns the number of parts. */
enum { VERTICAL_PARTS = 3 };

typedef struct VerticalPart {
    double from, to, side, in, out;
} VerticalPart;

int bend_vertical_parts(double T1, double w, double mu, double R, double a, double b,
                        VerticalPart part[VERTICAL_PARTS]);
/* (T16): the particular solution at a slope, m = k mu side; k = 1 in a sag, -1 over a crest. */
double bend_vertical_particular(double w, double R, double k, double m, double slope);
/* One roller over which a weightless cable turns by `turn`: T1 (1 + mu tan(turn/2)) / (1 - mu tan(turn/2));
 * refuses where it locks, mu tan(turn/2) >= 1. (T17) */
hawser_status roller_tension(double T1, double mu, double turn, double *T2, hawser_error *err);
/* Size of the force on a roller between tensions T1 and T2 that turn by `turn`, N. (T18) */
double roller_load(double T1, double T2, double turn);
/* Orientation of a piece of a route: level and vertical-plane bends have closed forms, other turns have none. */
typedef enum PieceLie { LIES_STRAIGHT, LIES_LEVEL, LIES_UPRIGHT, LIES_OTHERWISE } PieceLie;

PieceLie piece_lie(const RoutePiece *piece);
/* Computes the slopes (rad) at which a bend in a vertical plane is entered and left: the tangent's vertical component
 * gives their size, the side of the centre whether the slope rises. */
void piece_slopes(const RoutePiece *piece, int direction, double *a, double *b);
/* Applies the closed form that fits a piece of a route, pulled toward growing s (direction +1) or back (-1), with or
 * without separate supports. Refuses bends that are neither level nor in a vertical plane, and what the functions above
 * refuse. */
hawser_status piece_tension(const RoutePiece *piece, int direction, double T1, double w, double mu, int separate,
                            double *T2, hawser_error *err);
/* The paper's tension formulas, its eq. 3-10: the pull is a sum of terms along the path, without capstan
 * effect. docs/theory.md, "Pulling theory", (T1)-(T4). Units: W kg/m (as in the paper), g m/s2, forces N. */

/* The term's force, N: eq. 3 and 9 for reel and rope, eq. 4 and 6-8 for slopes, eq. 5 for arcs. */
double paper_term_force(const PaperTermDef *term, double W, double mu, double g);
/* Length of path that the term covers, m; 0 for reel and rope. */
double paper_term_path(const PaperTermDef *term);
/* Eq. 10: the sum of n terms, N. */
double paper_total(int n, const PaperTermDef *term, double W, double mu, double g);
/* Tension in the cable at arc length s (m) from where the terms' path begins, N: all of every reel term, the
 * path up to s (linear inside a slope, exact inside an arc), never the rope. s outside the path is taken at
 * its nearer end. */
double paper_tension(int n, const PaperTermDef *term, double W, double mu, double g, double s);

#endif
