#include "io/report/crew.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "io/report/svg.h"

/* Numbers that keep the sheet on one side. */
enum { MARKS = 14, MARKS_MAX = 32, POSTS_MAX = 24, OF_A_KIND = 3, LOADED = 6, FACTS_MAX = 12 };
enum { WIDTH = 460, HEIGHT = 210, LEFT = 64, RIGHT = 16, TOP = 56, BELOW = 48, POINTS = 200 };

static const char style[] =
    "<style>.side{display:flex;gap:24px;flex-wrap:wrap;align-items:flex-start}.side h2{margin-top:8px}@media "
    "print{h1{font-size:16px}h2{font-size:12px;margin:8px 0 3px}.verdict{font-size:13px;padding:4px 10px;margin:4px "
    "0}dl{margin:3px 0;gap:0 12px}p{margin:3px 0}.job{margin:0 0 4px}.side{gap:12px;flex-wrap:nowrap}}</style>\n";

/* A pull one way. */
typedef struct CrewSheet {
    const Calculation *page;
    int way;
    double length; /* m, of the route */
} CrewSheet;

/* Returns the distance, m, that the cable's front at s has come from the beginning of the pull. */
static double come(const CrewSheet *sheet, double s) { return sheet->way == PLAN_FORWARD ? s : sheet->length - s; }

static const char *shown(const CrewSheet *sheet, double value, const char *unit, char text[HAWSER_SHOWN_MAX])
{
    return hawser_show(value, unit, sheet->page->units, text);
}

/* ------------------------------------------------------------------------------------------ force by the front's place
 */

typedef struct Mark {
    double come, station; /* m; station NAN: the same */
    const char *piece, *winch;
    double force, restart; /* N */
} Mark;

static const Column mark_column[] = {
    {COLUMN("come_m", NUMBER, Mark, come), .label = "front has come, m", .decimals = 0},
    {COLUMN("station_m", NUMBER, Mark, station), .label = "station, m", .decimals = 0},
    {COLUMN("piece", TEXT, Mark, piece), .label = "in"},
    {COLUMN("force_N", NUMBER, Mark, force), .label = "winch pulls, N", .decimals = 0},
    {COLUMN("restart_N", NUMBER, Mark, restart), .label = "from rest, N", .decimals = 0},
    {COLUMN("winch", TEXT, Mark, winch), .label = "winch at"},
};

/* Returns a round step that divides a length into about MARKS parts, 1, 2 or 5 times a power of ten. */
static double step_of(double length)
{
    const double step = length / MARKS, ten = pow(10, floor(log10(step)));
    return step <= ten ? ten : step <= 2 * ten ? 2 * ten : step <= 5 * ten ? 5 * ten : 10 * ten;
}

static const char *winch_of(const CrewSheet *sheet, double head)
{
    const TheoryDef *const theory = &sheet->page->setup->def->theory;
    const PlanSection part = plan_section_at(&sheet->page->c->def, sheet->way, head);
    if (theory->n_pits == 0) return "-";
    return part.ends < 0 ? "the end" : theory->pits[part.ends - theory->n_machines].name;
}

static hawser_status mark_make(const CrewSheet *sheet, double at, Mark *mark, hawser_error *err)
{
    const Calculator *const c = sheet->page->c;
    const double head = sheet->way == PLAN_FORWARD ? at : sheet->length - at;
    HeadForce found;
    const hawser_status status = plan_head(&c->def, sheet->way, head, &found, err);
    if (status) return status;
    *mark = (Mark){.come = at,
                   .station = sheet->way == PLAN_FORWARD ? NAN : head,
                   .piece = c->route->piece[route_at(c->route, head).piece].name,
                   .winch = winch_of(sheet, head),
                   .force = found.force,
                   .restart = found.restart};
    return HAWSER_OK;
}

/* Makes marks at round places and at the end, and one for each pit. *n: how many. */
static hawser_status marks_make(const CrewSheet *sheet, Mark mark[MARKS_MAX], int *n, hawser_error *err)
{
    const double factor = scale_of("m", 10, sheet->page->units).factor, step = step_of(sheet->length * factor) / factor;
    hawser_status status = HAWSER_OK;
    for (*n = 0; !status && *n < MARKS_MAX - 1 && step * *n < sheet->length - 0.3 * step; ++*n)
        status = mark_make(sheet, step * *n, &mark[*n], err);
    if (!status) status = mark_make(sheet, sheet->length, &mark[(*n)++], err);
    return status;
}

static hawser_status figure_draw(const CrewSheet *sheet, Text *out, hawser_error *err)
{
    const Calculator *const c = sheet->page->c;
    const double trip = c->trip[sheet->way].force;
    double at[POINTS], force[POINTS], restart[POINTS], most = 0;
    char label[2][64];
    Svg svg;
    for (int i = 0; i < POINTS; ++i) {
        Mark mark;
        const hawser_status status = mark_make(sheet, sheet->length * i / (POINTS - 1), &mark, err);
        if (status) return status;
        at[i] = mark.come;
        force[i] = mark.force;
        restart[i] = mark.restart;
        most = fmax(most, fmax(mark.force, mark.restart));
    }
    const Scale metres = scale_of("m", 10, sheet->page->units), newtons = scale_of("N", most, sheet->page->units);
    for (int i = 0; i < POINTS; ++i) {
        at[i] *= metres.factor;
        force[i] *= newtons.factor;
        restart[i] *= newtons.factor;
    }
    const double top = newtons.factor * (trip < 3 * most ? fmax(1.05 * trip, most) : most);
    snprintf(label[0], sizeof *label, "front has come, %s", metres.unit);
    snprintf(label[1], sizeof *label, "winch, %s", newtons.unit);
    const Axis x = {0, at[POINTS - 1], LEFT, WIDTH - LEFT - RIGHT, label[0]},
               y = {0, top > 0 ? 1.05 * top : 1, TOP + HEIGHT, -HEIGHT, label[1]};
    svg_begin(&svg, WIDTH, y.at + BELOW, "Winch by the place of the cable's front");
    svg_legend_at(&svg, LEFT, 42);
    svg_legend(&svg, "at speed", SVG_FIRST, 0);
    svg_legend(&svg, "from rest", SVG_SECOND, 0);
    svg_frame(&svg, &x, &y);
    if (trip * newtons.factor <= y.to) svg_level(&svg, &x, &y, trip * newtons.factor, "set to stop", SVG_LIMIT);
    svg_line(&svg, &x, &y, POINTS, at, restart, SVG_SECOND);
    svg_line(&svg, &x, &y, POINTS, at, force, SVG_FIRST);
    svg_into(&svg, out);
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------------- posts */

/* A place where somebody must stand. */
typedef struct Post {
    double come; /* m from the beginning of the pull */
    char place[2 * NAME_MAX_LENGTH];
    char why[256];
} Post;

static const Column post_column[] = {
    {COLUMN("come_m", NUMBER, Post, come), .label = "at, m", .decimals = 0},
    {COLUMN("piece", CHARS, Post, place), .label = "place"},
    {COLUMN("why", CHARS, Post, why), .label = "to watch and to do"},
};

typedef struct Posts {
    const CrewSheet *sheet;
    int n;
    Post post[POSTS_MAX];
} Posts;

static void __attribute__((format(printf, 4, 5))) post_add(Posts *p, double s, const char *place, const char *why, ...)
{
    va_list args;
    if (p->n == POSTS_MAX) return;
    Post *const post = &p->post[p->n++];
    *post = (Post){.come = come(p->sheet, s)};
    snprintf(post->place, sizeof post->place, "%s", place);
    va_start(args, why);
    vsnprintf(post->why, sizeof post->why, why, args);
    va_end(args);
}

static const SurfaceDef *duct_at(const Setup *setup, double s)
{
    const SurfaceDef *const on = supports_surface(&setup->supports, s);
    return on && on->shape.kind == SURFACE_DUCT ? on : NULL;
}

/* Adds the beginning and the end of the pull. */
static void posts_ends(Posts *p, double first, double last)
{
    const Setup *const setup = p->sheet->page->setup;
    const Calculator *const c = p->sheet->page->c;
    const int way = p->sheet->way;
    const double back = c->plan.way[way].start, inside = 1e-6 * p->sheet->length;
    const SurfaceDef *const duct = duct_at(setup, first + (way == PLAN_FORWARD ? inside : -inside));
    char hold[HAWSER_SHOWN_MAX], brake[HAWSER_SHOWN_MAX], trip[HAWSER_SHOWN_MAX], words[160] = "", lead[96] = "";
    if (c->brake[way].brake > 0)
        snprintf(words, sizeof words, "brake with %s: without it the cable runs away; ",
                 shown(p->sheet, c->brake[way].brake, "N", brake));
    if (duct) snprintf(lead, sizeof lead, "; lead the cable into '%.40s', lubricate", duct->name);
    post_add(p, first, "reel", "%s%s %s behind the cable, no loose turns%s", words, back < 0 ? "push with" : "keep",
             shown(p->sheet, fabs(back), "N", hold), lead);
    post_add(p, last, "winch", "read force and length; stop at %s (%s)", shown(p->sheet, c->trip[way].force, "N", trip),
             c->trip[way].by);
}

/* Adds mouths of ducts on the way: a duct begins there, in the direction of the pull, and none ends. */
static void posts_mouths(Posts *p)
{
    const Supports *const map = &p->sheet->page->setup->supports;
    const double near = 1e-6 * p->sheet->length, sign = p->sheet->way == PLAN_FORWARD ? 1 : -1;
    int n = 0;
    for (int k = 0; k < map->n_along; ++k) {
        const int i = sign > 0 ? k : map->n_along - 1 - k;
        const SurfaceShape *const shape = &map->along[i]->shape;
        const double s = sign > 0 ? shape->from : shape->to;
        if (shape->kind != SURFACE_DUCT || come(p->sheet, s) <= near || come(p->sheet, s) >= p->sheet->length - near)
            continue;
        if (duct_at(p->sheet->page->setup, s - sign * near) || n++ == OF_A_KIND) continue;
        post_add(p, s, map->along[i]->name, "lead the front into the duct, lubricate, watch the jacket");
    }
}

/* Adds conveyors, machines and pits; for many of one kind the first ones, and the number of the others. */
static void posts_machines(Posts *p, int n, const Placed *equipment)
{
    static const char *const kinds[][2] = {{"conveyor", "runs with the winch, grips with up to"},
                                           {"machine", "takes off up to"},
                                           {"pit", "a winch of its own: here the pull begins anew"}};
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; ++k) {
        int found = 0, all = 0;
        for (int i = 0; i < n; ++i) all += !strcmp(equipment[i].kind, kinds[k][0]);
        for (int j = 0; j < n; ++j) {
            const Placed *const e = &equipment[p->sheet->way == PLAN_FORWARD ? j : n - 1 - j];
            char force[HAWSER_SHOWN_MAX], more[48] = "";
            if (strcmp(e->kind, kinds[k][0]) != 0 || found++ >= OF_A_KIND) continue;
            if (found == OF_A_KIND && all > found) snprintf(more, sizeof more, "; so do %d more", all - found);
            if (isnan(e->load)) post_add(p, e->station, e->name, "%s%s", kinds[k][1], more);
            if (!isnan(e->load))
                post_add(p, e->station, e->name, "%s %s; stop all if it stands%s", kinds[k][1],
                         shown(p->sheet, e->load, "N", force), more);
        }
    }
}

/* Adds open bends by the pressure on the cable, the worst first. */
static void posts_bends(Posts *p)
{
    const Calculator *const c = p->sheet->page->c;
    const PlanPiece *const piece = c->plan.way[p->sheet->way].piece;
    double allowed = NAN, before = INFINITY;
    for (int i = 0; i < c->n_limits; ++i) {
        const hawser_limit *const l = &c->limit[p->sheet->way][i];
        if (l->kind == HAWSER_LIMIT_SIDEWALL && l->judged) allowed = l->limit;
    }
    for (int k = 0; k < OF_A_KIND; ++k) {
        int worst = -1;
        for (int i = 0; i < c->plan.n; ++i) {
            const RoutePiece *const on = &c->route->piece[i];
            if (on->kind == ROUTE_STRAIGHT || duct_at(p->sheet->page->setup, on->s0 + on->length / 2)) continue;
            if (piece[i].sidewall < before && (worst < 0 || piece[i].sidewall > piece[worst].sidewall)) worst = i;
        }
        if (worst < 0 || !(piece[worst].sidewall > 0)) return;
        char found[HAWSER_SHOWN_MAX], most[HAWSER_SHOWN_MAX], of[64] = "";
        before = piece[worst].sidewall;
        if (!isnan(allowed)) snprintf(of, sizeof of, " of %s allowed", shown(p->sheet, allowed, "N/m", most));
        post_add(p, c->route->piece[worst].s0 + c->route->piece[worst].length / 2, c->route->piece[worst].name,
                 "bend: %s on the cable%s; see that it lies on its rollers", shown(p->sheet, before, "N/m", found), of);
    }
}

static int compare_posts(const void *a, const void *b)
{
    const double x = ((const Post *)a)->come, y = ((const Post *)b)->come;
    return (x > y) - (x < y);
}

/* ------------------------------------------------------------------------------------------------------ rollers */

typedef struct Loaded {
    double come;
    const char *name, *kind;
    double load, rating, margin;
} Loaded;

static const Column loaded_column[] = {
    {COLUMN("come_m", NUMBER, Loaded, come), .label = "at, m", .decimals = 1},
    {COLUMN("name", TEXT, Loaded, name), .label = "name"},
    {COLUMN("kind", TEXT, Loaded, kind), .label = "kind"},
    {COLUMN("load_N", NUMBER, Loaded, load), .label = "bears, N", .decimals = 0},
    {COLUMN("rating_N", NUMBER, Loaded, rating), .label = "rating, N", .decimals = 0},
    {COLUMN("margin_pct", NUMBER, Loaded, margin), .label = "margin, %", .decimals = 0},
};

static int is_roller(const Placed *e)
{
    return !strcmp(e->kind, "roller") || !strcmp(e->kind, "guide") || !strcmp(e->kind, "hold-down");
}

static int compare_loads(const void *a, const void *b)
{
    const double x = ((const Loaded *)a)->load, y = ((const Loaded *)b)->load;
    return (x < y) - (x > y);
}

/* Lists all rollers in row [n], the largest loads first. Returns how many there are. */
static int loaded_list(const CrewSheet *sheet, int n, const Placed *equipment, Loaded *row)
{
    int found = 0;
    for (int i = 0; i < n; ++i) {
        const Placed *const e = &equipment[i];
        if (is_roller(e) && e->load > 0)
            row[found++] = (Loaded){come(sheet, e->station), e->name, e->kind, e->load, e->rating, e->margin};
    }
    qsort(row, (size_t)found, sizeof *row, compare_loads);
    return found;
}

/* ------------------------------------------------------------------------------------------------------- facts */

enum { SAID = 200 };

typedef struct Facts {
    int n;
    Fact fact[FACTS_MAX];
    char said[FACTS_MAX][SAID];
} Facts;

static void __attribute__((format(printf, 3, 4))) fact_say(Facts *f, const char *label, const char *words, ...)
{
    va_list args;
    char *const said = f->said[f->n];
    va_start(args, words);
    vsnprintf(said, SAID, words, args);
    va_end(args);
    f->fact[f->n++] = (Fact){label, label, "", cell_text(said)};
}

static void cable_say(const CrewSheet *sheet, Facts *f)
{
    const SceneDef *const def = sheet->page->setup->def;
    const double g = v3_norm(def->gravity), mass = g > 0 ? sheet->page->setup->cable_weight / g : 0;
    char d[HAWSER_SHOWN_MAX], whole[HAWSER_SHOWN_MAX], length[HAWSER_SHOWN_MAX];
    const int cables = sheet->page->c->cables;
    fact_say(f, "cable", "%d \xC3\x97 %s, %s on the route's %s", cables, shown(sheet, bundle_diameter(def), "m", d),
             shown(sheet, mass * sheet->length, "kg", whole), shown(sheet, sheet->length, "m", length));
}

static void winch_say(const CrewSheet *sheet, Facts *f)
{
    const Calculator *const c = sheet->page->c;
    const HeadSeries *const heads = &c->heads[sheet->way];
    const TripSetting *const trip = &c->trip[sheet->way];
    char force[HAWSER_SHOWN_MAX], rest[HAWSER_SHOWN_MAX], at[HAWSER_SHOWN_MAX], stop[HAWSER_SHOWN_MAX];
    fact_say(f, "winch", "%s at most, the front having come %s; %s from rest",
             shown(sheet, heads->peak.force, "N", force), shown(sheet, come(sheet, heads->peak.head), "m", at),
             shown(sheet, heads->restart_peak.restart, "N", rest));
    if (isnan(trip->force)) fact_say(f, "set it to stop at", "%s", trip->by);
    if (!isnan(trip->force)) fact_say(f, "set it to stop at", "%s: %s", shown(sheet, trip->force, "N", stop), trip->by);
}

static void speed_say(const CrewSheet *sheet, Facts *f)
{
    const SceneDef *const def = sheet->page->setup->def;
    const double speed = def->winch.present ? winch_def_largest(&def->winch, INFINITY) : 0;
    if (!(speed > 0) || !isfinite(speed)) return;
    const double minutes = sheet->length / speed / 60;
    char metres[HAWSER_SHOWN_MAX];
    shown(sheet, 60 * speed, "m", metres);
    fact_say(f, "speed", "%s in a minute; %.0f h %02.0f min for the route without a stop", metres, floor(minutes / 60),
             floor(fmod(minutes, 60)));
}

static void rope_say(const CrewSheet *sheet, Facts *f)
{
    const Calculator *const c = sheet->page->c;
    const LimitsDef *const limits = &sheet->page->setup->def->limits;
    double longest = 0;
    char length[HAWSER_SHOWN_MAX], strength[HAWSER_SHOWN_MAX], with[96] = "";
    for (int i = 0; i < plan_sections(&c->def, sheet->way); ++i) {
        const PlanSection part = plan_section(&c->def, sheet->way, i);
        longest = fmax(longest, fabs(part.to - part.from));
    }
    if (limits->rope_strength > 0)
        snprintf(with, sizeof with, "; breaks at %s", shown(sheet, limits->rope_strength, "N", strength));
    fact_say(f, "rope", "at least %s beyond what stays on the winch%s", shown(sheet, longest, "m", length), with);
}

/* Lists limits for which the case lacks values. */
static void open_say(const CrewSheet *sheet, Facts *f)
{
    const Calculator *const c = sheet->page->c;
    char names[SAID] = "";
    for (int i = 0; i < c->n_limits; ++i) {
        const hawser_limit *const l = &c->limit[sheet->way][i];
        const size_t at = strlen(names);
        if (!l->judged && l->kind != HAWSER_LIMIT_TRIP)
            snprintf(names + at, sizeof names - at, "%s%s", at ? ", " : "", l->name);
    }
    if (*names) fact_say(f, "not judged", "%s", names);
}

/* -------------------------------------------------------------------------------------------------- the sheet */

static void verdict_write(const CrewSheet *sheet, Text *out)
{
    text_print(out, "<p class=\"verdict %s\">", sheet->page->code);
    text_words(out, "", sheet->page->verdict, "</p>\n");
    if (!strcmp(sheet->page->code, hawser_word_code(HAWSER_NOT_SAFE)))
        text_add(out, "<p><b>Do not pull by this sheet: it shows what would happen.</b></p>\n");
}

static void part_write(const Document *part, const CrewSheet *sheet, Text *out)
{
    char *text = NULL;
    if (document_html(part, sheet->page->units, &text, NULL)) out->failed = 1;
    if (text) text_add(out, text);
    free(text);
}

static void table_write(const Table *table, const CrewSheet *sheet, Text *out)
{
    part_write(&(Document){.n_tables = 1, .table = table}, sheet, out);
}

hawser_status crew_body(const Calculation *page, int way, int n, const Placed *equipment, Text *out, hawser_error *err)
{
    const CrewSheet sheet = {page, way, page->c->route->length};
    const double first = way == PLAN_FORWARD ? 0 : sheet.length, last = sheet.length - first;
    const RoutePiece *const piece = page->c->route->piece;
    Posts posts = {.sheet = &sheet};
    Facts facts = {.n = 0};
    Mark mark[MARKS_MAX];
    int marks;
    const hawser_status status = marks_make(&sheet, mark, &marks, err);
    if (status) return status;
    Loaded *const loaded = malloc(((size_t)n + 1) * sizeof *loaded);
    if (!loaded) return error_memory(err);
    const int rollers = loaded_list(&sheet, n, equipment, loaded);
    fact_say(&facts, "pulled", "%s, from '%s' to '%s'", way == PLAN_FORWARD ? "forward" : "back",
             piece[way == PLAN_FORWARD ? 0 : page->c->route->n - 1].name,
             piece[way == PLAN_FORWARD ? page->c->route->n - 1 : 0].name);
    cable_say(&sheet, &facts);
    winch_say(&sheet, &facts);
    speed_say(&sheet, &facts);
    rope_say(&sheet, &facts);
    open_say(&sheet, &facts);
    posts_ends(&posts, first, last);
    posts_mouths(&posts);
    posts_machines(&posts, n, equipment);
    posts_bends(&posts);
    qsort(posts.post, (size_t)posts.n, sizeof *posts.post, compare_posts);
    text_add(out, style);
    verdict_write(&sheet, out);
    part_write(&(Document){.n_facts = facts.n, .fact = facts.fact}, &sheet, out);
    text_add(out, "<div class=\"side\"><div>");
    table_write(&(Table){"marks", "Winch by the place of the cable's front", COLUMNS(Mark, mark_column), marks, mark},
                &sheet, out);
    text_add(out, "</div><div>");
    const hawser_status drawn = figure_draw(&sheet, out, err);
    text_add(out, "</div></div>\n");
    table_write(&(Table){"posts", "Where somebody stands", COLUMNS(Post, post_column), posts.n, posts.post}, &sheet,
                out);
    char heading[96];
    snprintf(heading, sizeof heading, "Rollers that bear most, of %d", rollers);
    if (rollers > 0)
        table_write(
            &(Table){"rollers", heading, COLUMNS(Loaded, loaded_column), rollers < LOADED ? rollers : LOADED, loaded},
            &sheet, out);
    text_add(out, "<p>Stop at once when the winch reads more than it is set to, when the cable at the reel is slack, "
                  "when a machine or a roller stands still, or when somebody cannot be heard. A force that stays above "
                  "the table means more friction than was calculated with.</p>\n");
    free(loaded);
    return drawn;
}
