// SPDX-License-Identifier: MIT
// Kinds of mistakes in a scene file: SW_MISTAKE(NAME, code). A message ends with its code in brackets, which stays the
// same when its words change. docs/scenes.md says what each means.
SW_MISTAKE(SYNTAX, "not_yaml")
SW_MISTAKE(TOO_LARGE, "too_large")
SW_MISTAKE(WRONG_FORM, "wrong_form")
SW_MISTAKE(UNKNOWN_KEY, "unknown_key")
SW_MISTAKE(MISSING_KEY, "missing_key")
SW_MISTAKE(REPEATED, "repeated")
SW_MISTAKE(OUT_OF_RANGE, "out_of_range")
SW_MISTAKE(UNKNOWN_WORD, "unknown_word")
SW_MISTAKE(NO_EFFECT, "no_effect")
SW_MISTAKE(CONFLICT, "conflict")
SW_MISTAKE(NO_ENERGY, "no_energy")
SW_MISTAKE(BAD_FILE, "bad_file")
SW_MISTAKE(NO_RECORD, "no_record")
