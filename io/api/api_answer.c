/* Writes the short answer for a planner, for a run and for the calculation. */
#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/api/api_handles.h"
#include "io/results/words.h"
#include "theory/conditions.h"

enum { OPEN_MAX = 400, INDENT = 17, WIDE_ENOUGH = 40 };

/* Adds this many bytes of a text, as far as they fit. */
static void add(Answer *a, const char *text, int n)
{
    const int written = snprintf(a->text + a->used, a->size - a->used, "%.*s", n, text);
    a->used += (size_t)written < a->size - a->used ? (size_t)written : a->size - a->used - 1;
}

/* Adds a sentence of a page, in its language. */
static void add_page_line(Answer *a, const char *word, const char *sentence)
{
    char said[WORDS_MAX], shown[WORDS_MAX];
    const char *const first = words_in(a->language, word, said);
    add(a, first, (int)strlen(first));
    add(a, "\t", 1);
    const char *const rest = hawser_show_text(words_in(a->language, sentence, said), a->units, shown, sizeof shown);
    add(a, rest, (int)strlen(rest));
    add(a, "\n", 1);
}

/* Adds a sentence that begins at column `at`, in the reader's units, wrapped at blanks into lines that begin at
 * `indent`. */
static void add_sentence(Answer *a, const char *sentence, int at, int indent)
{
    char shown[HAWSER_VERDICT_MAX], margin[INDENT + 2];
    const char *rest = hawser_show_text(sentence, a->units, shown, sizeof shown);
    const int blanks = snprintf(margin, sizeof margin, "\n%*s", indent, "");
    const int width = a->width >= WIDE_ENOUGH ? a->width : ANSWER_WIDTH;
    while ((int)strlen(rest) > width - at) {
        int n = width - at;
        while (n > 0 && rest[n] != ' ') --n;
        if (n == 0) break; /* a word that is too long is not cut */
        add(a, rest, n);
        add(a, margin, blanks);
        at = indent;
        rest += n + 1;
    }
    add(a, rest, (int)strlen(rest));
    add(a, "\n", 1);
}

void answer_line(Answer *a, const char *word, const char *format, ...)
{
    char sentence[HAWSER_VERDICT_MAX], first[64];
    va_list args;
    va_start(args, format);
    vsnprintf(sentence, sizeof sentence, format, args);
    va_end(args);
    if (a->page) {
        add_page_line(a, word, sentence);
        return;
    }
    const int at = snprintf(first, sizeof first, "  %-14s ", word);
    add(a, first, at);
    add_sentence(a, sentence, at, INDENT);
}

void answer_verdict(Answer *a, const char *verdict)
{
    if (a->page)
        add_page_line(a, "", verdict);
    else
        add_sentence(a, verdict, 0, 2);
}

void answer_assumed(Answer *a, const Setup *setup, int n)
{
    Assumed all[ASSUMED_KINDS];
    const int count = n > 0 ? assumed_list(setup, all) : 0;
    for (int k = 0; k < count; ++k) {
        const Assumed *const one = &all[k];
        char value[HAWSER_SHOWN_MAX], low[HAWSER_SHOWN_MAX], high[HAWSER_SHOWN_MAX], more[32] = "";
        if (one->more > 0) snprintf(more, sizeof more, " and %d more", one->more);
        hawser_show(one->value, one->unit, a->units, value);
        if (isnan(one->high))
            answer_line(a, "assumed", "%s %s: not given (%s%s)", one->name, value, one->key, more);
        else
            answer_line(a, "assumed", "%s %s, usually %s to %s (%s%s)", one->name, value,
                        hawser_show(one->low, one->unit, a->units, low),
                        hawser_show(one->high, one->unit, a->units, high),
                        one->kind == ASSUMED_FRICTION ? one->source : one->key, more);
    }
}

/* Writes a number without a power of ten. */
static const char *plain(double value, char text[32])
{
    snprintf(text, 32, fabs(value) < 1e4 ? "%.4g" : "%.0f", value);
    return text;
}

void answer_unusual(Answer *a, const SceneDef *def, const Route *route)
{
    char value[32], least[32], most[32], unread[300];
    PlausibleRow row[PLAUSIBLE_ROWS];
    const int n = plausible_find(def, route, row);
    if (theory_unread(def, unread, sizeof unread)) answer_line(a, "not read", "%s", unread);
    for (int i = 0; i < n; ++i)
        answer_line(a, "unusual", "%s of %c%s%c: %s%s%s, usually %s to %s: is the unit right?", row[i].what,
                    NAME_BEGINS, row[i].of, NAME_ENDS, plain(row[i].value, value), *row[i].unit ? " " : "", row[i].unit,
                    plain(row[i].least, least), plain(row[i].most, most));
}

/* ------------------------------------------------------------------------------------------------------ limits */

/* Writes "; allowed 18.9 kN: 75.6 % left". */
enum { MARGIN_MAX = 160 };

static void say_margin(const hawser_limit *l, hawser_units units, char *text, size_t size)
{
    char allowed[HAWSER_SHOWN_MAX];
    const int over = l->margin < 0;
    const double share = 100 * (over ? fabs(l->value / l->limit - 1) : l->margin);
    hawser_show(l->limit, l->unit, units, allowed);
    if (!isfinite(share)) { /* the allowed value is 0 */
        snprintf(text, size, "allowed %s", allowed);
        return;
    }
    if (over && share >= 1000) {
        snprintf(text, size, "allowed %s: %.0f times as much", allowed, share / 100 + 1);
        return;
    }
    snprintf(text, size, "allowed %s: %.3g %% %s", allowed, share,
             !over                 ? "left"
             : l->value > l->limit ? "over"
                                   : "short");
}

static const hawser_limit *limit_of(int n, const hawser_limit *limit, hawser_limit_kind kind)
{
    for (int i = 0; i < n; ++i) {
        if (limit[i].kind == kind) return &limit[i];
    }
    return NULL;
}

/* Checks whether the common remedy covers that limit, too. */
static int is_told(const Mend *mend, const hawser_limit *l)
{
    return mend && (mend->safe ? !(mend->beside & 1U << l->kind) : limits_is(l->kind, LIMIT_MENDED));
}

/* Writes the worst value of a limit with its place and, if it is broken, the remedy, unless the common remedy covers it
 * or `said` already holds it. */
static void limit_lines(Answer *a, const Setup *setup, const char *word, const hawser_limit *l, const Mend *mend,
                        char said[REMEDY_MAX])
{
    char found[HAWSER_SHOWN_MAX], margin[128], remedy[REMEDY_MAX] = "", where[sizeof l->where + 2];
    Remedy r;
    say_margin(l, a->units, margin, sizeof margin);
    answer_line(a, word, "%s %s%s%s; %s", l->name, hawser_show(l->value, l->unit, a->units, found),
                *l->where ? " at " : "", place_mark(l->where, where, sizeof where), margin);
    if (l->ok || is_told(mend, l)) return;
    if (remedy_find(setup, l, &r)) remedy_say(&r, a->units, remedy);
    if (*remedy && strcmp(remedy, said) != 0) answer_line(a, "remedy", "%s", remedy);
    strcpy(said, remedy);
}

/* Lists the limits that are not judged, and how to see the reasons. */
static void open_line(Answer *a, int n, const hawser_limit *limit)
{
    char names[OPEN_MAX] = "";
    for (int i = 0; i < n; ++i) {
        const size_t used = strlen(names);
        if (!limit[i].judged) snprintf(names + used, sizeof names - used, "%s%s", used ? ", " : "", limit[i].name);
    }
    if (*names) answer_line(a, "not judged", "%s (--tables limits)", names);
}

enum { BROKEN_SHOWN = 3, BROKEN_BRIEF = 1 }; /* besides the worst */

static void limits_say(Answer *a, const Setup *setup, int n, const hawser_limit *limit, const Mend *mend)
{
    const hawser_limit *worst = NULL;
    const int shown = a->brief ? BROKEN_BRIEF : BROKEN_SHOWN;
    int broken = 0;
    char said[REMEDY_MAX] = "", more[OPEN_MAX] = "";
    for (int i = 0; i < n; ++i) {
        if (limit[i].judged && (!worst || limit[i].margin < worst->margin)) worst = &limit[i];
    }
    if (worst) limit_lines(a, setup, "worst", worst, mend, said);
    for (int i = 0; i < n; ++i) {
        if (!limit[i].judged || limit[i].ok || &limit[i] == worst) continue;
        if (broken++ < shown) {
            limit_lines(a, setup, "broken", &limit[i], mend, said);
        } else {
            const size_t used = strlen(more);
            snprintf(more + used, sizeof more - used, "%s%s", used ? ", " : "", limit[i].name);
        }
    }
    if (*more) answer_line(a, "broken", "%s, too (--tables limits)", more);
    if (n == 0) answer_line(a, "remedy", "give the allowed values in the case's section 'limits'");
    open_line(a, n, limit);
}

/* ------------------------------------------------------------------------------------------ the calculation */

/* Writes the place of the largest force of a way, unless that is at the end of the only section: " (pit P, the head at
 * 400 m)"; head: m along the route. */
static const char *largest_place(const Answer *a, const Setup *setup, const Calculator *c, int k, double head,
                                 char text[160])
{
    const TheoryDef *const theory = &setup->def->theory;
    const PlanSection s = plan_section_at(&c->def, k, head);
    char shown[HAWSER_SHOWN_MAX], pit[96] = "";
    *text = 0;
    if (theory->n_pits == 0 && fabs(head - s.to) < 1e-6 * c->route->length) return text;
    if (s.ends >= 0) snprintf(pit, sizeof pit, "%.80s, ", theory->pits[s.ends - theory->n_machines].name);
    if (s.ends < 0 && theory->n_pits > 0) snprintf(pit, sizeof pit, "the end, ");
    snprintf(text, 160, " (%sthe head at %s)", pit, hawser_show(head, "m", a->units, shown));
    return text;
}

/* Writes "; allowed 18.9 kN: 75.6 % left": the cable's limit, at speed or from rest, whichever leaves less; preceded by
 * its tension where that differs from the winch's force. */
static void pull_margin(const Answer *a, int n, const hawser_limit *limit, const char *force, const char *at_rest,
                        char text[MARGIN_MAX])
{
    const hawser_limit *const speed = limit_of(n, limit, HAWSER_LIMIT_PULL), *const rest = limit_of(
                                                                                 n, limit, HAWSER_LIMIT_RESTART);
    const int resting = speed && rest && at_rest && rest->judged && rest->margin < speed->margin - 1e-4;
    const hawser_limit *const l = resting ? rest : speed;
    char own[HAWSER_SHOWN_MAX];
    *text = 0;
    if (!l || !l->judged) return;
    hawser_show(l->value, "N", a->units, own);
    if (resting) force = at_rest;
    snprintf(text, MARGIN_MAX, "; %s%s%s%s", strcmp(own, force) ? "in the cable " : "", strcmp(own, force) ? own : "",
             strcmp(own, force) ? ", " : "", resting ? "from rest " : "");
    say_margin(l, a->units, text + strlen(text), MARGIN_MAX - strlen(text));
}

/* Writes the largest winch force of one way, at speed and from rest, over all sections and all places of the head. */
static void way_line(Answer *a, const Setup *setup, const Calculator *c, int k)
{
    char force[HAWSER_SHOWN_MAX], restart[HAWSER_SHOWN_MAX], margin[MARGIN_MAX], at[160], then[160];
    const HeadSeries *const heads = &c->heads[k];
    const char *const word = k == PLAN_FORWARD ? "pull" : "pulled back";
    if (!c->pulled[k].holds && !isnan(c->brake[k].brake)) {
        answer_line(a, word, "%s at the winch with the brake that is missing, %s",
                    hawser_show(c->brake[k].force, "N", a->units, force),
                    hawser_show(c->brake[k].brake, "N", a->units, restart));
        return;
    }
    hawser_show(heads->peak.force, "N", a->units, force);
    hawser_show(heads->restart_peak.restart, "N", a->units, restart);
    pull_margin(a, c->n_limits, c->limit[k], force, restart, margin);
    largest_place(a, setup, c, k, heads->peak.head, at);
    largest_place(a, setup, c, k, heads->restart_peak.head, then);
    answer_line(a, word, "%s at the winch%s, %s from rest%s%s", force, at, restart, strcmp(at, then) ? then : "",
                margin);
}

enum { MEND_SHOWN = 4, MEND_BRIEF = 2 };

/* Writes the common remedy, or that no duct, radius and friction makes the pull safe. */
static void mend_lines(Answer *a, const Setup *setup, const Mend *m, int of_run)
{
    char text[1600] = "", one[REMEDY_MAX];
    Remedy part[MEND_PARTS_MAX];
    const int n = mend_parts(setup, m, part), shown = a->brief ? MEND_BRIEF : MEND_SHOWN;
    for (int i = 0; i < n && i < shown; ++i) {
        remedy_say(&part[i], a->units, one);
        snprintf(text + strlen(text), sizeof text - strlen(text), "%s%s", i ? " and " : "", one);
    }
    if (n > shown)
        snprintf(text + strlen(text), sizeof text - strlen(text), " and %d more (--tables remedies)", n - shown);
    const char *const but = m->beside ? " for all limits but those above" : "";
    if (m->safe && of_run)
        answer_line(a, "remedy", "%s would do%s, by theory with this run's figures (%s): run the case again with it",
                    text, but, m->word);
    else if (m->safe)
        answer_line(a, "remedy", "%s would do%s; computed again: %s", text, but, m->word);
    else if (*text)
        answer_line(a, "remedy", "%s would help, but then is still broken: %s", text, m->still);
    else if (*m->still)
        answer_line(a, "remedy", "no duct, radius or lower friction makes this safe: still broken is %s", m->still);
}

/* Counts the assumptions whose range goes above the assumed value. */
static int open_ranges(const Setup *setup)
{
    Assumed list[ASSUMED_KINDS];
    const int n = assumed_list(setup, list);
    int ranges = 0;
    for (int i = 0; i < n; ++i) ranges += list[i].high > list[i].value;
    return ranges;
}

/* Writes bounds by the same calculation that would keep the limits of this way: less friction, a shorter pull,
 * machines. */
static void inverse_lines(Answer *a, const Setup *setup, const Calculator *c, const Inverse *inverse, int way)
{
    char shown[HAWSER_SHOWN_MAX], now[HAWSER_SHOWN_MAX], text[REMEDY_MAX];
    const InverseMachines *const machines = &inverse->machines[way];
    int unknown = 0;
    for (int i = 0; i < c->n_limits; ++i)
        unknown |= !c->limit[way][i].judged && limits_is(c->limit[way][i].kind, LIMIT_ESSENTIAL);
    const char *const limits = unknown ? "limits that can be judged" : "limits";
    for (int i = 0; i < inverse->n; ++i) {
        const InverseAnswer *const b = &inverse->answer[i];
        const char *const but = *b->stays ? " but " : "";
        const double least = ceil(1e3 * b->from) / 1e3, most = floor(1e3 * b->value) / 1e3; /* rounded inward */
        if (b->way == way && b->end == SEARCH_EVERYWHERE && !isnan(least))
            answer_line(a, "remedy", "friction of at least %.3g, now %.3g, would keep all %s%s%s", least, b->now,
                        limits, but, b->stays);
        if (b->way == way && b->end == SEARCH_FOUND && least <= most)
            answer_line(a, "remedy", "friction of %.3g to %.3g, now %.3g, would keep all %s%s%s", least, most, b->now,
                        limits, but, b->stays);
        if (b->way != way || b->end != SEARCH_FOUND || !(b->value < b->now)) continue;
        const Mend *const m = &inverse->mend[way];
        if (m->safe && *b->stays) continue;
        const int told = m->safe && m->n + m->n_ducts == 0; /* the common remedy has the same friction, rounded */
        if (b->kind == INVERSE_FRICTION && !told) {
            const Remedy r = friction_part(setup, b->now, b->value);
            remedy_say(&r, a->units, text);
            answer_line(a, "remedy", "%s would keep all %s%s%s", text, limits, but, b->stays);
        }
        if (b->kind == INVERSE_LENGTH)
            answer_line(a, "remedy", "a pull of at most %s, now %s, would keep all %s%s%s",
                        show_bound(b->value, 0, "m", a->units, shown), hawser_show(b->now, "m", a->units, now), limits,
                        but, b->stays);
    }
    if (inverse->asked && machines->n > 0)
        answer_line(a, "remedy", "%d machine%s of %s, the first at %s, would keep all %s%s%s%s", machines->n,
                    machines->n > 1 ? "s" : "", hawser_show(setup->def->theory.machine_push, "N", a->units, shown),
                    hawser_show(machines->at[0], "m", a->units, now), limits,
                    open_ranges(setup) ? " with what is assumed" : "", *machines->stays ? " but " : "",
                    machines->stays);
}

/* Writes the result with all assumptions at their upper ends. */
static void together_line(Answer *a, const Setup *setup, const Calculator *c)
{
    hawser_limit all[HAWSER_LIMITS_MAX];
    char found[HAWSER_SHOWN_MAX], broken[OPEN_MAX] = "";
    hawser_error err;
    if (c->n_limits == 0 || open_ranges(setup) < 2) return;
    if (assumed_together(setup, c, PLAN_FORWARD, all, &err)) return;
    const hawser_limit *const pull = limit_of(c->n_limits, all, HAWSER_LIMIT_PULL);
    for (int i = 0; i < c->n_limits; ++i) {
        const size_t used = strlen(broken);
        if (all[i].judged && !all[i].ok)
            snprintf(broken + used, sizeof broken - used, "%s%s", used ? ", " : "; broken: ", all[i].name);
    }
    if (pull)
        answer_line(a, "all at once", "all assumed at upper ends: pull %s%s",
                    hawser_show(pull->value, "N", a->units, found), broken);
}

/* Returns the verdict; in a short answer with the number of broken limits but without their names, which are in the
 * lines below. */
static const char *verdict_shown(const Answer *a, const Calculator *c, int way, const TheoryVerdict *verdict,
                                 char text[HAWSER_VERDICT_MAX])
{
    int judged = 0, broken = 0;
    if (!a->brief || verdict->word != HAWSER_NOT_SAFE) return verdict->shown;
    for (int i = 0; i < c->n_limits; ++i) {
        judged += c->limit[way][i].judged;
        broken += c->limit[way][i].judged && !c->limit[way][i].ok;
    }
    snprintf(text, HAWSER_VERDICT_MAX, "NOT SAFE: %d of %d limits broken", broken, judged);
    return text;
}

static void theory_say(Answer *a, const Setup *setup, const Calculator *c, const Inverse *inverse,
                       const TheoryVerdict verdict[PLAN_WAYS])
{
    char text[HAWSER_VERDICT_MAX], says[CANNOT_SAYS];
    const hawser_word other = verdict[PLAN_BACKWARD].word;
    answer_unusual(a, setup->def, setup->route);
    answer_assumed(a, setup, c->n_limits);
    if (setup->def->theory.simulated && head_before_bend(setup, says))
        answer_line(a, "assumed", "a rope as far as the winch, without which nothing runs: %s", says);
    const int forward = calculator_holds(c, PLAN_FORWARD);
    answer_verdict(a, verdict_shown(a, c, PLAN_FORWARD, &verdict[PLAN_FORWARD], text));
    way_line(a, setup, c, PLAN_FORWARD);
    limits_say(a, setup, c->n_limits, c->limit[PLAN_FORWARD], &inverse->mend[PLAN_FORWARD]);
    if (!forward && c->n_limits > 0) mend_lines(a, setup, &inverse->mend[PLAN_FORWARD], 0);
    if (!forward) inverse_lines(a, setup, c, inverse, PLAN_FORWARD);
    together_line(a, setup, c);
    if (!forward && (other == HAWSER_SAFE || other == HAWSER_SAFE_ONLY_IF)) {
        limits_only_if(c->n_limits, c->limit[PLAN_BACKWARD], text, sizeof text);
        answer_line(a, "remedy", "pulled from the other end: %s", text);
    }
    way_line(a, setup, c, PLAN_BACKWARD);
    answer_line(a, "", "%s", verdict_shown(a, c, PLAN_BACKWARD, &verdict[PLAN_BACKWARD], text));
}

enum { LINES_MOST = 24 }; /* below the title */

/* Writes the answer, and a shorter one instead if it takes more lines than a terminal has. */
void answer_theory(Answer *a, const Setup *setup, const Calculator *c, const Inverse *inverse,
                   const TheoryVerdict verdict[PLAN_WAYS])
{
    int lines = 0;
    theory_say(a, setup, c, inverse, verdict);
    for (const char *at = a->text; (at = strchr(at, '\n')); ++at) ++lines;
    if (lines <= LINES_MOST || a->width == 0) return;
    a->brief = 1;
    a->used = 0;
    theory_say(a, setup, c, inverse, verdict);
}

/* -------------------------------------------------------------------------------------------------- a run */

/* Writes " +- 0.38 %"; nothing where the bound is not known. A bound larger than the figure itself is useless. */
static const char *say_bar(const hawser_error_bar *bar, double figure, char text[32])
{
    *text = 0;
    if (!(bar->total >= 0) || !(fabs(figure) > 0)) return text;
    if (bar->total < fabs(figure)) snprintf(text, 32, " +- %.2g %%", 100 * bar->total / fabs(figure));
    if (bar->total >= fabs(figure)) snprintf(text, 32, " (no error bound)");
    return text;
}

/* Writes the winch's force against the cable's limit. */
static void pull_line(Answer *a, const hawser_summary *s, int n, const hawser_limit *limit)
{
    char mean[HAWSER_SHOWN_MAX], peak[HAWSER_SHOWN_MAX], bar[32], peak_bar[32], margin[MARGIN_MAX];
    pull_margin(a, n, limit, hawser_show(s->pull_peak_N, "N", a->units, peak), NULL, margin);
    say_bar(&s->pull_peak_error, s->pull_peak_N, peak_bar);
    if (!(s->pull_peak_N > 0)) {
        answer_line(a, "pull", "nothing was pulled: there is no winch, or its rope stayed slack");
    } else if (isnan(s->pull_mean_N) || !(s->steady_to_s > s->steady_from_s)) {
        answer_line(a, "pull", "peak %s%s; no mean: its window begins at %g s, the run ended at %.4g s%s", peak,
                    peak_bar, s->steady_from_s, s->sim_time_s, margin);
    } else {
        answer_line(a, "pull", "mean %s%s, peak %s%s%s", hawser_show(s->pull_mean_N, "N", a->units, mean),
                    say_bar(&s->pull_mean_error, s->pull_mean_N, bar), peak, peak_bar, margin);
    }
}

/* Writes where the pull is largest, and the largest figures there. */
static void place_lines(Answer *a, const hawser_summary *s)
{
    char pull[HAWSER_SHOWN_MAX], at[HAWSER_SHOWN_MAX], what[HAWSER_SHOWN_MAX], last[HAWSER_SHOWN_MAX];
    const hawser_place *const p = s->worst_place;
    if (!p) return;
    answer_line(a, "position", "worst with the front at %s: %s, of %d between %s and %s",
                hawser_show(p->head_m, "m", a->units, at), hawser_show(p->pull_N, "N", a->units, pull), s->n_places,
                hawser_show(s->places[0].head_m, "m", a->units, what),
                hawser_show(s->places[s->n_places - 1].head_m, "m", a->units, last));
    if (p->sidewall_N_per_m > 0)
        answer_line(a, "", "sidewall pressure there up to %s, at %s",
                    hawser_show(p->sidewall_N_per_m, "N/m", a->units, what),
                    hawser_show(p->sidewall_at_m, "m", a->units, at));
    if (p->roller)
        answer_line(a, "", "roller load there up to %s, on %c%s%c", hawser_show(p->roller_N, "N", a->units, what),
                    NAME_BEGINS, p->roller, NAME_ENDS);
}

static const double REACHED = 0.995; /* share of the route at which the pull counts as finished */

/* Notes that the limits cover only the part of the pull that was run. */
static void reached_line(Answer *a, hawser_sim *s)
{
    const Scene *const scene = &s->stage.scene;
    const double front = scene->joint_s[scene->eye] + s->look.sample.winch_travel, length = scene->route.length;
    char at[HAWSER_SHOWN_MAX], of[HAWSER_SHOWN_MAX];
    if (!scene->winch->present || scene->def.analysis.kind != ANALYSIS_DYNAMICS || !(front < REACHED * length)) return;
    answer_line(a, "reached", "the cable's front reached %s of %s: the answer covers the pull up to there",
                hawser_show(front, "m", a->units, at), hawser_show(length, "m", a->units, of));
}

/* Writes the reasons why the figures cannot be trusted, one a line; or that they can. */
static void trust_lines(Answer *a, const hawser_summary *s)
{
    char found[HAWSER_SHOWN_MAX], allowed[HAWSER_SHOWN_MAX];
    int failed = 0;
    for (int i = 0; i < s->n_conditions; ++i) {
        const hawser_condition *const c = &s->conditions[i];
        if (c->holds) continue;
        answer_line(a, c->name, "%s (found %s, allowed %s)", c->remedy, hawser_show(c->value, c->unit, a->units, found),
                    hawser_show(c->allowed, c->unit, a->units, allowed));
        ++failed;
    }
    if (!failed) answer_line(a, "trust", "the figures are to be trusted: all %d conditions hold", s->n_conditions);
}

/* Writes a common remedy for the limits that theory computes, and single remedies for the rest. */
static void run_limits_say(Answer *a, const hawser_sim *s, int n, const hawser_limit *limit)
{
    const Setup *const setup = &s->stage.scene.setup;
    Mend mend;
    const int together = mend_run(s, n, limit, &mend);
    limits_say(a, setup, n, limit, together ? &mend : NULL);
    if (together) mend_lines(a, setup, &mend, 1);
}

/* Writes only whether the figures can be trusted for a rod: it is not pulled and has no limits. */
const char *hawser_sim_answer(hawser_sim *s, hawser_units units, char *text, size_t size)
{
    if (!s || !text || size == 0) return "";
    hawser_summary sum;
    hawser_limit limit[HAWSER_LIMITS_MAX];
    char verdict[HAWSER_VERDICT_MAX];
    Answer a = {.text = text, .size = size, .units = units, .width = TERMINAL_WIDTH};
    s = SHOWN(s);
    hawser_sim_summary(s, &sum);
    const int n = hawser_sim_limits(s, limit), broken = verdict_say(0, NULL, n, limit, 0, verdict, sizeof verdict);
    int failed = 0;
    for (int i = 0; i < sum.n_conditions; ++i) failed += !sum.conditions[i].holds;
    if (failed) {
        snprintf(verdict, sizeof verdict, "NOT TRUSTED, for %d reason%s", failed, failed > 1 ? "s" : "");
        if (broken > 0) snprintf(verdict + strlen(verdict), 64, "; besides, %d of the limits would be broken", broken);
    }
    answer_unusual(&a, &s->stage.scene.def, &s->stage.scene.route);
    answer_assumed(&a, &s->stage.scene.setup, n);
    answer_verdict(&a, verdict);
    if (failed) trust_lines(&a, &sum);
    place_lines(&a, &sum);
    if (!sum.rod) {
        pull_line(&a, &sum, n, limit);
        if (n > 0) reached_line(&a, s);
        if (s->stage.scene.def.theory.n_pits > 0)
            answer_line(&a, "pits",
                        "a run is one pull: it does not begin anew at theory.pits, which hawser theory does");
        if (n > 0 || !failed) run_limits_say(&a, s, n, limit);
    }
    if (!failed) trust_lines(&a, &sum);
    if (sum.passes) answer_line(&a, "passes", "%s: %s", sum.passes->why, sum.passes->says);
    return text;
}

/* Remedies that would make a broken limit hold, from the figures of the limit and of the scene. */

/* Reserve of a remedy for a run's figure: when one place holds the next one may be the worst, and the next run has
 * another error bound. */
static const double SPARE = 1.005;

const char *show_bound(double value, int least, const char *unit, hawser_units units, char *text)
{
    const double shown = value * scale_of(unit, value, units).factor, step = pow(10, floor(log10(shown)) - 2);
    const double steps = least ? ceil(shown / step - 1e-9) : floor(shown / step + 1e-9);
    return hawser_show(value * (steps * step / shown), unit, units, text);
}

/* Returns the bend at a place that begins with metres along the route, "17.3 m (out)": the one there, or one that ends
 * or begins within the rounding; -1 if there is none. */
static int bend_at(const Route *route, const char *where)
{
    char *end;
    const double s = strtod(where, &end);
    int found = -1;
    if (end == where || strncmp(end, " m", 2) != 0) return -1;
    for (int p = 0; p < route->n; ++p) {
        const RoutePiece *const piece = &route->piece[p];
        if (piece->kind != ROUTE_BEND || s < piece->s0 - 0.06 || s > piece->s0 + piece->length + 0.06) continue;
        if (found < 0 || (s > piece->s0 && s < piece->s0 + piece->length)) found = p;
    }
    return found;
}

/* Returns the duct of that name; -1 if there is none. */
static int duct_called(const SceneDef *def, const char *name)
{
    for (int i = 0; i < def->n_surfaces; ++i) {
        const SurfaceDef *const s = &def->surfaces[i];
        if (s->shape.kind == SURFACE_DUCT && !strcmp(s->name, name)) return i;
    }
    return -1;
}

static double largest_friction(const FrictionLaw *law) { return fmax(law->mu_s, law->mu_d); }

/* Returns the largest growth of a bend's tension with its radius, N/m, also from rest. A longer bend carries more
 * weight; friction takes mu of it at the beginning and exp(mu angle) times as much at the end; a climb takes all of it.
 */
static double tension_by_radius(const Setup *setup, const RoutePiece *bend)
{
    const SceneDef *const def = setup->def;
    double mu = largest_friction(&def->friction);
    for (int i = 0; i < def->n_surfaces; ++i) mu = fmax(mu, largest_friction(&def->surfaces[i].friction));
    const Supports *const map = &setup->supports;
    for (int i = supports_from(map, bend->s0); i < map->n_rollers && map->roller[i].s <= bend->s0 + bend->length; ++i)
        mu = fmax(mu, largest_friction(&def->rollers[map->roller[i].item].friction));
    const double rise =
        fabs(route_slope(setup->route, bend->s0)) + fabs(route_slope(setup->route, bend->s0 + bend->length));
    return setup->cable_weight * bend->angle * (mu * exp(mu * bend->angle) + (rise > 1e-6 ? 1 : 0));
}

/* Finds the smallest R' with (T + k (R' - R)) / R' at the limit: T/R falls as R grows. */
static void sidewall_remedy(const Setup *setup, const hawser_limit *l, Remedy *r)
{
    const int p = bend_at(setup->route, l->where);
    const RoutePiece *const bend = p >= 0 ? &setup->route->piece[p] : NULL;
    const double k = bend ? tension_by_radius(setup, bend) : INFINITY;
    r->code = l->limit > k ? "radius" : "less_tension";
    r->share = 1 - l->limit / l->value;
    if (!(l->limit > k)) return;
    assert(bend);
    r->unit = "m";
    r->now = mend_radius_given(setup->def, setup->route, p);
    r->least = r->now * (l->value - k) / (l->limit - k);
    snprintf(r->where, sizeof r->where, "%s", bend->name);
    mend_key(setup, p, r->key);
}

/* Considers all limits of the duct together, so that the remedy for one does not break another. */
static void duct_remedy(const Setup *setup, const hawser_limit *l, Remedy *r)
{
    const int i = duct_called(setup->def, l->where);
    MendDuct found;
    if (i < 0 || !mend_duct(setup->def, i, &found)) return;
    r->code = found.least > found.now ? "wider_duct" : "narrower_duct";
    r->unit = "m";
    r->now = found.now;
    r->least = found.least;
    r->most = isinf(found.most) ? NAN : found.most;
    snprintf(r->where, sizeof r->where, "%s", setup->def->surfaces[i].name);
    surface_key(setup->def, i, "radius", r->key);
}

/* Remedies that are the limit itself or the amount missing to it; their keys and sentences are below. */
typedef enum Bound { BOUND_NONE, BOUND_LEAST, BOUND_MOST, BOUND_OVER } Bound;

static const struct SimpleRemedy {
    Bound bound;
    const char *code, *key, *text;
} simple[LIMIT_KINDS] = {
#define LIMIT_REMEDY(kind, ...) [HAWSER_LIMIT_##kind] = {__VA_ARGS__},
#include "def/limit_kinds.h"
};

static void simple_remedy(const hawser_limit *l, Remedy *r)
{
    const struct SimpleRemedy *const by = (int)l->kind < LIMIT_KINDS ? &simple[l->kind] : NULL;
    if (by && by->code) {
        r->code = by->code;
        r->unit = l->unit;
        snprintf(r->key, sizeof r->key, "%s", by->key);
        if (by->bound == BOUND_LEAST) r->least = l->limit;
        if (by->bound == BOUND_MOST) *(l->value < l->limit ? &r->least : &r->most) = l->limit;
        if (by->bound == BOUND_OVER) r->least = l->value - l->limit;
    }
    if (!strcmp(l->where, "theory.feed")) {
        r->code = "less_feed";
        r->unit = "N";
        r->least = NAN;
        r->most = l->limit;
        snprintf(r->key, sizeof r->key, "theory.feed");
    }
    if (!strncmp(l->source, LIMITS_NO_TRIP, strlen(LIMITS_NO_TRIP))) r->code = NULL; /* in its sentence */
}

/* Shares the brake force among the cables, each with its own `drive.tail` (BU10); a machine that pushes the cable from
 * behind may push less. */
static void run_away_remedy(const Setup *setup, const hawser_limit *l, Remedy *r)
{
    const int tails = bundle_tails(&setup->def->bundle);
    r->code = tails > 1 ? "brake_each" : "brake";
    r->unit = "N";
    r->least = l->value / tails;
    snprintf(r->key, sizeof r->key, "drive.tail.tension");
    if (setup->def->theory.feed > 0) snprintf(r->also, sizeof r->also, "theory.feed");
}

int remedy_find(const Setup *setup, const hawser_limit *broken, Remedy *r)
{
    hawser_limit sure = *broken;
    const hawser_limit *const l = &sure;
    if (sure.error > 0) sure.value = SPARE * (sure.value + sure.error); /* the remedy must hold for certain */
    *r = (Remedy){.limit = broken->name, .unit = "1", .least = NAN, .most = NAN, .now = NAN, .share = NAN};
    switch (l->kind) {
    case HAWSER_LIMIT_SIDEWALL:
        sidewall_remedy(setup, l, r);
        break;
    case HAWSER_LIMIT_ROPE: /* the limit is the strength over its factor of safety */
        r->code = "rope_strength";
        r->unit = "N";
        r->least = l->value * (setup->def->limits.rope_strength / l->limit);
        snprintf(r->key, sizeof r->key, "limits.rope_strength");
        break;
    case HAWSER_LIMIT_JAM_RATIO:
    case HAWSER_LIMIT_CLEARANCE:
    case HAWSER_LIMIT_FILL:
    case HAWSER_LIMIT_WEIGHT_CORRECTION:
        duct_remedy(setup, l, r);
        break;
    case HAWSER_LIMIT_ROLLER_STEADY:
    case HAWSER_LIMIT_ROLLER_PEAK:
        r->code = "more_rollers";
        r->share = floor(1e3 * l->limit / l->value) / 1e3;
        r->least = l->value / l->limit;
        if (l->kind == HAWSER_LIMIT_ROLLER_PEAK) snprintf(r->also, sizeof r->also, "drive.winch.to");
        break;
    case HAWSER_LIMIT_RUN_AWAY:
        run_away_remedy(setup, l, r);
        break;
    default:
        simple_remedy(l, r);
        if (l->kind == HAWSER_LIMIT_BUCKLING && setup->def->theory.feed > 0)
            snprintf(r->key, sizeof r->key, "theory.feed");
    }
    return r->code != NULL;
}

/* ------------------------------------------------------------------------------- the common remedy */

static Remedy part_of(const char *code, const char *where, double now)
{
    Remedy r = {.code = code, .limit = "all", .unit = "m", .now = now, .least = NAN, .most = NAN, .share = NAN};
    snprintf(r.where, sizeof r.where, "%s", where);
    return r;
}

static Remedy duct_part(const Setup *setup, const MendDuct *duct)
{
    const int wider = duct->least > duct->now;
    Remedy r =
        part_of(wider ? "do_wider_duct" : "do_narrower_duct", setup->def->surfaces[duct->surface].name, duct->now);
    r.least = wider ? duct->taken : duct->least;
    r.most = isinf(duct->most) ? NAN : duct->most;
    surface_key(setup->def, duct->surface, "radius", r.key);
    return r;
}

/* All changes of slope share one radius. */
static Remedy bend_part(const Setup *setup, const MendBend *bend)
{
    const RoutePiece *const piece = &setup->route->piece[bend->piece];
    char key[sizeof(Remedy){0}.key];
    mend_key(setup, bend->piece, key);
    Remedy r = part_of(!piece->listed && *key ? "do_slopes" : "do_radius", piece->name, bend->now);
    r.least = bend->radius;
    memcpy(r.key, key, sizeof r.key);
    return r;
}

Remedy friction_part(const Setup *setup, double now, double most)
{
    FrictionUsed used[16];
    const int n = frictions_used(setup, 16, used);
    int top = 0;
    for (int i = 1; i < n; ++i)
        if (used[i].moving > used[top].moving) top = i;
    const int apart = n > 0 && !used[top].rest_assumed;
    Remedy r = part_of(n > 1 ? "do_frictions" : "do_friction", "", now);
    r.unit = "1";
    r.most = most;
    if (n == 1) snprintf(r.key, sizeof r.key, "%.40s.mu%s", used[0].key, used[0].apart ? "_d" : "");
    if (apart) show_bound(most / now * used[top].rest, 0, "1", HAWSER_SI, r.also);
    return r;
}

int mend_parts(const Setup *setup, const Mend *m, Remedy part[MEND_PARTS_MAX])
{
    int n = 0, slopes = 0;
    for (int i = 0; i < m->n_ducts; ++i) part[n++] = duct_part(setup, &m->duct[i]);
    for (int i = 0; i < m->n; ++i) {
        part[n] = bend_part(setup, &m->bend[i]);
        if (!strcmp(part[n].code, "do_slopes") && slopes++) continue;
        ++n;
    }
    if (m->friction > 0) part[n++] = friction_part(setup, m->now, m->friction);
    return n;
}

int mend_run(const hawser_sim *s, int n, const hawser_limit *limit, Mend *out)
{
    int broken = 0;
    for (int i = 0; i < n; ++i) broken |= limit[i].judged && !limit[i].ok && limits_is(limit[i].kind, LIMIT_MENDED);
    if (!broken) return 0;
    const Setup *const setup = &s->stage.scene.setup;
    Calculator c;
    const int found = !calculator_build(setup, &s->expected, 1, &c, NULL) &&
                      !mend_find(setup, &c, NULL, PLAN_FORWARD, n, limit, out, NULL) && out->safe;
    calculator_free(&c);
    return found;
}

/* ------------------------------------------------------------------------------------------------------- sentences */

/* Sentences of the codes that the kinds do not have. {NAME} is a value; a part in [...] is omitted if one of its values
 * is missing, or replaced by the text behind its '|'. */
static const struct RemedySentence {
    const char *code, *text;
} sentence[] = {
    {"radius", "a radius of {least}[ in '{where}'| there] would keep this limit ([{key}, ]now {now}), or {percent} % "
               "less tension "
               "there"},
    {"less_tension", "{percent} % less tension there, or what presses less"},
    {"rope_strength", "a rope that breaks at {least} ({key}), or less pull"},
    {"wider_duct", "an inside diameter of at least {least}[ and at most {most}] in '{where}' would keep its limits "
                   "(now {now}, twice {key})"},
    {"narrower_duct",
     "an inside diameter of at most {most} and at least {least} in '{where}' would keep its limits (now {now}, twice "
     "{key})"},
    {"do_wider_duct",
     "an inside diameter of at least {least}[ and at most {most}] in '{where}' (now {now}, twice {key})"},
    {"do_narrower_duct",
     "an inside diameter of at most {most} and at least {least} in '{where}' (now {now}, twice {key})"},
    {"do_radius", "a radius of {least}[ in '{where}'| there] ([{key}, ]now {now})"},
    {"do_slopes", "a radius of {least} at changes of slope ({key}, now {now})"},
    {"do_friction", "friction of at most {most}[ and at rest {also}] ({key}, now {now})"},
    {"do_frictions", "friction of at most {most}[ and at rest {also}] where it is {now}, elsewhere in proportion,"},
    {"more_rollers",
     "rollers there at {share} of their spacing, or rated {least} times as high[, or a softer start ({also})]"},
    {"brake", "a brake of {least} more where the pull begins ({key})[, or less feed ({also})]"},
    {"brake_each", "a brake of {least} more where the pull begins ({key}, of each cable)[, or less feed ({also})]"},
    {"less_feed", "less feed ({key}): at most {most}"},
};

static const char *sentence_of(const Remedy *r)
{
    for (size_t k = 0; r->code && k < sizeof sentence / sizeof *sentence; ++k)
        if (!strcmp(sentence[k].code, r->code)) return sentence[k].text;
    for (int k = 0; r->code && k < LIMIT_KINDS; ++k)
        if (simple[k].text && !strcmp(simple[k].code, r->code)) return simple[k].text;
    return NULL;
}

/* Returns the value called name [n]; "" if there is none. */
static const char *remedy_value(const Remedy *r, const char *name, size_t n, hawser_units units, char text[64])
{
    const struct {
        const char *name;
        double value;
        int least; /* > 0: rounded up, 0: down, < 0: to the nearest */
        const char *unit;
    } number[] = {{"least", r->least, 1, r->unit}, {"most", r->most, 0, r->unit}, {"now", r->now, -1, r->unit}};
    *text = 0;
    for (size_t k = 0; k < sizeof number / sizeof *number; ++k) {
        if (strncmp(number[k].name, name, n) != 0 || isnan(number[k].value)) continue;
        if (number[k].least < 0) return hawser_show(number[k].value, number[k].unit, units, text);
        return show_bound(number[k].value, number[k].least, number[k].unit, units, text);
    }
    if (!strncmp("where", name, n)) return r->where;
    if (!strncmp("key", name, n)) return r->key;
    if (!strncmp("also", name, n)) return r->also;
    if (!strncmp("share", name, n)) snprintf(text, 64, "%.3g", r->share);
    if (!strncmp("percent", name, n)) snprintf(text, 64, "%.3g", 100 * r->share);
    return text;
}

void remedy_say(const Remedy *r, hawser_units units, char text[REMEDY_MAX])
{
    size_t n = 0, group = 0; /* beginning of the group */
    size_t whole = 0;        /* end of the group, while its replacement is skipped */
    int missing = 0;         /* a value of the group is missing */
    char value[64];
    for (const char *from = sentence_of(r); from && *from; ++from) {
        const char *piece = from;
        size_t size = 1;
        if (*from == '{') {
            const size_t name = strcspn(from + 1, "}");
            piece = remedy_value(r, from + 1, name, units, value);
            size = strlen(piece);
            missing |= !size;
            from += name + 1;
        } else if (*from == '[') {
            group = n, missing = 0;
            continue;
        } else if (*from == '|' || *from == ']') {
            if (missing) n = group;
            if (whole) n = whole;
            whole = *from == '|' && !missing ? n : 0;
            missing = 0;
            continue;
        }
        if (size > REMEDY_MAX - 1 - n) size = REMEDY_MAX - 1 - n;
        memcpy(text + n, piece, size);
        n += size;
    }
    text[n] = 0;
}
