// SPDX-License-Identifier: MIT
// A server and two players in processes of their own, each with its own frame rate. Once a second they compare 64 bits
// of their seas; one player joins late, from the server's save. Links the core alone; POSIX.
#define _POSIX_C_SOURCE 200809L

#include <seaway/seaway.h>

#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

enum
{
    SECONDS = 8,
    JOIN_SECOND = 4
};

static swWaveSystemDef MakeWaves(void)
{
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    waves.resolution = 64;
    waves.tileWaves = 16;
    return waves;
}

static swWorld* MakeSea(const swHost* host)
{
    swWorldDef def = swDefaultWorldDef();
    swWaveSystemDef waves = MakeWaves();
    swWaveSystemId id;
    swWorld* world;
    if (swCreateWorld(host, &def, &world) != SW_SUCCESS || swCreateWaveSystem(world, &waves, &id) != SW_SUCCESS)
    {
        exit(1); // the host's log has said why
    }
    return world;
}

// Everybody does this at the same second: the wind turns and freshens over five.
static void ChangeWind(swWorld* world)
{
    swWaveSystemDef waves = MakeWaves();
    waves.spectrum.windSpeed = 14.0f;
    waves.spectrum.direction = 0.7f;
    swWaveSystemId first = {1, 1};
    if (swWaveSystem_Set(world, first, &waves, 5.0) != SW_SUCCESS)
    {
        exit(1);
    }
}

// One second of frames. Stepping to times that all compute alike, not by dt: sums of 1/60 and 1/144 drift apart.
static void StepSecond(swWorld* world, int second, int framesPerSecond)
{
    if (second == 2)
    {
        ChangeWind(world);
    }
    for (int frame = 0; frame < framesPerSecond; ++frame)
    {
        if (swWorld_StepTo(world, second + (frame + 1.0) / framesPerSecond) != SW_SUCCESS)
        {
            exit(1);
        }
    }
}

// A player's process: step, and tell the digest.
static void Play(swWorld* world, int firstSecond, int framesPerSecond, int pipeEnd)
{
    for (int second = firstSecond; second < SECONDS; ++second)
    {
        StepSecond(world, second, framesPerSecond);
        uint64_t digest = swWorld_GetDigest(world);
        if (write(pipeEnd, &digest, sizeof digest) != sizeof digest)
        {
            exit(1);
        }
    }
    swDestroyWorld(world);
    exit(0);
}

// What a player says of this second against what the server has.
static bool Agrees(int pipeEnd, uint64_t wanted)
{
    uint64_t digest = 0;
    return read(pipeEnd, &digest, sizeof digest) == sizeof digest && digest == wanted;
}

static void JoinLate(const swHost* host, const swWorld* server, int pipeEnd)
{
    size_t size = 0;
    swWorld_Save(server, NULL, &size);
    void* bytes = malloc(size); // what a server would send
    swRestoreDef def = swDefaultRestoreDef();
    swWorld* world;
    if (bytes == NULL || swWorld_Save(server, bytes, &size) != SW_SUCCESS ||
        swRestoreWorld(host, bytes, size, &def, &world) != SW_SUCCESS)
    {
        exit(1);
    }
    free(bytes);
    Play(world, JOIN_SECOND, 144, pipeEnd);
}

int main(void)
{
    swHost host = swDefaultHost();
    int early[2], late[2];
    if (pipe(early) != 0 || pipe(late) != 0)
    {
        perror("pipe");
        return 1;
    }
    fflush(stdout);
    if (fork() == 0)
    {
        Play(MakeSea(&host), 0, 60, early[1]);
    }
    close(early[1]); // so that reading ends if the player does
    swWorld* server = MakeSea(&host);
    bool isSame = true;
    for (int second = 0; second < SECONDS; ++second)
    {
        if (second == JOIN_SECOND)
        {
            fflush(stdout);
            if (fork() == 0)
            {
                JoinLate(&host, server, late[1]);
            }
            close(late[1]);
        }
        StepSecond(server, second, 20);
        uint64_t digest = swWorld_GetDigest(server);
        bool first = Agrees(early[0], digest);
        bool joined = second < JOIN_SECOND || Agrees(late[0], digest);
        printf("second %d: %016llx, the player %s%s\n", second + 1, (unsigned long long)digest,
               first ? "agrees" : "DIFFERS",
               second < JOIN_SECOND ? ""
               : joined             ? ", who joined late agrees"
                                    : ", who joined late DIFFERS");
        isSame = isSame && first && joined;
    }
    while (wait(NULL) > 0)
    {
    }
    swDestroyWorld(server);
    return isSame ? 0 : 1;
}
