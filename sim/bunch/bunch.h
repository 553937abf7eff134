/* Several chains that move together. Each is a scene of its own with its workspace and its equations of motion; one
 * integrator moves them all, and what they do to each other, contact and links, is here. A bunch is a Motion
 * (sim/step/motion.h) whose state is the chains' states, one after the other. docs/model.md, "Several chains". */
#ifndef HAWSER_SIM_BUNCH_BUNCH_H
#define HAWSER_SIM_BUNCH_BUNCH_H

#include "contact/self/self_contact.h"
#include "sim/bunch/links.h"
#include "sim/newton/newton.h"
#include "sim/step/motion.h"

/* One chain of a bunch; borrowed. */
typedef struct BunchChain {
    Scene *scene;
    Workspace *ws;
    Motion *motion; /* its own equations in space, as if it were alone */
    int at;         /* where its state begins in the bunch's */
    int row;        /* the block row of its first segment */
} BunchChain;

/* What the chains do to each other at one moment, by the last evaluation. */
typedef struct Bunch {
    Motion motion; /* first: a Motion is the Bunch that it begins */
    int n;
    BunchChain *chain; /* [n] */
    int coupled;       /* there is contact between them, or a link; 0: each is solved by itself */
    SelfModel contact; /* between them; present: 0 none */
    SelfLine *line;    /* [n] */
    SelfPairs pairs;
    int n_links;
    Link *link;        /* [n_links] */
    BlockPair *linked; /* [n_links] rows */
    double links_lost; /* W, of the last evaluation */
    long refreshes;
    /* of a coupled bunch: the matrix of all, and each chain's part of it */
    Newton whole;
    Newton *part; /* [n] views */
} Bunch;

/* From n chains that are built, with the contact and the links of the first one's definition; their scenes learn who is
 * beside them. Errors: INPUT, MEMORY. The free may follow either way. */
hawser_status bunch_new(Bunch *b, int n, const BunchChain *chain, const LinOptions *options, hawser_error *err);
void bunch_free(Bunch *b);

/* The bunch's state from those of its chains y[n], and back. */
void bunch_gather(const Bunch *b, double *const y[], double *all);
void bunch_scatter(const Bunch *b, const double *all, double *const y[]);

/* The lines of now, for what looks at contacts. */
static inline SelfLines bunch_lines(const Bunch *b) { return (SelfLines){b->n, b->line, 0}; }
/* Adds what the chains do to each other to their loads, for the kinematics in their workspaces. */
void bunch_interact(Bunch *b, double friction);
/* New candidates for contact where something has moved too far, by the kinematics in the workspaces; or always. Errors:
 * MEMORY. */
hawser_status bunch_candidates(Bunch *b, int always, hawser_error *err);
/* K and D of what the chains do to each other, into the matrix of all. */
void bunch_blocks(Bunch *b, double friction);
/* The chain of a row, and its segment there. */
int bunch_chain_of(const Bunch *b, int row, int *segment);

/* Rates of all at (t, y); friction as in dynamics_rates (sim/bunch/bunch_motion.c). */
void bunch_rates(Bunch *b, double t, const double *y, double friction, double *ydot);
/* Derivative blocks of all at (t, y), with the point of linearisation. */
void bunch_linearise(Bunch *b, double t, const double *y, const double *ydot, double friction);
/* Newton's matrix of all for gamma; its factors; b of all becomes the solution. */
void bunch_form(Bunch *b, double gamma);
int bunch_factor(Bunch *b);
int bunch_solve(Bunch *b, double *rhs);
/* As relax_to_equilibrium (sim/bunch/bunch_relax.c). */
hawser_status bunch_relax(Bunch *b, double t, double *y, hawser_relaxation *out, hawser_error *err);
const MotionOps *bunch_ops(void);

/* ---- What the chains do to each other, in figures (sim/bunch/bunch_look.c). */

/* For the kinematics in the workspaces, which have been looked at: forces of rollers and surfaces are there. Leaves
 * what the last evaluation has counted alone. O(segments + contacts). */
void bunch_look(Bunch *b, ChainsLook *out);
/* look->all from its chains, of which all else is known. */
void bunch_sum(ChainsLook *look);
/* What pulls at the head of chain k, N (SC11). */
double bunch_pull(const Bunch *b, int k);

#endif
