// SPDX-License-Identifier: MIT
// Several pictures of one world with one renderer: each shows, to the byte, what it would show alone.

#include <math.h>
#include <string.h>

#include <seaway/seaway.h>
#include <seaway/stage.h>

#include "gpu/vk/vk_device.h"
#include "support/cmocka_setup.h"
#include "support/counting_host.h"

#define WIDTH 96
#define HEIGHT 54
#define BYTES (4 * WIDTH * HEIGHT)

// Halves of a split screen: a deck at noon, and a mast in the low sun, so that sky, mesh and exposure differ.
enum
{
    LEFT,
    RIGHT,
    HALVES
};

static CountingMemory s_memory;

static struct
{
    swStage* stage;
    swWorld* world;
    swView* view;
    swGpuWorld* gpuWorld;
    swStageTargets targets[HALVES];
    swStageBuffer bytes[HALVES];
} s_set;

// A renderer and the pictures that are drawn with it.
typedef struct Show
{
    swRenderer* renderer;
    swPicture* pictures[HALVES];
} Show;

static Show OpenShow(bool hasLeft, bool hasRight)
{
    Show show = {0};
    const bool has[HALVES] = {hasLeft, hasRight};
    const swPictureDef def = swDefaultPictureDef();
    assert_int_equal(swCreateRenderer(s_set.gpuWorld, &show.renderer), SW_SUCCESS);
    for (int i = 0; i < HALVES; ++i)
    {
        assert_int_equal(has[i] ? swCreatePicture(show.renderer, &def, &show.pictures[i]) : SW_SUCCESS, SW_SUCCESS);
    }
    return show;
}

static void CloseShow(Show* show)
{
    assert_int_equal(swStage_Wait(s_set.stage), SW_SUCCESS);
    for (int i = 0; i < HALVES; ++i)
    {
        swDestroyPicture(show->pictures[i]);
    }
    swDestroyRenderer(show->renderer);
}

static swShot MakeShot(int half, float sunElevation)
{
    const swPos places[HALVES] = {{0.0, 6.0, 0.0}, {20.0, 90.0, -35.0}};
    const float headings[HALVES] = {0.5f, 2.6f};
    swShot shot = {.view = s_set.view, .sky = swDefaultSkyDef(), .water = swDefaultWaterDef(), .time = 10.0};
    shot.camera = swMakeCamera(places[half], headings[half], -0.15f, 0.0f, 0.9f, WIDTH, HEIGHT);
    shot.sky.sunElevation = sunElevation;
    return shot;
}

static void Record(const Show* show, const swShot* shots, float dt, bool immediate, const swStageFrame* frame)
{
    assert_int_equal(swGpuWorld_Record(s_set.gpuWorld, frame->commands, frame->index), SW_SUCCESS);
    for (int i = 0; i < HALVES; ++i) // all are prepared before any is drawn: nothing of one may be lost by the other
    {
        swPicture* picture = show->pictures[i];
        swResult result =
            picture != NULL ? swPicture_Prepare(picture, frame->commands, &shots[i], frame->index) : SW_SUCCESS;
        assert_int_equal(result, SW_SUCCESS);
    }
    for (int i = 0; i < HALVES; ++i)
    {
        if (show->pictures[i] != NULL)
        {
            swStage_DrawPicture(s_set.stage, frame->commands, show->pictures[i], &s_set.targets[i], NULL, dt,
                                immediate);
            swStage_CopyToHost(s_set.stage, frame->commands, &s_set.targets[i].output, SW_STAGE_USE_COLOR_TARGET,
                               &s_set.bytes[i]);
        }
    }
}

static void Submit(const Show* show, const swShot* shots, float dt, bool immediate)
{
    swStageFrame frame;
    assert_int_equal(swStage_BeginFrame(s_set.stage, &frame), SW_SUCCESS);
    Record(show, shots, dt, immediate, &frame);
    assert_int_equal(swStage_SubmitFrame(s_set.stage, &frame, NULL), SW_SUCCESS);
}

static void Draw(const Show* show, const swShot* shots, float dt, bool immediate)
{
    Submit(show, shots, dt, immediate);
    assert_int_equal(swStage_Wait(s_set.stage), SW_SUCCESS);
}

// The day, then some frames of dusk that the eye gets used to.
static void DrawDusk(const Show* show, float first, float then)
{
    const swShot day[HALVES] = {MakeShot(LEFT, first), MakeShot(RIGHT, first)};
    const swShot dusk[HALVES] = {MakeShot(LEFT, then), MakeShot(RIGHT, first)};
    Draw(show, day, 0.0f, true);
    Draw(show, dusk, 0.2f, false);
    Draw(show, dusk, 0.2f, false);
}

static double MeanOf(const uint8_t* bytes)
{
    double sum = 0.0;
    for (int i = 0; i < BYTES; ++i)
    {
        sum += (i & 3) != 3 ? (double)bytes[i] / (0.75 * BYTES) : 0.0;
    }
    return sum;
}

static void TwoPicturesOfAFrameAreThoseOfOneEach(void** state)
{
    (void)state;
    static uint8_t pair[HALVES][BYTES];
    const swShot shots[HALVES] = {MakeShot(LEFT, 0.7f), MakeShot(RIGHT, 0.05f)};
    Show both = OpenShow(true, true);
    Draw(&both, shots, 0.0f, true);
    for (int i = 0; i < HALVES; ++i)
    {
        memcpy(pair[i], s_set.bytes[i].data, BYTES);
    }
    CloseShow(&both);
    assert_memory_not_equal(pair[LEFT], pair[RIGHT], BYTES);
    for (int i = 0; i < HALVES; ++i)
    {
        Show one = OpenShow(i == LEFT, i == RIGHT);
        Draw(&one, shots, 0.0f, true);
        assert_memory_equal(pair[i], s_set.bytes[i].data, BYTES);
        CloseShow(&one);
    }
}

static void ExposuresDoNotMix(void** state)
{
    (void)state;
    static uint8_t pair[HALVES][BYTES];
    Show both = OpenShow(true, true);
    DrawDusk(&both, 0.7f, 0.02f);
    for (int i = 0; i < HALVES; ++i)
    {
        memcpy(pair[i], s_set.bytes[i].data, BYTES);
    }
    const swShot used[HALVES] = {MakeShot(LEFT, 0.02f), MakeShot(RIGHT, 0.7f)};
    Draw(&both, used, 0.0f, true);
    assert_true(MeanOf(s_set.bytes[LEFT].data) > MeanOf(pair[LEFT]) + 2.0); // the eye was not used to the dusk yet
    CloseShow(&both);
    for (int i = 0; i < HALVES; ++i)
    {
        Show one = OpenShow(i == LEFT, i == RIGHT);
        DrawDusk(&one, 0.7f, 0.02f);
        assert_memory_equal(pair[i], s_set.bytes[i].data, BYTES);
        CloseShow(&one);
    }
}

static void APictureGoesWhileItsFrameIsInFlight(void** state)
{
    (void)state;
    static uint8_t wanted[HALVES][BYTES];
    const swShot shots[HALVES] = {MakeShot(LEFT, 0.7f), MakeShot(RIGHT, 0.05f)};
    Show both = OpenShow(true, true);
    Draw(&both, shots, 0.0f, true);
    for (int i = 0; i < HALVES; ++i)
    {
        memcpy(wanted[i], s_set.bytes[i].data, BYTES);
    }
    Submit(&both, shots, 0.0f, true);
    swDestroyPicture(both.pictures[RIGHT]);
    both.pictures[RIGHT] = NULL;
    for (int i = 0; i < 5; ++i) // past the frames in flight
    {
        Submit(&both, shots, 0.0f, true);
    }
    assert_int_equal(swStage_Wait(s_set.stage), SW_SUCCESS);
    assert_memory_equal(wanted[LEFT], s_set.bytes[LEFT].data, BYTES);
    assert_memory_equal(wanted[RIGHT], s_set.bytes[RIGHT].data, BYTES); // of its last frame
    CloseShow(&both);
}

static void PicturesFollowFramesThatAreThrownAway(void** state)
{
    (void)state;
    static uint8_t wanted[HALVES][BYTES];
    const swShot shots[HALVES] = {MakeShot(LEFT, 0.7f), MakeShot(RIGHT, 0.05f)};
    Show first = OpenShow(true, true);
    Draw(&first, shots, 0.0f, true);
    for (int i = 0; i < HALVES; ++i)
    {
        memcpy(wanted[i], s_set.bytes[i].data, BYTES);
    }
    CloseShow(&first);
    Show second = OpenShow(true, true);
    swStageFrame frame;
    assert_int_equal(swStage_BeginFrame(s_set.stage, &frame), SW_SUCCESS);
    Record(&second, shots, 0.0f, true, &frame); // the first: tables, exposure and the foam's texture are in it
    swStage_DropFrame(s_set.stage, &frame);
    swGpuWorld_Discard(s_set.gpuWorld, frame.index);
    Draw(&second, shots, 0.0f, true);
    for (int i = 0; i < HALVES; ++i)
    {
        assert_memory_equal(wanted[i], s_set.bytes[i].data, BYTES);
    }
    CloseShow(&second);
}

// A mirror or a map may do with fewer bits. Formats are a picture's, not the renderer's.
static void APictureOfOtherFormatsIsOfTheSameRenderer(void** state)
{
    (void)state;
    const swShot shots[HALVES] = {MakeShot(LEFT, 0.7f), MakeShot(RIGHT, 0.7f)};
    Show show = OpenShow(true, false);
    Draw(&show, shots, 0.0f, true);
    const double wanted = MeanOf(s_set.bytes[LEFT].data);
    swDestroyPicture(show.pictures[LEFT]);
    swPictureDef def = swDefaultPictureDef();
    def.colorFormat = VK_FORMAT_B10G11R11_UFLOAT_PACK32;
    assert_int_equal(swCreatePicture(show.renderer, &def, &show.pictures[LEFT]), SW_SUCCESS);
    const swStageImageDef hdr = {.name = "a small picture",
                                 .format = def.colorFormat,
                                 .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
                                 .width = WIDTH,
                                 .height = HEIGHT};
    swStageImage kept = s_set.targets[LEFT].hdr;
    assert_int_equal(swStage_CreateImage(s_set.stage, &hdr, &s_set.targets[LEFT].hdr), SW_SUCCESS);
    Draw(&show, shots, 0.0f, true);
    assert_true(fabs(MeanOf(s_set.bytes[LEFT].data) - wanted) < 1.0);
    CloseShow(&show);
    swStage_DestroyImage(s_set.stage, &s_set.targets[LEFT].hdr);
    s_set.targets[LEFT].hdr = kept;

    def.colorFormat = VK_FORMAT_D32_SFLOAT; // no colour
    swPicture* none = NULL;
    Show other = OpenShow(false, false);
    assert_int_equal(swCreatePicture(other.renderer, &def, &none), SW_ERROR_UNSUPPORTED);
    assert_null(none);
    CloseShow(&other);
}

// Shaders write floats, and a stencil holds no depth: Vulkan's rules would be broken without a word.
static void IntegersAndStencilsAreNoFormatsOfAPicture(void** state)
{
    (void)state;
    Show show = OpenShow(false, false);
    swPictureDef defs[3] = {swDefaultPictureDef(), swDefaultPictureDef(), swDefaultPictureDef()};
    defs[0].colorFormat = VK_FORMAT_R16G16B16A16_UINT;
    defs[1].depthFormat = VK_FORMAT_S8_UINT;
    defs[2].outputFormat = VK_FORMAT_R8G8B8A8_UINT;
    for (int i = 0; i < 3; ++i)
    {
        swPicture* none = NULL;
        assert_int_equal(swCreatePicture(show.renderer, &defs[i], &none), SW_ERROR_UNSUPPORTED);
        assert_null(none);
    }
    CloseShow(&show);
}

#ifdef NDEBUG // misuse stops the program where asserts are on
// At a hundred stops and more a float overflows, and a picture that should be white is black.
static void AnExposureBeyondItsRangeIsRefused(void** state)
{
    (void)state;
    Show show = OpenShow(true, false);
    swStageFrame frame;
    assert_int_equal(swStage_BeginFrame(s_set.stage, &frame), SW_SUCCESS);
    assert_int_equal(swGpuWorld_Record(s_set.gpuWorld, frame.commands, frame.index), SW_SUCCESS);
    const float stops[] = {-41.0f, 41.0f, 1000.0f, NAN};
    for (size_t i = 0; i < sizeof(stops) / sizeof(stops[0]); ++i)
    {
        swShot shot = MakeShot(LEFT, 0.7f);
        shot.exposureEv = stops[i];
        assert_int_equal(swPicture_Prepare(show.pictures[LEFT], frame.commands, &shot, frame.index), SW_ERROR_INVALID);
    }
    swStage_DropFrame(s_set.stage, &frame);
    swGpuWorld_Discard(s_set.gpuWorld, frame.index);
    CloseShow(&show);
}
#endif

// Foam of a device that does not filter 32-bit floats: by hand, and as smooth.
static void FoamIsAsSmoothWithoutFiltersOfFloats(void** state)
{
    (void)state;
    static uint8_t wanted[BYTES];
    swShot shots[HALVES] = {MakeShot(LEFT, 0.7f), MakeShot(RIGHT, 0.7f)};
    shots[LEFT].debug = SW_DEBUG_FOAM;
    Show show = OpenShow(true, false);
    Draw(&show, shots, 0.0f, true);
    memcpy(wanted, s_set.bytes[LEFT].data, BYTES);
    CloseShow(&show);
    swGpu* gpu = swStage_GetGpu(s_set.stage);
    assert_true(gpu->filtersFloats);
    gpu->filtersFloats = false;
    show = OpenShow(true, false);
    Draw(&show, shots, 0.0f, true);
    gpu->filtersFloats = true;
    const uint8_t* got = s_set.bytes[LEFT].data;
    int most = 0, foam = 0;
    for (int i = 0; i < BYTES; ++i)
    {
        int difference = got[i] > wanted[i] ? got[i] - wanted[i] : wanted[i] - got[i];
        most = difference > most ? difference : most;
        foam += (i & 3) == 0 && wanted[i] > 8;
    }
    assert_true(foam > 50); // there is some
    assert_true(most <= 1); // hardware has 8 bits between texels
    CloseShow(&show);
}

static void WithoutMemoryThereIsNoRendererAndNoPicture(void** state)
{
    (void)state;
    const swPictureDef def = swDefaultPictureDef();
    const long long before = s_memory.bytes;
    bool isMade = false;
    int failed = 0;
    for (; !isMade; ++failed)
    {
        swRenderer* renderer = NULL;
        swPicture* picture = NULL;
        s_memory.failAt = s_memory.allocations + failed;
        swResult result = swCreateRenderer(s_set.gpuWorld, &renderer);
        isMade = result == SW_SUCCESS && swCreatePicture(renderer, &def, &picture) == SW_SUCCESS;
        s_memory.failAt = -1;
        assert_true(result == SW_SUCCESS || renderer == NULL);
        assert_true(isMade || picture == NULL);
        swDestroyPicture(picture);
        swDestroyRenderer(renderer);
    }
    assert_true(failed > 3);                      // the renderer, its pipelines' list, the picture
    assert_true(s_memory.bytes - before < 65536); // but for lists of the device that have grown
}

static int OpenSet(void** state)
{
    (void)state;
    swHost host = MakeCountingHost(&s_memory);
    host.log = swDefaultHost().log;
    swGpuDef gpuDef = swDefaultGpuDef();
    gpuDef.enableValidation = true;
    gpuDef.layers = SW_LAYERS_CORE;
    swWorldDef worldDef = swDefaultWorldDef();
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    swViewDef viewDef = swDefaultViewDef();
    viewDef.enableCpuLayers = true;
    viewDef.resolution = 128;
    swWaveSystemId id;
    bool isReady = swCreateStage(&host, &gpuDef, &s_set.stage) == SW_SUCCESS &&
                   swCreateWorld(&host, &worldDef, &s_set.world) == SW_SUCCESS &&
                   swCreateWaveSystem(s_set.world, &waves, &id) == SW_SUCCESS &&
                   swCreateView(s_set.world, &viewDef, &s_set.view) == SW_SUCCESS &&
                   swCreateGpuWorld(swStage_GetGpu(s_set.stage), s_set.world, &s_set.gpuWorld) == SW_SUCCESS &&
                   swWorld_Step(s_set.world, 10.0) == SW_SUCCESS;
    for (int i = 0; i < HALVES && isReady; ++i)
    {
        isReady =
            swStage_CreateTargets(s_set.stage, WIDTH, HEIGHT, 0, 0, &s_set.targets[i]) == SW_SUCCESS &&
            swStage_CreateBuffer(s_set.stage, BYTES, VK_BUFFER_USAGE_TRANSFER_DST_BIT, &s_set.bytes[i]) == SW_SUCCESS;
    }
    return isReady ? 0 : -1;
}

static int CloseSet(void** state)
{
    (void)state;
    int messages = swGpu_GetValidationCount(swStage_GetGpu(s_set.stage));
    for (int i = 0; i < HALVES; ++i)
    {
        swStage_DestroyTargets(s_set.stage, &s_set.targets[i]);
        swStage_DestroyBuffer(s_set.stage, &s_set.bytes[i]);
    }
    swDestroyGpuWorld(s_set.gpuWorld);
    swDestroyStage(s_set.stage);
    swDestroyView(s_set.view);
    swDestroyWorld(s_set.world);
    return messages + (s_memory.bytes != 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(TwoPicturesOfAFrameAreThoseOfOneEach),
        cmocka_unit_test(ExposuresDoNotMix),
        cmocka_unit_test(APictureGoesWhileItsFrameIsInFlight),
        cmocka_unit_test(PicturesFollowFramesThatAreThrownAway),
        cmocka_unit_test(APictureOfOtherFormatsIsOfTheSameRenderer),
        cmocka_unit_test(IntegersAndStencilsAreNoFormatsOfAPicture),
#ifdef NDEBUG
        cmocka_unit_test(AnExposureBeyondItsRangeIsRefused),
#endif
        cmocka_unit_test(FoamIsAsSmoothWithoutFiltersOfFloats),
        cmocka_unit_test(WithoutMemoryThereIsNoRendererAndNoPicture),
    };
    return cmocka_run_group_tests(tests, OpenSet, CloseSet);
}
