/* Every limit once, as rows for the files that include this one. They yield the public enumeration (made by
 * tests/house/check_kinds.py --update from the comments here), names and units (def/limits.c), the case's keys
 * (io/case/case_read.c), the bounds that are one number (def/limits.c) and the remedies (io/api/api_answer.c). No
 * include guard: define the row macros needed, then include it. docs/reference/limits.md.
 *
 *     LIMIT(KIND, name, unit, traits)            rows keep their order; new ones are appended
 *     LIMIT_KEY(KIND, key, dimension, ...)       the case's own bound, section `limits`; default and range as a CaseKey
 *     LIMIT_RULE(KIND, rule, code, a, b)         value of the codes where the case has none (def/limits.h)
 *     LIMIT_REMEDY(KIND, bound, code, key, text) change that keeps the limit; text NULL: that of an earlier row
 */
#ifndef LIMIT
#define LIMIT(...)
#endif
#ifndef LIMIT_KEY
#define LIMIT_KEY(...)
#endif
#ifndef LIMIT_RULE
#define LIMIT_RULE(...)
#endif
#ifndef LIMIT_REMEDY
#define LIMIT_REMEDY(...)
#endif

/* N, largest tension of the cable, borne by conductor or sheath
 * Found: largest tension in the cable, eye included.
 * Allowed: K x stress x area of conductor or sheath (the paper's eq. 11): K is 1 for power cables, 0.6 for control
 * cables. Several cables: less by `code`; with `paper` and `gb50217` that of one cable times the number of the
 * thickest. A rope that shares its pull unequally needs a smaller `K`.
 * Remedy: pull from the other end; lubricant; rollers that turn; less back tension; a pit or a conveyor (`hawser
 * place`); a wider bend near the winch; a stronger rope or winch.
 */
LIMIT(PULL, "pull", "N", LIMIT_ESSENTIAL | LIMIT_PULLS | LIMIT_TENSION | LIMIT_MENDED)
LIMIT_KEY(PULL, "pull", DIM_FORCE, .otherwise = "by eq. 11", ABOVE(0, STRONG))
LIMIT_REMEDY(PULL, BOUND_OVER, "less_pull", "", "{least} less pull: conveyors, a pit, or a lubricant")

/* N, the same from rest
 * Found: the same from rest, with the static friction; in a calculation only, since a simulated pull starts from rest.
 * Allowed: as `pull`.
 * Remedy: as for `pull`; avoid stops with the cable in a bend; measure the friction at rest.
 */
LIMIT(RESTART, "restart", "N", LIMIT_PULLS | LIMIT_MENDED)
LIMIT_REMEDY(RESTART, BOUND_OVER, "less_pull", "", NULL)

/* N, at the eye or net, borne by that device
 * Found: tension at the eye or net and its swivel.
 * Allowed: by `code`, `attachment_rating`, or `swivel_rating` if that is less.
 * Remedy: as for `pull`.
 */
LIMIT(ATTACHMENT, "attachment", "N", LIMIT_PULLS | LIMIT_TENSION | LIMIT_MENDED)
LIMIT_REMEDY(ATTACHMENT, BOUND_OVER, "less_pull", "", NULL)

/* N/m, largest tension over radius in a bend
 * Found: largest tension over the route's radius, T/R; of several cables on the worst loaded one. A single roller in a
 * bend loads the cable more: use `practice: rollers`, or the rollers' ratings.
 * Allowed: by `code` or `practice`, and `cable_type`.
 * Remedy: a wider bend at the named place; pull from the other end; less tension ahead of the bend; `practice` and
 * `cable_type`, if the code's value is not for your cable.
 */
LIMIT(SIDEWALL, "sidewall", "N/m", LIMIT_ESSENTIAL | LIMIT_TENSION | LIMIT_MENDED)
LIMIT_KEY(SIDEWALL, "sidewall", DIM_LINE_FORCE, .otherwise = "by `practice`", ABOVE(0, STRONG))
LIMIT_RULE(SIDEWALL, RULE_SIDEWALL, practice_code(def), def->cable_type, def->cores > 1)

/* N/m, largest force per length on ducts, trays, floors and walls
 * Found: largest force per length on ducts, trays, floors and walls, weight and stiffness included; taken in rows, so
 * that a peak between two rows is missed.
 * Allowed: `contact_pressure` alone, since no code has one.
 * Remedy: smaller spacing, rollers with a higher rating, a wider bend.
 */
LIMIT(CONTACT_PRESSURE, "contact_pressure", "N/m", LIMIT_OPTIONAL | LIMIT_STARTS)
LIMIT_KEY(CONTACT_PRESSURE, "contact_pressure", DIM_LINE_FORCE, .otherwise = "not known", ABOVE(0, STRONG))

/* m, smallest radius of the cable
 * Found: smallest radius of the cable, from the angle between neighbouring segments in rows, so not below a segment's
 * length; in a calculation that of the route.
 * Allowed: `practice`, diameters.
 * Remedy: a wider bend or larger rollers.
 */
LIMIT(BEND_RADIUS, "bend_radius", "m", LIMIT_AT_LEAST | LIMIT_MENDED)
LIMIT_KEY(BEND_RADIUS, "bend_radius", DIM_LENGTH, .otherwise = "`bend_factor` times the cable's diameter",
          ABOVE(0, LONG))
LIMIT_REMEDY(BEND_RADIUS, BOUND_LEAST, "bend_radius", "", "a radius of at least {least} there")

/* 1, smallest bending diameter of the rope over its own
 * Found: smallest diameter that the rope is bent round, over its own: bends ahead of the cable, single rollers that
 * turn it by 30 deg or more, `sheave`.
 * Allowed: 20 (steel), 8 (fibre): riggers' rule (Toss, The Complete Rigger's Apprentice; ASME B30.5 allows hoists 18).
 * Remedy: as for `bend_radius`.
 */
LIMIT(ROPE_BEND, "rope_bend", "1", LIMIT_AT_LEAST)
LIMIT_KEY(ROPE_BEND, "rope_bend", DIM_NONE, .otherwise = "by `rope_kind`", ABOVE(0, 1000))
LIMIT_RULE(ROPE_BEND, RULE_ROPE_BEND, CODE_USUAL, def->rope_kind, 0)
LIMIT_REMEDY(ROPE_BEND, BOUND_LEAST, "sheaves", "", "sheaves and bends of at least {least} times the rope's diameter")

/* N, largest load of a roller at steady speed
 * Found: largest lasting load of the roller that is worst for its rating: the mean while the cable moves on by a
 * segment; of several `chains` the sum ([SC18](../theory/36-several-chains.md)).
 * Allowed: rating / 1.6.
 * Remedy: as for `contact_pressure`.
 */
LIMIT(ROLLER_STEADY, "roller_steady", "N", 0)

/* N, largest load of a roller at any time
 * Found: largest load of the roller that is worst for its rating; simulation only.
 * Allowed: rating.
 * Remedy: as for `contact_pressure`.
 */
LIMIT(ROLLER_PEAK, "roller_peak", "N", LIMIT_STARTS)

/* N, largest tension of the rope
 * Found: largest pull of the rope.
 * Allowed: strength / 5 (our choice; `rope_factor` changes it; Greenlee requires four times the puller's capacity).
 * Remedy: as for `pull`.
 */
LIMIT(ROPE, "rope", "N", LIMIT_PULLS | LIMIT_TENSION)

/* N, largest force of the winch
 * Found: largest force of the winch.
 * Allowed: `winch_capacity`.
 * Remedy: as for `pull`.
 */
LIMIT(WINCH, "winch", "N", LIMIT_PULLS | LIMIT_TENSION | LIMIT_MENDED)
LIMIT_KEY(WINCH, "winch_capacity", DIM_FORCE, .otherwise = "not known", ABOVE(0, STRONG))
LIMIT_REMEDY(WINCH, BOUND_OVER, "less_pull", "", NULL)

/* N, largest push of a machine
 * Found: largest force of a conveyor on the cable; in a calculation also of `theory.machines` and `theory.feed`.
 * Allowed: `push`.
 * Remedy: less push per machine, more machines, a longer clamp, a rope that pulls at the same time.
 */
LIMIT(PUSH, "push", "N", 0)
LIMIT_KEY(PUSH, "push", DIM_FORCE, .otherwise = "not known", ABOVE(0, STRONG))
LIMIT_REMEDY(PUSH, BOUND_MOST, "more_machines", "", "more conveyors or machines, each with at most {most}")

/* N, compression where it is nearest to the critical load there
 * Found: compression where it is nearest to the critical load: snaking in a duct, bowing between carriers or guides
 * ([BK2, BK7](../theory/60-theory.md#compression)).
 * Allowed: that load.
 * Remedy: as for `push`.
 */
LIMIT(BUCKLING, "buckling", "N", 0)
LIMIT_REMEDY(BUCKLING, BOUND_OVER, "less_push", "conveyors.N.limit",
             "{least} less push ({key}), a narrower duct, or guides and carriers closer together")

/* N/m, of belts on the cable
 * Found: force of the belts over the length on which they press.
 * Allowed: `squeeze`.
 * Remedy: as for `push`.
 */
LIMIT(SQUEEZE, "squeeze", "N/m", 0)
LIMIT_KEY(SQUEEZE, "squeeze", DIM_LINE_FORCE, .otherwise = "not known", ABOVE(0, STRONG))
LIMIT_REMEDY(SQUEEZE, BOUND_MOST, "longer_conveyors", "",
             "longer conveyors or more of them, pressing with at most {most}")

/* N, brake that is missing where the pull begins
 * Found: brake that is missing where the pull begins, so that the cable is in tension everywhere.
 * Allowed: 0.
 * Remedy: a brake or back tension of at least the named force.
 */
LIMIT(RUN_AWAY, "run_away", "N", 0)

/* 1, largest force of the winch over that of theory
 * Found: peak tension over the theory of that moment (eq. 12) at the worst roller that the front has passed;
 * simulation only.
 * Allowed: 1.5.
 * Remedy: a gentler start (`drive.winch.to`), smoother rollers at the named place.
 */
LIMIT(ALPHA, "alpha", "1", LIMIT_TENSION)
LIMIT_KEY(ALPHA, "alpha", DIM_NONE, .fallback = "1.5", FROM(1, 100))
LIMIT_REMEDY(ALPHA, BOUND_NONE, "softer_start", "drive.winch.to", "a softer start: a longer {key}, ramp step5")

/* N, at which the winch stops
 * Found: `drive.winch.trip`, the force at which the winch stops.
 * Allowed: above what the winch needs, below what cable, eye, rope and winch bear.
 * Remedy: a trip force between these two.
 */
LIMIT(TRIP, "trip", "N", 0)
LIMIT_REMEDY(TRIP, BOUND_MOST, "trip", "drive.winch.trip", "a winch that stops at [{most}|{least}] ({key})")

/* m/s, of the winch or the fastest belt
 * Found: largest speed of the winch, or of the belts if there is no winch.
 * Allowed: 15 m/min.
 * Remedy: a slower winch.
 */
LIMIT(SPEED, "speed", "m/s", 0)
LIMIT_KEY(SPEED, "speed", DIM_SPEED, .otherwise = "15 m/min", ABOVE(0, 1e3))
LIMIT_RULE(SPEED, RULE_SPEED, def->code, 0, 0)
LIMIT_REMEDY(SPEED, BOUND_MOST, "slower", "drive.winch.speed", "a winch that pulls with at most {most} ({key})")

/* 1, diameters of duct and cable, of three cables in a duct
 * Found: D/d of three cables in the duct that is nearest to jamming, times `bundle.oval`.
 * Allowed: by `code`; usual: 1.05 D/d not from 2.6 to 3.2.
 * Remedy: another duct; no friction or force repairs it.
 */
LIMIT(JAM_RATIO, "jam_ratio", "1", LIMIT_OF_DUCT | LIMIT_MENDED)

/* m, over the uppermost cable in a duct
 * Found: clearance over the uppermost cable in the tightest duct.
 * Allowed: by `code`; usual: 6.35 mm.
 * Remedy: as for `jam_ratio`.
 */
LIMIT(CLEARANCE, "clearance", "m", LIMIT_OF_DUCT | LIMIT_AT_LEAST | LIMIT_MENDED)
LIMIT_KEY(CLEARANCE, "clearance", DIM_LENGTH, .otherwise = "by `code`", FROM(0, LONG))
LIMIT_RULE(CLEARANCE, RULE_CLEARANCE, def->code, 0, 0)

/* 1, share of a duct that is filled
 * Found: share of the fullest duct's cross-section; of one cable (d/D)^2.
 * Allowed: by `code`; usual: 0.53 one cable, 0.31 two, 0.40 three or four.
 * Remedy: as for `jam_ratio`.
 */
LIMIT(FILL, "fill", "1", LIMIT_OF_DUCT | LIMIT_MENDED)
LIMIT_KEY(FILL, "fill", DIM_NONE, .otherwise = "by `code` and the number of cables", ABOVE(0, 1))
LIMIT_RULE(FILL, RULE_FILL, def->code, f->cables, 0)

/* 1, weight correction of several cables in a duct
 * Found: largest weight correction factor of several cables.
 * Allowed: `weight_correction`.
 * Remedy: another duct or arrangement.
 */
LIMIT(WEIGHT_CORRECTION, "weight_correction", "1", LIMIT_OF_DUCT)
LIMIT_KEY(WEIGHT_CORRECTION, "weight_correction", DIM_NONE, .otherwise = "not known", FROM(1, 100))

/* m, least between cable or rope and the environment
 * Found: least distance between cable or rope and a model of the [environment](../guide/environment.md), below 0 where
 * they overlap: along the route in a calculation, in the recorded rows of a run.
 * Allowed: 0.
 * Remedy: another line, or that part moved; `clearance: no` for what the cable is to lie on.
 */
LIMIT(CLEARANCE_ENVIRONMENT, "clearance_environment", "m", LIMIT_AT_LEAST)
LIMIT_KEY(CLEARANCE_ENVIRONMENT, "clearance_environment", DIM_LENGTH, .fallback = "0 m", FROM(0, 5))
LIMIT_REMEDY(CLEARANCE_ENVIRONMENT, BOUND_NONE, "move_away", "environment.N.clearance",
             "another line, or that part moved; for what the cable is to lie on, {key}: no")

#undef LIMIT
#undef LIMIT_KEY
#undef LIMIT_RULE
#undef LIMIT_REMEDY
