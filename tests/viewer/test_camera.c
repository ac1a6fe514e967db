// SPDX-License-Identifier: MIT
#include "camera.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

static const double seaLevel = 100.0;

static Camera MakeCamera(double height, float heading, float pitch)
{
    Camera camera = DefaultCamera(seaLevel);
    camera.position.y = seaLevel + height;
    camera.heading = heading;
    camera.pitch = pitch;
    return camera;
}

static void HeadingNorthFliesTowardsNegativeZ(void** state)
{
    (void)state;
    Camera camera = MakeCamera(7.0, 0.0f, 0.0f);
    CameraInput input = {.forward = 1.0f};
    MoveCamera(&camera, &input, 0.5, seaLevel);
    assert_float_equal(camera.position.x, 0.0, 1e-6);
    assert_float_equal(camera.position.z, -5.0, 1e-6); // (3 + 7) m/s for half a second
}

static void HeadingEastFliesTowardsPositiveX(void** state)
{
    (void)state;
    Camera camera = MakeCamera(7.0, (float)(SW_PI / 2.0), 0.0f);
    CameraInput input = {.forward = 1.0f};
    MoveCamera(&camera, &input, 0.5, seaLevel);
    assert_float_equal(camera.position.x, 5.0, 1e-5);
    assert_float_equal(camera.position.z, 0.0, 1e-5);
}

static void SpeedGrowsWithHeight(void** state)
{
    (void)state;
    Camera low = MakeCamera(2.0, 0.0f, 0.0f);
    Camera high = MakeCamera(2000.0, 0.0f, 0.0f);
    CameraInput input = {.right = 1.0f};
    MoveCamera(&low, &input, 0.1, seaLevel);
    MoveCamera(&high, &input, 0.1, seaLevel);
    assert_true(high.position.x > 100.0 * low.position.x);
}

static void OrbitStartsWithoutAJump(void** state)
{
    (void)state;
    Camera camera = MakeCamera(30.0, 1.0f, -0.4f);
    swPos before = camera.position;
    CameraInput input = {0};
    ToggleOrbit(&camera, seaLevel);
    MoveCamera(&camera, &input, 0.1, seaLevel);
    assert_int_equal(camera.mode, CAMERA_ORBIT);
    assert_float_equal(camera.target.y, seaLevel, 1e-4);
    assert_float_equal(camera.position.x, before.x, 1e-4);
    assert_float_equal(camera.position.y, before.y, 1e-4);
    assert_float_equal(camera.position.z, before.z, 1e-4);
}

static void OrbitKeepsItsDistance(void** state)
{
    (void)state;
    Camera camera = MakeCamera(30.0, 1.0f, -0.4f);
    ToggleOrbit(&camera, seaLevel);
    CameraInput input = {.turnRight = 0.7f, .turnUp = -0.2f};
    MoveCamera(&camera, &input, 0.1, seaLevel);
    double x = camera.position.x - camera.target.x;
    double y = camera.position.y - camera.target.y;
    double z = camera.position.z - camera.target.z;
    assert_float_equal(sqrt(x * x + y * y + z * z), camera.distance, 1e-4);
}

static void TheEyeRidesOverACrestAndComesBack(void** state)
{
    (void)state;
    Camera camera = MakeCamera(2.0, 0.0f, 0.0f);
    KeepCameraDry(&camera, seaLevel + 5.0);
    assert_float_equal((float)GetCameraEye(&camera).y, (float)(seaLevel + 5.3), 1e-4f);
    KeepCameraDry(&camera, seaLevel - 1.0);
    assert_float_equal((float)GetCameraEye(&camera).y, (float)(seaLevel + 2.0), 1e-4f);
}

static void TheEyeDivesOnlyIfAsked(void** state)
{
    (void)state;
    Camera camera = MakeCamera(-4.0, 0.0f, 0.0f);
    KeepCameraDry(&camera, seaLevel);
    assert_true(GetCameraEye(&camera).y > seaLevel);
    camera.mayDive = true;
    KeepCameraDry(&camera, seaLevel);
    assert_float_equal((float)GetCameraEye(&camera).y, (float)(seaLevel - 4.0), 1e-4f);
}

static void LookingUpStopsBeforeTheZenith(void** state)
{
    (void)state;
    Camera camera = MakeCamera(2.0, 0.0f, 0.0f);
    CameraInput input = {.turnUp = 10.0f};
    MoveCamera(&camera, &input, 0.1, seaLevel);
    assert_true(camera.pitch < (float)(SW_PI / 2.0));
    assert_true(camera.pitch > 1.5f);
}

static void AnotherOriginShiftsAnOrbitAsAWhole(void** state)
{
    (void)state;
    Camera camera = MakeCamera(7.0, 1.0f, -0.3f);
    ToggleOrbit(&camera, seaLevel);
    Camera other = camera;
    ShiftCamera(&other, -5000.0, 3000.0);
    CameraInput input = {.right = 1.0f, .turnUp = 0.01f, .wheel = 1.0f};
    MoveCamera(&camera, &input, 0.5, seaLevel);
    MoveCamera(&other, &input, 0.5, seaLevel);
    assert_true(fabs(other.position.x - (camera.position.x - 5000.0)) < 1e-6);
    assert_true(fabs(other.position.y - camera.position.y) < 1e-6);
    assert_true(fabs(other.position.z - (camera.position.z + 3000.0)) < 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(HeadingNorthFliesTowardsNegativeZ),
        cmocka_unit_test(HeadingEastFliesTowardsPositiveX),
        cmocka_unit_test(SpeedGrowsWithHeight),
        cmocka_unit_test(OrbitStartsWithoutAJump),
        cmocka_unit_test(OrbitKeepsItsDistance),
        cmocka_unit_test(TheEyeRidesOverACrestAndComesBack),
        cmocka_unit_test(TheEyeDivesOnlyIfAsked),
        cmocka_unit_test(LookingUpStopsBeforeTheZenith),
        cmocka_unit_test(AnotherOriginShiftsAnOrbitAsAWhole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
