/* An FMU as a file: a zip archive with the description, the library and the resources. The resources are laid out in a
 * folder first and the case is read from there, so that what is packed is known to serve. */
#include "fmi/archive/archive.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zip.h>

#include "core/base/error.h"
#include "io/api/api_handles.h"
#include "io/library/library.h"
#include "io/results/results_file.h"

enum { PATH_ROOM = 4096, IDENTIFIER_ROOM = 64 };
/* What libzip and its random numbers may take, bytes: they do not survive an allocation that fails. */
enum { ZIP_ROOM = 4 << 20, ZLIB_NO_MEMORY = -4 };

/* -------------------------------------------------------------------------------------------------- a folder for it */

static hawser_status file_write(const char *path, const char *bytes, size_t size, hawser_error *err)
{
    errno = 0;
    FILE *const f = fopen(path, "wb");
    int ok = f && fwrite(bytes, 1, size, f) == size;
    if (f && fclose(f)) ok = 0;
    return ok ? HAWSER_OK : out_error(path, errno, err);
}

static hawser_status file_copy(const char *from, const char *to, hawser_error *err)
{
    char *bytes = NULL;
    size_t size;
    hawser_status status = case_file_read(from, &bytes, &size, err);
    if (!status) status = file_write(to, bytes, size, err);
    free(bytes);
    return status;
}

/* A name below a folder; both are short enough for the room. */
static const char *path_below(const char *folder, const char *name, char path[PATH_ROOM])
{
    snprintf(path, PATH_ROOM, "%.2040s/%.2040s", folder, name);
    return path;
}

/* Case and files below `folder`, which has room for names behind it. */
static hawser_status resources_lay_out(const Resources *r, const char *folder, hawser_error *err)
{
    char path[PATH_ROOM];
    hawser_status status = file_write(path_below(folder, MODEL_CASE, path), r->text.at, r->text.size, err);
    for (int i = 0; i < r->n && !status; ++i) {
        status = file_copy(r->file[i].path, path_below(folder, r->file[i].name, path), err);
    }
    return status;
}

static void folder_remove(const Resources *r, const char *folder)
{
    char path[PATH_ROOM];
    unlink(path_below(folder, MODEL_CASE, path));
    for (int i = 0; i < r->n; ++i) unlink(path_below(folder, r->file[i].name, path));
    rmdir(folder);
}

/* ------------------------------------------------------------------------------------------------------ the archive */

/* What goes in; the bytes or files stay until the archive is closed. */
typedef struct Packing {
    zip_t *zip;
    hawser_error *err;
    hawser_status status;
} Packing;

/* Why something could not be packed. */
static hawser_status zip_fault(zip_error_t *why, const char *what, const char *name, hawser_error *err)
{
    const int code = zip_error_code_zip(why); /* none is known of what was never made */
    const int kind = zip_error_system_type(why), below = zip_error_code_system(why);
    const int lacks = (kind == ZIP_ET_SYS && below == ENOMEM) || (kind == ZIP_ET_ZLIB && below == ZLIB_NO_MEMORY);
    if (lacks || code == ZIP_ER_MEMORY || code == ZIP_ER_OK) return error_memory(err);
    return error_set(err, HAWSER_ERR_OUTPUT, "cannot %s '%.600s': %s", what, name, zip_error_strerror(why));
}

/* A source under a name; two archives of the same case are the same, so that all have the same date. libzip packs as
 * small as it can where nobody says how: a sixth of the time makes them 7 % larger. */
static void source_add(Packing *p, const char *name, zip_source_t *source)
{
    static const time_t date = 631152000; /* 1990-01-01 */
    static const zip_uint32_t effort = 3; /* of 9 */
    if (p->status) {
        zip_source_free(source);
        return;
    }
    const zip_int64_t at = source ? zip_file_add(p->zip, name, source, ZIP_FL_ENC_UTF_8) : -1;
    const zip_uint64_t entry = (zip_uint64_t)at;
    if (at >= 0 && !zip_file_set_mtime(p->zip, entry, date, 0) &&
        !zip_set_file_compression(p->zip, entry, ZIP_CM_DEFLATE, effort))
        return;
    if (at < 0) zip_source_free(source);
    p->status = zip_fault(zip_get_error(p->zip), "pack", name, p->err);
}

static void text_pack(Packing *p, const char *name, const Text *text)
{
    source_add(p, name, zip_source_buffer(p->zip, text->at, text->size, 0));
}

static void file_pack(Packing *p, const char *name, const char *path)
{
    source_add(p, name, zip_source_file(p->zip, path, 0, -1));
}

/* All parts of an archive whose model has been made of the resources in `folder`. */
static hawser_status parts_pack(const char *path, hawser_fmi version, const char *identifier, const char *library,
                                const Resources *r, const char *folder, const Text *description, const Text *page,
                                hawser_error *err)
{
    char name[PATH_ROOM], from[PATH_ROOM];
    const char *const slash = strrchr(library, '/');
    int code = 0;
    if (!memory_room(ZIP_ROOM)) return error_memory(err);
    Packing p = {.zip = zip_open(path, ZIP_CREATE | ZIP_TRUNCATE, &code), .err = err};
    if (!p.zip) {
        zip_error_t why;
        zip_error_init_with_code(&why, code);
        const hawser_status status = zip_fault(&why, "write", path, err);
        zip_error_fini(&why);
        return status;
    }
    text_pack(&p, "modelDescription.xml", description);
    snprintf(name, sizeof name, "binaries/%s/%s.so", version == HAWSER_FMI_2 ? "linux64" : "x86_64-linux", identifier);
    file_pack(&p, name, library);
    text_pack(&p, "documentation/index.html", page);
    snprintf(from, sizeof from, "%.*slicences.txt", slash ? (int)(slash + 1 - library) : 0, library);
    file_pack(&p, "documentation/licenses/license.txt", from);
    text_pack(&p, "resources/" MODEL_CASE, &r->text);
    for (int i = 0; i < r->n; ++i) {
        file_pack(&p, path_below("resources", r->file[i].name, name), path_below(folder, r->file[i].name, from));
    }
    if (!p.status && zip_close(p.zip) == 0) return HAWSER_OK;
    if (!p.status) p.status = zip_fault(zip_get_error(p.zip), "write", path, err);
    zip_discard(p.zip);
    return p.status;
}

/* ------------------------------------------------------------------------------------------------------ the request */

/* "cases/3 ducts.yaml" -> "case_3_ducts": a name of C's. */
static void identifier_make(const char *case_name, char identifier[IDENTIFIER_ROOM])
{
    const char *const slash = strrchr(case_name, '/'), *const base = slash ? slash + 1 : case_name;
    const char *const dot = strrchr(base, '.');
    const int length = (int)(dot && dot > base ? dot - base : (long)strlen(base));
    snprintf(identifier, IDENTIFIER_ROOM, "%s%.*s", isalpha((unsigned char)*base) ? "" : "case_", length, base);
    for (char *c = identifier; *c; ++c) {
        if (!isalnum((unsigned char)*c)) *c = '_';
    }
}

/* With the resources laid out in a folder. */
static hawser_status archive_write(const hawser_case *c, const Resources *r, const char *folder, hawser_fmi version,
                                   const char *path, hawser_error *err)
{
    char identifier[IDENTIFIER_ROOM];
    Model model = {0};
    Text description = {0}, page = {0};
    char *const library = shipped_find(HAWSER_FMU_PLACE);
    hawser_status status = HAWSER_OK;
    if (!library)
        status = error_set(err, HAWSER_ERR_INPUT, "the library for archives, %s, is not beside the program",
                           HAWSER_FMU_PLACE);
    if (!status) status = resources_lay_out(r, folder, err);
    if (!status) status = model_load(folder, &model, NULL, err);
    identifier_make(c->name, identifier);
    const char *const title = *c->def->title ? c->def->title : identifier;
    if (!status) description_write(&model, version, title, identifier, &description);
    if (!status) documentation_write(&model, version, title, &page);
    if (!status && (description.failed || page.failed)) status = error_memory(err);
    if (!status) status = parts_pack(path, version, identifier, library, r, folder, &description, &page, err);
    text_clear(&page);
    text_clear(&description);
    model_clear(&model);
    free(library);
    return status;
}

hawser_status hawser_fmu_write(hawser_case *c, hawser_fmi version, const char *path, hawser_error *err)
{
    char folder[PATH_ROOM];
    const char *const temporary = getenv("TMPDIR");
    Resources r = {.n = 0};
    if (!c) return error_argument(err, "c");
    if (!path || !*path) return error_argument(err, "path");
    if (version != HAWSER_FMI_2 && version != HAWSER_FMI_3)
        return error_set(err, HAWSER_ERR_INPUT, "version %d of FMI: 2 or 3 can be written", (int)version);
    hawser_status status = case_ensure_read(c, err); /* mistakes are found where the user made them */
    if (!status) status = file_marks_spare(&c->def->files, path, err);
    if (!status) status = resources_make(c->tree, &r, err);
    snprintf(folder, sizeof folder, "%.2000s/hawser-XXXXXX", temporary && *temporary ? temporary : "/tmp");
    if (!status && !mkdtemp(folder))
        status = error_set(err, HAWSER_ERR_OUTPUT, "cannot make a folder like '%.800s': %s", folder, strerror(errno));
    if (!status) {
        status = archive_write(c, &r, folder, version, path, err);
        folder_remove(&r, folder);
    }
    resources_clear(&r);
    return status;
}
