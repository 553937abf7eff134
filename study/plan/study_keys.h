/* The study file's sections as tables of keys, and what they are first read into. For study/plan alone. */
#ifndef HAWSER_STUDY_PLAN_STUDY_KEYS_H
#define HAWSER_STUDY_PLAN_STUDY_KEYS_H

#include "study/plan/study.h"

enum { STUDY_TEXT_MAX = 1024 };

/* What the tables fill. */
typedef struct StudyRecord {
    char title[256], base[STUDY_TEXT_MAX], list[STUDY_TEXT_MAX];
    int fidelity, points, method, limits, starts, raw;
    double close, time_limit, tolerance, at_least, at_most, speed, head, from, to;
    long pilot, samples, memory, seed, searches, evaluations;
} StudyRecord;

/* A law's numbers, with units of the user's: in the order a, b, c, low, high of a Distribution. */
typedef struct LawKeys {
    const char *name;
    DistributionKind kind;
    const CaseSection *section;
    const char *key[5]; /* NULL: the law has none */
} LawKeys;
enum { STUDY_LAWS = 4 };
extern const LawKeys study_laws[STUDY_LAWS];

extern const CaseSection study_parameter, study_discrete, study_steps, study_range, study_whole, study_list_section,
    study_monte_carlo, study_correlation, study_sensitivity, study_optimise, study_constraint, study_calibrate;

/* One parameter's section into *p: a grid wants choices, a list has them in its columns, else a law is wanted. Errors:
 * INPUT, MEMORY. */
hawser_status parameter_read(const CaseReader *r, const CaseNode *node, StudyKind kind, Parameter *p);
/* What is sought into s->aim, once parameters and quantities are known; adds quantities that it asks for. Errors:
 * INPUT, MEMORY. */
hawser_status aim_read(const CaseReader *r, const CaseNode *section, Study *s);
/* The log into s->measured, once parameters are known. Errors: INPUT, MEMORY. */
hawser_status measured_read(const CaseReader *r, const CaseNode *section, Study *s);
/* Whether each key of the case is one parameter's alone; way: the section that a list's columns are blamed on. Errors:
 * INPUT. */
hawser_status twice_check(const CaseReader *r, const Study *s, const CaseNode *way);
/* A path beside the study's file, malloc'ed; NULL without memory. */
char *path_beside(Study *s, const char *path);
/* The correlations into s->factor. Errors: INPUT, MEMORY. */
hawser_status correlations_read(const CaseReader *r, const CaseNode *list, Study *s);

#endif
