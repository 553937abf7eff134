/* The case files of tests/data: each says in its first lines what it is for. */
#ifndef HAWSER_TESTS_SUPPORT_DATA_H
#define HAWSER_TESTS_SUPPORT_DATA_H

/* The text of tests/data/NAME.yaml, read once and kept until the program ends; fails if there is none. */
const char *data_text(const char *name);

/* The same with `to` in the place of `from`, which must stand in it just once; kept until the program ends. */
const char *data_with(const char *name, const char *from, const char *to);

#endif
