/* What the desk's functions share: how a case is read and how an answer is handed to the page. */
#ifndef HAWSER_WEB_ENGINE_DESK_H
#define HAWSER_WEB_ENGINE_DESK_H

#include "hawser/hawser.h"

/* '=' and the text, or '!' and the error as JSON; takes `text`, which may be NULL. NULL: no memory. */
char *desk_answered(hawser_status status, char *text, const hawser_error *err);
/* A case out of its text, with the folder that the page's files are in; hawser_case_free follows in any case. */
hawser_status desk_case(const char *text, hawser_case **c, hawser_error *err);

#endif
