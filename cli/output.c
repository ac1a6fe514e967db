// SPDX-License-Identifier: MIT
#include "output.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common.h"

#define MOST_LINKS 40 // as many as the kernel follows

// ---- interrupts ----

static char pendingPath[MAX_PATH_LENGTH];    // what an interrupt removes
static volatile sig_atomic_t hasPending;     // the path is complete
static volatile sig_atomic_t pendingProcess; // what it ends before
static const int interrupts[] = {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE};

static void RemovePending(int number)
{
    if (pendingProcess > 0)
    {
        kill((pid_t)pendingProcess, SIGKILL);
    }
    if (hasPending)
    {
        unlink(pendingPath);
    }
    signal(number, SIG_DFL);
    raise(number);
}

// A signal that is ignored, as nohup does with SIGHUP, stays ignored.
static void WatchInterrupts(void)
{
    static bool isWatching;
    for (size_t i = 0; i < sizeof(interrupts) / sizeof(interrupts[0]) && !isWatching; ++i)
    {
        struct sigaction old;
        if (sigaction(interrupts[i], NULL, &old) == 0 && old.sa_handler == SIG_DFL)
        {
            signal(interrupts[i], RemovePending);
        }
    }
    isWatching = true;
}

void SetOutputProcess(pid_t process)
{
    pendingProcess = (sig_atomic_t)process;
}

// ---- places ----

bool HasEnding(const char* path, const char* ending)
{
    size_t length = strlen(path), endingLength = strlen(ending);
    return length >= endingLength && strcasecmp(path + length - endingLength, ending) == 0;
}

static bool BeginsWith(const char* path, const char* start)
{
    return strncmp(path, start, strlen(start)) == 0;
}

bool IsDevice(const char* path)
{
    struct stat status;
    bool isOpenedFile = BeginsWith(path, "/proc/") || BeginsWith(path, "/dev/std") || BeginsWith(path, "/dev/fd/");
    return stat(path, &status) == 0 && !S_ISDIR(status.st_mode) && (!S_ISREG(status.st_mode) || isOpenedFile);
}

// Bytes of the path up to its name, the last slash included.
static int MeasureFolder(const char* path)
{
    const char* slash = strrchr(path, '/');
    return slash != NULL ? (int)(slash - path) + 1 : 0;
}

static bool FailOutput(const char* name, const char* reason)
{
    Complain("cannot write %s: %s", name, reason);
    return false;
}

// Follow the links of a path to the file that they lead to, which may not be there yet, into output->finalPath.
static bool FollowLinks(OutputFile* output)
{
    char* path = output->finalPath;
    if (snprintf(path, MAX_PATH_LENGTH, "%s", output->name) >= MAX_PATH_LENGTH)
    {
        return FailOutput(output->name, "the path has more than 4,095 bytes");
    }
    for (int i = 0; i < MOST_LINKS && !IsDevice(path); ++i)
    {
        char target[MAX_PATH_LENGTH], joined[2 * MAX_PATH_LENGTH];
        ssize_t length = readlink(path, target, sizeof(target) - 1);
        if (length < 0)
        {
            return true; // no link
        }
        target[length] = 0;
        snprintf(joined, sizeof(joined), "%.*s%s", target[0] == '/' ? 0 : MeasureFolder(path), path, target);
        if (strlen(joined) >= MAX_PATH_LENGTH)
        {
            return FailOutput(output->name, "its link leads to a path of more than 4,095 bytes");
        }
        memcpy(path, joined, strlen(joined) + 1);
    }
    output->isCopied = IsDevice(path);
    return output->isCopied || FailOutput(output->name, "its links lead in a circle");
}

// The folder that a path's name would be in is there and takes files.
static bool CheckFolder(const char* name, const char* path)
{
    char folder[MAX_PATH_LENGTH];
    struct stat status;
    int length = MeasureFolder(path);
    snprintf(folder, sizeof(folder), "%.*s", length > 0 ? length : 1, length > 0 ? path : ".");
    if (stat(folder, &status) != 0)
    {
        return FailOutput(name, errno == ENOENT ? "its folder does not exist" : strerror(errno));
    }
    if (access(folder, W_OK | X_OK) != 0)
    {
        char reason[256];
        snprintf(reason, sizeof(reason), "its folder takes no new file: %s", strerror(errno));
        return FailOutput(name, reason);
    }
    return true;
}

// Why a folder could not be made. Systems without files to make, such as /proc, also say that something is missing.
static const char* ExplainNoFolder(const char* path, int reason)
{
    char parent[MAX_PATH_LENGTH];
    struct stat status;
    snprintf(parent, sizeof(parent), "%s", path);
    for (size_t end = strlen(parent); end > 1 && parent[end - 1] == '/'; --end)
    {
        parent[end - 1] = 0;
    }
    int length = MeasureFolder(parent);
    snprintf(parent + length, sizeof(parent) - (size_t)length, ".");
    if (reason == EEXIST || reason == ENOTDIR)
    {
        return "a file has that name";
    }
    return reason != ENOENT             ? strerror(reason)
           : stat(parent, &status) == 0 ? "the folder that it would be in takes no other"
                                        : "the folder that it would be in does not exist";
}

bool MakeFolder(const char* path)
{
    struct stat status;
    bool isThere = stat(path, &status) == 0;
    if (isThere && !S_ISDIR(status.st_mode))
    {
        Complain("cannot make the folder %s: a file has that name", path);
        return false;
    }
    if (!isThere && mkdir(path, 0777) != 0)
    {
        Complain("cannot make the folder %s: %s", path, ExplainNoFolder(path, errno));
        return false;
    }
    if (access(path, W_OK | X_OK) != 0)
    {
        Complain("cannot write into the folder %s: %s", path, strerror(errno));
        return false;
    }
    return true;
}

// ---- files ----

// A temporary file for what is copied in the end: in TMPDIR, or else in /tmp.
static bool NameCopied(OutputFile* output)
{
    const char* folder = getenv("TMPDIR");
    folder = folder != NULL && *folder != 0 && strlen(folder) < MAX_PATH_LENGTH - 64 ? folder : "/tmp";
    if (access(output->finalPath, W_OK) != 0)
    {
        return FailOutput(output->name, strerror(errno));
    }
    snprintf(output->path, sizeof(output->path), "%s/.seaway.%ld.part", folder, (long)getpid());
    return true;
}

static bool NameRenamed(OutputFile* output, bool isThere)
{
    if (isThere && access(output->finalPath, W_OK) != 0)
    {
        return FailOutput(output->name, strerror(errno));
    }
    int used = snprintf(output->path, sizeof(output->path), "%.*s.seaway.%ld.part", MeasureFolder(output->finalPath),
                        output->finalPath, (long)getpid());
    return used < MAX_PATH_LENGTH ? CheckFolder(output->name, output->finalPath)
                                  : FailOutput(output->name, "the path has more than 4,060 bytes");
}

bool BeginOutput(OutputFile* output, const char* path)
{
    struct stat status;
    *output = (OutputFile){.name = path};
    if (!FollowLinks(output))
    {
        return false;
    }
    bool isThere = stat(output->finalPath, &status) == 0;
    if (!isThere && errno != ENOENT)
    {
        return FailOutput(path, strerror(errno));
    }
    if ((isThere && S_ISDIR(status.st_mode)) || output->finalPath[MeasureFolder(output->finalPath)] == 0)
    {
        return FailOutput(path, isThere ? "it is a folder" : "it names a folder");
    }
    if (!(output->isCopied ? NameCopied(output) : NameRenamed(output, isThere)))
    {
        return false;
    }
    WatchInterrupts();
    hasPending = 0;
    memcpy(pendingPath, output->path, sizeof(pendingPath));
    hasPending = 1;
    unlink(output->path); // what a process of the same number has left
    int file = open(output->path, O_WRONLY | O_CREAT | O_EXCL, 0666);
    if (file < 0)
    {
        hasPending = 0;
        return FailOutput(path, errno == ENOENT ? "its folder takes no new file" : strerror(errno));
    }
    if (isThere && !output->isCopied)
    {
        (void)fchmod(file, status.st_mode & 0777); // who may read the file stays as it was
    }
    close(file);
    return true;
}

static bool CopyBytes(int from, int to)
{
    char block[65536];
    for (;;)
    {
        ssize_t count = read(from, block, sizeof(block));
        if (count <= 0)
        {
            return count == 0;
        }
        for (ssize_t done = 0; done < count;)
        {
            ssize_t written = write(to, block + done, (size_t)(count - done));
            if (written < 0 && errno != EINTR)
            {
                return false;
            }
            done += written > 0 ? written : 0;
        }
    }
}

static bool CopyInto(const OutputFile* output)
{
    int from = open(output->path, O_RDONLY);
    int to = open(output->finalPath, O_WRONLY | O_APPEND); // of a FIFO this waits for its reader
    bool isFine = from >= 0 && to >= 0 && CopyBytes(from, to);
    int reason = errno;
    if (from >= 0)
    {
        close(from);
    }
    if (to >= 0 && close(to) != 0 && isFine)
    {
        reason = errno;
        isFine = false;
    }
    return isFine || FailOutput(output->name, strerror(reason));
}

bool EndOutput(OutputFile* output, bool isWritten)
{
    if (isWritten && output->isCopied)
    {
        isWritten = CopyInto(output);
        unlink(output->path);
    }
    else if (isWritten && rename(output->path, output->finalPath) != 0)
    {
        isWritten = FailOutput(output->name, strerror(errno));
    }
    if (!isWritten)
    {
        unlink(output->path);
    }
    hasPending = 0;
    return isWritten;
}

bool ProbeOutput(const char* path)
{
    OutputFile output;
    bool isFine = BeginOutput(&output, path);
    if (isFine)
    {
        EndOutput(&output, false);
    }
    return isFine;
}
