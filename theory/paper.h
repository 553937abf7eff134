/* The paper's tension formulas, its eq. 3-10: the pull is a sum of terms along the path, without capstan
 * effect. docs/model.md, "Pulling theory", (T1)-(T4). Units: W kg/m (as in the paper), g m/s2, forces N. */
#ifndef HAWSER_THEORY_PAPER_H
#define HAWSER_THEORY_PAPER_H

#include "def/output_def.h"

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
