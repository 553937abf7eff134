/* hawser_ranks by MPI: a library that the program loads on request (study/slurm.c), so that a program that is built
 * without MPI, or runs where there is none, does not need it. */
#include <limits.h>
#include <mpi.h>
#include <stdlib.h>

#include "hawser/hawser.h"

enum { TAG = 1, WAITING_MAX = 64 };

/* Buffer for messages under way, so that a sender does not wait for the receiver. */
static void *buffer;

static void share(void *user, void *data, size_t size)
{
    (void)user;
    for (size_t at = 0; at < size; at += INT_MAX) {
        const size_t part = size - at < INT_MAX ? size - at : INT_MAX;
        MPI_Bcast((char *)data + at, (int)part, MPI_BYTE, 0, MPI_COMM_WORLD);
    }
}

static void send(void *user, int to, const int64_t *message)
{
    (void)user;
    MPI_Bsend(message, HAWSER_RANK_WORDS, MPI_INT64_T, to, TAG, MPI_COMM_WORLD);
}

static int receive(void *user, int *from, int64_t *message)
{
    int there = 0;
    MPI_Status status;
    (void)user;
    MPI_Iprobe(MPI_ANY_SOURCE, TAG, MPI_COMM_WORLD, &there, &status);
    if (!there) return 0;
    *from = status.MPI_SOURCE;
    MPI_Recv(message, HAWSER_RANK_WORDS, MPI_INT64_T, *from, TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return 1;
}

/* Receives messages that were sent and not yet received, before MPI ends. */
static void end_all(void *user)
{
    int64_t message[HAWSER_RANK_WORDS];
    int from, size;
    MPI_Barrier(MPI_COMM_WORLD);
    while (receive(user, &from, message)) continue;
    MPI_Buffer_detach(&buffer, &size);
    free(buffer);
    MPI_Finalize();
}

__attribute__((visibility("default"))) int hawser_mpi_open(hawser_ranks *out);

/* Returns 0, or something else if MPI cannot begin. */
int hawser_mpi_open(hawser_ranks *out)
{
    *out = (hawser_ranks){.share = share, .send = send, .receive = receive, .end = end_all};
    if (MPI_Init(NULL, NULL) != MPI_SUCCESS) return 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &out->rank);
    MPI_Comm_size(MPI_COMM_WORLD, &out->count);
    const size_t size = (size_t)out->count * WAITING_MAX * (HAWSER_RANK_WORDS * sizeof(int64_t) + MPI_BSEND_OVERHEAD);
    if (size > INT_MAX) return 1;
    buffer = malloc(size);
    return !buffer || MPI_Buffer_attach(buffer, (int)size) != MPI_SUCCESS;
}
