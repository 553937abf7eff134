/* Springs between points of two chains: what joins heads to a rope, and what ties cables together. docs/model.md,
 * "Several chains" (SC4)-(SC8). */
#ifndef HAWSER_SIM_SOLVE_CHAINS_H
#define HAWSER_SIM_SOLVE_CHAINS_H

#include "contact/self.h"
#include "core/block_chain.h"
#include "core/state.h"
#include "sim/solve/motion.h"
#include "sim/solve/newton.h"

/* A spring and damper, the same in every direction, between a point of one segment and a point of another. */
typedef struct Link {
    int line[2], segment[2]; /* of which lines, and their segments */
    Vec3 arm[2];             /* m, from the segments' centres, in their own axes */
    double k, c;             /* N/m, N s/m */
    int head;                /* it joins a head to a rope: what it carries is that chain's pull */
} Link;

/* What a link does now. */
typedef struct LinkNow {
    Vec3 arm[2];  /* m, world */
    Vec3 gap;     /* d, from the second point to the first, m */
    Vec3 at[2];   /* m, from either centre to the middle between the points, where the force acts */
    Vec3 turn[2]; /* angular velocities, rad/s */
    Vec3 speed;   /* of the first segment against the second there, m/s */
    Vec3 force;   /* N, on the first */
} LinkNow;

LinkNow link_now(const Link *link, const SelfLine *line);
/* Adds it to loads[line]. */
void link_load(const Link *link, const LinkNow *now, Loads *const loads[]);
/* Adds its derivatives to k and d, of all rows, and off their diagonals to extras. */
void link_blocks(const Link *link, const SelfLine *line, BlockChain *k, BlockChain *d, BlockExtras *extras);
/* W, what its damper takes; J, what its spring holds. */
double link_lost(const Link *link, const LinkNow *now);
double link_energy(const Link *link, const LinkNow *now);
/* Several chains that move together. Each is a scene of its own with its workspace and its equations of motion; one
 * integrator moves them all, and what they do to each other, contact and links, is here. A bunch is a Motion
 * (sim/solve/motion.h) whose state is the chains' states, one after the other. docs/model.md, "Several chains". */

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

/* ---- What the chains do to each other, in figures (sim/solve/chains.c). */

/* For the kinematics in the workspaces, which have been looked at: forces of rollers and surfaces are there. Leaves
 * what the last evaluation has counted alone. O(segments + contacts). */
void bunch_look(Bunch *b, ChainsLook *out);
/* look->all from its chains, of which all else is known. */
void bunch_sum(ChainsLook *look);
/* What pulls at the head of chain k, N (SC11). */
double bunch_pull(const Bunch *b, int k);

#endif
