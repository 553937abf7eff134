#include "study/plan/study_keys.h"

static const char *const fidelities[] = {"theory", "run", "both", "auto", NULL};
static const char *const points[] = {"random", "latin", "sobol", NULL};
static const char *const methods[] = {"morris", "sobol", NULL};
static const char *const search_methods[] = {"auto", "linear", "random", "all", NULL};

/* Numbers in the unit of whatever is varied. */
#define ANY_NUMBER(name)                                                                                               \
    {                                                                                                                  \
        name, KEY_ANY, .required = 1, .form = "a number, with the unit that the case takes"                            \
    }
#define MAYBE_NUMBER(name)                                                                                             \
    {                                                                                                                  \
        name, KEY_ANY, .otherwise = "not cut off", .form = "a number, with the unit that the case takes"               \
    }
#define OPEN_LAW(first, second) ANY_NUMBER(first), ANY_NUMBER(second), MAYBE_NUMBER("from"), MAYBE_NUMBER("to")

/* clang-format off */
static const CaseKey uniform_keys[] = {ANY_NUMBER("from"), ANY_NUMBER("to")};
static const CaseKey normal_keys[] = {OPEN_LAW("mean", "sd")};
static const CaseKey lognormal_keys[] = {OPEN_LAW("median", "factor")};
static const CaseKey triangular_keys[] = {ANY_NUMBER("from"), ANY_NUMBER("to"), ANY_NUMBER("mode")};
/* clang-format on */
static SECTION(uniform, "parameters.NAME.uniform", uniform_keys);
static SECTION(normal, "parameters.NAME.normal", normal_keys);
static SECTION(lognormal, "parameters.NAME.lognormal", lognormal_keys);
static SECTION(triangular, "parameters.NAME.triangular", triangular_keys);

const LawKeys study_laws[STUDY_LAWS] = {
    {"uniform", LAW_UNIFORM, &uniform, {"from", "to"}},
    {"normal", LAW_NORMAL, &normal, {"mean", "sd", NULL, "from", "to"}},
    {"lognormal", LAW_LOGNORMAL, &lognormal, {"median", "factor", NULL, "from", "to"}},
    {"triangular", LAW_TRIANGULAR, &triangular, {"from", "to", "mode"}},
};

static const CaseKey discrete_keys[] = {
    {"values", KEY_LIST, .required = 1, .form = "values as the case takes them"},
    {"weights", KEY_LIST, .otherwise = "all alike", .form = "a number for each value"},
};
SECTION(study_discrete, "parameters.NAME.discrete", discrete_keys);

static const CaseKey steps_keys[] = {
    ANY_NUMBER("from"),
    ANY_NUMBER("to"),
    {"count", KEY_INTEGER, .required = 1, FROM(2, 1e6), .offset = 0, .size = sizeof(long)},
};
SECTION(study_steps, "parameters.NAME.steps", steps_keys);

static const CaseKey range_keys[] = {
    ANY_NUMBER("from"),
    ANY_NUMBER("to"),
    {"start", KEY_ANY, .otherwise = "the middle", .form = "a number, with the unit that the case takes"},
};
SECTION(study_range, "parameters.NAME.range", range_keys);
SECTION(study_whole, "parameters.NAME.whole", range_keys);

static const CaseKey parameter_keys[] = {
    {"key", KEY_ANY, .otherwise = "NAME", .form = "a dotted key of the case, or a list of such"},
    {"uniform", KEY_MAP, .otherwise = "none", .section = &uniform},
    {"normal", KEY_MAP, .otherwise = "none", .section = &normal},
    {"lognormal", KEY_MAP, .otherwise = "none", .section = &lognormal},
    {"triangular", KEY_MAP, .otherwise = "none", .section = &triangular},
    {"discrete", KEY_MAP, .otherwise = "none", .section = &study_discrete},
    {"values", KEY_LIST, .otherwise = "none", .form = "values as the case takes them"},
    {"steps", KEY_MAP, .otherwise = "none", .section = &study_steps},
    {"range", KEY_MAP, .otherwise = "none", .section = &study_range},
    {"whole", KEY_MAP, .otherwise = "none", .section = &study_whole},
};
SECTION(study_parameter, "parameters.NAME", parameter_keys);

static const CaseKey list_keys[] = {
    {"file", KEY_TEXT, .required = 1, AT(StudyRecord, list)},
};
SECTION(study_list_section, "list", list_keys);

static const CaseKey correlation_keys[] = {
    {"of", KEY_LIST, .required = 1, .form = "the names of two parameters"},
    {"r", KEY_NUMBER, .required = 1, FROM(-1, 1), .offset = 0, .size = sizeof(double)},
};
SECTION(study_correlation, "monte-carlo.correlated.N", correlation_keys);

static const CaseKey monte_carlo_keys[] = {
    {"samples", KEY_INTEGER, .required = 1, FROM(1, 1e8), AT(StudyRecord, samples)},
    {"points", KEY_CHOICE, .fallback = "sobol", .choices = points, AT(StudyRecord, points)},
    {"seed", KEY_INTEGER, .fallback = "1", FROM(0, 1e15), AT(StudyRecord, seed)},
    {"correlated", KEY_LIST, .otherwise = "none", .form = "correlations one by one", .section = &study_correlation},
};
SECTION(study_monte_carlo, "monte-carlo", monte_carlo_keys);

static const CaseKey sensitivity_keys[] = {
    {"method", KEY_CHOICE, .fallback = "sobol", .choices = methods, AT(StudyRecord, method)},
    {"samples", KEY_INTEGER, .required = 1, FROM(2, 1e7), AT(StudyRecord, samples)},
    {"seed", KEY_INTEGER, .fallback = "1", FROM(0, 1e15), AT(StudyRecord, seed)},
};
SECTION(study_sensitivity, "sensitivity", sensitivity_keys);

static const CaseKey constraint_keys[] = {
    {"of", KEY_TEXT, .required = 1, .form = "a parameter's name or a path into the answer", AT(StudyRecord, base)},
    {"at_least", KEY_NUMBER, .otherwise = "no bound", FROM(-1e15, 1e15), AT(StudyRecord, at_least)},
    {"at_most", KEY_NUMBER, .otherwise = "no bound", FROM(-1e15, 1e15), AT(StudyRecord, at_most)},
};
SECTION(study_constraint, "optimise.constraints.N", constraint_keys);

static const CaseKey optimise_keys[] = {
    {"least", KEY_ANY, .otherwise = "none", .form = "a name or path, or a map of such with weights: their sum"},
    {"most", KEY_ANY, .otherwise = "none", .form = "likewise"},
    {"limits", KEY_FLAG, .fallback = "true", AT(StudyRecord, limits)},
    {"constraints", KEY_LIST, .otherwise = "none", .form = "constraints one by one", .section = &study_constraint},
    {"method", KEY_CHOICE, .fallback = "auto", .choices = search_methods, AT(StudyRecord, method)},
    {"searches", KEY_INTEGER, .fallback = "4", FROM(1, 1000), AT(StudyRecord, searches)},
    {"evaluations", KEY_INTEGER, .fallback = "200", FROM(2, 1e6), AT(StudyRecord, evaluations)},
    {"tolerance", KEY_NUMBER, .fallback = "1e-3", ABOVE(0, 0.1), AT(StudyRecord, tolerance)},
    {"seed", KEY_INTEGER, .fallback = "1", FROM(0, 1e15), AT(StudyRecord, seed)},
};
SECTION(study_optimise, "optimise", optimise_keys);

static const CaseKey calibrate_keys[] = {
    {"log", KEY_TEXT, .required = 1, AT(StudyRecord, list)},
    {"head", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(-LONG, LONG), AT(StudyRecord, head)},
    {"from", KEY_NUMBER, DIM_LENGTH, .fallback = "-1e6 m", FROM(-LONG, LONG), AT(StudyRecord, from)},
    {"to", KEY_NUMBER, DIM_LENGTH, .fallback = "1e6 m", FROM(-LONG, LONG), AT(StudyRecord, to)},
    {"speed", KEY_NUMBER, DIM_SPEED, .otherwise = "the log's", ABOVE(0, 100), AT(StudyRecord, speed)},
    {"parts", KEY_INTEGER, .fallback = "100", FROM(5, 2000), AT(StudyRecord, samples)},
    {"starts", KEY_FLAG, .fallback = "false", AT(StudyRecord, starts)},
    {"raw", KEY_FLAG, .fallback = "false", AT(StudyRecord, raw)},
    {"evaluations", KEY_INTEGER, .fallback = "1000", FROM(10, 1e5), AT(StudyRecord, evaluations)},
};
SECTION(study_calibrate, "calibrate", calibrate_keys);

static const CaseKey top_keys[] = {
    {"title", KEY_TEXT, .fallback = "", AT(StudyRecord, title)},
    {"case", KEY_TEXT, .required = 1, AT(StudyRecord, base)},
    {"set", KEY_MAP, .otherwise = "nothing", .form = "values by the case's dotted keys"},
    {"fidelity", KEY_CHOICE, .fallback = "theory", .choices = fidelities, AT(StudyRecord, fidelity)},
    {"pilot", KEY_INTEGER, .fallback = "12", FROM(1, 1e6), AT(StudyRecord, pilot)},
    {"close", KEY_NUMBER, .fallback = "0.1", FROM(0, 100), AT(StudyRecord, close)},
    {"parameters", KEY_MAP, .otherwise = "the columns of `list`", .form = "a name and what is varied for each",
     .section = &study_parameter},
    {"quantities", KEY_ANY, .otherwise = "pull and sidewall pressure",
     .form = "a list of paths, or lists under `theory` and `run`"},
    {"grid", KEY_LIST, .otherwise = "none", .form = "the parameters' names, the last one changes fastest"},
    {"list", KEY_MAP, .otherwise = "none", .section = &study_list_section},
    {"monte-carlo", KEY_MAP, .otherwise = "none", .section = &study_monte_carlo},
    {"sensitivity", KEY_MAP, .otherwise = "none", .section = &study_sensitivity},
    {"optimise", KEY_MAP, .otherwise = "none", .section = &study_optimise},
    {"calibrate", KEY_MAP, .otherwise = "none", .section = &study_calibrate},
    {"time_limit", KEY_NUMBER, DIM_TIME, .fallback = "10 min", FROM(0, LATE), AT(StudyRecord, time_limit)},
    {"memory", KEY_INTEGER, .fallback = "0", FROM(0, 1e9), AT(StudyRecord, memory)},
};
SECTION(study_top, "", top_keys);
