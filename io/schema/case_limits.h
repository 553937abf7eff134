/* What the section `limits` is read into; see io/schema/case_records.h. */
#ifndef HAWSER_IO_SCHEMA_CASE_LIMITS_H
#define HAWSER_IO_SCHEMA_CASE_LIMITS_H

#include "io/schema/case_records.h"

/* Values straight into `def`, which comes first; the two sections on their own. */
typedef struct LimitsRecord {
    LimitsDef def;
    const CaseNode *conductor, *sheath;
} LimitsRecord;

#endif
