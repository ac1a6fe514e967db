// SPDX-License-Identifier: MIT
// Saved worlds, made anew and gone back to. The hash at the end would keep a fuzzer out, so it is made right here.
// Whatever is let in leaves a surface of numbers and foam between 0 and 1.

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "fuzz_hash.h"
#include "seaway/seaway.h"

static void CheckNumbers(swWorld* world)
{
    FUZZ_CHECK(isfinite(swMoment_GetHeight(swWorld_GetMoment(world), 1.0, 2.0)));
    for (int i = 0; i < swWorld_GetViewCount(world); ++i)
    {
        const swView* view = swWorld_GetView(world, i);
        const float* foam = swView_GetFoam(view, 0);
        int side = swView_GetSlice(view, 0).resolution;
        for (int k = 0; foam != NULL && k < side * side; ++k)
        {
            FUZZ_CHECK(foam[k] >= 0.0f && foam[k] <= 1.0f);
        }
    }
}

int LLVMFuzzerTestOneInput(const uint8_t* input, size_t size)
{
    if (size < 8 || size > 1 << 20)
    {
        return 0;
    }
    uint8_t* data = malloc(size);
    if (data == NULL)
    {
        return 0;
    }
    memcpy(data, input, size);
    FixHash(data, size - 8);
    swHost host = swDefaultHost();
    host.log = NULL;
    swWorld* world = NULL;
    swRestoreDef def = swDefaultRestoreDef();
    def.memoryBudget = (size_t)256 << 20;
    if (swRestoreWorld(&host, data, size, &def, &world) == SW_SUCCESS)
    {
        swWorld_Step(world, 0.1);
        CheckNumbers(world);
        if (swWorld_Rewind(world, data, size) == SW_SUCCESS)
        {
            swWorld_Step(world, 0.1);
            CheckNumbers(world);
        }
        swDestroyWorld(world);
    }
    free(data);
    return 0;
}
