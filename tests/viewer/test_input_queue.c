// SPDX-License-Identifier: MIT
// However long a frame is, the panel sees every key and button go down before it goes up.

#include "input_queue.h"

#include "support/cmocka_setup.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

static InputQueue s_queue;
static InputEvent s_batch[MAX_INPUT_EVENTS];

static int Empty(void** state)
{
    (void)state;
    s_queue.count = 0;
    return 0;
}

static void Key(int code, int action, int modifiers)
{
    PushInput(&s_queue, (InputEvent){.kind = INPUT_KEY, .code = code, .action = action, .modifiers = modifiers});
}

static void Button(int action)
{
    PushInput(&s_queue, (InputEvent){.kind = INPUT_BUTTON, .code = GLFW_MOUSE_BUTTON_LEFT, .action = action});
}

static void Type(char letter)
{
    Key(letter, GLFW_PRESS, 0);
    PushInput(&s_queue, (InputEvent){.kind = INPUT_LETTER, .code = letter});
    Key(letter, GLFW_RELEASE, 0);
}

static int Take(void)
{
    return TakeInput(&s_queue, s_batch);
}

static void EnterStaysDownForAFrame(void** state)
{
    (void)state;
    Key(GLFW_KEY_ENTER, GLFW_PRESS, 0);
    Key(GLFW_KEY_ENTER, GLFW_RELEASE, 0);
    assert_int_equal(Take(), 1);
    assert_int_equal(s_batch[0].action, GLFW_PRESS);
    assert_int_equal(Take(), 1);
    assert_int_equal(s_batch[0].action, GLFW_RELEASE);
    assert_int_equal(Take(), 0);
}

static void ANumberAndItsEnterArriveInOneFrame(void** state)
{
    (void)state;
    Type('1');
    Type('2');
    Key(GLFW_KEY_ENTER, GLFW_PRESS, 0);
    Key(GLFW_KEY_ENTER, GLFW_RELEASE, 0);
    assert_int_equal(Take(), 7); // all but Enter's release
    assert_int_equal(s_batch[6].code, GLFW_KEY_ENTER);
    assert_int_equal(Take(), 1);
}

static void WhatFollowsEnterIsNotWritten(void** state)
{
    (void)state;
    Type('5');
    Key(GLFW_KEY_ENTER, GLFW_PRESS, 0);
    Key(GLFW_KEY_ENTER, GLFW_RELEASE, 0);
    Type('o');
    assert_int_equal(Take(), 4);
    assert_int_equal(Take(), 4); // the release and the letter
    assert_int_equal(s_batch[1].code, 'o');
}

static void CtrlIsDownWithItsClickAndUpAfterIt(void** state)
{
    (void)state;
    Key(GLFW_KEY_LEFT_CONTROL, GLFW_PRESS, GLFW_MOD_CONTROL);
    Button(GLFW_PRESS);
    Button(GLFW_RELEASE);
    Key(GLFW_KEY_LEFT_CONTROL, GLFW_RELEASE, 0);
    Type('7');
    assert_int_equal(Take(), 2); // Ctrl and the press
    assert_int_equal(s_batch[1].kind, INPUT_BUTTON);
    assert_int_equal(Take(), 1); // the button's release
    assert_int_equal(Take(), 4); // now the field is open
    assert_int_equal(s_queue.count, 0);
}

static void TwoClicksAreTwo(void** state)
{
    (void)state;
    for (int i = 0; i < 2; i++)
    {
        Button(GLFW_PRESS);
        Button(GLFW_RELEASE);
    }
    for (int i = 0; i < 4; i++)
    {
        assert_int_equal(Take(), 1);
        assert_int_equal(s_batch[0].action, i % 2 == 0 ? GLFW_PRESS : GLFW_RELEASE);
    }
}

static void ErasingKeepsItsPlaceAmongLetters(void** state)
{
    (void)state;
    Type('1');
    Key(GLFW_KEY_BACKSPACE, GLFW_PRESS, 0);
    Key(GLFW_KEY_BACKSPACE, GLFW_RELEASE, 0);
    Key(GLFW_KEY_BACKSPACE, GLFW_PRESS, 0);
    Type('2');
    assert_int_equal(Take(), 4);
    assert_int_equal(Take(), 1);
    assert_int_equal(Take(), 1);
    assert_int_equal(Take(), 3);
}

static void NothingIsLostAndOrderIsKept(void** state)
{
    (void)state;
    static const int codes[] = {'A', GLFW_KEY_ENTER, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_TAB, '5', GLFW_KEY_LEFT_SHIFT};
    uint32_t random = 7;
    int pushed = 0, taken = 0;
    for (int round = 0; round < 400; round++)
    {
        for (int i = 0; i < 3 && s_queue.count < MAX_INPUT_EVENTS; i++)
        {
            random = random * 1664525u + 1013904223u;
            PushInput(&s_queue, (InputEvent){.kind = (InputKind)(random >> 28 & 3),
                                             .code = codes[(random >> 20) % 6],
                                             .action = (int)(random >> 16 & 1),
                                             .scancode = pushed++});
        }
        int count = Take();
        assert_true(count > 0);
        for (int i = 0; i < count; i++)
        {
            assert_int_equal(s_batch[i].scancode, taken++);
        }
    }
    for (int count = Take(); count > 0; count = Take())
    {
        taken += count;
    }
    assert_int_equal(taken, pushed);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(EnterStaysDownForAFrame, Empty),
        cmocka_unit_test_setup(ANumberAndItsEnterArriveInOneFrame, Empty),
        cmocka_unit_test_setup(WhatFollowsEnterIsNotWritten, Empty),
        cmocka_unit_test_setup(CtrlIsDownWithItsClickAndUpAfterIt, Empty),
        cmocka_unit_test_setup(TwoClicksAreTwo, Empty),
        cmocka_unit_test_setup(ErasingKeepsItsPlaceAmongLetters, Empty),
        cmocka_unit_test_setup(NothingIsLostAndOrderIsKept, Empty),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
