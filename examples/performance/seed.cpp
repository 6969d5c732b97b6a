// Linked to a program that asks `rand` for its random numbers, it starts them elsewhere.
#include <stdlib.h>

static struct Seed {
    Seed() { srand(2); }
} seed;
