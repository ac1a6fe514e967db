// SPDX-License-Identifier: MIT
#include "video.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "mp4_check.h"
#include "output.h"
#include "common.h"

#define EXIT_NO_PROGRAM 127

struct Video
{
    OutputFile output;
    pid_t process;
    int pipe;
    FILE* messages; // what ffmpeg says
    size_t frameSize;
    int frameCount; // written so far
    bool isFine;
};

// In the child: stdin from the pipe, stderr to a file, then become ffmpeg. If that fails, a byte goes into `failure`.
static void BecomeEncoder(int input, int messages, int failure, const char* path, int width, int height,
                          double framesPerSecond)
{
    char size[32], rate[32], target[MAX_PATH_LENGTH + 8];
    snprintf(target, sizeof(target), "file:%s", path); // or what stands before a colon would be a protocol
    snprintf(size, sizeof(size), "%dx%d", width, height);
    snprintf(rate, sizeof(rate), "%.9g", framesPerSecond);
    const char* arguments[] = {"ffmpeg",      "-hide_banner", "-loglevel",
                               "error",       "-nostdin",     "-y",
                               "-f",          "rawvideo",     "-pix_fmt",
                               "rgb24",       "-s",           size,
                               "-r",          rate,           "-i",
                               "pipe:0",      "-an",          "-c:v",
                               "libx264",     "-preset",      "medium",
                               "-crf",        "17",           "-pix_fmt",
                               "yuv420p",     "-vf",          "scale=out_color_matrix=bt709",
                               "-colorspace", "bt709",        "-color_primaries",
                               "bt709",       "-color_trc",   "bt709",
                               "-movflags",   "+faststart",   "-f",
                               "mp4",         target,         NULL};
    char* copies[sizeof(arguments) / sizeof(arguments[0])];
    memcpy(copies, arguments, sizeof(arguments)); // execvp's char* const* is older than const
    dup2(input, STDIN_FILENO);
    dup2(messages, STDERR_FILENO);
    dup2(messages, STDOUT_FILENO);
    signal(SIGPIPE, SIG_DFL);
    execvp(copies[0], copies);
    _exit(write(failure, "x", 1) == 1 ? EXIT_NO_PROGRAM : EXIT_FAILURE);
}

// Both ends are closed when a process becomes another program.
static bool OpenPipe(int ends[2])
{
    return pipe(ends) == 0 && fcntl(ends[0], F_SETFD, FD_CLOEXEC) == 0 && fcntl(ends[1], F_SETFD, FD_CLOEXEC) == 0;
}

static bool StartEncoder(Video* video, int width, int height, double framesPerSecond)
{
    int ends[2], failure[2];
    char byte;
    video->messages = tmpfile();
    if (video->messages == NULL || !OpenPipe(ends) || !OpenPipe(failure))
    {
        Complain("cannot start ffmpeg: %s", strerror(errno));
        return false;
    }
    signal(SIGPIPE, SIG_IGN);
    video->process = fork();
    if (video->process == 0)
    {
        BecomeEncoder(ends[0], fileno(video->messages), failure[1], video->output.path, width, height, framesPerSecond);
    }
    int reason = errno;
    close(ends[0]);
    close(failure[1]);
    video->pipe = ends[1];
    SetOutputProcess(video->process > 0 ? video->process : 0);
    bool isAbsent = read(failure[0], &byte, 1) == 1; // nothing comes of a program that starts
    close(failure[0]);
    if (video->process > 0 && !isAbsent)
    {
        return true;
    }
    if (isAbsent)
    {
        Complain("cannot write %s: ffmpeg is not installed; `--out FOLDER/` writes numbered pictures instead",
                 video->output.name);
        SetOutputProcess(0);
        waitpid(video->process, NULL, 0);
    }
    else
    {
        Complain("cannot start ffmpeg: %s", strerror(reason));
    }
    close(video->pipe);
    return false;
}

Video* OpenVideo(const char* path, int width, int height, double framesPerSecond)
{
    Video* video = calloc(1, sizeof(Video));
    if (video == NULL)
    {
        Complain("no memory for a video");
        return NULL;
    }
    if (!BeginOutput(&video->output, path))
    {
        free(video);
        return NULL;
    }
    if (!StartEncoder(video, width, height, framesPerSecond))
    {
        EndOutput(&video->output, false);
        if (video->messages != NULL)
        {
            fclose(video->messages);
        }
        free(video);
        return NULL;
    }
    video->frameSize = (size_t)width * (size_t)height * 3;
    video->isFine = true;
    return video;
}

bool WriteVideoFrame(Video* video, const uint8_t* rgb)
{
    for (size_t done = 0; done < video->frameSize && video->isFine;)
    {
        ssize_t written = write(video->pipe, rgb + done, video->frameSize - done);
        if (written < 0 && errno != EINTR)
        {
            video->isFine = false; // ffmpeg has left; CloseVideo() says why
        }
        done += written > 0 ? (size_t)written : 0;
    }
    video->frameCount += video->isFine;
    return video->isFine;
}

// `fault`: of the file that it left, or NULL.
static void ComplainAboutEncoder(Video* video, const char* fault)
{
    char message[512] = "";
    rewind(video->messages);
    if (fgets(message, sizeof(message), video->messages) != NULL)
    {
        message[strcspn(message, "\n")] = 0;
    }
    Complain("cannot write %s: ffmpeg failed: %s", video->output.name,
             message[0] != 0 ? message
             : fault != NULL ? fault
                             : "it gave no reason");
}

bool CloseVideo(Video* video, bool keep)
{
    if (video == NULL)
    {
        return false;
    }
    close(video->pipe);
    int status = 0;
    while (waitpid(video->process, &status, 0) < 0 && errno == EINTR)
    {
    }
    SetOutputProcess(0);
    bool isWritten = video->isFine && WIFEXITED(status) && WEXITSTATUS(status) == 0;
    const char* fault = isWritten && keep ? FindVideoFault(video->output.path, video->frameCount) : NULL;
    if (!isWritten || fault != NULL)
    {
        ComplainAboutEncoder(video, fault);
        isWritten = false;
    }
    isWritten = EndOutput(&video->output, isWritten && keep);
    fclose(video->messages);
    free(video);
    return isWritten;
}
