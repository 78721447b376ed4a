// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays that grow one element at a time. The capacity follows from the number of elements (16, then the
// next power of two), so that none has to be kept beside it.
#ifndef ORR_CORE_ARRAY_H
#define ORR_CORE_ARRAY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

// Makes room for one more element behind the n that *array has. `array` is the address of the pointer to
// the elements (of any type); the pointer is NULL at first and freed with free(). Only arrays that grew by
// this function alone may be given. False without memory; the array is then as it was.
static inline bool orr_array_grow(void *array, size_t n, size_t element_size)
{
    void *items;
    memcpy(&items, array, sizeof items); // whatever type the pointer has
    const bool full = n == 0 ? items == NULL : n >= 16 && (n & (n - 1)) == 0;
    if (!full) return true;
    const size_t capacity = n < 16 ? 16 : 2 * n;
    void *grown = capacity > SIZE_MAX / element_size ? NULL : realloc(items, capacity * element_size);
    if (grown == NULL) return false;
    memcpy(array, &grown, sizeof grown);
    return true;
}

#define ORR_ARRAY_GROW(array, n) orr_array_grow(&(array), (n), sizeof *(array))

#endif
