// SPDX-License-Identifier: MIT

#define _XOPEN_SOURCE 700 // realpath(), fsync()

#include "files/file_text.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include "core/base/host.h"

#define FIRST_CAPACITY 65536

bool swHasFile(const char* path)
{
    FILE* file = fopen(path, "rb");
    if (file != NULL)
    {
        fclose(file);
    }
    return file != NULL;
}

bool swIsDevice(const char* path)
{
    struct stat status;
    return stat(path, &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

static swResult growText(const swHost* host, swFileText* text)
{
    size_t capacity = text->capacity > 0 ? 2 * text->capacity : FIRST_CAPACITY;
    char* data = swAllocate(host, capacity);
    if (data == NULL)
    {
        return SW_ERROR_NO_MEMORY;
    }
    if (text->size > 0)
    {
        memcpy(data, text->data, text->size);
    }
    swFree(host, text->data, text->capacity);
    text->data = data;
    text->capacity = capacity;
    return SW_SUCCESS;
}

static swResult readAll(const swHost* host, gzFile file, const char* path, size_t limit, swFileText* text)
{
    for (;;)
    {
        if (text->size == text->capacity && growText(host, text) != SW_SUCCESS)
        {
            return swFail(host, SW_ERROR_NO_MEMORY, "No memory to read %s.", path);
        }
        size_t room = text->capacity - text->size;
        int count = gzread(file, text->data + text->size, (unsigned)(room < 1u << 20 ? room : 1u << 20));
        if (count < 0)
        {
            int code = 0;
            const char* reason = gzerror(file, &code);
            return swFail(host, SW_ERROR_FILE, "Cannot read %s: %s.", path, code == Z_ERRNO ? strerror(errno) : reason);
        }
        if (count == 0)
        {
            return SW_SUCCESS;
        }
        text->size += (size_t)count;
        if (text->size > limit)
        {
            return swFail(host, SW_ERROR_FILE, "%s is larger than %zu MiB, the most that is read.", path, limit >> 20);
        }
    }
}

swResult swReadText(const swHost* host, const char* path, size_t limit, swFileText* text)
{
    memset(text, 0, sizeof(*text));
    errno = 0;
    gzFile file = gzopen(path, "rb"); // reads plain files as they are
    if (file == NULL)
    {
        return swFail(host, SW_ERROR_FILE, "Cannot open %s: %s.", path, errno != 0 ? strerror(errno) : "no memory");
    }
    swResult result = readAll(host, file, path, limit, text);
    text->isPacked = gzdirect(file) == 0;
    if (gzclose(file) == Z_BUF_ERROR && result == SW_SUCCESS)
    {
        result = swFail(host, SW_ERROR_FILE, "Cannot read %s: its gzip data end early.", path);
    }
    if (result != SW_SUCCESS)
    {
        swFreeText(host, text);
    }
    return result;
}

void swFreeText(const swHost* host, swFileText* text)
{
    swFree(host, text->data, text->capacity);
    memset(text, 0, sizeof(*text));
}

bool swIsSameFile(const char* a, const char* b)
{
    struct stat left, right;
    return stat(a, &left) == 0 && stat(b, &right) == 0 && left.st_dev == right.st_dev && left.st_ino == right.st_ino;
}

void swFindFolder(const char* path, char folder[SW_MAX_PATH])
{
    const char* slash = strrchr(path, '/');
    // The root folder keeps its slash.
    int size = slash == NULL ? 0 : slash > path ? (int)(slash - path) : 1;
    snprintf(folder, SW_MAX_PATH, "%.*s", size, path);
}

// ---- writing ----

// The file that a path leads to, also where it is a link, and its permissions; 0 if there is none yet.
static swResult findTarget(const swHost* host, const char* path, char target[SW_MAX_PATH], mode_t* mode)
{
    struct stat status;
    char* real = realpath(path, NULL);
    const char* found = real != NULL ? real : path;
    bool isFound = stat(found, &status) == 0, isLong = strlen(found) >= SW_MAX_PATH;
    if (!isLong)
    {
        memcpy(target, found, strlen(found) + 1);
    }
    free(real);
    if (isLong)
    {
        return swFail(host, SW_ERROR_FILE, "Cannot write %.60s...: the path has more than %d bytes.", path,
                      SW_MAX_PATH - 1);
    }
    if (isFound && !S_ISREG(status.st_mode))
    {
        return swFail(host, SW_ERROR_FILE, "Cannot write %s: it is no file.", path);
    }
    if (isFound && access(target, W_OK) != 0)
    {
        return swFail(host, SW_ERROR_FILE, "Cannot write %s: %s.", path, strerror(errno));
    }
    *mode = isFound ? status.st_mode & 0777 : 0;
    return SW_SUCCESS;
}

static bool writeAll(int file, const char* text, size_t size)
{
    while (size > 0)
    {
        ssize_t count = write(file, text, size);
        if (count < 0 && errno == EINTR)
        {
            continue;
        }
        if (count <= 0)
        {
            return false;
        }
        text += count;
        size -= (size_t)count;
    }
    return true;
}

// The new name of a file is on the disk when its folder is.
static void syncFolder(const char* path)
{
    char folder[SW_MAX_PATH];
    swFindFolder(path, folder);
    int file = open(folder[0] != '\0' ? folder : ".", O_RDONLY);
    if (file >= 0)
    {
        fsync(file);
        close(file);
    }
}

// A new file beside one; -1 if there cannot be any.
static int openBeside(const char* target, char fresh[SW_MAX_PATH + 32])
{
    int file = -1;
    for (int i = 0; i < 100 && file < 0 && (i == 0 || errno == EEXIST); ++i)
    {
        snprintf(fresh, SW_MAX_PATH + 32, "%s.new-%ld-%d", target, (long)getpid(), i);
        file = open(fresh, O_WRONLY | O_CREAT | O_EXCL, 0666);
    }
    return file;
}

swResult swWriteText(const swHost* host, const char* path, const char* text, size_t size)
{
    char target[SW_MAX_PATH], fresh[SW_MAX_PATH + 32];
    mode_t mode = 0;
    swResult result = findTarget(host, path, target, &mode);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    int file = openBeside(target, fresh);
    if (file < 0)
    {
        return swFail(host, SW_ERROR_FILE, "Cannot write beside %s: %s.", path, strerror(errno));
    }
    bool isWritten = writeAll(file, text, size) && (mode == 0 || fchmod(file, mode) == 0) && fsync(file) == 0;
    int reason = errno;
    bool isClosed = close(file) == 0;
    if (isWritten && (!isClosed || rename(fresh, target) != 0))
    {
        reason = errno;
        isWritten = false;
    }
    if (!isWritten)
    {
        unlink(fresh);
        return swFail(host, SW_ERROR_FILE, "Cannot write %s: %s. The file that was there is as it was.", path,
                      strerror(reason));
    }
    syncFolder(target);
    return SW_SUCCESS;
}
