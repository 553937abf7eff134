#include "sim/watch/events.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/equipment/winch.h"

hawser_status events_add(EventLog *log, hawser_event event, hawser_error *err)
{
    if (log->n == EVENTS_MAX) {
        ++log->missed;
        return HAWSER_OK;
    }
    if (log->n == log->room) {
        const int room = 2 * log->room + 8;
        hawser_event *const grown = realloc(log->event, (size_t)room * sizeof *grown);
        if (!grown) return error_memory(err);
        log->event = grown;
        log->room = room;
    }
    log->event[log->n++] = event;
    return HAWSER_OK;
}

hawser_status events_say(EventLog *log, hawser_event event, hawser_error *err)
{
    if (log->n < EVENTS_MAX && log->n_texts == log->texts_room) {
        const int room = 2 * log->texts_room + 8;
        char **const grown = realloc(log->text, (size_t)room * sizeof *grown);
        if (!grown) return error_memory(err);
        log->text = grown;
        log->texts_room = room;
    }
    if (log->n < EVENTS_MAX) {
        char *const own = strdup(event.what);
        if (!own) return error_memory(err);
        log->text[log->n_texts++] = own;
        event.what = own;
    }
    return events_add(log, event, err);
}

void events_free(EventLog *log)
{
    for (int i = 0; i < log->n_texts; ++i) free(log->text[i]);
    free(log->text);
    free(log->event);
    memset(log, 0, sizeof *log);
}

/* cos(150 deg / 2): of the angle between two orientations q and p the half has the cosine |q.p|; cos 30 deg. */
static const double HALF_FAR = 0.25881904510252076, HEAD_FAR = 0.8660254037844386;

static int joint_turned(const Chain *chain, const Kinematics *kin)
{
    for (int j = 0; j <= chain->n; ++j) {
        double dot = 0;
        for (int c = 0; c < 4; ++c) dot += kin->q[c][j - 1] * kin->q[c][j];
        if (fabs(dot) < HALF_FAR && chain->stiffness[3][j] > 0) return TURNED_JOINT;
    }
    return 0;
}

static int head_turned(const Scene *scene, const Kinematics *kin)
{
    const Winch *const w = scene->winch;
    const int i = scene->chain.n - 1;
    if (!w->present || !scene->def.winch.axial_only || w->mode != WINCH_SPEED) return 0;
    const double along = v3_dot(w->direction, v3(kin->a[0][i], kin->a[1][i], kin->a[2][i]));
    return along < HEAD_FAR ? TURNED_HEAD : 0;
}

int turned(const Scene *scene, int planar, const Kinematics *kin)
{
    return (planar ? 0 : joint_turned(&scene->chain, kin)) | head_turned(scene, kin);
}
