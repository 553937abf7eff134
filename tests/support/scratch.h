/* A folder of a test program's own for the files it writes: made before a group of tests, removed with all that is in
 * it behind them. */
#ifndef HAWSER_TESTS_SUPPORT_SCRATCH_H
#define HAWSER_TESTS_SUPPORT_SCRATCH_H

/* Set-up and tear-down of the group. */
int scratch_make(void **state);
int scratch_remove(void **state);

/* The folder. */
const char *scratch_folder(void);
/* folder/NAME, and folder/IN/NAME (name NULL: folder/IN), in a place that the next four calls of both leave alone. */
const char *scratch_path(const char *name);
const char *scratch_path_in(const char *in, const char *name);

/* Writes folder/NAME; its path, as above. */
const char *scratch_write(const char *name, const char *text);

/* A folder and all that is in it. 0: removed. */
int folder_remove(const char *dir);

/* All of a file as text, which free() frees; fails if there is none. */
char *file_text(const char *path);
void file_write(const char *path, const char *text);

/* Fails unless the file of the project, named from its root, is this text; with HAWSER_WRITE in the environment the
 * text is written there. */
void check_reference(const char *name, const char *text);

#endif
