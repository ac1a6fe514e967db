// SPDX-License-Identifier: MIT
// The panel leaves room for the sea, its letters can be read, and handles lie where the mouse puts them.

#include "ui_scale.h"

#include <math.h>

#include "support/cmocka_setup.h"

static float GetPart(float width, float height, float density)
{
    return ChoosePanelWidth(width, 13.0f * ChooseUiScale(width, height, density, 1.0f)) / width;
}

static void ThePanelIsAtMostTwoFifthsOfAWindow(void** state)
{
    (void)state;
    static const float sizes[][3] = {{640, 360, 1},   {800, 600, 1},   {1280, 720, 1}, {1024, 768, 1}, {1920, 1080, 1},
                                     {3840, 2160, 1}, {3840, 2160, 2}, {1280, 720, 2}, {2560, 1440, 1}};
    for (int i = 0; i < (int)(sizeof(sizes) / sizeof(sizes[0])); i++)
    {
        float part = GetPart(sizes[i][0], sizes[i][1], sizes[i][2]);
        print_message("%.0f x %.0f at density %.0f: %.0f %%\n", (double)sizes[i][0], (double)sizes[i][1],
                      (double)sizes[i][2], 100.0 * (double)part);
        assert_true(part <= 0.401f);
    }
}

static void LettersStayReadable(void** state)
{
    (void)state;
    assert_true(ChooseUiScale(320.0f, 200.0f, 1.0f, 1.0f) * 13.0f > 11.0f);
    assert_true(ChooseUiScale(1280.0f, 720.0f, 1.0f, 1.0f) == 1.0f);
    assert_true(ChooseUiScale(1920.0f, 1080.0f, 1.0f, 1.0f) == 1.0f);
    assert_true(ChooseUiScale(3840.0f, 2160.0f, 1.0f, 1.0f) == 2.0f);
    assert_true(ChooseUiScale(2560.0f, 1440.0f, 2.0f, 1.0f) == 2.0f);
    assert_true(ChooseUiScale(1280.0f, 720.0f, 1.0f, 1.5f) == 1.5f);
}

static void WishesGoUpAndComeBack(void** state)
{
    (void)state;
    float factor = StepUiFactor(StepUiFactor(StepUiFactor(1.0f, 1), 1), -1);
    assert_true(factor > 1.1f && StepUiFactor(factor, -1) == 1.0f);
    for (int i = 0; i < 50; i++)
    {
        factor = StepUiFactor(factor, 1);
    }
    assert_true(factor == LARGEST_UI_FACTOR);
}

static void HandlesLieByValueOrByLogarithm(void** state)
{
    (void)state;
    assert_true(FindSliderPlace(5.0, 0.0, 20.0, false) == 0.25);
    assert_true(fabs(FindSliderPlace(10.0, 1.0, 100.0, true) - 0.5) < 1e-12);
    assert_true(FindSliderPlace(-3.0, 0.0, 20.0, false) == 0.0 && FindSliderPlace(30.0, 0.0, 20.0, false) == 1.0);
    assert_true(FindSliderPlace(0.0, 1.0, 100.0, true) == 0.0 && FindSliderPlace(-1.0, 1.0, 100.0, true) == 0.0);
    assert_true(FindSliderPlace(1.0, 1.0, 1.0, false) == 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ThePanelIsAtMostTwoFifthsOfAWindow),
        cmocka_unit_test(LettersStayReadable),
        cmocka_unit_test(WishesGoUpAndComeBack),
        cmocka_unit_test(HandlesLieByValueOrByLogarithm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
