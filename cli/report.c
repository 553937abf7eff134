/* Prints the report. All of it is also in summary.json, stations.csv and rollers.csv, which programs should read: the
 * layout here may change. It begins with the answer; the cost of the computation is shown on request alone. */
#include <assert.h>
#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/commands.h"
#include "hawser/hawser.h"

enum { SENTENCE_MAX = 1024, PAGE = 118 };

/* Data of the report, and their form. */
typedef struct Report {
    hawser_summary sum;
    hawser_units units;
    hawser_sim *sim;
    int all, n_limits; /* all: further figures, too */
    hawser_limit limit[HAWSER_LIMITS_MAX];
} Report;

static void say(const Report *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Prints as printf, with numbers before an SI unit converted to the reader's units. */
static void say(const Report *r, const char *format, ...)
{
    char si[SENTENCE_MAX], shown[SENTENCE_MAX];
    va_list args;
    va_start(args, format);
    vsnprintf(si, sizeof si, format, args);
    va_end(args);
    fputs(hawser_show_text(si, r->units, shown, sizeof shown), stdout);
}

/* Prints a rod's places at the end of the run. */
static void report_rod(const Report *r)
{
    const hawser_summary *s = &r->sum;
    printf("\nAt the end (%s); forces are those of the part ahead on the part behind\n", s->analysis);
    for (int i = 0; i < s->n_probes; i++) {
        const hawser_probe *p = &s->probes[i];
        const double *const d = p->displacement, *const q = p->rotation, *const f = p->force, *const m = p->moment;
        say(r, "  %-12s moved (%.6g m, %.6g m, %.6g m), turned (%.6g, %.6g, %.6g) rad\n", p->name, d[0], d[1], d[2],
            q[0], q[1], q[2]);
        say(r, "  %-12s force (%.6g N, %.6g N, %.6g N), moment (%.6g N m, %.6g N m, %.6g N m)\n", "", f[0], f[1], f[2],
            m[0], m[1], m[2]);
    }
}

/* Prints frequencies, one line each. */
static void report_modes(const Report *r)
{
    const hawser_summary *const s = &r->sum;
    if (s->n_modes > 0) printf("\nModes about the last equilibrium\n");
    for (int i = 0; i < s->n_modes; i++) {
        const hawser_mode *m = &s->modes[i];
        printf("  %3d %14.6g Hz", i + 1, m->frequency_Hz);
        if (m->growth_per_s > 0) printf("   not stable: grows by exp(t / %.4g s)", 1 / m->growth_per_s);
        printf("\n");
    }
}

/* Prints loads at which an equilibrium became unstable, and the outcome of the run. */
static void report_stability(const Report *r)
{
    const hawser_summary *s = &r->sum;
    if (s->n_critical > 0) printf("\nCritical loads\n");
    for (int i = 0; i < s->n_critical; i++) {
        const hawser_critical *const c = &s->critical[i];
        const double *const d = c->direction;
        say(r, "  %-12s at %.6g s, %.6g of the run; moves most at %.4g m, along (%.3g, %.3g, %.3g)\n", c->kind, c->t,
            c->share, c->at, d[0], d[1], d[2]);
    }
    if (s->unstable > 0) printf("  the last equilibrium is not stable: %d motions grow\n", s->unstable);
    if (s->unstable == 0) printf("  the last equilibrium is stable\n");
}

/* Prints, before the run, the case and on request the counts of its model. */
void report_scene(const hawser_sim *s, const Arguments *args)
{
    hawser_summary sum;
    hawser_sim_summary(s, &sum);
    printf("%s\n", hawser_sim_title(s));
    if (!args->verbose) return;
    printf("  %d segments, %d bushings, %d rollers, %d contact candidates; %g s to simulate\n", sum.segments,
           sum.bushings, sum.rollers, sum.contact_candidates, hawser_sim_end_time(s));
}

/* Prints whether the run began at rest. Failing to reach it is no error, but the start of the run cannot be trusted
 * then. */
static void report_relaxation(const Report *report)
{
    const hawser_relaxation *const r = &report->sum.relaxation;
    if (!(r->tolerance_N > 0)) return; /* the case forbids it */
    if (r->reached) {
        say(report,
            "\nAt rest before t = 0: largest unbalanced force %.2g N after %d iterations, moved by up to %.3g mm\n",
            r->residual_N, r->iterations, 1e3 * r->moved_m);
    } else {
        say(report, "\nNot at rest before t = 0: %.3g N are unbalanced at segment %d (aim: %.3g N)\n", r->residual_N,
            r->segment, r->tolerance_N);
    }
}

/* Prints one theory: its winch force, the simulated mean's distance from it, and the stations' errors. */
static void report_theory(const Report *r, const char *name, double total, double max_pct, double mean_pct)
{
    char force[HAWSER_SHOWN_MAX];
    if (!(total > 0)) return;
    printf("  %-18s %14s %+12.2f %%", name, hawser_show(total, "N", r->units, force),
           100 * (r->sum.pull_mean_N - total) / total);
    if (isnan(max_pct)) printf(" %23s %9s\n", "no stations", "-");
    if (!isnan(max_pct)) printf(" %21.2f %% %7.2f %%\n", max_pct, mean_pct);
}

/* Prints how even the pull was, and theory's value of it; the pull itself is in the answer. */
static void report_pull(const Report *r)
{
    const hawser_summary *s = &r->sum;
    if (!(s->pull_peak_N > 0) || isnan(s->pull_mean_N) || !(s->steady_to_s > s->steady_from_s)) return;
    say(r, "\nSteady pull from %g s to %g s: ripple %.3g N RMS, speed %.5g m/s, ", s->steady_from_s, s->steady_to_s,
        s->pull_ripple_N, s->steady_speed_m_per_s);
    if (s->settle_time_s < s->sim_time_s * (1 - 1e-9))
        printf("settled at %.4g s\n", s->settle_time_s);
    else
        printf("not settled when the run ended\n");
    printf("  %-18s %14s %14s %23s %9s\n", "", "winch force", "pull is off by", "tension error: largest", "mean");
    report_theory(r, "reference theory", s->reference_total_N, s->error_max_pct, s->error_mean_pct);
    if (r->all) /* the formulas have no level bends */
        report_theory(r, "piece formulas", s->paper_total_N, s->error_max_paper_pct, s->error_mean_paper_pct);
}

/* Prints the figures of machines, one line each, under the heading of their kind. */
static void report_machines(const Report *r)
{
    char figure[2 * HAWSER_SHOWN_MAX];
    const char *kind = "";
    for (int i = 0; i < r->sum.n_machines; i++) {
        const hawser_machine *m = &r->sum.machines[i];
        if (strcmp(kind, m->kind)) printf("  %s:\n", kind = m->kind);
        printf("    %s:", m->name);
        for (int k = 0; k < m->n_figures; k++) {
            printf("%s %s", k ? "," : "", hawser_show_figure(&m->figure[k], r->units, figure));
        }
        printf("\n");
    }
}

/* Prints the bundle of the equivalent cable: its terms, then a line for each duct. */
static void report_bundle(const Report *r)
{
    const hawser_bundle *const b = r->sum.bundle;
    if (!b) return;
    say(r,
        "\nBundle: %s taken as one cable, %.4g kg/m, EA %.4g MN, EI %.4g N m2, GJ %.4g N m2, touching with %.4g mm\n",
        b->name, b->mass_kg_per_m, b->EA_N / 1e6, b->EI_N_m2, b->GJ_N_m2, 1e3 * b->diameter_m);
    for (int i = 0; i < b->n_ducts; i++) {
        const hawser_bundle_duct *const d = &b->ducts[i];
        printf(
            "  %s: %s, weight factor %.4g (%s), so friction %.4g, in bends %.4g; the worst cable bears %.3g of T/R\n",
            d->name, d->layout, d->weight_factor, b->weight_correction, d->friction_straight, d->friction_bend,
            d->sidewall_factor);
        say(r, "  %*s  jam ratio %.3g (risk %s), clearance %.3g mm, fill %.3g %%, room %.3g mm\n", (int)strlen(d->name),
            "", d->jam_ratio, d->jam_risk, 1e3 * d->clearance_m, 100 * d->fill, 1e3 * d->room_m);
    }
}

/* Prints trips and their consequences. */
static void report_events(const Report *r)
{
    for (int i = 0; i < r->sum.n_events; i++) {
        const hawser_event *e = &r->sum.events[i];
        say(r, "  t = %8.3f s: %s, pull %.2f N\n", e->t, e->what, e->pull_N);
    }
}

/* Prints the most heavily loaded roller. */
static void report_rollers(const Report *report)
{
    char load[HAWSER_SHOWN_MAX];
    const hawser_roller *r;
    const int n = hawser_sim_rollers(report->sim, &r);
    if (n == 0) return;
    const hawser_roller *heaviest = &r[0];
    for (int i = 1; i < n; i++) {
        if (r[i].peak_N > heaviest->peak_N) heaviest = &r[i];
    }
    printf("  largest roller load %s on %s", hawser_show(heaviest->peak_N, "N", report->units, load), heaviest->name);
    if (!isnan(heaviest->steady_N)) printf(", steady %s", hawser_show(heaviest->steady_N, "N", report->units, load));
    if (heaviest->rating_N > 0) printf(", rated %s", hawser_show(heaviest->rating_N, "N", report->units, load));
    printf("\n");
}

/* Prints the cost, in the integrator's own counts. */
static void report_work(const Report *r)
{
    const hawser_summary *const s = &r->sum;
    printf("\nWork: %g s in %.3g s (%.3g x real time), %ld steps (%.0f a second)\n", s->sim_time_s, s->wall_time_s,
           s->real_time_factor, s->steps, s->steps_per_second);
    printf("  %ld right-hand sides, %ld Newton iterations, %ld Jacobians, %ld set-ups, %ld error-test and "
           "%ld Newton "
           "failures\n",
           s->rhs_evals, s->newton_iters, s->jac_evals, s->lin_setups, s->error_test_fails, s->newton_fails);
    printf("  %d contact candidates, at most %d active, looked up %ld times\n", s->contact_candidates,
           s->contact_active_max, s->contact_refreshes);
    printf("  linear solver: %s", s->linear_solver ? s->linear_solver : "?");
    if (s->ordering && s->ordering[0]) printf(", %s ordering", s->ordering);
    if (s->linear_solver_why && s->linear_solver_why[0]) printf(" (%s)", s->linear_solver_why);
    printf("; %d thread%s\n", s->threads, s->threads == 1 ? "" : "s");
    printf("  solved in %s (%s); integration by %s\n", s->planar ? "the plane" : "space", s->planar_why, s->method);
}

/* Prints the balances of energy and momentum. */
static void report_balance(const Report *r)
{
    const hawser_balance *const b = r->sum.balance;
    if (!b) return;
    say(r,
        "\nBalances: energy closes to %.2g %% of what goes through '%s' (%.4g kJ), momentum to %.2g %% of the largest "
        "impulse; the steps in time took %.2g %%\n",
        100 * b->residual_share, b->turnover_of, b->turnover_J / 1e3, 100 * b->impulse_residual_share,
        100 * b->numerical_share);
}

/* Prints wall time by phase, so that a slow case shows its reason. */
static void report_phases(const Report *r)
{
    const hawser_summary *const s = &r->sum;
    const hawser_phases *p = &s->phases;
    const struct {
        const char *name;
        double time;
    } row[] = {{"relaxation", p->relax},           {"right-hand side", p->rhs}, {"contacts", p->contacts},
               {"Jacobian blocks", p->jacobian},   {"factor", p->factor},       {"solve", p->solve},
               {"vectors and control", p->vector}, {"output", p->output},       {"other", p->other}};
    printf("\nWhere the time went\n");
    for (int i = 0; i < 9; i++) {
        const double share = s->wall_time_s > 0 ? 100 * row[i].time / s->wall_time_s : 0;
        printf("  %-20s %9.2f ms %6.1f %%\n", row[i].name, 1e3 * row[i].time, share);
    }
}

/* Prints the limits one by one; the source of a limit stands below it if the line is too short for it. */
static void report_limits(const Report *r)
{
    const int n = r->n_limits;
    char found[HAWSER_SHOWN_MAX], allowed[HAWSER_SHOWN_MAX], where[SENTENCE_MAX], source[SENTENCE_MAX];
    if (n > 0) printf("\nLimits\n  %-14s %13s %13s %9s\n", "", "found", "allowed", "margin");
    for (int i = 0; i < n; i++) {
        const hawser_limit *l = &r->limit[i];
        if (isdigit((unsigned char)*l->where)) hawser_show_text(l->where, r->units, where, sizeof where);
        if (!isdigit((unsigned char)*l->where)) snprintf(where, sizeof where, "%s", l->where); /* a name */
        hawser_show_text(l->source, r->units, source, sizeof source);
        int used = printf("  %-14s %13s %13s ", l->name, hawser_show(l->value, l->unit, r->units, found),
                          hawser_show(l->limit, l->unit, r->units, allowed));
        if (l->judged) used += printf("%7.1f %%  %-7s %s", 100 * l->margin, l->ok ? "holds" : "BROKEN", where);
        if (!l->judged) used += printf("%9s  not judged", "-");
        const int fits = used + 2 + (int)strlen(source) <= PAGE;
        printf(!fits ? "\n                 %s\n" : *where || !l->judged ? "; %s\n" : "%s\n", source);
    }
}

static void report_known(const Report *r) { report_assumptions(r->sim, r->units); }

/* Below the answer, in the order of a planner's questions. */
static const struct Part {
    const char *name; /* NULL: it is always printed */
    int rod;          /* 1: for rods alone, 0: for pulls alone, -1: for both */
    void (*print)(const Report *r);
} parts[] = {{NULL, 1, report_rod},        {NULL, 1, report_stability},       {NULL, 1, report_modes},
             {NULL, 0, report_pull},       {NULL, -1, report_events},         {NULL, -1, report_rollers},
             {"bundle", 0, report_bundle}, {"machines", -1, report_machines}, {"limits", 0, report_limits},
             {NULL, -1, report_known},     {"rest", -1, report_relaxation},   {"balances", -1, report_balance},
             {"work", -1, report_work},    {"times", -1, report_phases}};

enum { PARTS = sizeof parts / sizeof *parts };

/* Checks whether a list of names with commas between has that name. */
static int is_listed(const char *list, const char *name)
{
    for (const char *at = list; at; at = strchr(at, ',') ? strchr(at, ',') + 1 : NULL)
        if (strcspn(at, ",") == strlen(name) && !strncmp(at, name, strlen(name))) return 1;
    return 0;
}

int report_tables_check(const char *list)
{
    const char *names[PARTS + 1] = {"all"};
    int n = 1;
    for (int k = 0; k < PARTS; k++)
        if (parts[k].name) names[n++] = parts[k].name;
    for (const char *at = list; at; at = strchr(at, ',') ? strchr(at, ',') + 1 : NULL) {
        char name[32];
        snprintf(name, sizeof name, "%.*s", (int)strcspn(at, ","), at);
        if (choose("--tables", name, n, names) < 0) return 0;
    }
    return 1;
}

void report_run(hawser_sim *s, const Arguments *args, const char *dir)
{
    Report r = {.units = args->units, .sim = s, .all = args->verbose || is_listed(args->tables, "all")};
    char answer[HAWSER_ANSWER_MAX];
    hawser_sim_summary(s, &r.sum);
    r.n_limits = hawser_sim_limits(s, r.limit);
    putchar('\n');
    print_answer(args, hawser_sim_answer(s, args->units, answer, sizeof answer));
    for (int k = 0; k < PARTS; k++) {
        const struct Part *const part = &parts[k];
        if (part->rod >= 0 && part->rod != !!r.sum.rod) continue;
        if (!part->name || r.all || is_listed(args->tables, part->name)) part->print(&r);
    }
    printf("\n");
    tell("Results: %s", dir);
}

/* hawser report: results as one page. The page's program is in the library; the frame is here. */

static const char help[] = "Usage: hawser report RESULTS [RESULTS2 ...] [options]\n"
                           "\n"
                           "Writes one HTML page about the results that hawser run has left in the folder\n"
                           "RESULTS: verdict and remedies, figures along the route and over time, loads,\n"
                           "limits, inputs, and the pull in three dimensions. Two to six folders are\n"
                           "compared on one page. Of a folder of hawser study it is the study's page. The\n"
                           "page needs no network and no other file; any browser of today opens it.\n"
                           "\n"
                           "  -o, --output FILE       where the page goes (default: RESULTS/report.html; of\n"
                           "                          several ./report.html)\n"
                           "      --pdf               also prints the page to FILE with .pdf in place of\n"
                           "                          .html, by an installed Chromium; implied where FILE\n"
                           "                          ends in .pdf, the page is then FILE with .html\n"
                           "  -q, --quiet             prints nothing but errors\n"
                           "  -h, --help              this text\n"
                           "  -V, --version           the version\n"
                           "\n"
                           "Exit status: 0 written; 2 a folder holds no results; 4 the page could not be\n"
                           "written or printed; 5 no memory.\n";

static int ends_in(const char *name, const char *ending)
{
    const size_t n = strlen(name), e = strlen(ending);
    return n > e && strcmp(name + n - e, ending) == 0;
}

/* Returns "DIR/report" and `ending` for "DIR/report.html", "DIR/report.pdf" or "DIR/report"; malloc'ed. */
static char *name_ending(const char *name, const char *ending)
{
    const size_t end = strlen(name) - (ends_in(name, ".html") ? 5 : ends_in(name, ".pdf") ? 4 : 0);
    char *const path = malloc(end + strlen(ending) + 1);
    if (path) sprintf(path, "%.*s%s", (int)end, name, ending);
    return path;
}

static int study_is_in(const char *folder)
{
    char path[4096];
    snprintf(path, sizeof path, "%.4000s/workers/study", folder);
    return access(path, F_OK) == 0;
}

/* Folders of a page. */
typedef struct Folders {
    const char *const *folder; /* [n] */
    size_t n;
} Folders;

static hawser_status folders_write(void *what, const char *path, hawser_error *err)
{
    const Folders *const f = what;
    const int study = f->n == 1 && study_is_in(f->folder[0]);
    if (study && is_stdout(path)) {
        *err = (hawser_error){HAWSER_ERR_INPUT, "the page of a study goes into a file: give its name with -o"};
        return HAWSER_ERR_INPUT;
    }
    return study ? hawser_study_report(f->folder[0], path, err) : hawser_report_write(f->folder, f->n, path, err);
}

static hawser_status page_write(PageWrite write, void *what, const char *path, int quiet, hawser_error *err)
{
    const hawser_status status = write(what, path, err);
    if (!status && !quiet && !is_stdout(path)) tell("Report: %s", path);
    return status;
}

hawser_status page_make(const char *const *folders, size_t n, const char *path, int pdf, int quiet, hawser_error *err)
{
    Folders what = {folders, n};
    return page_make_of(folders_write, &what, path, pdf, quiet, err);
}

/* Prints by a browser only files that are named as a page, and never over the page. */
hawser_status page_make_of(PageWrite write, void *what, const char *path, int pdf, int quiet, hawser_error *err)
{
    if (!pdf && !ends_in(path, ".pdf")) return page_write(write, what, path, quiet, err);
    char *const page = name_ending(path, ".html"), *const printed = name_ending(path, ".pdf");
    hawser_status status = page && printed ? HAWSER_OK : HAWSER_ERR_MEMORY;
    if (status) *err = (hawser_error){HAWSER_ERR_MEMORY, "out of memory"};
    if (!status) status = page_write(write, what, page, quiet, err);
    interrupt_watch(); /* the browser ends with this program */
    fflush(stdout);
    if (!status) status = pdf_print(page, printed, err);
    if (!status && !quiet) tell("Printed: %s", printed);
    free(page);
    free(printed);
    return status;
}

const char *page_path(const Arguments *args, const char *kind, char path[PAGE_PATH])
{
    int length;
    const char *const name = file_stem(args->case_path, &length);
    snprintf(path, PAGE_PATH, "%.*s-%s.html", length, name, kind);
    return args->dir ? args->dir : path;
}

int held_status(const Arguments *args, hawser_word word)
{
    if (!args->strict || word == HAWSER_SAFE) return 0;
    return word == HAWSER_NOT_TRUSTED ? EXIT_NOT_TRUSTED : EXIT_NOT_HELD;
}

static int report(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    if (args->n_words > HAWSER_REPORT_RUNS_MAX) {
        complain("report compares up to %d results; these are %d", HAWSER_REPORT_RUNS_MAX, args->n_words);
        return EXIT_USAGE;
    }
    const char *folders[HAWSER_REPORT_RUNS_MAX];
    for (int i = 0; i < args->n_words; i++) {
        char *const dir = args->words[i];
        for (size_t n = strlen(dir); n > 1 && dir[n - 1] == '/'; n--) dir[n - 1] = 0;
        folders[i] = dir;
    }
    assert(args->n_words > 0);
    const size_t size = strlen(folders[0]) + sizeof "/report.html";
    char *const beside = malloc(size);
    if (!beside) {
        complain("out of memory");
        return EXIT_INTERNAL;
    }
    snprintf(beside, size, "%s/report.html", folders[0]);
    const char *const path = args->dir ? args->dir : args->n_words > 1 ? "report.html" : beside;
    const hawser_status status = page_make(folders, (size_t)args->n_words, path, args->pdf, args->quiet, &err);
    free(beside);
    return finish_stdout(exit_status(status, &err));
}

const Command command_report = {"report", "one HTML page about results, or comparing some", "oqP*", help, report};

/* hawser plot: main figures of results as SVG, for documents. */

static const char plot_help[] = "Usage: hawser plot RESULTS [FIGURE ...] [options]\n"
                                "\n"
                                "Draws main figures of the results in the folder RESULTS as SVG files: tension\n"
                                "(along the route, against theory), series (forces and speed over time), rollers\n"
                                "(their loads), plan (plan and profile of the route). Without names all of them\n"
                                "for which there is something to draw.\n"
                                "\n"
                                "  -o, --output DIR        where they go (default: RESULTS)\n"
                                "      --units UNITS       si (default: kN, m) or us (lbf, ft)\n"
                                "  -q, --quiet             prints nothing but errors\n"
                                "  -h, --help              this text\n"
                                "  -V, --version           the version\n"
                                "\n"
                                "Exit status: 0 drawn; 2 no results, or nothing for a figure that was named; 4 a\n"
                                "file could not be written.\n";

static int plot(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    char *const results = args->words[0];
    for (size_t n = strlen(results); n > 1 && results[n - 1] == '/'; n--) results[n - 1] = 0;
    const char *const dir = args->dir ? args->dir : results;
    int drawn;
    const hawser_status status = hawser_plot_write(results, dir, (size_t)args->n_words - 1,
                                                   (const char *const *)(args->words + 1), args->units, &drawn, &err);
    if (!status && !args->quiet) tell("Drawn: %d figure%s in %s", drawn, drawn == 1 ? "" : "s", dir);
    return finish_stdout(exit_status(status, &err));
}

const Command command_plot = {"plot", "main figures of results as SVG", "oqu*#", plot_help, plot};
