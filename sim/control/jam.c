/* Jams: a roller or a conveyor that stops in mid-run, at a time or when the cable's front comes to a place, and perhaps
 * one that is released again. docs/model.md, "Jams" (JA1)-(JA6).
 *
 * A jam acts through the room of what jams: that is given a Seizure when the scene is built and looks at its share at
 * every evaluation. Between two events the share is a function of time alone; it changes after accepted steps only, in
 * jams_happen(). What a jam does to a roller or a belt stands there, not here. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "sim/equipment/rooms.h"
#include "sim/scene.h"

typedef enum JamDoing { JAM_WAITS, JAM_HOLDS, JAM_IS_OVER } JamDoing;

typedef struct Jam {
    const JamDef *def; /* the scene's */
    JamDoing doing;
    Seizure seizure;
    char says[2][NAME_MAX_LENGTH + 32]; /* when it begins, when it is over */
} Jam;

typedef struct Jams {
    int n;
    Jam *item; /* [n], in the case's order */
} Jams;

static hawser_status jams_build(Room *room, Scene *scene, hawser_error *err)
{
    Jams *const all = room->self = calloc(1, sizeof *all);
    if (!all) return error_memory(err);
    all->n = room->present = scene->def.n_jams;
    all->item = calloc((size_t)all->n + 1, sizeof *all->item);
    if (!all->item) return error_memory(err);
    for (int i = 0; i < all->n; ++i) {
        const JamDef *const def = &scene->def.jams[i];
        all->item[i] = (Jam){.def = def, .seizure = {.ramp = def->ramp, .mu = def->friction}};
    }
    return HAWSER_OK;
}

static void jams_clear(Room *room)
{
    Jams *const all = room->self;
    if (all) free(all->item);
}

/* When all rooms are built: hands the seizure to whose name it is. */
static hawser_status jams_finish(Room *room, Scene *scene, hawser_error *err)
{
    const Jams *const all = room->self;
    for (int i = 0; i < all->n; ++i) {
        Jam *const jam = &all->item[i];
        const char *kind = NULL;
        for (int r = 0; !kind && r < scene->n_rooms; ++r) {
            Room *const other = &scene->room[r];
            if (other->present && other->kind->seize)
                kind = other->kind->seize(other, scene, jam->def->what, &jam->seizure);
        }
        if (!kind) {
            return error_set(err, HAWSER_ERR_INPUT, "key 'jams.%d.what': nothing that can jam is called '%s'", i,
                             jam->def->what);
        }
        snprintf(jam->says[0], sizeof jam->says[0], "%s %s jams", kind, jam->def->what);
        snprintf(jam->says[1], sizeof jam->says[1], "%s %s is free again", kind, jam->def->what);
    }
    return HAWSER_OK;
}

int seizure_command(Seizure *told, const Seizure *by, const Command *c, double t, hawser_error *err)
{
    const int holds = by == told && told->share.v1 > 0;
    if (by && by != told) {
        error_set(err, HAWSER_ERR_INPUT, "'%s' jams by the case's section 'jams', which commands leave alone", c->what);
        return -1;
    }
    if (holds == (c->kind == HAWSER_JAM)) {
        error_set(err, HAWSER_ERR_INPUT, "'%s' is %s", c->what, holds ? "jammed already" : "not jammed");
        return -1;
    }
    told->share = command_ramp(&told->share, t, c->kind == HAWSER_JAM, c->ramp);
    told->ramp = c->ramp;
    return 1;
}

/* -------------------------------------------------------------------------------------------------- between steps */

static const double ON_TIME = 1e-9; /* s: the integrator stops at an event's time up to rounding */

/* At a time (s) or a place of the cable's front (m); NAN: not by this (JA1). */
static int due(double at, double front, const Occasion *now) { return now->t >= at - ON_TIME || now->front >= front; }

/* From now on the share goes from `from` to `to` by STEP (JA2). */
static void share_begin(Jam *jam, JamDoing doing, double t, double from, double to)
{
    jam->doing = doing;
    jam->seizure.share = (Profile){.kind = PROFILE_STEP, .t0 = t, .v0 = from, .t1 = t + jam->seizure.ramp, .v1 = to};
}

/* A jam is released when it is complete, not before. */
static Occurrence jam_happen(Jam *jam, const Occasion *now)
{
    const JamDef *const def = jam->def;
    if (jam->doing == JAM_WAITS && due(def->at, def->head_at, now)) {
        share_begin(jam, JAM_HOLDS, now->t, 0, 1);
        return (Occurrence){HAWSER_EVENT_JAM, jam->says[0]};
    }
    const int complete = jam->doing == JAM_HOLDS && now->t >= jam->seizure.share.t1 - ON_TIME;
    if (!complete || !due(def->release, def->release_head_at, now)) return (Occurrence){0};
    share_begin(jam, JAM_IS_OVER, now->t, 1, 0);
    return (Occurrence){HAWSER_EVENT_FREE, jam->says[1]};
}

static Occurrence jams_happen(Room *room, const Occasion *now)
{
    const Jams *const all = room->self;
    Occurrence found = {0};
    for (int i = 0; !found.what && i < all->n; ++i) found = jam_happen(&all->item[i], now);
    return found;
}

static void jams_controls(Room *room, ControlsVisit *visit)
{
    const Jams *const all = room->self;
    for (int i = 0; i < all->n; ++i) {
        int doing = (int)all->item[i].doing;
        controls_count(visit, &doing, JAM_IS_OVER);
        all->item[i].doing = (JamDoing)doing;
        controls_seizure(visit, &all->item[i].seizure);
    }
}

/* The pull is told with every event; the front, where a jam still waits for it. */
static int jams_watch(const Room *room)
{
    const Jams *const all = room->self;
    int watched = 0;
    for (int i = 0; i < all->n; ++i) {
        const Jam *const jam = &all->item[i];
        const double front = jam->doing == JAM_WAITS ? jam->def->head_at : jam->def->release_head_at;
        if (jam->doing == JAM_IS_OVER) continue;
        watched |= WATCH_PULL | (isnan(front) ? 0 : WATCH_FRONT);
    }
    return watched;
}

/* Events at a time are met exactly; so are the ends of the ramps. */
static double jams_next_stop(const Room *room, const Scene *scene, double t)
{
    (void)scene;
    const Jams *const all = room->self;
    double next = INFINITY;
    for (int i = 0; i < all->n; ++i) {
        const Jam *const jam = &all->item[i];
        if (jam->def->at > t) next = fmin(next, jam->def->at);
        if (jam->def->release > t) next = fmin(next, jam->def->release);
        next = profile_corner_before(&jam->seizure.share, t, next);
    }
    return next;
}

const RoomKind JAM_ROOM = {.name = "jams",
                           .build = jams_build,
                           .finish = jams_finish,
                           .clear = jams_clear,
                           .watches = jams_watch,
                           .happen = jams_happen,
                           .next_stop = jams_next_stop,
                           .controls = jams_controls,
                           .in_space = "something jams in mid-run, which theory does not know"};
