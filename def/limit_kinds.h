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

/* N, largest tension of the cable, borne by conductor or sheath */
LIMIT(PULL, "pull", "N", LIMIT_ESSENTIAL | LIMIT_PULLS | LIMIT_TENSION | LIMIT_MENDED)
LIMIT_KEY(PULL, "pull", DIM_FORCE, .otherwise = "by eq. 11", ABOVE(0, STRONG))
LIMIT_REMEDY(PULL, BOUND_OVER, "less_pull", "", "{least} less pull: conveyors, a pit, or a lubricant")

/* N, the same from rest */
LIMIT(RESTART, "restart", "N", LIMIT_PULLS | LIMIT_MENDED)
LIMIT_REMEDY(RESTART, BOUND_OVER, "less_pull", "", NULL)

/* N, at the eye or net, borne by that device */
LIMIT(ATTACHMENT, "attachment", "N", LIMIT_PULLS | LIMIT_TENSION | LIMIT_MENDED)
LIMIT_REMEDY(ATTACHMENT, BOUND_OVER, "less_pull", "", NULL)

/* N/m, largest tension over radius in a bend */
LIMIT(SIDEWALL, "sidewall", "N/m", LIMIT_ESSENTIAL | LIMIT_TENSION | LIMIT_MENDED)
LIMIT_KEY(SIDEWALL, "sidewall", DIM_LINE_FORCE, .otherwise = "by `practice`", ABOVE(0, STRONG))
LIMIT_RULE(SIDEWALL, RULE_SIDEWALL, practice_code(def), def->cable_type, def->cores > 1)

/* N/m, largest force per length on ducts, trays, floors and walls */
LIMIT(CONTACT_PRESSURE, "contact_pressure", "N/m", LIMIT_OPTIONAL | LIMIT_STARTS)
LIMIT_KEY(CONTACT_PRESSURE, "contact_pressure", DIM_LINE_FORCE, .otherwise = "not known", ABOVE(0, STRONG))

/* m, smallest radius of the cable */
LIMIT(BEND_RADIUS, "bend_radius", "m", LIMIT_AT_LEAST | LIMIT_MENDED)
LIMIT_KEY(BEND_RADIUS, "bend_radius", DIM_LENGTH, .otherwise = "`bend_factor` times the cable's diameter",
          ABOVE(0, LONG))
LIMIT_REMEDY(BEND_RADIUS, BOUND_LEAST, "bend_radius", "", "a radius of at least {least} there")

/* 1, smallest bending diameter of the rope over its own */
LIMIT(ROPE_BEND, "rope_bend", "1", LIMIT_AT_LEAST)
LIMIT_KEY(ROPE_BEND, "rope_bend", DIM_NONE, .otherwise = "by `rope_kind`", ABOVE(0, 1000))
LIMIT_RULE(ROPE_BEND, RULE_ROPE_BEND, CODE_USUAL, def->rope_kind, 0)
LIMIT_REMEDY(ROPE_BEND, BOUND_LEAST, "sheaves", "", "sheaves and bends of at least {least} times the rope's diameter")

/* N, largest load of a roller at steady speed */
LIMIT(ROLLER_STEADY, "roller_steady", "N", 0)

/* N, largest load of a roller at any time */
LIMIT(ROLLER_PEAK, "roller_peak", "N", LIMIT_STARTS)

/* N, largest tension of the rope */
LIMIT(ROPE, "rope", "N", LIMIT_PULLS | LIMIT_TENSION)

/* N, largest force of the winch */
LIMIT(WINCH, "winch", "N", LIMIT_PULLS | LIMIT_TENSION | LIMIT_MENDED)
LIMIT_KEY(WINCH, "winch_capacity", DIM_FORCE, .otherwise = "not known", ABOVE(0, STRONG))
LIMIT_REMEDY(WINCH, BOUND_OVER, "less_pull", "", NULL)

/* N, largest push of a machine */
LIMIT(PUSH, "push", "N", 0)
LIMIT_KEY(PUSH, "push", DIM_FORCE, .otherwise = "not known", ABOVE(0, STRONG))
LIMIT_REMEDY(PUSH, BOUND_MOST, "more_machines", "", "more conveyors or machines, each with at most {most}")

/* N, compression where it is nearest to the critical load there */
LIMIT(BUCKLING, "buckling", "N", 0)
LIMIT_REMEDY(BUCKLING, BOUND_OVER, "less_push", "conveyors.N.limit",
             "{least} less push ({key}), a narrower duct, or guides and carriers closer together")

/* N/m, of belts on the cable */
LIMIT(SQUEEZE, "squeeze", "N/m", 0)
LIMIT_KEY(SQUEEZE, "squeeze", DIM_LINE_FORCE, .otherwise = "not known", ABOVE(0, STRONG))
LIMIT_REMEDY(SQUEEZE, BOUND_MOST, "longer_conveyors", "",
             "longer conveyors or more of them, pressing with at most {most}")

/* N, brake that is missing where the pull begins */
LIMIT(RUN_AWAY, "run_away", "N", 0)

/* 1, largest force of the winch over that of theory */
LIMIT(ALPHA, "alpha", "1", LIMIT_TENSION)
LIMIT_KEY(ALPHA, "alpha", DIM_NONE, .fallback = "1.5", FROM(1, 100))
LIMIT_REMEDY(ALPHA, BOUND_NONE, "softer_start", "drive.winch.to", "a softer start: a longer {key}, ramp step5")

/* N, at which the winch stops */
LIMIT(TRIP, "trip", "N", 0)
LIMIT_REMEDY(TRIP, BOUND_MOST, "trip", "drive.winch.trip", "a winch that stops at [{most}|{least}] ({key})")

/* m/s, of the winch or the fastest belt */
LIMIT(SPEED, "speed", "m/s", 0)
LIMIT_KEY(SPEED, "speed", DIM_SPEED, .otherwise = "15 m/min", ABOVE(0, 1e3))
LIMIT_RULE(SPEED, RULE_SPEED, def->code, 0, 0)
LIMIT_REMEDY(SPEED, BOUND_MOST, "slower", "drive.winch.speed", "a winch that pulls with at most {most} ({key})")

/* 1, diameters of duct and cable, of three cables in a duct */
LIMIT(JAM_RATIO, "jam_ratio", "1", LIMIT_OF_DUCT | LIMIT_MENDED)

/* m, over the uppermost cable in a duct */
LIMIT(CLEARANCE, "clearance", "m", LIMIT_OF_DUCT | LIMIT_AT_LEAST | LIMIT_MENDED)
LIMIT_KEY(CLEARANCE, "clearance", DIM_LENGTH, .otherwise = "by `code`", FROM(0, LONG))
LIMIT_RULE(CLEARANCE, RULE_CLEARANCE, def->code, 0, 0)

/* 1, share of a duct that is filled */
LIMIT(FILL, "fill", "1", LIMIT_OF_DUCT | LIMIT_MENDED)
LIMIT_KEY(FILL, "fill", DIM_NONE, .otherwise = "by `code` and the number of cables", ABOVE(0, 1))
LIMIT_RULE(FILL, RULE_FILL, def->code, f->cables, 0)

/* 1, weight correction of several cables in a duct */
LIMIT(WEIGHT_CORRECTION, "weight_correction", "1", LIMIT_OF_DUCT)
LIMIT_KEY(WEIGHT_CORRECTION, "weight_correction", DIM_NONE, .otherwise = "not known", FROM(1, 100))

/* m, least between cable or rope and the environment */
LIMIT(CLEARANCE_ENVIRONMENT, "clearance_environment", "m", LIMIT_AT_LEAST)
LIMIT_KEY(CLEARANCE_ENVIRONMENT, "clearance_environment", DIM_LENGTH, .fallback = "0 m", FROM(0, 5))
LIMIT_REMEDY(CLEARANCE_ENVIRONMENT, BOUND_NONE, "move_away", "environment.N.clearance",
             "another line, or that part moved; for what the cable is to lie on, {key}: no")

#undef LIMIT
#undef LIMIT_KEY
#undef LIMIT_RULE
#undef LIMIT_REMEDY
