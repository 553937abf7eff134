/* Springs between points of two chains: they join heads to a rope, and tie cables together. docs/theory.md, "Several
 * chains" (SC4)-(SC8). */
#ifndef HAWSER_SIM_SOLVE_CHAINS_H
#define HAWSER_SIM_SOLVE_CHAINS_H

#include "contact/self.h"
#include "core/block_chain.h"
#include "core/state.h"
#include "sim/solve/motion.h"
#include "sim/solve/newton.h"

/* A spring and damper, the same in every direction, between a point of one segment and a point of another. */
typedef struct Link {
    int line[2], segment[2]; /* indices of the lines and of their segments */
    Vec3 arm[2];             /* m, from the segments' centres, in their own axes */
    double k, c;             /* N/m, N s/m */
    int head;                /* 1: it joins a head to a rope: its force is that chain's pull */
} Link;

/* Present geometry and force of a link. */
typedef struct LinkNow {
    Vec3 arm[2];  /* m, world */
    Vec3 gap;     /* d, from the second point to the first, m */
    Vec3 at[2];   /* m, from either centre to the middle between the points, where the force acts */
    Vec3 turn[2]; /* angular velocities, rad/s */
    Vec3 speed;   /* m/s, of the first segment relative to the second at that point */
    Vec3 force;   /* N, on the first */
} LinkNow;

LinkNow link_now(const Link *link, const SelfLine *line);
/* Adds the force to loads[line]. */
void link_load(const Link *link, const LinkNow *now, Loads *const loads[]);
/* Adds its derivatives to k and d, of all rows, and those off their diagonals to extras. */
void link_blocks(const Link *link, const SelfLine *line, BlockChain *k, BlockChain *d, BlockExtras *extras);
/* W, dissipated by its damper; J, stored in its spring. */
double link_lost(const Link *link, const LinkNow *now);
double link_energy(const Link *link, const LinkNow *now);
/* Several chains that move together. Each is a scene of its own with its workspace and its equations of motion; one
 * integrator moves them all. Their interaction, contact and links, is here. A Bunch is a Motion (sim/solve/motion.h)
 * whose state is the chains' states, one after the other. docs/theory.md, "Several chains". */

/* One of the chains; borrowed. */
typedef struct BunchChain {
    Scene *scene;
    Workspace *ws;
    Motion *motion; /* its own equations in space, as if it were alone */
    int at;         /* where its state begins in the common one */
    int row;        /* block row of its first segment */
} BunchChain;

/* Interaction of the chains at one moment, by the last evaluation. */
typedef struct Bunch {
    Motion motion; /* first: a pointer to it is one to the Bunch */
    int n;
    BunchChain *chain; /* [n] */
    int coupled;       /* 1: there is contact between them, or a link; 0: each is solved by itself */
    SelfModel contact; /* between them; present: 0 none */
    SelfLine *line;    /* [n] */
    SelfPairs pairs;
    int n_links;
    Link *link;        /* [n_links] */
    BlockPair *linked; /* [n_links] rows */
    double links_lost; /* W, of the last evaluation */
    long refreshes;
    /* of coupled chains: the common matrix, and each chain's part of it */
    Newton whole;
    Newton *part; /* [n] views */
} Bunch;

/* Creates it from n chains that are built, with the contact and the links of the first one's definition; sets the step
 * limit of their scenes. Errors: INPUT, MEMORY. The free may follow either way. */
hawser_status bunch_new(Bunch *b, int n, const BunchChain *chain, const LinOptions *options, hawser_error *err);
void bunch_free(Bunch *b);
/* Assembles the common state from those of the chains y[n]; the second copies it back. */
void bunch_gather(const Bunch *b, double *const y[], double *all);
void bunch_scatter(const Bunch *b, const double *all, double *const y[]);
/* The present lines, for contact searches. */
static inline SelfLines bunch_lines(const Bunch *b) { return (SelfLines){b->n, b->line, 0}; }

/* ---- Figures of the interaction (sim/solve/chains.c). */

/* Finds the figures for the kinematics in the workspaces, after a look at each, which has put the forces of rollers and
 * surfaces there. Leaves the counts of the last evaluation unchanged. O(segments + contacts). */
void bunch_look(Bunch *b, ChainsLook *out);
/* Computes look->all from its chains, whose figures are complete. */
void bunch_sum(ChainsLook *look);
/* Force at the head of chain k, N (SC11). */
double bunch_pull(const Bunch *b, int k);

#endif
