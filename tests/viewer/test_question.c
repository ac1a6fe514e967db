// SPDX-License-Identifier: MIT
// Nothing that the user has tuned is dropped without a question.

#include "question.h"

#include <string.h>

#include "support/cmocka_setup.h"

static void WithoutChangesNobodyIsAsked(void** state)
{
    (void)state;
    Asked question = ASKED_NOTHING;
    assert_true(MayProceed(&question, ASKED_QUIT, 0));
    assert_true(MayProceed(&question, ASKED_RELOAD, 0));
    assert_int_equal(question, ASKED_NOTHING);
}

static void AskingAgainIsAYes(void** state)
{
    (void)state;
    for (Asked wish = ASKED_RELOAD; wish <= ASKED_QUIT; wish++)
    {
        Asked question = ASKED_NOTHING;
        assert_false(MayProceed(&question, wish, 3));
        assert_int_equal(question, wish);
        assert_true(MayProceed(&question, wish, 3));
        assert_int_equal(question, ASKED_NOTHING);
    }
}

static void AnotherWishIsAnotherQuestion(void** state)
{
    (void)state;
    Asked question = ASKED_NOTHING;
    assert_false(MayProceed(&question, ASKED_RELOAD, 1));
    assert_false(MayProceed(&question, ASKED_QUIT, 1));
    assert_int_equal(question, ASKED_QUIT);
}

static void QuestionsSayHowMuchIsLost(void** state)
{
    (void)state;
    char text[300];
    for (Asked wish = ASKED_RELOAD; wish <= ASKED_QUIT; wish++)
    {
        WriteQuestion(wish, 12, "gale.yaml", text, sizeof(text));
        assert_non_null(strstr(text, "12 changes from gale.yaml"));
        assert_non_null(strstr(text, "loses what you changed"));
    }
    WriteQuestion(ASKED_QUIT, 1, "gale.yaml", text, sizeof(text));
    assert_non_null(strstr(text, "1 change from"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(WithoutChangesNobodyIsAsked),
        cmocka_unit_test(AskingAgainIsAYes),
        cmocka_unit_test(AnotherWishIsAnotherQuestion),
        cmocka_unit_test(QuestionsSayHowMuchIsLost),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
