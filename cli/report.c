/* Everything in the report is also in summary.json, stations.csv and rollers.csv, where programs should look for it:
 * the layout here may change. */
#include "cli/commands.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A rod's places, as the run ended. */
static void report_rod(const hawser_summary *s)
{
    printf("\nAt the end (%s), m, rad, N, N m; forces are those of the part ahead on the part behind\n", s->analysis);
    for (int i = 0; i < s->n_probes; i++) {
        const hawser_probe *p = &s->probes[i];
        const double *const d = p->displacement, *const r = p->rotation, *const f = p->force, *const m = p->moment;
        printf("  %-12s moved (%.6g, %.6g, %.6g), turned (%.6g, %.6g, %.6g)\n", p->name, d[0], d[1], d[2], r[0], r[1],
               r[2]);
        printf("  %-12s force (%.6g, %.6g, %.6g), moment (%.6g, %.6g, %.6g)\n", "", f[0], f[1], f[2], m[0], m[1], m[2]);
    }
}

/* Frequencies, one line each. */
static void report_modes(const hawser_summary *s)
{
    if (s->n_modes > 0) printf("\nModes about the last equilibrium\n");
    for (int i = 0; i < s->n_modes; i++) {
        const hawser_mode *m = &s->modes[i];
        printf("  %3d %14.6g Hz", i + 1, m->frequency_Hz);
        if (m->growth_per_s > 0) printf("   not stable: grows by exp(t / %.4g s)", 1 / m->growth_per_s);
        printf("\n");
    }
}

/* Loads at which an equilibrium stopped being stable, and how the run ended. */
static void report_stability(const hawser_summary *s)
{
    if (s->n_critical > 0) printf("\nCritical loads\n");
    for (int i = 0; i < s->n_critical; i++) {
        const hawser_critical *const c = &s->critical[i];
        const double *const d = c->direction;
        printf("  %-12s at %.6g s, %.6g of the run; moves most at %.4g m, along (%.3g, %.3g, %.3g)\n", c->kind, c->t,
               c->share, c->at, d[0], d[1], d[2]);
    }
    if (s->unstable > 0) printf("  the last equilibrium is not stable: %d motions grow\n", s->unstable);
    if (s->unstable == 0) printf("  the last equilibrium is stable\n");
}

/* Before the run: what the counts of the model are. */
void report_scene(const hawser_sim *s)
{
    hawser_summary sum;
    hawser_sim_summary(s, &sum);
    printf("%s\n", hawser_sim_title(s));
    printf("  %d segments, %d bushings, %d rollers, %d contact candidates; %g s to simulate\n", sum.segments,
           sum.bushings, sum.rollers, sum.contact_candidates, hawser_sim_end_time(s));
}

/* Whether the run began at rest. Not having reached it is no error, but the start of the run is then not to be trusted.
 */
static void report_relaxation(const hawser_relaxation *r)
{
    if (!(r->tolerance_N > 0)) return; /* the case did not want it */
    if (r->reached) {
        printf("\nAt rest before t = 0: largest unbalanced force %.2g N after %d iterations, moved by up to "
               "%.3g mm\n",
               r->residual_N, r->iterations, 1e3 * r->moved_m);
    } else {
        printf(
            "\nNot at rest before t = 0: %.3g N are unbalanced at segment %d (aim: %.3g N); the start of the run may "
            "show it\n",
            r->residual_N, r->segment, r->tolerance_N);
    }
}

/* One theory: its winch force, how far the simulated mean lies from it, and the stations' errors. */
static void report_theory(const char *name, double total, double pull, double max_pct, double mean_pct)
{
    if (!(total > 0)) return;
    printf("  %-18s %12.2f N %+13.2f %% %21.2f %% %7.2f %%\n", name, total, 100 * (pull - total) / total, max_pct,
           mean_pct);
}

/* An error bar behind its figure; nothing where it is not known. Beyond the figure itself its size says nothing. */
static const char *say_error(const hawser_error_bar *bar, double figure, char text[32])
{
    *text = 0;
    if (!(bar->total >= 0) || !(fabs(figure) > 0)) return text;
    if (bar->total < fabs(figure)) snprintf(text, 32, " +- %.2g %%", 100 * bar->total / fabs(figure));
    if (bar->total >= fabs(figure)) snprintf(text, 32, " +- over 100 %%");
    return text;
}

/* The figures that a run is made for: the pull, its theory, and when it was steady. */
static void report_pull(const hawser_summary *s)
{
    if (!(s->pull_peak_N > 0)) {
        printf("\nNothing was pulled: there is no winch, or its rope stayed slack\n");
        return;
    }
    char mean[32], peak[32];
    say_error(&s->pull_mean_error, s->pull_mean_N, mean);
    say_error(&s->pull_peak_error, s->pull_peak_N, peak);
    if (isnan(s->pull_mean_N)) {
        printf("\nPull force: peak %.2f N%s; no mean, its window begins at %g s\n", s->pull_peak_N, peak,
               s->steady_from_s);
        return;
    }
    printf("\nPull force: mean %.2f N%s (ripple %.3g N RMS) from %g s to %g s, peak %.2f N%s\n", s->pull_mean_N, mean,
           s->pull_ripple_N, s->steady_from_s, s->steady_to_s, s->pull_peak_N, peak);
    printf("  %-18s %14s %15s %23s %9s\n", "", "winch force", "pull is off by", "tension error: largest", "mean");
    report_theory("reference theory", s->reference_total_N, s->pull_mean_N, s->error_max_pct, s->error_mean_pct);
    report_theory("paper's formulas", s->paper_total_N, s->pull_mean_N, s->error_max_paper_pct,
                  s->error_mean_paper_pct);
    printf("  speed %.5g m/s, ", s->steady_speed_m_per_s);
    if (isnan(s->settle_time_s)) printf("not settled: more than 2 %% off the winch's as the run ended\n");
    if (!isnan(s->settle_time_s)) printf("settled at %.4g s\n", s->settle_time_s);
}

/* What machines did, one line each, under the heading of their kind. */
static void report_machines(const hawser_summary *s)
{
    const char *kind = "";
    for (int i = 0; i < s->n_machines; i++) {
        const hawser_machine *m = &s->machines[i];
        if (strcmp(kind, m->kind)) printf("  %s:\n", kind = m->kind);
        printf("    %s:", m->name);
        for (int k = 0; k < m->n_figures; k++) printf("%s %s %.4g", k ? "," : "", m->figure[k].key, m->figure[k].value);
        printf("\n");
    }
}

/* What the one cable that was computed stands for: its terms, then a line a duct. */
static void report_bundle(const hawser_bundle *b)
{
    if (!b) return;
    printf("\nBundle: %s taken as one cable, %.4g kg/m, EA %.4g MN, EI %.4g and GJ %.4g N m2, touching with %.4g mm\n",
           b->name, b->mass_kg_per_m, b->EA_N / 1e6, b->EI_N_m2, b->GJ_N_m2, 1e3 * b->diameter_m);
    for (int i = 0; i < b->n_ducts; i++) {
        const hawser_bundle_duct *d = &b->ducts[i];
        printf(
            "  %s: %s, weight factor %.4g (%s), so friction %.4g, in bends %.4g; the worst cable bears %.3g of T/R\n",
            d->name, d->layout, d->weight_factor, b->weight_correction, d->friction_straight, d->friction_bend,
            d->sidewall_factor);
        printf("  %*s  jam ratio %.3g (risk %s), clearance %.3g mm, fill %.3g %%, room %.3g mm\n", (int)strlen(d->name),
               "", d->jam_ratio, d->jam_risk, 1e3 * d->clearance_m, 100 * d->fill, 1e3 * d->room_m);
    }
}

/* Trips and what followed. */
static void report_events(const hawser_summary *s)
{
    for (int i = 0; i < s->n_events; i++) {
        const hawser_event *e = &s->events[i];
        printf("  t = %8.3f s: %s, pull %.2f N\n", e->t, e->what, e->pull_N);
    }
}

/* The most heavily loaded roller. */
static void report_rollers(hawser_sim *s)
{
    const hawser_roller *r;
    const int n = hawser_sim_rollers(s, &r);
    if (n == 0) return;
    const hawser_roller *heaviest = &r[0];
    for (int i = 1; i < n; i++) {
        if (r[i].peak_N > heaviest->peak_N) heaviest = &r[i];
    }
    printf("  largest roller load %.1f N on %s", heaviest->peak_N, heaviest->name);
    if (!isnan(heaviest->steady_N)) printf(", steady %.1f N", heaviest->steady_N);
    if (heaviest->rating_N > 0) printf(", rated %g N", heaviest->rating_N);
    printf("\n");
}

/* What it cost, in the integrator's own counts. */
static void report_work(const hawser_summary *s)
{
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
    printf("  solved in %s (%s)\n", s->planar ? "the plane" : "space", s->planar_why);
}

/* Whether energy and momentum add up. */
static void report_balance(const hawser_balance *b)
{
    if (!b) return;
    printf(
        "\nBalances: energy closes to %.2g %% of what goes through '%s' (%.4g kJ), momentum to %.2g %% of the largest "
        "impulse; the steps in time took %.2g %%\n",
        100 * b->residual_share, b->turnover_of, b->turnover_J / 1e3, 100 * b->impulse_residual_share,
        100 * b->numerical_share);
}

/* Where the time went, so that a slow case shows its reason. */
static void report_phases(const hawser_summary *s)
{
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

/* A number with its unit, in kN where it is a large force. */
static const char *say_quantity(double value, const char *unit, char text[32])
{
    const int large = unit[0] == 'N';
    const char *const shown = !strcmp(unit, "1") ? "" : unit;
    if (isinf(value)) return "none";
    if (isnan(value)) return "-";
    snprintf(text, 32, "%.4g%s%s%s", large ? value / 1e3 : value, *shown ? " " : "", large ? "k" : "", shown);
    return text;
}

/* The verdict and what it rests on, one reason a line: the answer that everything below is for. */
static void report_verdict(const hawser_summary *s, const char *verdict)
{
    char found[32], allowed[32];
    int failed = 0;
    for (int i = 0; i < s->n_conditions; i++) failed += !s->conditions[i].holds;
    if (failed) {
        printf("\nNOT TRUSTED, for %d reason%s\n", failed, failed > 1 ? "s" : "");
    } else {
        printf("\n%s\n  the figures are to be trusted: all %d conditions hold\n", verdict, s->n_conditions);
    }
    for (int i = 0; i < s->n_conditions; i++) {
        const hawser_condition *c = &s->conditions[i];
        if (c->holds) continue;
        printf("  %-16s %s (found %s, allowed %s)\n", c->name, c->remedy, say_quantity(c->value, c->unit, found),
               say_quantity(c->allowed, c->unit, allowed));
    }
}

/* The limits one by one. */
static void report_limits(int n, const hawser_limit *limit)
{
    char found[32], allowed[32];
    if (n > 0) printf("\nLimits\n  %-14s %12s %12s %9s\n", "", "found", "allowed", "margin");
    for (int i = 0; i < n; i++) {
        const hawser_limit *l = &limit[i];
        printf("  %-14s %12s %12s ", l->name, say_quantity(l->value, l->unit, found),
               say_quantity(l->limit, l->unit, allowed));
        if (l->judged)
            printf("%7.1f %%  %-10s %s; %s\n", 100 * l->margin, l->ok ? "holds" : "BROKEN", l->where, l->source);
        if (!l->judged) printf("%9s  not judged: %s\n", "-", l->source);
    }
}

/* The whole report, in the order in which a planner asks. The verdict comes first, and last of all in one line, where a
 * long report ends. */
void report_run(hawser_sim *s, const char *dir)
{
    hawser_summary sum;
    hawser_limit limit[HAWSER_LIMITS_MAX];
    char verdict[HAWSER_VERDICT_MAX];
    hawser_sim_summary(s, &sum);
    const int n = hawser_sim_limits(s, limit);
    hawser_verdict(sum.n_conditions, sum.conditions, n, limit, verdict, sizeof verdict);
    report_verdict(&sum, verdict);
    if (sum.rod) {
        report_rod(&sum);
        report_stability(&sum);
        report_modes(&sum);
    } else {
        report_pull(&sum);
    }
    report_bundle(sum.bundle);
    report_machines(&sum);
    report_events(&sum);
    report_rollers(s);
    report_limits(n, limit);
    report_assumptions(s);
    report_relaxation(&sum.relaxation);
    report_balance(sum.balance);
    report_work(&sum);
    report_phases(&sum);
    printf("\nResults: %s\n\n%s\n", dir, verdict);
}
