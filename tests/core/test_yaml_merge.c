// SPDX-License-Identifier: MIT
// A YAML text is changed where its values change, and nowhere else.

#include "support/cmocka_setup.h"
#include "support/counting_host.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/yaml_merge.h"
#include "scene/yaml_read.h"

// ---- trees from texts ----

static void AddNode(swTree* tree, yaml_document_t* document, const yaml_node_t* node, int at);

static const char* Keep(const yaml_node_t* node)
{
    static char names[4096][24]; // keys outlive their trees
    static int count;
    snprintf(names[count], sizeof(names[0]), "%s", (const char*)node->data.scalar.value);
    return names[count++];
}

static int AddChild(swTree* tree, yaml_document_t* document, int parent, const char* key, const yaml_node_t* node)
{
    if (node->type == YAML_SCALAR_NODE)
    {
        int child = swAddTreeText(tree, parent, key, (const char*)node->data.scalar.value, false);
        swTreeNode* added = (swTreeNode*)tree->nodes.data + child;
        added->isMain = key != NULL && (strcmp(key, "spectrum") == 0 || strcmp(key, "beaufort") == 0);
        return child;
    }
    int child = swAddTreeNode(tree, parent, node->type == YAML_MAPPING_NODE ? SW_TREE_MAPPING : SW_TREE_LIST, key);
    ((swTreeNode*)tree->nodes.data)[child].isLine = key != NULL && strncmp(key, "line", 4) == 0;
    AddNode(tree, document, node, child);
    return child;
}

// Items are those of the text in order, or the ones that a pair "item: N" names; -1 is a new one.
static void AddNode(swTree* tree, yaml_document_t* document, const yaml_node_t* node, int at)
{
    if (node->type == YAML_SEQUENCE_NODE)
    {
        int count = (int)(node->data.sequence.items.top - node->data.sequence.items.start);
        for (int i = 0; i < count; ++i)
        {
            const yaml_node_t* item = yaml_document_get_node(document, node->data.sequence.items.start[i]);
            int child = AddChild(tree, document, at, NULL, item), named = i;
            for (yaml_node_pair_t* pair = item->data.mapping.pairs.start;
                 item->type == YAML_MAPPING_NODE && pair < item->data.mapping.pairs.top; ++pair)
            {
                const char* key = (const char*)yaml_document_get_node(document, pair->key)->data.scalar.value;
                const char* value = (const char*)yaml_document_get_node(document, pair->value)->data.scalar.value;
                named = strcmp(key, "item") == 0 ? atoi(value) : named;
            }
            ((swTreeNode*)tree->nodes.data)[child].item = named;
        }
        return;
    }
    for (yaml_node_pair_t* pair = node->data.mapping.pairs.start; pair < node->data.mapping.pairs.top; ++pair)
    {
        const char* key = Keep(yaml_document_get_node(document, pair->key));
        if (strcmp(key, "item") != 0)
        {
            AddChild(tree, document, at, key, yaml_document_get_node(document, pair->value));
        }
    }
}

static swTree ReadTree(const swHost* host, const char* text)
{
    swTree tree = swBeginTree(host, SW_TREE_MAPPING);
    swYaml yaml;
    yaml_node_t* root = NULL;
    assert_int_equal(swOpenYaml(host, text, strlen(text), "tree", &yaml, &root), SW_SUCCESS);
    if (root != NULL)
    {
        AddNode(&tree, &yaml.document, root, 0);
    }
    swCloseYaml(&yaml);
    return tree;
}

// ---- changes ----

typedef struct Case
{
    const char *text, *wanted;
    const char* made; // NULL: it is refused
} Case;

static void CheckCase(const Case* one)
{
    CountingMemory counting;
    swHost host = MakeCountingHost(&counting);
    swTree before = ReadTree(&host, one->text), after = ReadTree(&host, one->wanted);
    char* made = NULL;
    size_t size = 0;
    swResult result = swMergeYaml(&host, one->text, strlen(one->text), "a.yaml", &before, &after, &made, &size);
    if (one->made == NULL)
    {
        if (result != SW_ERROR_FORMAT)
        {
            print_message("from:\n%s\nmade:\n%s\n", one->text, made != NULL ? made : "");
        }
        assert_int_equal(result, SW_ERROR_FORMAT);
    }
    else
    {
        assert_int_equal(result, SW_SUCCESS);
        if (strcmp(made, one->made) != 0)
        {
            print_message("from:\n%s\nmade:\n%s\nwanted:\n%s\n", one->text, made, one->made);
        }
        assert_string_equal(made, one->made);
        assert_int_equal(size, strlen(one->made));
        swTree again = ReadTree(&host, made);
        assert_true(swAreTreesEqual(&again, 0, &after, 0));
        swFreeTree(&again);
        swFree(&host, made, size + 1);
    }
    swFreeTree(&before);
    swFreeTree(&after);
    assert_int_equal(atomic_load(&counting.bytes), 0);
}

static void CheckCases(const Case* cases, size_t count)
{
    for (size_t i = 0; i < count; ++i)
    {
        CheckCase(&cases[i]);
    }
}

#define CHECK(cases) CheckCases(cases, sizeof(cases) / sizeof((cases)[0]))

static void OneValueChangesItsBytes(void** state)
{
    (void)state;
    static const Case cases[] = {
        {"a: 1\nb: 2 # two\n", "{a: 1, b: 3}", "a: 1\nb: 3 # two\n"},
        {"a:   1   # one\r\nb: 2\r\n", "{a: 3, b: 2}", "a:   3   # one\r\nb: 2\r\n"},
        {"\xEF\xBB\xBF# \xC3\xA9t\xC3\xA9\na: \"\xC3\xA9\" # \xC3\xA9\nb: 'x'", "{a: \"y\", b: \"it's\"}",
         "\xEF\xBB\xBF# \xC3\xA9t\xC3\xA9\na: \"y\" # \xC3\xA9\nb: 'it''s'"},
        {"---\n{a: 1, b: [1, 2 , 3]} # c\n...\n", "{a: 2, b: [1, 5, 3]}", "---\n{a: 2, b: [1, 5 , 3]} # c\n...\n"},
        {"a:\n  - 1\n  # two\n  - 2\n", "{a: [1, 4]}", "a:\n  - 1\n  # two\n  - 4\n"},
        {"a: &x !!str 1 # c\n", "{a: 2}", "a: &x !!str 2 # c\n"},
        {"a: |\n  one\n  two\n\n# c\nb: 1\n", "{a: three, b: 1}", "a: three\n\n# c\nb: 1\n"},
        {"a: >-\n  one\n  two", "{a: 'x: y'}", "a: \"x: y\""},
        {"a: one\n  two # c\nb: 1", "{a: three, b: 1}", "a: three # c\nb: 1"},
        {"a:\n    1\n", "{a: 2}", "a:\n    2\n"},
        {"? a\n: 1\n", "{a: 2}", "? a\n: 2\n"},
        {"\"a\": 1\r", "{a: \"x\\ty\\u2028\\\"\"}", "\"a\": \"x\\u0009y\\u2028\\\"\"\r"},
        {"a: [b, c]\n", "{a: [b, \"c, d\"]}", "a: [b, \"c, d\"]\n"},
        {"a: 'q'\n", "{a: \"q\\nr\"}", "a: \"q\\u000Ar\"\n"},
    };
    CHECK(cases);
}

static void NewPairsComeBehindTheOthers(void** state)
{
    (void)state;
    static const Case cases[] = {
        {"", "{a: 1, s: {b: 2, c: [1, 2]}}", "a: 1\n\ns:\n  b: 2\n  c:\n    - 1\n    - 2\n"},
        {"# nothing\n", "{a: 1}", "# nothing\na: 1\n"},
        {"# nothing", "{a: 1}", "# nothing\na: 1\n"},
        {"a: 1 # one\n# end\n", "{a: 1, b: 2}", "a: 1 # one\nb: 2\n# end\n"},
        {"a: 1", "{a: 1, b: 2, c: 3}", "a: 1\nb: 2\nc: 3"},
        {"a: 1\r\n", "{a: 1, b: 2}", "a: 1\r\nb: 2\r\n"},
        {"a: 1\n...\n", "{a: 1, b: 2}", "a: 1\nb: 2\n...\n"},
        {"n: x\n\ns:\n    a: 1\n\nt:\n    a: 1 # c\n", "{n: x, s: {a: 1, b: 2}, t: {a: 1}, u: {d: 4}}",
         "n: x\n\ns:\n    a: 1\n    b: 2\n\nt:\n    a: 1 # c\n\nu:\n    d: 4\n"},
        {"s: {a: 1 , }\n", "{s: {a: 1, b: 2}}", "s: {a: 1, b: 2 , }\n"},
        {"s: {}\n", "{s: {a: 1, b: 2}}", "s: {a: 1, b: 2}\n"},
        {"s: {\n  a: 1 # one\n}\n", "{s: {a: 1, b: 2}}", "s: {\n  a: 1, b: 2 # one\n}\n"},
        {"s:\n  t:\n    a: 1", "{s: {t: {a: 1, b: 2}, c: 3}, d: 4}", "s:\n  t:\n    a: 1\n    b: 2\n  c: 3\nd: 4"},
        {"a: |+\n  x\n\n", "{a: \"x\\n\\n\", b: 1}", NULL},
    };
    // The last one would be read as another text, which the scene's writer finds by reading it: here it is written.
    CheckCases(cases, sizeof(cases) / sizeof(cases[0]) - 1);
}

static void PairsAreTakenAwayWithTheirLine(void** state)
{
    (void)state;
    static const Case cases[] = {
        {"a: 1\nb: 2 # two\n# about c\nc: 3\n", "{a: 1, c: 3}", "a: 1\n# about c\nc: 3\n"},
        {"a: 1\nb:\n  - 1\n  - 2 # two\nc: 3", "{a: 1, c: 3}", "a: 1\nc: 3"},
        {"a: 1\nb: 2", "{a: 1}", "a: 1\n"},
        {"a: 1\nb: 2\n", "{a: 1, c: 3}", "a: 1\nc: 3\n"},
        {"s: {a: 1, b: 2, c: 3}\n", "{s: {b: 2}}", "s: {b: 2}\n"},
        {"s: {a: 1, b: 2, c: 3}\n", "{s: {a: 1, d: 4}}", "s: {a: 1, d: 4}\n"},
        {"s: {a: 1, b: 2}\n", "{s: {c: 3, d: 4}}", "s: {c: 3, d: 4}\n"},
        {"l:\n  - a: 1\n    b: 2\n", "{l: [{b: 2}]}", "l:\n  - b: 2\n"},
        {"l:\n  - a: 1 # one\n    # about b\n    b: 2\n", "{l: [{b: 2}]}", "l:\n  -  # one\n    # about b\n    b: 2\n"},
        {"l:\n  - a: 1 # one\n", "{l: [{b: 2, c: 3}]}", "l:\n  - b: 2 # one\n    c: 3\n"},
        {"l:\n  - a: 1\n    b:\n      - 1\n    c: 2 # two\n    d: 3\n", "{l: [{d: 3}]}", "l:\n  - d: 3\n"},
        {"l:\n  - a: 1\n", "{l: [{}]}", NULL},
    };
    CHECK(cases);
}

static void TheMainPairGivesItsPlace(void** state)
{
    (void)state;
    static const Case cases[] = {
        {"l:\n  - beaufort: 4 # breeze\n    d: 3\n", "{l: [{spectrum: jonswap, w: 7, d: 3}]}",
         "l:\n  - spectrum: jonswap # breeze\n    d: 3\n    w: 7\n"},
        {"l:\n  - {d: 3, beaufort: 4}\n", "{l: [{spectrum: jonswap, w: 7}]}", "l:\n  - {spectrum: jonswap, w: 7}\n"},
    };
    CHECK(cases);
}

static void ItemsComeAndGo(void** state)
{
    (void)state;
    static const Case cases[] = {
        {"l:\n  - a: 1\n    b: 2 # two\n  # between\n  - a: 2\n\nm: 1\n", "{l: [{item: 0, a: 1, b: 2}], m: 1}",
         "l:\n  - a: 1\n    b: 2 # two\n  # between\n\nm: 1\n"},
        {"l:\n- a: 1\n- a: 2\n", "{l: [{item: 1, a: 2}, {item: -1, a: 3, line: [1, 2]}]}",
         "l:\n- a: 2\n- a: 3\n  line: [1, 2]\n"},
        {"l:\n  - a: 1\n  -\n    # deep\n    a: 2\n", "{l: [{item: 0, a: 1}]}", "l:\n  - a: 1\n"},
        {"l:\n  - a: 1\n", "{l: [{item: -1, a: 0}, {item: 0, a: 1}]}", "l:\n  - a: 0\n  - a: 1\n"},
        {"l: # colon: here\n  - a: 1 # x\n", "{l: []}", "l: [] # colon: here\n"},
        {"l:\n  - a: 1\n", "{l: [{item: -1, a: 2}]}", "l:\n  - a: 2\n"},
        {"l: [ ] # none\nm: 1\n", "{l: [{item: -1, a: 2}, {item: -1, a: 3}], m: 1}",
         "l: # none\n  - a: 2\n  - a: 3\nm: 1\n"},
        {"s: {l: []}\n", "{s: {l: [{item: -1, a: 2}]}}", "s: {l: [{a: 2}]}\n"},
        {"l: []", "{l: [{item: -1, a: 2}]}", "l:\n  - a: 2"},
        {"l: [{a: 1}, {a: 2}, {a: 3}]\n", "{l: [{item: 1, a: 2}, {item: -1, a: 4}]}", "l: [{a: 2}, {a: 4}]\n"},
        {"l: [{a: 1}, {a: 2}]\n", "{l: [{item: -1, a: 0}, {item: 0, a: 1}, {item: -1, a: 5}, {item: 1, a: 2}]}",
         "l: [{a: 0}, {a: 1}, {a: 5}, {a: 2}]\n"},
        {"l: [{a: 1}, {a: 2}]\n", "{l: [{item: -1, a: 0}, {item: -1, a: 1}]}", "l: [{a: 0}, {a: 1}]\n"},
        {"l:\n  - a: 1\n  - a: 2", "{l: [{item: 0, a: 1, b: 3}, {item: 1, a: 2, b: 4}, {item: -1, a: 9}], m: 3}",
         "l:\n  - a: 1\n    b: 3\n  - a: 2\n    b: 4\n  - a: 9\nm: 3"},
        {"l:\n  - a: 1\n  - a: 2\n", "{l: [{item: 1, a: 2}, {item: 0, a: 1}]}", NULL},
    };
    CHECK(cases);
}

static void WhatIsSharedIsRefused(void** state)
{
    (void)state;
    static const Case cases[] = {
        {"a: &x 1\nb: *x\nc: 3\n", "{a: 2, b: 1, c: 3}", NULL},
        {"a: &x 1\nb: *x\nc: 3\n", "{a: 1, b: 2, c: 3}", NULL},
        {"a: &x 1\nb: *x\nc: 3\n", "{a: 1, b: 1, c: 4}", "a: &x 1\nb: *x\nc: 4\n"},
        {"l:\n  - &x {a: 1}\n  - *x\n", "{l: [{item: 0, a: 1}]}", NULL},
        {"l:\n  - &x {a: 1}\n  - *x\n", "{l: [{item: 0, a: 1}, {item: 1, a: 2}]}", NULL},
        {"l:\n  - &x {a: 1}\n  - {a: 1}\n", "{l: [{item: 1, a: 1}]}", "l:\n  - {a: 1}\n"},
    };
    CHECK(cases);
}

static void EveryAllocationMayFail(void** state)
{
    (void)state;
    static const char text[] = "a: 1\nl:\n  - a: 1\n  - a: 2\n";
    CountingMemory counting;
    swHost host = MakeCountingHost(&counting);
    swTree before = ReadTree(&host, text),
           after = ReadTree(&host, "{a: 2, l: [{item: 1, a: 3}, {item: -1, a: 4}], m: 1}");
    long long held = atomic_load(&counting.bytes);
    swResult result = SW_ERROR_NO_MEMORY;
    for (int fail = 0; result != SW_SUCCESS && fail < 100; ++fail)
    {
        char* made = NULL;
        size_t size = 0;
        atomic_store(&counting.failAt, atomic_load(&counting.allocations) + fail);
        result = swMergeYaml(&host, text, strlen(text), "a.yaml", &before, &after, &made, &size);
        atomic_store(&counting.failAt, -1);
        assert_true(result == SW_SUCCESS || result == SW_ERROR_NO_MEMORY);
        swFree(&host, made, made != NULL ? size + 1 : 0);
        assert_int_equal(atomic_load(&counting.bytes), held);
    }
    assert_int_equal(result, SW_SUCCESS);
    swFreeTree(&before);
    swFreeTree(&after);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(OneValueChangesItsBytes),
        cmocka_unit_test(NewPairsComeBehindTheOthers),
        cmocka_unit_test(PairsAreTakenAwayWithTheirLine),
        cmocka_unit_test(TheMainPairGivesItsPlace),
        cmocka_unit_test(ItemsComeAndGo),
        cmocka_unit_test(WhatIsSharedIsRefused),
        cmocka_unit_test(EveryAllocationMayFail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
