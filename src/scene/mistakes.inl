// SPDX-License-Identifier: MIT
// Kinds of mistakes in a scene file, for which it is refused: SW_MISTAKE(NAME, code, what it is, what helps). A message
// ends with its code in brackets, which stays the same when its words change. scripts/make_check_docs writes
// docs/checks.md from this list.
SW_MISTAKE(SYNTAX, "not_yaml", "the text is not YAML, or a second document; nothing after it is read",
           "look at indentation, colons and quotes")
SW_MISTAKE(TOO_LARGE, "too_large",
           "more bytes, values, items or nesting than a scene has; at most 64 mistakes are told",
           "remove what is no scene")
SW_MISTAKE(WRONG_FORM, "wrong_form", "a value of another kind: a word where a number belongs, no list, no time",
           "write it as the message says")
SW_MISTAKE(UNKNOWN_KEY, "unknown_key", "a key that nobody reads", "choose one of those that the message lists")
SW_MISTAKE(MISSING_KEY, "missing_key", "a key without which the others mean nothing", "add it")
SW_MISTAKE(REPEATED, "repeated", "a key, a name or an octave that stands twice", "remove or rename one")
SW_MISTAKE(OUT_OF_RANGE, "out_of_range", "a number outside its range, or not of the form that it needs",
           "stay within the range that the message gives")
SW_MISTAKE(UNKNOWN_WORD, "unknown_word",
           "none of the words that are known here, or no name of the scene or place of the file",
           "choose one of those that the message lists")
SW_MISTAKE(NO_EFFECT, "no_effect", "a key that would do nothing beside the others", "remove it")
SW_MISTAKE(CONFLICT, "conflict", "keys of which only one can be", "remove all but one")
SW_MISTAKE(NO_ENERGY, "no_energy", "waves without energy, of a spectrum that needs some",
           "give them a height, a wind, or an octave")
SW_MISTAKE(BAD_FILE, "bad_file", "a file that cannot be read; its own message stands before", "see that message")
SW_MISTAKE(REFUSED, "refused",
           "waves, a body of water or an input that a world cannot make; its own message stands before",
           "see that message")
SW_MISTAKE(NO_RECORD, "no_record", "a file of measured seas that has no such record",
           "choose a time or a place that it has")
