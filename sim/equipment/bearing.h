/* What a roller's bearing holds back with. docs/model.md, "Bearing and spin". */
#ifndef HAWSER_SIM_EQUIPMENT_BEARING_H
#define HAWSER_SIM_EQUIPMENT_BEARING_H

typedef struct Bearing {
    double friction; /* coefficient at the journal */
    double journal;  /* m, its radius */
    double torque;   /* N m, whatever the load: seals, grease, own weight */
    double speed;    /* rad/s, > 0: below it the torque falls to zero with the speed */
} Bearing;

/* Torque on the roller, N m, at angular speed om (rad/s) against its mount and under `load` (N) (SP7). d_om and d_load
 * get its derivatives, N m s and m. */
double bearing_torque(const Bearing *bearing, double load, double om, double *d_om, double *d_load);

#endif
