// SPDX-License-Identifier: MIT
// Runs a fuzz target over files, and over every prefix and single-byte change of each at regular places, so that any
// compiler's test run covers the seeds: replay FILE...

#include <string.h>

#include "fuzz.h"

#define MAX_SIZE ((size_t)1 << 20)
#define VARIANTS 200

static void RunVariants(const uint8_t* data, size_t size)
{
    static const uint8_t bytes[] = {0, '\n', '(', '#', '|', '-', '9', 0xff};
    uint8_t* copy = malloc(size > 0 ? size : 1); // exact, so that a sanitizer sees a read past the end
    if (copy == NULL)
    {
        exit(2);
    }
    LLVMFuzzerTestOneInput(memcpy(copy, data, size), size);
    for (size_t i = 0; i < VARIANTS && size > 0; ++i)
    {
        size_t at = (size - 1) * i / VARIANTS;
        LLVMFuzzerTestOneInput(copy, at);
        uint8_t kept = copy[at];
        copy[at] = bytes[i % sizeof(bytes)];
        LLVMFuzzerTestOneInput(copy, size);
        copy[at] = kept;
    }
    free(copy);
}

int main(int argc, char** argv)
{
    uint8_t* data = malloc(MAX_SIZE);
    if (data == NULL || argc < 2)
    {
        fprintf(stderr, "usage: %s FILE...\n", argv[0]);
        free(data);
        return 2;
    }
    for (int i = 1; i < argc; ++i)
    {
        FILE* file = fopen(argv[i], "rb");
        if (file == NULL)
        {
            fprintf(stderr, "cannot open %s\n", argv[i]);
            free(data);
            return 2;
        }
        size_t size = fread(data, 1, MAX_SIZE, file);
        fclose(file);
        RunVariants(data, size);
    }
    printf("%d files and their variants: no finding\n", argc - 1);
    free(data);
    return 0;
}
