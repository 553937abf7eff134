#include "io/case/case_parts.h"
#include "io/yaml/case_error.h"

/* The six stiffnesses of a mount: three by shift, three by turn. */
static const CaseKey shift_key = {"stiffness", KEY_NUMBER, DIM_SPRING, .min = 0, .max = 1e15, .above = 1};
static const CaseKey turn_key = {"stiffness", KEY_NUMBER, DIM_TURN_SPRING, .min = 0, .max = 1e15, .above = 1};

hawser_status case_spin_read(const CaseReader *r, const CaseNode *node, double radius, SpinDef *spin)
{
    SpinRecord record = {0};
    *spin = (SpinDef){.speed = 1};
    if (!node) return HAWSER_OK;
    const hawser_status status = case_section_read(r, node, &case_spin, &record);
    if (status) return status;
    *spin = (SpinDef){.inertia = record.inertia,
                      .friction = record.bearing.friction,
                      .journal = record.bearing.journal,
                      .torque = record.bearing.torque,
                      .speed = record.bearing.speed};
    if (record.bearing.journal < radius) return HAWSER_OK;
    const CaseNode *const bearing = case_node_key(node, "bearing");
    return case_key_error(r->err, bearing ? bearing : node, bearing ? "journal" : "bearing.journal",
                          "out of range: must be below the roller's radius, %g m", radius);
}

hawser_status case_mount_read(const CaseReader *r, const CaseNode *node, MountDef *mount)
{
    const CaseKey *const key[6] = {&shift_key, &shift_key, &shift_key, &turn_key, &turn_key, &turn_key};
    MountRecord record = {0};
    *mount = (MountDef){0};
    if (!node) return HAWSER_OK;
    const hawser_status status = case_section_read(r, node, &case_mount, &record);
    if (status) return status;
    mount->present = 1;
    mount->damping = record.damping;
    mount->mass = record.mass;
    mount->inertia = record.inertia;
    return case_numbers_read(r, record.stiffness, 6, key, mount->stiffness);
}
