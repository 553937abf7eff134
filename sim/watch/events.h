/* What happened in a run besides that time went by: a short list with times, kept as it grows. */
#ifndef HAWSER_SIM_WATCH_EVENTS_H
#define HAWSER_SIM_WATCH_EVENTS_H

#include "hawser/hawser.h"
#include "sim/scene.h"

enum { EVENTS_MAX = 10000 }; /* kept; later ones are only counted */

typedef struct EventLog {
    int n, room;
    long missed;
    hawser_event *event; /* [n] */
    int n_texts, texts_room;
    char **text; /* [n_texts] of events whose words are the log's own */
} EventLog;

/* Adds an event, whose text outlives the log. Errors: MEMORY. */
hawser_status events_add(EventLog *log, hawser_event event, hawser_error *err);
/* The same with a text that the log keeps. Errors: MEMORY. */
hawser_status events_say(EventLog *log, hawser_event event, hawser_error *err);
void events_free(EventLog *log);

/* What has turned farther than the model can follow. A run goes on then, but its results must not be taken for good
 * without a word: hawser_sim_record notes it as an event. */
enum { TURNED_JOINT = 1, TURNED_HEAD = 2 };
#define TURNED_JOINT_SAYS                                                                                              \
    "a joint is turned by more than 150 deg and snaps back at 180: the chain needs shorter segments"
#define TURNED_HEAD_SAYS                                                                                               \
    "the head is turned by more than 30 deg from the winch's line: 'grip: axial' pulls along the head, 'clamp' holds " \
    "it"

/* TURNED_JOINT: two neighbours differ by more than 150 deg in orientation (B16); joints that turn freely about the
 * axis (swivels, free ends) do not count, and in a plane there is no such limit. TURNED_HEAD: a head that a winch of
 * set speed pulls along its own axis has left the winch's line by more than 30 deg. Both or 0. kin: with ghosts, of
 * now. */
int turned(const Scene *scene, int planar, const Kinematics *kin);

#endif
