/* MuJoCo's side of the comparison. Usage and row: run.h. Settings and what they are without being given:
 *
 *   as=pieces         springs: how the segments are held together (mujoco_model.h)
 *   piece=60          segments of a tree, 1: all are bodies of their own (MuJoCo reads XML less than 100 levels deep)
 *   joints=universal  ball: of the chain's trees
 *   dt=1e-3           s, the time step (MuJoCo has fixed ones)
 *   integrator=Euler  RK4 or implicit
 *   solver=Newton     CG or PGS; iterations=100, tolerance=1e-8, cone=elliptic, impratio=1, jacobian=auto
 *   contact_time=5e-3 s, solref of contacts; link_time=2 dt of connect constraints; impedance=0.99: solimp of both
 *   stiff=1           springs: share of table 1's stiffness
 *   damping=1e-3      s: damping over stiffness of bending springs (pieces), of all springs (springs) */
#include "bench/peers/mujoco_model.h"

/* MuJoCo's call-backs know the model and its data only: what else they need. */
static struct {
    PeerProblem problem;
    int n, first, winch, close; /* body of segment 0; constraints: of the winch, the last of the chain's; -1: none */
    Formulation as;
    double k[3], c[3]; /* springs: axial, shear (N/m), bending (N m/rad), and their damping */
    double value;      /* N: tension of the last spring */
    double (*half)[3]; /* [n], of the chain's links in their bodies' axes */
} now;

/* MuJoCo's constraints are implicit in the velocities, so that the winch is one: on the head's place along x. */
static void move_winch(const mjModel *m, const mjData *d)
{
    if (now.winch >= 0) m->eq_data[mjNEQDATA * now.winch] = straight_travel(d->time);
}

/* The wrench of a joint between segments i and i + 1 in the plane: the gap of their ends in the axes half-way, and the
 * angle. State of a segment: x, z, angle about y (from x toward -z). */
static void add_planar_spring(mjData *d, int i)
{
    const double *const q = d->qpos + 3 * i, *const v = d->qvel + 3 * i, r = PEER_LINK / 2;
    const double ca = r * cos(q[2]), sa = r * sin(q[2]), cb = r * cos(q[5]), sb = r * sin(q[5]);
    const double gap[2] = {q[3] - q[0] + PEER_LINK - ca - cb, q[4] - q[1] + sa + sb};
    const double rate[2] = {v[3] - v[0] + sa * v[2] + sb * v[5], v[4] - v[1] + ca * v[2] + cb * v[5]};
    const double c = cos((q[2] + q[5]) / 2), s = sin((q[2] + q[5]) / 2);
    const double along = now.k[0] * (c * gap[0] - s * gap[1]) + now.c[0] * (c * rate[0] - s * rate[1]);
    const double across = now.k[1] * (s * gap[0] + c * gap[1]) + now.c[1] * (s * rate[0] + c * rate[1]);
    const double fx = c * along + s * across, fz = -s * along + c * across;
    const double moment = now.k[2] * (q[5] - q[2]) + now.c[2] * (v[5] - v[2]);
    double *const f = d->qfrc_passive + 3 * i;
    f[0] += fx;
    f[1] += fz;
    f[2] += moment - sa * fx - ca * fz;
    f[3] -= fx;
    f[4] -= fz;
    f[5] -= moment + sb * fx + cb * fz;
}

/* The place and velocity of an end of link i (sign 1: the front one), and its arm from the centre. */
static void end_of(const mjModel *m, const mjData *d, int i, double sign, double *place, double *velocity, double *arm)
{
    const int body = now.first + i, at = m->body_dofadr[body];
    double omega[3], turn[3];
    mju_rotVecMat(arm, now.half[i], d->xmat + 9 * body);
    mju_scl3(arm, arm, sign);
    mju_rotVecMat(omega, d->qvel + at + 3, d->xmat + 9 * body);
    mju_cross(turn, omega, arm);
    mju_add3(place, d->xpos + 3 * body, arm);
    mju_add3(velocity, d->qvel + at, turn);
}

/* Adds a force at an arm from link i's centre; a free joint's moments are in the body's axes. */
static void add_force(const mjModel *m, mjData *d, int i, const double *arm, const double *force, double sign)
{
    const int body = now.first + i, at = m->body_dofadr[body];
    double moment[3], local[3];
    mju_cross(moment, arm, force);
    mju_rotVecMatT(local, moment, d->xmat + 9 * body);
    mju_addToScl3(d->qfrc_passive + at, force, sign);
    mju_addToScl3(d->qfrc_passive + at + 3, local, sign);
}

/* The hinge at joint j between links j - 1 and j, or a link and the ground: a spring alike in all directions. */
static void add_chain_spring(const mjModel *m, mjData *d, int j)
{
    double a[3] = {0}, va[3] = {0}, arm_a[3], b[3] = {chain_span(now.n), 0, 0}, vb[3] = {0}, arm_b[3], force[3];
    if (j > 0) end_of(m, d, j - 1, 1, a, va, arm_a);
    if (j < now.n) end_of(m, d, j, -1, b, vb, arm_b);
    for (int c = 0; c < 3; ++c) force[c] = now.k[0] * (b[c] - a[c]) + now.c[0] * (vb[c] - va[c]);
    if (j > 0) add_force(m, d, j - 1, arm_a, force, 1);
    if (j < now.n) add_force(m, d, j, arm_b, force, -1);
    now.value = force[0];
}

/* MuJoCo calls this for forces of its own kind (joint springs and the like): it is where a user's springs go. */
static void passive(const mjModel *m, mjData *d)
{
    if (now.as != AS_SPRINGS) return;
    if (now.problem == PEER_STRAIGHT) {
        for (int i = 0; i + 1 < now.n; ++i) add_planar_spring(d, i);
    } else {
        for (int j = 0; j <= now.n; ++j) add_chain_spring(m, d, j);
    }
}

/* The force of a constraint, along x if it has several components; on the head it is positive when it pulls. */
static double constraint_force(const mjData *d, int which)
{
    for (int i = 0; i < d->ne; ++i) {
        if (d->efc_type[i] == mjCNSTR_EQUALITY && d->efc_id[i] == which) return d->efc_force[i];
    }
    return NAN;
}

/* Takes what the problem is judged by out of the step that was just made; its forces are those of time t. */
static void look(PeerRun *run, const mjData *d, double t)
{
    if (run->problem == PEER_STRAIGHT) peer_force(run, t, constraint_force(d, now.winch));
    if (run->problem == PEER_HANG)
        peer_force(run, t, now.close >= 0 ? fabs(constraint_force(d, now.close)) : now.value);
    if (run->problem != PEER_SWING) return;
    const int i = chain_middle_segment(run->n), body = now.first + i;
    double place[3], arm[3];
    mju_rotVecMat(arm, now.half[i], d->xmat + 9 * body);
    mju_addScl3(place, d->xipos + 3 * body, arm, 2 * chain_middle_arm(run->n) / PEER_LINK);
    peer_place(run, t, place[1], place[2]);
}

/* The defaults are those of the comment above. */
static Settings read_settings(PeerRun *run)
{
    Settings s;
    s.as = strcmp(peer_word(run, "as", "pieces"), "springs") == 0 ? AS_SPRINGS : AS_PIECES;
    const double piece = s.as == AS_SPRINGS ? 1 : peer_number(run, "piece", 60);
    s.piece = (int)fmax(1, fmin(piece, run->n));
    s.dt = peer_number(run, "dt", 1e-3);
    s.integrator = peer_word(run, "integrator", "Euler");
    s.solver = peer_word(run, "solver", "Newton");
    s.cone = peer_word(run, "cone", "elliptic");
    s.jacobian = peer_word(run, "jacobian", "auto");
    s.iterations = (int)peer_number(run, "iterations", 100);
    s.tolerance = peer_number(run, "tolerance", 1e-8);
    s.impratio = peer_number(run, "impratio", 1);
    s.contact_time = peer_number(run, "contact_time", 5e-3);
    s.link_time = peer_number(run, "link_time", 2 * s.dt);
    s.impedance = peer_number(run, "impedance", 0.99);
    s.ball = strcmp(peer_word(run, "joints", "universal"), "ball") == 0;
    s.stiff = peer_number(run, "stiff", 1);
    s.damping = peer_number(run, "damping", 1e-3);
    return s;
}

/* What the call-backs need; 0 without memory. */
static int prepare(PeerRun *run, const mjModel *m, const Settings *s)
{
    const int n = run->n;
    now.problem = run->problem;
    now.n = n;
    now.as = s->as;
    now.first = mj_name2id(m, mjOBJ_BODY, "s0");
    now.winch = mj_name2id(m, mjOBJ_EQUALITY, "winch");
    now.close = mj_name2id(m, mjOBJ_EQUALITY, "close");
    now.k[0] = s->stiff * PEER_E * PEER_AREA / PEER_LINK;
    now.k[1] = s->stiff * PEER_G * PEER_AREA / PEER_LINK;
    now.k[2] = PEER_E * peer_second_moment() / PEER_LINK;
    for (int c = 0; c < 3; ++c) now.c[c] = s->damping * now.k[c];
    double *const joint = malloc(3 * ((size_t)n + 1) * sizeof *joint);
    now.half = calloc((size_t)n, sizeof *now.half);
    if (joint && now.half) {
        chain_joints(n, chain_angle(run->problem), joint);
        for (int k = 0; k < 3 * n; ++k) now.half[k / 3][k % 3] = (joint[k + 3] - joint[k]) / 2;
    }
    free(joint);
    return joint && now.half;
}

/* The model of an XML text, through a file that exists in memory only; NULL: *why says why. */
static mjModel *compile(const char *xml, char *why, int room)
{
    static mjVFS files;
    const size_t length = strlen(xml);
    mj_defaultVFS(&files);
    if (mj_makeEmptyFileVFS(&files, "model.xml", (int)length) != 0) return NULL;
    memcpy(files.filedata[0], xml, length);
    mjModel *const m = mj_loadXML("model.xml", &files, why, room);
    mj_deleteVFS(&files);
    return m;
}

/* MuJoCo mends states that are not finite by starting again: such a run has failed. */
static int is_broken(const mjData *d)
{
    return d->warning[mjWARN_BADQPOS].number || d->warning[mjWARN_BADQVEL].number ||
           d->warning[mjWARN_BADQACC].number || d->warning[mjWARN_CNSTRFULL].number ||
           d->warning[mjWARN_CONTACTFULL].number;
}

/* Steps of fixed size; a force is that of the state before the step. The run goes one step beyond its end, for the
 * path's last point. */
static void integrate(PeerRun *run, const mjModel *m, mjData *d)
{
    long steps = 0;
    peer_loop(run);
    while (d->time < run->until + m->opt.timestep / 2 && !peer_over_limit(run) && !is_broken(d)) {
        const double t = d->time;
        move_winch(m, d);
        mj_step(m, d);
        look(run, d, t);
        ++steps;
    }
    if (run->problem == PEER_SWING) look(run, d, d->time);
    peer_finish(run, d->time, steps, is_broken(d));
}

int main(int argc, char **argv)
{
    static PeerRun run;
    char why[1000] = "no memory";
    peer_start(&run, "mujoco", argc, argv);
    const Settings s = read_settings(&run);
    char *const xml = model_xml(run.problem, run.n, &s);
    mjModel *const m = xml ? compile(xml, why, sizeof why) : NULL;
    free(xml);
    if (!m) peer_stop(&run, "cannot make the model:", why);
    mjData *const d = mj_makeData(m);
    if (!d || !prepare(&run, m, &s)) peer_stop(&run, "cannot make the model:", "no memory");
    mjcb_passive = passive;
    integrate(&run, m, d);
    mj_deleteData(d);
    mj_deleteModel(m);
    free(now.half);
    return 0;
}
