/* Checkpoints as files and as memory: around the state of a simulation, what it takes to recognise it.
 *
 * A file is a head of fixed size (what it is, its length, its hash) and a row of pieces: the program's version and
 * kernels, the case, and what follows from it, all of which are compared before anything is read; then, of a run with
 * results, how far these have come; then the simulation. */
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/isa.h"
#include "core/base/team.h"
#include "io/api/api_handles.h"
#include "io/results/results_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { FORMAT = 9 };

typedef struct FileHead {
    char magic[16];
    uint64_t format, size, hash; /* size, hash: of what follows */
} FileHead;

static const char magic[16] = "hawser restart\n";

/* ------------------------------------------------------------------------------------------------- what it is of */

/* The case, key by key, as it is read: values and units. How often checkpoints are made is not asked. */
static uint64_t inputs_identity(const SceneDef *def)
{
    uint64_t all = 0;
    const char *text = def->inputs;
    for (int i = 0; i < def->n_inputs; i++) {
        int counts = 1;
        for (int k = 0; k < INPUT_TEXTS; k++, text += strlen(text) + 1) {
            if (k == INPUT_KEY) counts = strcmp(text, "run.checkpoint") != 0;
            if (!counts || (k != INPUT_KEY && k != INPUT_VALUE && k != INPUT_UNIT)) continue;
            const uint64_t both[2] = {all, checkpoint_hash(text, strlen(text))};
            all = checkpoint_hash(both, sizeof both);
        }
    }
    return all;
}

/* What stands in front. */
typedef struct Preface {
    const char *version, *kernels; /* of the program, of the machine */
    uint64_t inputs, scene;        /* hashes of the case as read, of what was built from it */
    const char *name, *folder;     /* of the case; NULL: it has no folder */
    const char *text;              /* the case */
} Preface;

static Preface preface_of(const hawser_sim *s)
{
    return (Preface){.version = hawser_version(),
                     .kernels = isa_name(isa_best()),
                     .inputs = inputs_identity(&s->stage.scene.def),
                     .scene = sim_identity(s),
                     .name = s->case_name,
                     .folder = s->case_folder,
                     .text = s->case_text};
}

void run_identity(const hawser_sim *s, char run[SUM_SIZE])
{
    const Preface p = preface_of(s);
    const uint64_t all[] = {p.inputs, p.scene, checkpoint_hash(p.version, strlen(p.version)),
                            checkpoint_hash(p.kernels, strlen(p.kernels))};
    sum_text(run, checkpoint_hash(all, sizeof all));
}

static void preface_checkpoint(Checkpoint *c, Preface *p)
{
    checkpoint_text(c, "version", &p->version);
    checkpoint_text(c, "kernels", &p->kernels);
    CHECKPOINT(c, p->inputs);
    CHECKPOINT(c, p->scene);
    checkpoint_text(c, "name", &p->name);
    checkpoint_text(c, "folder", &p->folder);
    checkpoint_text(c, "text", &p->text);
}

static int differ(const char *a, const char *b) { return strcmp(a ? a : "", b ? b : "") != 0; }

/* That of the file against that of the simulation which is to go on from it. */
static hawser_status preface_compare(const Preface *file, const Preface *mine, const char *path, hawser_error *err)
{
    if (differ(file->version, mine->version)) {
        return error_set(err, HAWSER_ERR_INPUT, "'%.500s' is a checkpoint of hawser %.40s; this is %.40s", path,
                         file->version ? file->version : "?", mine->version);
    }
    if (differ(file->kernels, mine->kernels)) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "'%.500s' was computed with the instruction set %.20s, this machine uses %.20s: the run would "
                         "not go on with the same bits; HAWSER_ISA=%.20s goes on where the machine has it",
                         path, file->kernels ? file->kernels : "?", mine->kernels, file->kernels ? file->kernels : "?");
    }
    if (file->inputs != mine->inputs || file->scene != mine->scene) {
        return error_set(
            err, HAWSER_ERR_INPUT,
            "'%.500s' is a checkpoint of another case, or of '%.200s' with other settings or files than now", path,
            file->name ? file->name : "?");
    }
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------------ bytes */

static hawser_status fault(const Checkpoint *c, const char *path, hawser_error *err)
{
    if (c->status == HAWSER_ERR_MEMORY) return error_memory(err);
    return error_set(err, HAWSER_ERR_INPUT, "'%.500s' cannot be read as a checkpoint: %s", path, c->fault);
}

/* All pieces, behind the head. */
static hawser_status pieces_write(hawser_sim *s, RunKept *run, Checkpoint *c, hawser_error *err)
{
    FileHead head = {.format = FORMAT};
    Preface preface = preface_of(s);
    int kept = run != NULL;
    memcpy(head.magic, magic, sizeof magic);
    checkpoint_put(c, "head", &head, sizeof head);
    preface_checkpoint(c, &preface);
    CHECKPOINT(c, kept);
    if (kept) CHECKPOINT(c, *run);
    const hawser_status status = sim_checkpoint(c, s, err);
    if (!status && c->status) return c->status == HAWSER_ERR_MEMORY ? error_memory(err) : fault(c, "it", err);
    return status;
}

/* Counted first, so that memory is taken once. */
hawser_status checkpoint_write(hawser_sim *s, RunKept *run, Checkpoint *c, hawser_error *err)
{
    FileHead head;
    const size_t head_end = 2 * sizeof(uint64_t) + sizeof head; /* a piece has a head of its own */
    if (s->positions.n > 0)
        return error_set(err, HAWSER_ERR_RUN, "positions are not kept: each is found anew in a fraction of a second");
    *c = checkpoint_new(0);
    hawser_status status = pieces_write(s, run, c, err);
    if (status) return status;
    *c = checkpoint_new(c->size);
    status = pieces_write(s, run, c, err);
    if (status) return status;
    memcpy(&head, c->bytes + head_end - sizeof head, sizeof head);
    head.size = c->size - head_end;
    head.hash = checkpoint_hash(c->bytes + head_end, head.size);
    memcpy(c->bytes + head_end - sizeof head, &head, sizeof head);
    return HAWSER_OK;
}

/* Whether the bytes are what was written; c is then behind the head. */
static hawser_status head_check(Checkpoint *c, const char *path, hawser_error *err)
{
    FileHead head = {0};
    checkpoint_put(c, "head", &head, sizeof head);
    if (c->status || memcmp(head.magic, magic, sizeof magic) != 0)
        return error_set(err, HAWSER_ERR_INPUT, "'%.500s' is not a checkpoint of hawser", path);
    if (head.format != FORMAT) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "'%.500s' is a checkpoint of another version of hawser: format %llu, here %d", path,
                         (unsigned long long)head.format, FORMAT);
    }
    if (head.size != c->size - c->at || head.hash != checkpoint_hash(c->bytes + c->at, c->size - c->at))
        return error_set(err, HAWSER_ERR_INPUT, "the checkpoint '%.500s' is damaged or cut off", path);
    return HAWSER_OK;
}

/* Up to the simulation. */
static hawser_status preface_read(Checkpoint *c, const char *path, Preface *preface, int *kept, RunKept *run,
                                  hawser_error *err)
{
    const hawser_status status = head_check(c, path, err);
    if (status) return status;
    preface_checkpoint(c, preface);
    checkpoint_put(c, "kept", kept, sizeof *kept);
    if (*kept && !c->status) checkpoint_put(c, "*run", run, sizeof *run);
    return c->status ? fault(c, path, err) : HAWSER_OK;
}

hawser_status checkpoint_read(hawser_sim *s, const char *path, const void *bytes, size_t size, RunKept *run,
                              hawser_error *err)
{
    TextPool pool = {0};
    Checkpoint c = checkpoint_over(bytes, size, &pool);
    Preface theirs = {0};
    const Preface mine = preface_of(s);
    RunKept unused;
    int kept = 0;
    hawser_status status = preface_read(&c, path, &theirs, &kept, run ? run : &unused, err);
    if (!status) status = preface_compare(&theirs, &mine, path, err);
    if (!status && run && !kept)
        status = error_set(err, HAWSER_ERR_INPUT, "'%.500s' is a checkpoint of a simulation without results", path);
    text_pool_free(&pool);
    if (status) return status;
    c.texts = &pool;
    status = sim_checkpoint(&c, s, err);
    checkpoint_end(&c);
    text_pool_free(&s->texts); /* of a checkpoint before */
    s->texts = pool;
    if (status) return status;
    return c.status ? fault(&c, path, err) : HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------------- files */

/* All of a file that is open, malloc'ed; fd < 0: errno says why it is not. */
static hawser_status file_read(int fd, const char *path, void **bytes, size_t *size, hawser_error *err)
{
    struct stat info;
    int number = fd < 0 ? errno : 0;
    const int ok = fd >= 0 && !fstat(fd, &info);
    *bytes = ok ? checkpoint_memory((size_t)info.st_size) : NULL;
    *size = 0;
    errno = 0;
    const ssize_t n = *bytes ? whole_read(fd, *bytes, (size_t)info.st_size) : -1;
    if (!number) number = errno;
    if (fd >= 0) close(fd);
    if (ok && !*bytes) return error_memory(err);
    if (ok && n == info.st_size) {
        *size = (size_t)n;
        return HAWSER_OK;
    }
    free(*bytes);
    *bytes = NULL;
    return error_set(err, HAWSER_ERR_INPUT, "cannot read the checkpoint '%.700s': %s", path,
                     number ? file_reason(number) : "it has become shorter meanwhile");
}

/* The checkpoint of a folder. */
static hawser_status kept_read(OutSpot *spot, const OutDir *dir, void **bytes, size_t *size, hawser_error *err)
{
    const hawser_status status = out_spot(spot, dir, CHECKPOINT_FILE, err);
    return status ? status : file_read(file_open_in(dir->at, CHECKPOINT_FILE, O_RDONLY), spot->path, bytes, size, err);
}

hawser_status checkpoint_read_dir(hawser_sim *s, const OutDir *dir, RunKept *run, hawser_error *err)
{
    OutSpot spot;
    void *bytes;
    size_t size;
    hawser_status status = kept_read(&spot, dir, &bytes, &size, err);
    if (status) return status;
    status = checkpoint_read(s, spot.path, bytes, size, run, err);
    free(bytes);
    return status;
}

/* A handle that speaks of a finer pass goes on from states of that; one of before that pass brings the first back, and
 * with it a time when nothing was known of another. */
static hawser_status state_read(hawser_sim *handle, const char *path, const void *bytes, size_t size, hawser_error *err)
{
    hawser_sim *s = SHOWN(handle);
    hawser_error first = {.status = HAWSER_OK};
    hawser_status status = checkpoint_read(s, path, bytes, size, NULL, err);
    if (status == HAWSER_ERR_INPUT && s != handle && !checkpoint_read(handle, path, bytes, size, NULL, &first)) {
        handle->finer = sim_free(handle->finer);
        s = handle;
        status = HAWSER_OK;
    }
    if (status || !(hawser_sim_time(s) < hawser_sim_end_time(s))) return status;
    other_passes_free(&s->others);
    free(s->passes);
    s->passes = NULL;
    return HAWSER_OK;
}

hawser_status hawser_sim_save_memory(hawser_sim *s, void **bytes, size_t *size, hawser_error *err)
{
    Checkpoint c;
    s = SHOWN(s);
    if (!s || !bytes || !size) return error_argument(err, !s ? "s" : bytes ? "size" : "bytes");
    if (is_inside(s)) return error_inside(err);
    *bytes = NULL;
    *size = 0;
    const hawser_status status = checkpoint_write(s, NULL, &c, err);
    if (status) {
        checkpoint_free(&c);
        return status;
    }
    *bytes = c.bytes; /* the caller's from now on */
    *size = c.size;
    return HAWSER_OK;
}

hawser_status hawser_sim_load_memory(hawser_sim *s, const void *bytes, size_t size, hawser_error *err)
{
    if (!s || !bytes) return error_argument(err, s ? "bytes" : "s");
    if (is_inside(SHOWN(s)) || SHOWN(s)->running) return error_inside(err);
    team_settle(SHOWN(s)->team);
    return state_read(s, "memory", bytes, size, err);
}

void hawser_bytes_free(void *bytes) { free(bytes); }

/* Beside its name, whatever folder that is in. */
hawser_status hawser_sim_save(hawser_sim *s, const char *path, hawser_error *err)
{
    Checkpoint c;
    OutDir dir;
    s = SHOWN(s);
    if (!s || !path) return error_argument(err, s ? "path" : "s");
    if (is_inside(s)) return error_inside(err);
    char *const folder = strdup(path), *const slash = folder ? strrchr(folder, '/') : NULL;
    if (!folder) return error_memory(err);
    if (slash) slash[slash == folder] = 0;
    hawser_status status = file_marks_spare(&s->stage.scene.def.files, path, err);
    if (!status) status = out_enter(&dir, slash ? folder : ".", err);
    free(folder);
    if (status) return status;
    status = checkpoint_write(s, NULL, &c, err);
    if (!status) status = out_bytes_in(&dir, slash ? strrchr(path, '/') + 1 : path, c.bytes, c.size, err);
    checkpoint_free(&c);
    out_leave(&dir);
    return status;
}

hawser_status hawser_sim_load(hawser_sim *s, const char *path, hawser_error *err)
{
    void *bytes;
    size_t size;
    if (!s || !path) return error_argument(err, s ? "path" : "s");
    if (is_inside(SHOWN(s)) || SHOWN(s)->running) return error_inside(err);
    team_settle(SHOWN(s)->team);
    hawser_status status = file_read(file_open_named(path), path, &bytes, &size, err);
    if (status) return status;
    status = state_read(s, path, bytes, size, err);
    free(bytes);
    return status;
}

/* The case's file is where it was, unless somebody has moved it. */
static hawser_status path_keep(CaseTree *tree, const char *name, hawser_error *err)
{
    const char *const slash = strrchr(name, '/');
    const size_t size = strlen(tree->folder) + strlen(name) + 2;
    tree->path = malloc(size);
    if (!tree->path) return error_memory(err);
    snprintf(tree->path, size, "%s/%s", tree->folder, slash ? slash + 1 : name);
    return HAWSER_OK;
}

/* The case that is in front. */
hawser_status hawser_case_resume(const char *dir, hawser_case **out, hawser_error *err)
{
    OutDir folder = {.at = -1};
    OutSpot spot = {0};
    TextPool pool = {0};
    Preface preface = {0};
    RunKept run;
    void *bytes = NULL;
    size_t size = 0;
    int kept;
    if (!dir || !out) return error_argument(err, dir ? "out" : "dir");
    *out = NULL;
    hawser_status status = HAWSER_OK;
    if (out_enter(&folder, dir, NULL))
        status = error_set(err, HAWSER_ERR_INPUT, "cannot read the checkpoint '%.700s/" CHECKPOINT_FILE "': %s", dir,
                           strerror(errno));
    if (!status) status = kept_read(&spot, &folder, &bytes, &size, err);
    out_leave(&folder);
    Checkpoint c = checkpoint_over(bytes, size, &pool);
    if (!status) status = preface_read(&c, spot.path, &preface, &kept, &run, err);
    if (!status && (!preface.text || !preface.name))
        status = error_set(err, HAWSER_ERR_INPUT, "the checkpoint '%.500s' has no case in it", spot.path);
    if (!status) status = hawser_case_parse(preface.text, preface.name, out, err);
    if (!status) case_tree_unline((*out)->tree);
    if (!status && preface.folder) status = hawser_case_folder(*out, preface.folder, err);
    if (!status && preface.folder) status = path_keep((*out)->tree, preface.name, err);
    if (status && *out) {
        hawser_case_free(*out);
        *out = NULL;
    }
    text_pool_free(&pool);
    free(bytes);
    return status;
}
