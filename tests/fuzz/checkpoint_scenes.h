/* Small scenes of every kind that has something of its own in a checkpoint. */
#ifndef HAWSER_TESTS_FUZZ_CHECKPOINT_SCENES_H
#define HAWSER_TESTS_FUZZ_CHECKPOINT_SCENES_H

typedef struct CheckpointScene {
    const char *what, *text; /* a case */
    int steps;               /* after which the checkpoint is taken */
} CheckpointScene;

/* An input begins with a scene's number: a new one comes last. */
enum { CHECKPOINT_SCENES = 16 };
extern const CheckpointScene checkpoint_scenes[CHECKPOINT_SCENES];

#endif
