/* MuJoCo 2.2.2 knows models as XML only (its functions for editing one in memory came later), so the XML is written
 * here, into memory. It is read by a parser that takes no more than a hundred levels of elements, which bounds the
 * depth of a tree. */
#include "bench/peers/mujoco_model.h"

#include <stdarg.h>

/* Text that grows; at < 0 once there was no memory. */
typedef struct Text {
    char *data;
    long at, room;
} Text;

/* Appends one formatted piece, shorter than 1 kB. */
__attribute__((format(printf, 2, 3))) static void put(Text *text, const char *format, ...)
{
    va_list list;
    if (text->at < 0) return;
    if (text->at + 1024 > text->room) {
        text->room = 2 * text->room + 4096;
        char *const more = realloc(text->data, (size_t)text->room);
        if (!more) {
            text->at = -1;
            return;
        }
        text->data = more;
    }
    va_start(list, format);
    text->at += vsnprintf(text->data + text->at, 1024, format, list);
    va_end(list);
}

/* Segments of trees: piece j is from .. to, rooted at `root`. */
typedef struct Piece {
    int from, to, root;
} Piece;

static int pieces_of(int n, const Settings *s) { return (n + s->piece - 1) / s->piece; }

/* The pull's last piece is rooted at the head, which the winch holds; the chain's outer ones at the supports. */
static Piece piece_of(PeerProblem problem, int n, const Settings *s, int j)
{
    Piece p = {.from = j * s->piece, .to = (j + 1) * s->piece - 1};
    if (p.to > n - 1) p.to = n - 1;
    p.root = (p.from + p.to + 1) / 2;
    if (p.to == n - 1) p.root = n - 1;
    if (problem != PEER_STRAIGHT && j == 0) p.root = 0;
    return p;
}

/* Rows of constraints that the problem can have, with room to spare; MuJoCo allocates for as many. */
static int rows_of(PeerProblem problem, int n, const Settings *s)
{
    const int contacts = problem == PEER_STRAIGHT ? 8 * straight_rollers(n) : 0;
    return 64 + contacts + (s->as == AS_PIECES ? 6 * (pieces_of(n, s) + 1) : 0);
}

/* Options, sizes and defaults. The stack is MuJoCo's for dense matrices of all speeds (nv) and rows of constraints;
 * collision is looked for between the pairs alone that put_pairs names. solref of a positive pair is time constant and
 * damping ratio. */
static void put_head(Text *text, PeerProblem problem, int n, const Settings *s)
{
    const int rows = rows_of(problem, n, s), trees = s->as == AS_PIECES ? pieces_of(n, s) : n;
    const double nv = problem == PEER_STRAIGHT ? n + 2. * trees : 3. * (n + trees);
    put(text,
        "<mujoco><compiler angle=\"radian\" coordinate=\"local\"/>\n<option timestep=\"%.9g\" gravity=\"0 0 %.9g\" ",
        s->dt, -PEER_GRAVITY);
    put(text, "integrator=\"%s\" solver=\"%s\" cone=\"%s\" jacobian=\"%s\" iterations=\"%d\" ", s->integrator,
        s->solver, s->cone, s->jacobian, s->iterations);
    put(text, "tolerance=\"%.9g\" impratio=\"%.9g\" collision=\"predefined\"/>\n", s->tolerance, s->impratio);
    put(text, "<size njmax=\"%d\" nconmax=\"%d\" nstack=\"%.0f\"/>\n", rows, rows / 3 + 8,
        2e6 + 6 * nv * nv + 6. * rows * (rows + nv));
    put(text, "<default><equality solref=\"%.9g 1\" solimp=\"%.9g %.9g 0.001\"/></default>\n<worldbody>\n",
        s->link_time, s->impedance, s->impedance);
}

/* Mass and inertia of a segment whose centre is at `centre` of its body, along `axis`. */
static void put_inertia(Text *text, const double *centre, const double *axis)
{
    const double across = peer_inertia_across();
    put(text,
        "<inertial mass=\"%.9g\" pos=\"%.15g %.15g %.15g\" zaxis=\"%.15g %.15g %.15g\" diaginertia=\"%.9g %.9g "
        "%.9g\"/>",
        PEER_MASS, centre[0], centre[1], centre[2], axis[0], axis[1], axis[2], across, across, peer_inertia_along());
}

/* A segment of the pull: a capsule as long as the segment, caps beyond. */
static void put_capsule(Text *text, int i)
{
    static const double zero[3] = {0, 0, 0}, x[3] = {1, 0, 0};
    put_inertia(text, zero, x);
    put(text, "<geom name=\"g%d\" type=\"capsule\" fromto=\"%.9g 0 0 %.9g 0 0\" size=\"%.9g\"/>", i, -PEER_LINK / 2,
        PEER_LINK / 2, PEER_DIAMETER / 2);
}

/* The three joints of a body that moves in the plane y = 0. */
static void put_planar_joints(Text *text, int i)
{
    put(text, "<joint name=\"x%d\" type=\"slide\" axis=\"1 0 0\"/><joint name=\"z%d\" type=\"slide\" axis=\"0 0 1\"/>",
        i, i);
    put(text, "<joint name=\"a%d\" type=\"hinge\" axis=\"0 1 0\"/>", i);
}

/* A branch of one of the pull's trees from segment `from` in direction step to segment `to`: each body in the one
 * before, with the bending spring EI/h at the hinge. */
static void put_branch(Text *text, int from, int to, int step, const Settings *s)
{
    const double k = PEER_E * peer_second_moment() / PEER_LINK;
    for (int i = from; i != to + step; i += step) {
        put(text, "<body name=\"s%d\" pos=\"%.9g 0 0\"><joint type=\"hinge\" axis=\"0 1 0\" pos=\"%.9g 0 0\" ", i,
            step * PEER_LINK, -step * PEER_LINK / 2);
        put(text, "stiffness=\"%.9g\" damping=\"%.9g\"/>", k, s->damping * k);
        put_capsule(text, i);
        put(text, "\n");
    }
    for (int i = from; i != to + step; i += step) put(text, "</body>");
}

/* One tree of the pull: its root may move in the plane, branches go both ways. Joint values are 0 at t = 0. */
static void put_pull_piece(Text *text, Piece p, const Settings *s)
{
    put(text, "<body name=\"s%d\" pos=\"%.15g 0 0\">", p.root, straight_joint_x(p.root) + PEER_LINK / 2);
    put_planar_joints(text, p.root);
    put_capsule(text, p.root);
    put_branch(text, p.root - 1, p.from, -1, s);
    put_branch(text, p.root + 1, p.to, 1, s);
    put(text, "</body>\n");
}

/* Capsules across the cable. */
static void put_rollers(Text *text, int n)
{
    for (int k = 0; k < straight_rollers(n); ++k) {
        put(text, "<geom name=\"r%d\" type=\"capsule\" size=\"%.9g\" ", k, ROLLER_RADIUS);
        put(text, "fromto=\"%.15g %.9g %.15g %.15g %.9g %.15g\"/>\n", straight_roller_x(k), -ROLLER_WIDTH / 2,
            straight_roller_z(), straight_roller_x(k), ROLLER_WIDTH / 2, straight_roller_z());
    }
}

/* Pairs of segment and roller that can meet while the cable moves. */
static void put_pairs(Text *text, int n, const Settings *s)
{
    const double travel = straight_travel(WINDOW_TO), near = PEER_LINK / 2 + PEER_DIAMETER / 2 + ROLLER_RADIUS;
    put(text, "<contact>\n");
    for (int i = 0; i < n; ++i) {
        const double centre = straight_joint_x(i) + PEER_LINK / 2;
        for (int k = 0; k < straight_rollers(n); ++k) {
            if (straight_roller_x(k) < centre - near || straight_roller_x(k) > centre + travel + near) continue;
            put(text, "<pair geom1=\"g%d\" geom2=\"r%d\" condim=\"3\" friction=\"%.9g %.9g\" ", i, k, PEER_MU, PEER_MU);
            put(text, "solref=\"%.9g 1\" solimp=\"%.9g %.9g 0.001\"/>\n", s->contact_time, s->impedance, s->impedance);
        }
    }
    put(text, "</contact>\n");
}

/* Trees go on straight into each other: single segments meet at their ends and turn alike, longer pieces are welded.
 * The winch holds the head. */
static void put_pull_joints(Text *text, int n, const Settings *s)
{
    put(text, "<equality>\n");
    for (int j = 0; s->as == AS_PIECES && j + 1 < pieces_of(n, s); ++j) {
        const int i = piece_of(PEER_STRAIGHT, n, s, j).to;
        if (s->piece > 1) {
            put(text, "<weld body1=\"s%d\" body2=\"s%d\"/>\n", i, i + 1);
            continue;
        }
        put(text, "<connect body1=\"s%d\" body2=\"s%d\" anchor=\"%.9g 0 0\"/>", i, i + 1, PEER_LINK / 2);
        put(text, "<joint joint1=\"a%d\" joint2=\"a%d\"/>\n", i, i + 1);
    }
    put(text, "<joint name=\"winch\" joint1=\"x%d\"/>\n</equality>\n", n - 1);
}

/* Half of the link (or minus it), and its direction, in the world's axes, which are those of every body at t = 0. */
static void half_link(const double *joint, int i, double sign, double *half, double *axis)
{
    for (int c = 0; c < 3; ++c) {
        half[c] = sign * (joint[3 * i + 3 + c] - joint[3 * i + c]) / 2;
        axis[c] = 2 * half[c] / PEER_LINK;
    }
}

/* A link turns about the near end by a ball joint, or by two hinges across it: it has no reason to spin. */
static void put_link_joints(Text *text, const double *axis, int ball)
{
    if (ball) {
        put(text, "<joint type=\"ball\"/>");
        return;
    }
    const double size = hypot(axis[0], axis[2]), first[3] = {axis[2] / size, 0, -axis[0] / size};
    const double second[3] = {axis[1] * first[2], axis[2] * first[0] - axis[0] * first[2], -axis[1] * first[0]};
    put(text, "<joint type=\"hinge\" axis=\"%.15g %.15g %.15g\"/>", first[0], first[1], first[2]);
    put(text, "<joint type=\"hinge\" axis=\"%.15g %.15g %.15g\"/>", second[0], second[1], second[2]);
}

/* Links from `from` to `to` hanging on each other, the first at `place` of what it hangs on; a body's origin is at its
 * end toward the root. */
static void put_links(Text *text, const double *joint, int from, int to, int step, const double *first, int ball)
{
    double place[3] = {first[0], first[1], first[2]};
    for (int i = from; i != to + step; i += step) {
        double half[3], axis[3];
        half_link(joint, i, step, half, axis);
        put(text, "<body name=\"s%d\" pos=\"%.15g %.15g %.15g\">", i, place[0], place[1], place[2]);
        put_link_joints(text, axis, ball);
        put_inertia(text, half, axis);
        put(text, "\n");
        for (int c = 0; c < 3; ++c) place[c] = 2 * half[c];
    }
    for (int i = from; i != to + step; i += step) put(text, "</body>");
    put(text, "\n");
}

/* A tree of links: from a support, or from a link of its own that is free. */
static void put_chain_piece(Text *text, const double *joint, int n, Piece p, int ball)
{
    static const double zero[3] = {0, 0, 0};
    double half[3], axis[3], front[3];
    if (p.root == 0) {
        put_links(text, joint, 0, p.to, 1, joint, ball);
        return;
    }
    if (p.root == n - 1) {
        put_links(text, joint, n - 1, p.from, -1, joint + 3 * n, ball);
        return;
    }
    half_link(joint, p.root, 1, half, axis);
    for (int c = 0; c < 3; ++c) front[c] = 2 * half[c];
    put(text, "<body name=\"s%d\" pos=\"%.15g %.15g %.15g\"><freejoint/>", p.root, joint[3 * p.root],
        joint[3 * p.root + 1], joint[3 * p.root + 2]);
    put_inertia(text, half, axis);
    put_links(text, joint, p.root - 1, p.from, -1, zero, ball);
    put_links(text, joint, p.root + 1, p.to, 1, front, ball);
    put(text, "</body>\n");
}

/* Every link a body of its own with all freedom, its origin at its centre: for springs. */
static void put_chain_bodies(Text *text, const double *joint, int n)
{
    static const double zero[3] = {0, 0, 0};
    for (int i = 0; i < n; ++i) {
        double half[3], axis[3];
        half_link(joint, i, 1, half, axis);
        put(text, "<body name=\"s%d\" pos=\"%.15g %.15g %.15g\"><freejoint/>", i, joint[3 * i] + half[0],
            joint[3 * i + 1] + half[1], joint[3 * i + 2] + half[2]);
        put_inertia(text, zero, axis);
        put(text, "</body>\n");
    }
}

/* Pieces meet at the front end of each one's last link, whose origin is there or at its other end; a whole chain in one
 * tree meets the support. */
static void put_chain_joints(Text *text, PeerProblem problem, const double *joint, int n, const Settings *s)
{
    const int last = pieces_of(n, s) - (s->piece < n ? 2 : 1);
    put(text, "<equality>\n");
    for (int j = 0; j <= last; ++j) {
        const Piece p = piece_of(problem, n, s, j);
        double half[3], axis[3];
        half_link(joint, p.to, p.to < p.root ? 0 : 2, half, axis);
        put(text, "<connect %s body1=\"s%d\" ", j == last ? "name=\"close\"" : "", p.to);
        if (p.to + 1 < n) put(text, "body2=\"s%d\" ", p.to + 1);
        put(text, "anchor=\"%.15g %.15g %.15g\"/>\n", half[0], half[1], half[2]);
    }
    put(text, "</equality>\n");
}

/* The chain's bodies and what joins them. */
static void put_chain(Text *text, PeerProblem problem, int n, const Settings *s)
{
    double *const joint = malloc(3 * ((size_t)n + 1) * sizeof *joint);
    if (!joint) {
        text->at = -1;
        return;
    }
    chain_joints(n, chain_angle(problem), joint);
    for (int j = 0; s->as == AS_PIECES && j < pieces_of(n, s); ++j) {
        put_chain_piece(text, joint, n, piece_of(problem, n, s, j), s->ball);
    }
    if (s->as == AS_SPRINGS) put_chain_bodies(text, joint, n);
    put(text, "</worldbody>\n");
    if (s->as == AS_PIECES) put_chain_joints(text, problem, joint, n, s);
    free(joint);
}

/* Of springs every segment is a piece. */
static void put_pull(Text *text, int n, const Settings *s)
{
    put_rollers(text, n);
    for (int j = 0; j < pieces_of(n, s); ++j) put_pull_piece(text, piece_of(PEER_STRAIGHT, n, s, j), s);
    put(text, "</worldbody>\n");
    put_pairs(text, n, s);
    put_pull_joints(text, n, s);
}

char *model_xml(PeerProblem problem, int n, const Settings *s)
{
    Text text = {0};
    put_head(&text, problem, n, s);
    if (problem == PEER_STRAIGHT)
        put_pull(&text, n, s);
    else
        put_chain(&text, problem, n, s);
    put(&text, "</mujoco>\n");
    if (text.at >= 0) return text.data;
    free(text.data);
    return NULL;
}
