// SPDX-License-Identifier: MIT

#include "scene/yaml_merge.h"

#include <string.h>

#include "scene/yaml_edit.h"

typedef struct Merge
{
    swYamlEdits edits;
    const swTree *before, *after;
} Merge;

static void mergeValue(Merge* merge, int node, int before, int after, bool isInLine);

static yaml_node_t* getNode(Merge* merge, int node)
{
    return yaml_document_get_node(&merge->edits.places.yaml->document, node);
}

static bool isKey(Merge* merge, int node, const char* key)
{
    const yaml_node_t* at = getNode(merge, node);
    return at->type == YAML_SCALAR_NODE && at->data.scalar.length == strlen(key) &&
           memcmp(at->data.scalar.value, key, strlen(key)) == 0;
}

static int findKey(Merge* merge, const swTree* tree, int mapping, int key)
{
    const yaml_node_t* at = getNode(merge, key);
    return at->type == YAML_SCALAR_NODE
               ? swFindTreeKey(tree, mapping, (const char*)at->data.scalar.value, at->data.scalar.length)
               : -1;
}

static int countItems(const swTree* tree, int list)
{
    int count = 0;
    for (int child = swGetTreeNode(tree, list)->first; child >= 0; child = swGetTreeNode(tree, child)->next)
    {
        ++count;
    }
    return count;
}

// Whether a value is of another kind now, such as [1, 2] that becomes {x: 1}: the new one takes its place.
static bool hasOtherForm(Merge* merge, int node, int before, int after)
{
    swTreeType type = swGetTreeNode(merge->after, after)->type;
    yaml_node_type_t at = getNode(merge, node)->type;
    bool isSame = type == SW_TREE_SCALAR    ? at == YAML_SCALAR_NODE
                  : type == SW_TREE_MAPPING ? at == YAML_MAPPING_NODE
                                            : at == YAML_SEQUENCE_NODE;
    return !isSame && before >= 0 && !swAreTreesEqual(merge->before, before, merge->after, after);
}

// What a collection shall become, for swArrangeYaml().
typedef struct Plan
{
    bool* isKept;
    swYamlAdded* added;
    int count, addedCount;
    size_t size;
} Plan;

static bool beginPlan(Merge* merge, int count, int after, Plan* plan)
{
    int most = countItems(merge->after, after);
    *plan = (Plan){.count = count};
    plan->size = (size_t)most * sizeof(swYamlAdded) + (size_t)count + 1;
    plan->added = swAllocateZero(merge->edits.places.yaml->host, plan->size);
    plan->isKept = plan->added != NULL ? (bool*)(plan->added + most) : NULL;
    if (plan->added == NULL && merge->edits.result == SW_SUCCESS)
    {
        merge->edits.result = swFail(merge->edits.places.yaml->host, SW_ERROR_NO_MEMORY, "No memory to write %s.",
                                     merge->edits.places.yaml->name);
    }
    return plan->added != NULL;
}

static void endPlan(Merge* merge, int node, Plan* plan)
{
    swArrangeYaml(&merge->edits, node, plan->isKept, plan->added, plan->addedCount);
    swFree(merge->edits.places.yaml->host, plan->added, plan->size);
}

// The key that the mapping is about, such as the kind of waves: the new one takes the place of the old one.
static int mergeMain(Merge* merge, int node, int before, int after, Plan* plan)
{
    const yaml_node_t* at = getNode(merge, node);
    int child = swGetTreeNode(merge->after, after)->first, main = -1;
    for (; child >= 0; child = swGetTreeNode(merge->after, child)->next)
    {
        main = swGetTreeNode(merge->after, child)->isMain ? child : main;
    }
    for (int i = 0; main >= 0 && i < plan->count; ++i)
    {
        yaml_node_pair_t pair = at->data.mapping.pairs.start[i];
        if (isKey(merge, pair.key, swGetTreeNode(merge->after, main)->key))
        {
            return -1; // merged as the others are
        }
    }
    for (int i = 0; main >= 0 && i < plan->count; ++i)
    {
        yaml_node_pair_t pair = at->data.mapping.pairs.start[i];
        int old = before >= 0 ? findKey(merge, merge->before, before, pair.key) : -1;
        if (old >= 0 && swGetTreeNode(merge->before, old)->isMain &&
            getNode(merge, pair.value)->type == YAML_SCALAR_NODE &&
            swGetTreeNode(merge->after, main)->type == SW_TREE_SCALAR)
        {
            plan->isKept[i] = true;
            swReplaceYamlPair(&merge->edits, node, i, merge->after, main);
            return main;
        }
    }
    return -1;
}

static void mergeMapping(Merge* merge, int node, int before, int after)
{
    const yaml_node_t* at = getNode(merge, node);
    int count = (int)(at->data.mapping.pairs.top - at->data.mapping.pairs.start);
    Plan plan;
    if (!beginPlan(merge, count, after, &plan))
    {
        return;
    }
    int main = mergeMain(merge, node, before, after, &plan);
    for (int i = 0; i < count; ++i)
    {
        yaml_node_pair_t pair = at->data.mapping.pairs.start[i];
        int wanted = findKey(merge, merge->after, after, pair.key);
        int old = before >= 0 ? findKey(merge, merge->before, before, pair.key) : -1;
        if (wanted < 0 && old < 0 && before >= 0)
        {
            plan.isKept[i] = true; // neither tree knows of it
        }
        if (wanted >= 0 && hasOtherForm(merge, pair.value, old, wanted))
        {
            plan.added[plan.addedCount++] = (swYamlAdded){merge->after, wanted, i};
        }
        else if (wanted >= 0)
        {
            plan.isKept[i] = true;
            mergeValue(merge, pair.value, old, wanted, at->data.mapping.style == YAML_FLOW_MAPPING_STYLE);
        }
    }
    int child = swGetTreeNode(merge->after, after)->first;
    for (; child >= 0; child = swGetTreeNode(merge->after, child)->next)
    {
        bool isThere = child == main || swIsTreeDefault(merge->after, child);
        for (int i = 0; i < count && !isThere; ++i)
        {
            isThere = isKey(merge, at->data.mapping.pairs.start[i].key, swGetTreeNode(merge->after, child)->key);
        }
        if (!isThere)
        {
            plan.added[plan.addedCount++] = (swYamlAdded){merge->after, child, count - 1};
        }
    }
    endPlan(merge, node, &plan);
}

// How far along a list the first item is that says the same; -1 if there is none.
static int findEqual(const swTree* list, int from, const swTree* other, int item)
{
    int distance = 0;
    for (; from >= 0; from = swGetTreeNode(list, from)->next, ++distance)
    {
        if (swAreTreesEqual(list, from, other, item))
        {
            return distance;
        }
    }
    return -1;
}

// Which of the text's items each of the new list's is: those that say the same go together, and what lies between is
// taken in pairs.
static void matchItems(const swTree* before, int old, const swTree* after, int fresh, int* items)
{
    for (int item = 0, at = 0; fresh >= 0;)
    {
        int added = old >= 0 ? findEqual(after, fresh, before, old) : 1;
        int removed = old >= 0 ? findEqual(before, old, after, fresh) : -1;
        if (removed > 0 && (added < 0 || removed <= added))
        {
            old = swGetTreeNode(before, old)->next;
            item += 1;
            continue;
        }
        bool isNew = added > 0;
        items[at++] = isNew ? -1 : item;
        fresh = swGetTreeNode(after, fresh)->next;
        old = isNew ? old : swGetTreeNode(before, old)->next;
        item += isNew ? 0 : 1;
    }
}

// The items of the new list, by what they are or by what they say. NULL if there is no memory.
static int* listItems(Merge* merge, int before, int after, int count)
{
    int* items = swAllocate(merge->edits.places.yaml->host, (size_t)(count + 1) * sizeof(int));
    const swTreeNode* list = swGetTreeNode(merge->after, after);
    if (items == NULL)
    {
        merge->edits.result = swFail(merge->edits.places.yaml->host, SW_ERROR_NO_MEMORY, "No memory to write %s.",
                                     merge->edits.places.yaml->name);
        return NULL;
    }
    if (list->isMatched && before >= 0)
    {
        matchItems(merge->before, swGetTreeNode(merge->before, before)->first, merge->after, list->first, items);
        return items;
    }
    int child = list->first;
    for (int i = 0; child >= 0; ++i, child = swGetTreeNode(merge->after, child)->next)
    {
        items[i] = swGetTreeNode(merge->after, child)->item;
    }
    return items;
}

// The old list's item with this number.
static int findItem(const swTree* tree, int list, int item)
{
    bool isMatched = list >= 0 && swGetTreeNode(tree, list)->isMatched;
    int child = list >= 0 ? swGetTreeNode(tree, list)->first : -1;
    for (int i = 0; child >= 0 && (isMatched ? i : swGetTreeNode(tree, child)->item) != item; ++i)
    {
        child = swGetTreeNode(tree, child)->next;
    }
    return child;
}

static void mergeList(Merge* merge, int node, int before, int after)
{
    const yaml_node_t* at = getNode(merge, node);
    int count = (int)(at->data.sequence.items.top - at->data.sequence.items.start), last = -1;
    int wanted = countItems(merge->after, after);
    Plan plan;
    int* items = listItems(merge, before, after, wanted);
    if (items == NULL || !beginPlan(merge, count, after, &plan))
    {
        swFree(merge->edits.places.yaml->host, items, (size_t)(wanted + 1) * sizeof(int));
        return;
    }
    int child = swGetTreeNode(merge->after, after)->first;
    for (int i = 0; child >= 0; ++i, child = swGetTreeNode(merge->after, child)->next)
    {
        int item = items[i];
        if (item < 0)
        {
            plan.added[plan.addedCount++] = (swYamlAdded){merge->after, child, last};
        }
        else if (item <= last || item >= count)
        {
            swRefuseYamlEdit(&merge->edits, at, "its items were put into another order");
        }
        else if (hasOtherForm(merge, at->data.sequence.items.start[item], findItem(merge->before, before, item), child))
        {
            last = item;
            plan.added[plan.addedCount++] = (swYamlAdded){merge->after, child, last};
        }
        else
        {
            last = item;
            plan.isKept[item] = true;
            mergeValue(merge, at->data.sequence.items.start[item], findItem(merge->before, before, item), child,
                       at->data.sequence.style == YAML_FLOW_SEQUENCE_STYLE);
        }
    }
    endPlan(merge, node, &plan);
    swFree(merge->edits.places.yaml->host, items, (size_t)(wanted + 1) * sizeof(int));
}

static void mergeValue(Merge* merge, int node, int before, int after, bool isInLine)
{
    const yaml_node_t* at = getNode(merge, node);
    swTreeType type = swGetTreeNode(merge->after, after)->type;
    if (before >= 0 && swAreTreesEqual(merge->before, before, merge->after, after))
    {
        return;
    }
    if (type == SW_TREE_SCALAR && at->type == YAML_SCALAR_NODE)
    {
        swReplaceYamlScalar(&merge->edits, node, swGetTreeText(merge->after, after), isInLine);
    }
    else if (type == SW_TREE_MAPPING && at->type == YAML_MAPPING_NODE)
    {
        mergeMapping(merge, node, before, after);
    }
    else if (type == SW_TREE_LIST && at->type == YAML_SEQUENCE_NODE)
    {
        mergeList(merge, node, before, after);
    }
    else
    {
        swRefuseYamlEdit(&merge->edits, at, "it holds something else than is to be written");
    }
}

swResult swMergeYaml(const swHost* host, const char* text, size_t size, const char* name, const swTree* before,
                     const swTree* after, char** newText, size_t* newSize)
{
    swYaml yaml;
    yaml_node_t* root = NULL;
    if (before->isBroken || after->isBroken)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory to write %s.", name);
    }
    if (size >= 2 && (memcmp(text, "\xFF\xFE", 2) == 0 || memcmp(text, "\xFE\xFF", 2) == 0))
    {
        return swFail(host, SW_ERROR_FORMAT, "%s:1: the text is UTF-16 and cannot be written; save it as UTF-8.", name);
    }
    swResult result = swOpenYaml(host, text, size, name, &yaml, &root);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    Merge merge = {.before = before, .after = after};
    result = swBeginYamlEdits(&yaml, text, size, &merge.edits);
    if (result == SW_SUCCESS && root != NULL)
    {
        mergeValue(&merge, 1, 0, 0, false); // libyaml counts nodes from 1, and the root is the first
    }
    else if (result == SW_SUCCESS)
    {
        swFillYaml(&merge.edits, after, 0);
    }
    result = result == SW_SUCCESS ? swMakeYamlEdits(&merge.edits, newText, newSize) : result;
    swEndYamlEdits(&merge.edits);
    swCloseYaml(&yaml);
    return result;
}
