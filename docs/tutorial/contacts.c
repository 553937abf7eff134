/* A case as JSON, a force on each segment, and the contacts after each second. docs/guide/c.md */
#include <hawser/hawser.h>
#include <stdio.h>

static const char text[] = "{\"cables\": {\"power\": {\"EA\": 5e7, \"GA\": 2e7, \"GJ\": 8e3, \"EI\": 1e4, \"d\": 0.09, \"mass\": 20}},"
                           " \"chain\": [{\"cable\": \"power\", \"length\": 10, \"segment\": 0.5}],"
                           " \"route\": {\"head_at\": 12, \"pieces\": [{\"straight\": 20}]},"
                           " \"rollers\": {\"along\": {\"spacing\": 1}},"
                           " \"friction\": {\"mu\": 0.2},"
                           " \"drive\": {\"winch\": {\"speed\": \"6 m/min\"}},"
                           " \"run\": {\"duration\": 3}}";

/* Mud along the whole cable: 10 N s/m on each segment. Its derivative by the velocity is known. */
static int mud(void *user, const hawser_segment_now *at, double wrench[6], double by_place[36], double by_motion[36])
{
    (void)user;
    for (int k = 0; k < 3; k++) wrench[k] = -10 * at->velocity_m_per_s[k];
    for (int k = 0; by_place && k < 3; k++) by_motion[7 * k] = -10;
    return 0;
}

static void look(hawser_sim *sim, hawser_error *err)
{
    const hawser_contact *contact;
    const hawser_cable_point *joint;
    int contacts, joints;
    double normal = 0, bending = 0;
    if (hawser_sim_contacts(sim, &contact, &contacts, err) || hawser_sim_cable(sim, &joint, &joints, NULL, err)) return;
    for (int i = 0; i < contacts; i++) normal += contact[i].normal_N;
    for (int j = 0; j < joints; j++) bending = joint[j].bending_N_m > bending ? joint[j].bending_N_m : bending;
    printf("t = %.0f s: %d contacts carry %.0f N, the cable bends with %.0f N m at most\n", hawser_sim_time(sim), contacts, normal,
           bending);
}

int main(void)
{
    hawser_error err = {0};
    hawser_case *c = NULL;
    hawser_sim *sim = NULL;
    hawser_status status = hawser_case_parse_json(text, "look", &c, &err);
    if (!status) status = hawser_sim_new(c, NULL, &sim, &err);
    if (!status) status = hawser_sim_relax(sim, NULL, &err);
    if (!status) status = hawser_sim_set_law(sim, 0, 20, mud, 1, NULL, &err);
    for (int k = 1; k <= 3 && !status; k++) {
        status = hawser_sim_advance(sim, k, 0, &err);
        if (!status) look(sim, &err);
    }
    if (err.status) fprintf(stderr, "%s\n", err.message);
    hawser_sim_free(sim);
    hawser_case_free(c);
    return (int)err.status;
}
