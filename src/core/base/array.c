// SPDX-License-Identifier: MIT
#include "core/base/array.h"

#include <string.h>

#include "core/base/host.h"

void* swAppendItems(const swHost* host, swArray* array, size_t count, size_t itemSize)
{
    if (array->count + count > array->capacity)
    {
        size_t capacity = array->capacity < 64 ? 64 : 2 * array->capacity;
        while (capacity < array->count + count)
        {
            capacity *= 2;
        }
        void* data = swAllocate(host, capacity * itemSize);
        if (data == NULL)
        {
            return NULL;
        }
        if (array->count > 0)
        {
            memcpy(data, array->data, array->count * itemSize);
        }
        swFree(host, array->data, array->capacity * itemSize);
        array->data = data;
        array->capacity = capacity;
    }
    void* items = (char*)array->data + array->count * itemSize;
    array->count += count;
    return items;
}

void swFreeItems(const swHost* host, swArray* array, size_t itemSize)
{
    swFree(host, array->data, array->capacity * itemSize);
    memset(array, 0, sizeof(*array));
}
