// SPDX-License-Identifier: MIT
// Over libyaml's documents, which keep the line of every node. (libcyaml reads structs by tables too, but version 1.3.1
// names the line before an unknown key, follows the locale in numbers, and takes undecodable bytes for an empty file.)

#include "scene/yaml_read.h"

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "core/base/number.h"
#include "files/file_text.h"
#include "seaway/math.h"

static const char* const mistakeCodes[] = {
#define SW_MISTAKE(name, code) code,
#include "scene/mistakes.inl"
#undef SW_MISTAKE
};

swResult swFailYaml(swYaml* yaml, const yaml_node_t* node, swMistake mistake, const char* format, ...)
{
    char text[SW_MAX_PATH + 512];
    int line = (int)node->start_mark.line + 1;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof(text), format, arguments);
    va_end(arguments);
    yaml->mistakeCount += 1;
    if (yaml->mistakeCount < SW_YAML_MAX_MISTAKES)
    {
        swFail(yaml->host, SW_ERROR_FORMAT, "%s:%d: %s [%s]", yaml->name, line, text, mistakeCodes[mistake]);
    }
    else if (yaml->mistakeCount == SW_YAML_MAX_MISTAKES)
    {
        swFail(yaml->host, SW_ERROR_FORMAT,
               "%s:%d: here is mistake %d, and more are not looked for; mend those above. [%s]", yaml->name, line,
               yaml->mistakeCount, mistakeCodes[SW_MISTAKE_TOO_LARGE]);
    }
    return SW_ERROR_FORMAT;
}

swResult swKeepFailure(swResult first, swResult next)
{
    return first == SW_SUCCESS || next == SW_ERROR_NO_MEMORY ? next : first;
}

bool swIsYamlOver(const swYaml* yaml, swResult result)
{
    return result == SW_ERROR_NO_MEMORY || yaml->mistakeCount >= SW_YAML_MAX_MISTAKES;
}

// ---- documents ----

// libyaml gives an offset for bytes that are no text and a line for everything else.
static swResult failSyntax(const swHost* host, const yaml_parser_t* parser, const char* text, size_t size,
                           const char* name)
{
    if (parser->error == YAML_MEMORY_ERROR)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory to read %s.", name);
    }
    size_t line = parser->problem_mark.line + 1;
    if (parser->error == YAML_READER_ERROR)
    {
        line = 1;
        for (size_t i = 0; i < size && i < parser->problem_offset; ++i)
        {
            line += text[i] == '\n' ? 1 : 0;
        }
    }
    return swFail(host, SW_ERROR_FORMAT, "%s:%d: this is not YAML: %s; check indentation, colons and quotes. [%s]",
                  name, (int)line, parser->problem != NULL ? parser->problem : "unknown problem",
                  mistakeCodes[SW_MISTAKE_SYNTAX]);
}

// What a text holds so far.
typedef struct Shape
{
    int depth, nodeCount, anchorCount;
} Shape;

static void addEvent(Shape* shape, const yaml_event_t* event)
{
    bool begins = event->type == YAML_SEQUENCE_START_EVENT || event->type == YAML_MAPPING_START_EVENT;
    bool ends = event->type == YAML_SEQUENCE_END_EVENT || event->type == YAML_MAPPING_END_EVENT;
    bool isScalar = event->type == YAML_SCALAR_EVENT;
    const yaml_char_t* anchor = event->type == YAML_SEQUENCE_START_EVENT  ? event->data.sequence_start.anchor
                                : event->type == YAML_MAPPING_START_EVENT ? event->data.mapping_start.anchor
                                : isScalar                                ? event->data.scalar.anchor
                                                                          : NULL;
    shape->depth += begins ? 1 : ends ? -1 : 0;
    shape->nodeCount += begins || isScalar || event->type == YAML_ALIAS_EVENT;
    shape->anchorCount += anchor != NULL;
}

static swResult failSize(const swHost* host, const char* name, int line, const char* what, int most, const char* of)
{
    return swFail(host, SW_ERROR_FORMAT, "%s:%d: %s %d %s; remove what is no scene. [%s]", name, line, what, most, of,
                  mistakeCodes[SW_MISTAKE_TOO_LARGE]);
}

static swResult checkSizes(const swHost* host, const char* name, int line, const Shape* shape)
{
    if (shape->depth > SW_YAML_MAX_DEPTH)
    {
        return failSize(host, name, line, "lists and mappings are nested more than", SW_YAML_MAX_DEPTH, "deep");
    }
    if (shape->nodeCount > SW_YAML_MAX_NODES)
    {
        return failSize(host, name, line, "there are more than", SW_YAML_MAX_NODES, "values");
    }
    return shape->anchorCount > SW_YAML_MAX_ANCHORS
               ? failSize(host, name, line, "there are more than", SW_YAML_MAX_ANCHORS, "anchors (&)")
               : SW_SUCCESS;
}

// Lines that begin with %, before the parser sees any.
static swResult checkDirectives(const swHost* host, const char* text, size_t size, const char* name)
{
    int line = 1, count = 0;
    for (size_t i = 0; i < size; ++i)
    {
        count += text[i] == '%' && (i == 0 || text[i - 1] == '\n');
        if (count > SW_YAML_MAX_ANCHORS)
        {
            return failSize(host, name, line, "there are more than", SW_YAML_MAX_ANCHORS, "directives (%)");
        }
        line += text[i] == '\n';
    }
    return SW_SUCCESS;
}

// Go through the events of a text without keeping them, so that what is too deep or too large is never built.
static swResult checkShape(const swHost* host, yaml_parser_t* parser, const char* text, size_t size, const char* name)
{
    Shape shape = {0};
    swResult result = checkDirectives(host, text, size, name);
    for (bool isOver = false; !isOver && result == SW_SUCCESS;)
    {
        yaml_event_t event;
        if (yaml_parser_parse(parser, &event) == 0)
        {
            return failSyntax(host, parser, text, size, name);
        }
        addEvent(&shape, &event);
        result = checkSizes(host, name, (int)event.start_mark.line + 1, &shape);
        isOver = event.type == YAML_STREAM_END_EVENT;
        yaml_event_delete(&event);
    }
    return result;
}

// A second document would be ignored without a word.
static swResult checkEnd(yaml_parser_t* parser, const char* text, size_t size, swYaml* yaml)
{
    yaml_document_t second;
    if (yaml_parser_load(parser, &second) == 0)
    {
        return failSyntax(yaml->host, parser, text, size, yaml->name);
    }
    const yaml_node_t* root = yaml_document_get_root_node(&second);
    swResult result = SW_SUCCESS;
    if (root != NULL)
    {
        result = swFailYaml(yaml, root, SW_MISTAKE_SYNTAX,
                            "a second document begins; a scene file has one, so remove the line '---'.");
    }
    yaml_document_delete(&second);
    return result;
}

static swResult loadDocument(swYaml* yaml, yaml_parser_t* parser, const char* text, size_t size, yaml_node_t** root)
{
    if (yaml_parser_load(parser, &yaml->document) == 0)
    {
        return failSyntax(yaml->host, parser, text, size, yaml->name);
    }
    *root = yaml_document_get_root_node(&yaml->document);
    swResult result = checkEnd(parser, text, size, yaml);
    if (result != SW_SUCCESS)
    {
        yaml_document_delete(&yaml->document);
    }
    return result;
}

swResult swOpenYaml(const swHost* host, const char* text, size_t size, const char* name, swYaml* yaml,
                    yaml_node_t** root)
{
    *yaml = (swYaml){.host = host, .name = name};
    *root = NULL;
    swResult result = SW_SUCCESS;
    for (int pass = 0; pass < 2 && result == SW_SUCCESS; ++pass)
    {
        yaml_parser_t parser;
        if (yaml_parser_initialize(&parser) == 0)
        {
            return swFail(host, SW_ERROR_NO_MEMORY, "No memory to read %s.", name);
        }
        yaml_parser_set_input_string(&parser, (const unsigned char*)text, size);
        result =
            pass == 0 ? checkShape(host, &parser, text, size, name) : loadDocument(yaml, &parser, text, size, root);
        yaml_parser_delete(&parser);
    }
    return result;
}

void swCloseYaml(swYaml* yaml)
{
    yaml_document_delete(&yaml->document);
}

// ---- values ----

static const char* getScalar(const yaml_node_t* node, int* size)
{
    if (node->type != YAML_SCALAR_NODE)
    {
        return NULL;
    }
    *size = (int)node->data.scalar.length;
    return (const char*)node->data.scalar.value;
}

static swResult readNumber(swYaml* yaml, yaml_node_t* node, const swYamlField* field, double* value)
{
    int size = 0;
    const char* text = getScalar(node, &size);
    if (text == NULL || !swParseNumber(text, size, value))
    {
        return swFailYaml(yaml, node, SW_MISTAKE_WRONG_FORM, "%s is '%.*s'; it must be a number from %g to %g.",
                          field->key, text != NULL && size < 60 ? size : 0, text != NULL ? text : "", field->low,
                          field->high);
    }
    if (!(*value >= field->low && *value <= field->high))
    {
        return swFailYaml(yaml, node, SW_MISTAKE_OUT_OF_RANGE, "%s is %g; its range is %g to %g.", field->key, *value,
                          field->low, field->high);
    }
    return SW_SUCCESS;
}

static swResult readInteger(swYaml* yaml, yaml_node_t* node, const swYamlField* field, double* value)
{
    swResult result = readNumber(yaml, node, field, value);
    if (result == SW_SUCCESS && *value != floor(*value))
    {
        result =
            swFailYaml(yaml, node, SW_MISTAKE_OUT_OF_RANGE, "%s is %g; it must be a whole number.", field->key, *value);
    }
    return result;
}

static swResult readTriple(swYaml* yaml, yaml_node_t* node, const swYamlField* field, double values[3])
{
    int count = 0;
    swResult result = swReadYamlList(yaml, node, field->key, 3, &count);
    if (result == SW_SUCCESS && count != 3)
    {
        result = swFailYaml(yaml, node, SW_MISTAKE_WRONG_FORM,
                            "%s has %d numbers; it must have three, as in [0, 2, 0].", field->key, count);
    }
    for (int i = 0; i < count && i < 3; ++i)
    {
        result = swKeepFailure(result, readNumber(yaml, swGetYamlItem(yaml, node, i), field, &values[i]));
    }
    return result;
}

swResult swReadYamlText(swYaml* yaml, yaml_node_t* node, const swYamlField* field, char* target)
{
    int size = 0;
    const char* text = getScalar(node, &size);
    if (text == NULL || size == 0)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_WRONG_FORM, "%s must be a text.", field->key);
    }
    if ((size_t)size >= field->size)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_TOO_LARGE, "%s has %d bytes; at most %zu are kept.", field->key, size,
                          field->size - 1);
    }
    if (memchr(text, '\0', (size_t)size) != NULL)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_WRONG_FORM, "%s holds a zero byte; remove it.", field->key);
    }
    memset(target, 0, field->size);
    memcpy(target, text, (size_t)size);
    return SW_SUCCESS;
}

static bool isWord(const char* text, int size, const char* word)
{
    return (size_t)size == strlen(word) && memcmp(text, word, (size_t)size) == 0;
}

static swResult readBool(swYaml* yaml, yaml_node_t* node, const swYamlField* field, bool* target)
{
    int size = 0;
    const char* text = getScalar(node, &size);
    if (text != NULL && (isWord(text, size, "true") || isWord(text, size, "false")))
    {
        *target = text[0] == 't';
        return SW_SUCCESS;
    }
    return swFailYaml(yaml, node, SW_MISTAKE_WRONG_FORM, "%s must be true or false.", field->key);
}

// "a, b, c" for messages, cut off where the room ends.
static void listWord(char* list, size_t size, const char* word)
{
    size_t used = strlen(list);
    snprintf(list + used, size - used, "%s%s", used > 0 ? ", " : "", word);
}

static swResult readChoice(swYaml* yaml, yaml_node_t* node, const swYamlField* field, int* target)
{
    int size = 0;
    const char* text = getScalar(node, &size);
    char known[700] = "";
    for (int i = 0; field->words[i] != NULL; ++i)
    {
        if (text != NULL && isWord(text, size, field->words[i]))
        {
            *target = i;
            return SW_SUCCESS;
        }
        listWord(known, sizeof(known), field->words[i]);
    }
    return swFailYaml(yaml, node, SW_MISTAKE_UNKNOWN_WORD, "%s is '%.*s'; it must be one of: %s.", field->key,
                      size < 60 ? size : 60, text != NULL ? text : "", known);
}

static swResult readValue(swYaml* yaml, yaml_node_t* node, const swYamlField* field, void* target)
{
    char* member = (char*)target + field->offset;
    double values[3] = {0.0, 0.0, 0.0};
    swResult result = SW_SUCCESS;
    switch (field->type)
    {
    case SW_YAML_TEXT:
        return swReadYamlText(yaml, node, field, member);
    case SW_YAML_BOOL:
        return readBool(yaml, node, field, (bool*)(void*)member);
    case SW_YAML_CHOICE:
        return readChoice(yaml, node, field, (int*)(void*)member);
    case SW_YAML_CUSTOM:
        return field->read(yaml, node, target);
    case SW_YAML_COLOR:
    case SW_YAML_POSITION:
        result = readTriple(yaml, node, field, values);
        break;
    case SW_YAML_INT:
    case SW_YAML_UINT:
        result = readInteger(yaml, node, field, &values[0]);
        break;
    default:
        result = readNumber(yaml, node, field, &values[0]);
        break;
    }
    if (result != SW_SUCCESS)
    {
        return result;
    }

    float single = (float)values[0];
    switch (field->type)
    {
    case SW_YAML_DOUBLE:
        memcpy(member, &values[0], sizeof(double));
        break;
    case SW_YAML_INT:
        *(int*)(void*)member = (int)values[0];
        break;
    case SW_YAML_UINT:
        *(uint32_t*)(void*)member = (uint32_t)values[0];
        break;
    case SW_YAML_COLOR:
        *(swVec3*)(void*)member = (swVec3){(float)values[0], (float)values[1], (float)values[2]};
        break;
    case SW_YAML_POSITION:
        *(swPos*)(void*)member = (swPos){values[0], values[1], values[2]};
        break;
    case SW_YAML_DEGREES:
        single = (float)(values[0] * (SW_PI / 180.0));
        memcpy(member, &single, sizeof(float));
        break;
    case SW_YAML_BEARING:
        single = SW_DIRECTION_FROM_BEARING(values[0]);
        memcpy(member, &single, sizeof(float));
        break;
    default:
        memcpy(member, &single, sizeof(float));
        break;
    }
    return SW_SUCCESS;
}

// ---- collections ----

static int findField(const swYamlField* fields, int fieldCount, const char* key, int size)
{
    for (int i = 0; i < fieldCount; ++i)
    {
        if (isWord(key, size, fields[i].key))
        {
            return i;
        }
    }
    return -1;
}

static swResult failKey(swYaml* yaml, const yaml_node_t* key, const char* what, const swYamlField* fields,
                        int fieldCount)
{
    int size = 0;
    const char* text = getScalar(key, &size);
    char known[700] = "";
    for (int i = 0; i < fieldCount; ++i)
    {
        listWord(known, sizeof(known), fields[i].key);
    }
    return swFailYaml(yaml, key, SW_MISTAKE_UNKNOWN_KEY, "'%.*s' is no key of %s; it has: %s.", size < 60 ? size : 60,
                      text != NULL ? text : "", what, known);
}

swResult swReadYamlMapping(swYaml* yaml, yaml_node_t* node, const char* what, const swYamlField* fields, int fieldCount,
                           void* target, swYamlNodes* nodes)
{
    swYamlNodes local;
    nodes = nodes != NULL ? nodes : &local;
    memset(nodes, 0, sizeof(*nodes));
    if (node->type != YAML_MAPPING_NODE)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_WRONG_FORM, "%s must hold lines of the form 'key: value', indented.",
                          what);
    }
    swResult result = SW_SUCCESS;
    yaml_node_pair_t* pair = node->data.mapping.pairs.start;
    for (; pair < node->data.mapping.pairs.top && !swIsYamlOver(yaml, result); ++pair)
    {
        yaml_node_t* key = yaml_document_get_node(&yaml->document, pair->key);
        yaml_node_t* value = yaml_document_get_node(&yaml->document, pair->value);
        int size = 0;
        const char* text = getScalar(key, &size);
        int index = text != NULL ? findField(fields, fieldCount, text, size) : -1;
        swResult own = SW_SUCCESS;
        if (index < 0)
        {
            own = failKey(yaml, key, what, fields, fieldCount);
        }
        else if (nodes->nodes[index] != NULL)
        {
            own = swFailYaml(yaml, key, SW_MISTAKE_REPEATED, "%s stands twice in %s, first on line %d; remove one.",
                             fields[index].key, what, (int)nodes->nodes[index]->start_mark.line + 1);
        }
        else
        {
            nodes->nodes[index] = value;
            own = readValue(yaml, value, &fields[index], target);
            nodes->isWrong[index] = own != SW_SUCCESS;
        }
        result = swKeepFailure(result, own);
    }
    return result;
}

swResult swReadYamlList(swYaml* yaml, yaml_node_t* node, const char* what, int limit, int* count)
{
    *count = 0;
    if (node->type != YAML_SEQUENCE_NODE)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_WRONG_FORM,
                          "%s must be a list: lines that begin with '- ', or [a, b].", what);
    }
    ptrdiff_t items = node->data.sequence.items.top - node->data.sequence.items.start;
    *count = items > limit ? limit : (int)items;
    if (items > limit)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_TOO_LARGE, "%s has %d items; at most %d are allowed.", what,
                          (int)items, limit);
    }
    return SW_SUCCESS;
}

yaml_node_t* swGetYamlItem(swYaml* yaml, yaml_node_t* node, int index)
{
    return yaml_document_get_node(&yaml->document, node->data.sequence.items.start[index]);
}
