/* YAML text into nodes: libyaml's parser, and what it lets pass that a case may not hold. */
#ifndef HAWSER_IO_YAML_YAML_READ_H
#define HAWSER_IO_YAML_YAML_READ_H

#include <stddef.h>

#include "hawser/hawser.h"
#include "io/yaml/yaml_node.h"

/* Reads one YAML document of `size` bytes, with a NUL behind them. `origin` is said to be where it comes from and must
 * outlive the nodes; lines 0: it is a setting's value, and line numbers mean nothing. Errors: INPUT with the place (not
 * YAML, empty, several documents, a key twice, too large, too deep), MEMORY; *out is NULL then. */
hawser_status yaml_read(const char *text, size_t size, const char *origin, int lines, CaseNode **out,
                        hawser_error *err);

#endif
