/* results.h5 from somebody else: what in HDF5 can lead out of the file is refused before it is read. */
#include "results_fixture.h"

#include <hdf5.h>
#include <sys/stat.h>

#include "io/results/results_h5.h"
#include "tests/support/check.h"

enum { NUMBERS = 64, FOREIGN = 300 };

static size_t filter_nothing(unsigned flags, size_t n, const unsigned *values, size_t size, size_t *room, void **bytes)
{
    (void)flags, (void)n, (void)values, (void)room, (void)bytes;
    return size;
}

static const H5Z_class2_t foreign = {H5Z_CLASS_T_VERS, FOREIGN, 1, 1, "foreign", NULL, NULL, filter_nothing};

/* A link of a user's kind, which leads wherever its code says. */
static hid_t link_traverse(const char *name, hid_t group, const void *data, size_t size, hid_t access, hid_t transfer)
{
    (void)name, (void)data, (void)size, (void)access, (void)transfer;
    return H5Oopen(group, "good", H5P_DEFAULT);
}
static const H5L_class_t of_user = {
    H5L_LINK_CLASS_T_VERS, (H5L_type_t)200, "user", NULL, NULL, NULL, link_traverse, NULL, NULL};

static void set_make(hid_t file, const char *name, hid_t type, hid_t plist, const double *values)
{
    const hsize_t n = NUMBERS;
    const hid_t space = H5Screate_simple(1, &n, NULL),
                set = H5Dcreate2(file, name, type, space, H5P_DEFAULT, plist, H5P_DEFAULT);
    assert_true(set >= 0);
    if (values) assert_true(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
    H5Dclose(set);
    H5Sclose(space);
}

static hid_t chunked(void)
{
    const hsize_t n = NUMBERS;
    const hid_t plist = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(plist, 1, &n);
    return plist;
}

/* Every way out, in one file. */
static void container_make(const Fixture *f, const char *victim)
{
    double values[NUMBERS];
    const hsize_t n = NUMBERS, huge = 200000000;
    for (int k = 0; k < NUMBERS; k++) values[k] = k;
    const hid_t file = H5Fcreate(fixture_path(f, "results.h5"), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    hid_t plist = chunked();
    H5Pset_shuffle(plist);
    H5Pset_deflate(plist, 1);
    set_make(file, "good", H5T_IEEE_F64LE, plist, values);
    H5Pclose(plist);
    plist = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_external(plist, victim, 0, sizeof values);
    set_make(file, "external", H5T_IEEE_F64LE, plist, NULL);
    H5Pclose(plist);
    plist = H5Pcreate(H5P_DATASET_CREATE);
    const hid_t space = H5Screate_simple(1, &n, NULL);
    H5Pset_virtual(plist, space, victim, "good", space);
    set_make(file, "virtual", H5T_IEEE_F64LE, plist, NULL);
    H5Pclose(plist);
    H5Sclose(space);
    assert_true(H5Zregister(&foreign) >= 0);
    plist = chunked();
    H5Pset_filter(plist, FOREIGN, 0, 0, NULL);
    set_make(file, "filter", H5T_IEEE_F64LE, plist, values);
    H5Pclose(plist);
    const hid_t named = H5Tcopy(H5T_IEEE_F64LE);
    H5Tcommit2(file, "type", named, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    set_make(file, "named", named, H5P_DEFAULT, values);
    H5Tclose(named);
    const hid_t big = H5Screate_simple(1, &huge, NULL);
    plist = chunked();
    H5Dclose(H5Dcreate2(file, "unwritten", H5T_IEEE_F64LE, big, H5P_DEFAULT, plist, H5P_DEFAULT));
    H5Pclose(plist);
    H5Sclose(big);
    H5Lcreate_external(victim, "/good", file, "away", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_external(victim, "/", file, "outside", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_soft("/good", file, "soft", H5P_DEFAULT, H5P_DEFAULT);
    assert_true(H5Lregister(&of_user) >= 0);
    H5Lcreate_ud(file, "user", (H5L_type_t)200, NULL, 0, H5P_DEFAULT, H5P_DEFAULT);
    H5Fclose(file);
}

/* HDF5 alone reads each of them, of external storage and by the link the bytes of another file. */
static double first_by_hdf5(const Fixture *f, const char *name)
{
    double values[NUMBERS] = {-1};
    H5E_BEGIN_TRY
    {
        const hid_t file = H5Fopen(fixture_path(f, "results.h5"), H5F_ACC_RDONLY, H5P_DEFAULT),
                    set = H5Dopen2(file, name, H5P_DEFAULT);
        H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
        H5Dclose(set);
        H5Fclose(file);
    }
    H5E_END_TRY
    return values[0];
}

TEST_WITH(test_container, fixture_new, fixture_free)
{
    static const char *const out[] = {"external", "virtual",      "filter", "named", "unwritten", "away",
                                      "soft",     "outside/good", "user",   "type",  "nothing"};
    Fixture *f = *state;
    char victim[256];
    hsize_t n[1];
    double value = 7;
    OutDir dir;
    StatesFile s;
    mkdir(f->dir, 0777);
    snprintf(victim, sizeof victim, "%s", fixture_path(f, "victim"));
    FILE *const file = fopen(victim, "wb");
    for (int k = 0; k < NUMBERS; k++) assert_int_equal(fwrite(&value, sizeof value, 1, file), 1);
    fclose(file);
    container_make(f, victim);
    check_equal(first_by_hdf5(f, "external"), 7); /* this is what hawser report printed */
    assert_int_equal(out_enter(&dir, f->dir, NULL), HAWSER_OK);
    states_open(&s, &dir);
    assert_true(s.file >= 0);
    const hid_t good = door_set(s.file, "good", 0, 1, n, INFINITY);
    assert_true(good >= 0 && n[0] == NUMBERS);
    H5Dclose(good);
    for (size_t k = 0; k < sizeof out / sizeof *out; k++)
        if (door_set(s.file, out[k], 0, 1, n, INFINITY) >= 0) fail_msg("'%s' is opened", out[k]);
    assert_true(door_group(s.file, "outside") < 0);
    assert_true(door_set(s.file, "good", 0, 2, n, INFINITY) < 0);
    assert_true(door_set(s.file, "good", 1, 1, n, INFINITY) < 0);
    assert_true(door_set(s.file, "good", 0, 1, n, NUMBERS - 1) < 0);
    states_close(&s);
    out_leave(&dir);
    H5Zunregister(FOREIGN);
    H5Lunregister((H5L_type_t)200);
}
