// SPDX-License-Identifier: MIT
#include "output.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include "verbs.h"

static char pendingPath[MAX_PATH_LENGTH + 64]; // what an interrupt removes

static void RemovePending(int number)
{
    if (pendingPath[0] != 0)
    {
        unlink(pendingPath);
    }
    signal(number, SIG_DFL);
    raise(number);
}

bool HasEnding(const char* path, const char* ending)
{
    size_t length = strlen(path), endingLength = strlen(ending);
    return length >= endingLength && strcasecmp(path + length - endingLength, ending) == 0;
}

static bool IsFolder(const char* path)
{
    struct stat status;
    return stat(path, &status) == 0 && S_ISDIR(status.st_mode);
}

bool MakeFolder(const char* path)
{
    if (IsFolder(path))
    {
        return true;
    }
    if (mkdir(path, 0777) != 0)
    {
        Complain("cannot make the folder %s: %s", path, strerror(errno));
        return false;
    }
    return true;
}

bool BeginOutput(OutputFile* output, const char* finalPath)
{
    const char* slash = strrchr(finalPath, '/');
    const char* name = slash != NULL ? slash + 1 : finalPath;
    int folderLength = (int)(name - finalPath);
    if (strlen(finalPath) >= MAX_PATH_LENGTH)
    {
        Complain("cannot write %.60s...: the path is too long", finalPath);
        return false;
    }
    if (*name == 0 || IsFolder(finalPath))
    {
        Complain("cannot write %s: it is a folder", finalPath);
        return false;
    }
    snprintf(output->finalPath, sizeof(output->finalPath), "%s", finalPath);
    snprintf(output->path, sizeof(output->path), "%.*s.%s.%ld.part", folderLength, finalPath, name, (long)getpid());
    int file = open(output->path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (file < 0)
    {
        int reason = errno;
        Complain(reason == ENOENT ? "cannot write %s: its folder does not exist" : "cannot write %s: %s", finalPath,
                 strerror(reason));
        return false;
    }
    close(file);
    memcpy(pendingPath, output->path, sizeof(pendingPath));
    signal(SIGINT, RemovePending);
    signal(SIGTERM, RemovePending);
    return true;
}

bool EndOutput(OutputFile* output, bool isWritten)
{
    if (isWritten && rename(output->path, output->finalPath) != 0)
    {
        Complain("cannot write %s: %s", output->finalPath, strerror(errno));
        isWritten = false;
    }
    if (!isWritten)
    {
        unlink(output->path);
    }
    pendingPath[0] = 0;
    return isWritten;
}
