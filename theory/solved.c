#include "theory/solved.h"

hawser_status solved_make(const SceneDef *own, const Company *company, int forward_only, Solved *out, hawser_error *err)
{
    *out = (Solved){.def = *own};
    hawser_status status = setup_make(&out->def, &out->setup, err);
    out->setup.company = *company;
    if (!status) status = expected_fill(&out->setup, 0, NULL, &out->expected, err);
    return status ? status : calculator_build(&out->setup, &out->expected, forward_only, &out->c, err);
}

void solved_free(Solved *s)
{
    calculator_free(&s->c);
    expected_free(&s->expected);
    setup_free(&s->setup);
    scene_def_clear(&s->def);
}
