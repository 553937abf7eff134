#include "def/drive_law.h"

#include <math.h>

double cable_length(const SceneDef *def)
{
    double length = 0;
    for (int p = 0; p < scene_def_eye(def); ++p) length += def->pieces[p].length;
    return length;
}

Winding reel_winding(const SceneDef *def)
{
    const CableDef *const cable = &def->cables[def->pieces[0].cable];
    return (Winding){.barrel = def->reel.barrel / 2,
                     .pitch = cable->diameter,
                     .turns = winding_turns(def->reel.width, cable->diameter),
                     .line_mass = cable->mass,
                     .inertia = def->reel.inertia};
}

/* Builds the brake. A proportional brake gives its torque at its reference cable speed with a full drum. */
ReelBrake reel_brake_of(const SceneDef *def)
{
    const ReelDef *const d = &def->reel;
    ReelBrake b = {.law = d->brake,
                   .torque = d->torque,
                   .bearing = d->bearing,
                   .over = d->over,
                   .speed = d->speed,
                   .rest = {.mu_s = 1, .mu_d = 1, .v_s = d->v_s, .v_d = 2 * d->v_s}};
    const Winding winding = reel_winding(def);
    if (d->brake == BRAKE_PROPORTIONAL)
        b.viscous = d->torque * winding_radius(&winding, cable_length(def), NULL) / d->at_speed;
    return b;
}

/* Speed factor: 1 in motion, 0 at rest, odd (F3). */
static double moving(const ReelBrake *b, double v, double *slope)
{
    double curve;
    const double over_speed = friction_over_speed(&b->rest, fabs(v), &curve);
    *slope = over_speed + curve * v * v;
    return over_speed * v;
}

double reel_brake_torque(const ReelBrake *b, double share, double radius, double v, double t, double *by_radius,
                         double *by_v)
{
    double slope;
    const double f = moving(b, v, &slope);
    double torque = b->bearing * f;
    *by_radius = 0;
    *by_v = b->bearing * slope;
    if (b->law == BRAKE_CONSTANT) {
        torque += share * b->torque * f;
        *by_v += share * b->torque * slope;
    } else if (b->law == BRAKE_PROPORTIONAL) {
        torque += share * b->viscous * v / radius;
        *by_v += share * b->viscous / radius;
        *by_radius = -share * b->viscous * v / (radius * radius);
    } else if (b->law == BRAKE_SPEED) {
        torque += share * b->torque * step_cubic(v - profile_value(&b->speed, t), 0, 0, b->over, 1, &slope);
        *by_v += share * b->torque * slope;
    }
    return torque;
}

double conveyor_grip(const ConveyorDef *def, double clamp)
{
    const double most = 2 * def->mu * clamp;
    return def->limit > 0 ? fmin(most, def->limit) : most;
}

double bearing_torque(const Bearing *bearing, double load, double om, double *d_om, double *d_load)
{
    const double x = om / bearing->speed, most = bearing->torque + bearing->friction * bearing->journal * load;
    double f = x > 0 ? 1 : -1, slope = 0;
    if (fabs(x) < 1) {
        f = (3 * x - x * x * x) / 2;
        slope = 1.5 * (1 - x * x) / bearing->speed;
    }
    *d_om = -most * slope;
    *d_load = -bearing->friction * bearing->journal * f;
    return -most * f;
}

double motor_torque(const MotorNow *motor, double om, double *d_om)
{
    *d_om = 0;
    if (!(motor->below > motor->above)) return motor->below;
    return step_cubic(om, motor->from, motor->below, motor->to, motor->above, d_om);
}

MotorNow motor_along(const RollerDef *roller, double winch, double t)
{
    const MotorDef *const d = &roller->spin.motor;
    const double radius = roller->radius, droop = d->droop / radius;
    if (d->kind == MOTOR_TORQUE) {
        const double torque = profile_value(&d->set, t), most = d->speed_limit / radius;
        return (MotorNow){most - droop, most, torque, d->speed_limit > 0 ? 0 : torque};
    }
    const double speed = (d->factor > 0 ? d->factor * winch : profile_value(&d->set, t)) / radius;
    return (MotorNow){speed - droop, speed + droop, d->limit, -d->limit};
}
