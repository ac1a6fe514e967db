// SPDX-License-Identifier: MIT
// Over libyaml's documents, which keep the line of every node. (libcyaml reads structs by tables too, but version 1.3.1
// names the line before an unknown key, follows the locale in numbers, and takes undecodable bytes for an empty file.)

#include "scene/yaml_read.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "core/base/assert.h"
#include "files/file_text.h"
#include "scene/exact_number.h"

static const char* const mistakeCodes[] = {
#define SW_MISTAKE(name, code, meaning, remedy) code,
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

// "0 to 100", "above 0 to 100"
static const char* printRange(const swField* field, char text[80])
{
    double low = 0.0, high = 0.0;
    swField_GetShownRange(field, &low, &high);
    snprintf(text, 80, "%s%g to %s%g", field->isLowOpen ? "above " : "", low, field->isHighOpen ? "below " : "", high);
    return text;
}

static bool isInShownRange(const swField* field, double shown)
{
    double low = 0.0, high = 0.0;
    swField_GetShownRange(field, &low, &high);
    double room = 1e-12 * (fabs(low) + fabs(high)); // of degrees, which ranges have as radians
    return (shown >= low - (room < 1e300 ? room : 0.0) && shown <= high + (room < 1e300 ? room : 0.0)) &&
           (field->form == SW_FORM_DEGREES || field->form == SW_FORM_BEARING ||
            swField_IsInRange(field, swField_Read(field, shown)));
}

static bool isWhole(const swField* field)
{
    return field->type == SW_FIELD_INT || field->type == SW_FIELD_UINT || field->type == SW_FIELD_SIZE;
}

static swResult readNumber(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, int index, void* def)
{
    int size = 0;
    double shown = 0.0;
    char range[80];
    const char* text = getScalar(node, &size);
    if (text == NULL || !swParseExactNumber(text, size, &shown))
    {
        return swFailYaml(yaml, node, SW_MISTAKE_WRONG_FORM, "%s is '%.*s'; it must be a number from %s.", key->key,
                          text != NULL && size < 60 ? size : 0, text != NULL ? text : "",
                          printRange(key->field, range));
    }
    if (!isInShownRange(key->field, shown))
    {
        return swFailYaml(yaml, node, SW_MISTAKE_OUT_OF_RANGE, "%s is %g; its range is %s.", key->key, shown,
                          printRange(key->field, range));
    }
    if (isWhole(key->field) && shown != floor(shown))
    {
        return swFailYaml(yaml, node, SW_MISTAKE_OUT_OF_RANGE, "%s is %g; it must be a whole number.", key->key, shown);
    }
    swField_SetNumber(key->field, def, index, swField_Read(key->field, shown));
    return SW_SUCCESS;
}

static swResult readNumbers(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* def)
{
    static const char* const words[] = {"", "one", "two", "three", "four"};
    int count = 0, wanted = key->field->count;
    swResult result = swReadYamlList(yaml, node, key->key, wanted, &count);
    if (result == SW_SUCCESS && count != wanted)
    {
        result = swFailYaml(yaml, node, SW_MISTAKE_WRONG_FORM, "%s has %d numbers; it must have %s, as in %s.",
                            key->key, count, words[wanted < 4 ? wanted : 4], wanted == 3 ? "[0, 2, 0]" : "[0, 2]");
    }
    for (int i = 0; i < count && i < wanted; ++i)
    {
        result = swKeepFailure(result, readNumber(yaml, swGetYamlItem(yaml, node, i), key, i, def));
    }
    return result;
}

swResult swReadYamlText(swYaml* yaml, yaml_node_t* node, const char* key, char* target, size_t limit)
{
    int size = 0;
    const char* text = getScalar(node, &size);
    if (text == NULL || size == 0)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_WRONG_FORM, "%s must be a text.", key);
    }
    if ((size_t)size >= limit)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_TOO_LARGE, "%s has %d bytes; at most %zu are kept.", key, size,
                          limit - 1);
    }
    if (memchr(text, '\0', (size_t)size) != NULL)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_WRONG_FORM, "%s holds a zero byte; remove it.", key);
    }
    memset(target, 0, limit);
    memcpy(target, text, (size_t)size);
    return SW_SUCCESS;
}

static bool isWord(const char* text, int size, const char* word)
{
    return (size_t)size == strlen(word) && memcmp(text, word, (size_t)size) == 0;
}

static swResult readBool(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* def)
{
    int size = 0;
    const char* text = getScalar(node, &size);
    if (text != NULL && (isWord(text, size, "true") || isWord(text, size, "false")))
    {
        swField_SetNumber(key->field, def, 0, text[0] == 't' ? 1.0 : 0.0);
        return SW_SUCCESS;
    }
    return swFailYaml(yaml, node, SW_MISTAKE_WRONG_FORM, "%s must be true or false.", key->key);
}

// "a, b, c" for messages, cut off where the room ends.
static void listWord(char* list, size_t size, const char* word)
{
    size_t used = strlen(list);
    snprintf(list + used, size - used, "%s%s", used > 0 ? ", " : "", word);
}

static swResult readChoice(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* def)
{
    int size = 0;
    const char* text = getScalar(node, &size);
    char known[700] = "";
    for (int i = 0; key->field->words[i] != NULL; ++i)
    {
        if (text != NULL && isWord(text, size, key->field->words[i]))
        {
            swField_SetNumber(key->field, def, 0, (double)i);
            return SW_SUCCESS;
        }
        listWord(known, sizeof(known), key->field->words[i]);
    }
    return swFailYaml(yaml, node, SW_MISTAKE_UNKNOWN_WORD, "%s is '%.*s'; it must be one of: %s.", key->key,
                      size < 60 ? size : 60, text != NULL ? text : "", known);
}

static swResult readValue(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* target)
{
    char* def = (char*)target + key->offset;
    if (key->read != NULL)
    {
        return key->read(yaml, node, key, target);
    }
    switch (key->field->type)
    {
    case SW_FIELD_TEXT:
        return swReadYamlText(yaml, node, key->key, def + key->field->offset, key->field->size);
    case SW_FIELD_BOOL:
        return readBool(yaml, node, key, def);
    case SW_FIELD_CHOICE:
        return readChoice(yaml, node, key, def);
    case SW_FIELD_FLOATS:
    case SW_FIELD_DOUBLES:
        return readNumbers(yaml, node, key, def);
    default:
        return readNumber(yaml, node, key, 0, def);
    }
}

// ---- keys ----

void swBeginYamlMapping(swYamlMapping* mapping, const char* what)
{
    mapping->what = what;
    mapping->count = 0;
}

static void addKey(swYamlMapping* mapping, const swYamlKey* key)
{
    SW_ASSERT(mapping->count < SW_YAML_MAX_KEYS);
    if (mapping->count < SW_YAML_MAX_KEYS && swFindYamlKey(mapping, key->key) == NULL)
    {
        mapping->keys[mapping->count++] = *key;
    }
}

void swAddYamlKey(swYamlMapping* mapping, const char* key, swReadYamlFcn read)
{
    addKey(mapping, &(swYamlKey){.key = key, .read = read});
}

const char* swGetFieldSection(const swFields* fields, const swField* field)
{
    return field->section != NULL ? field->section : fields->section;
}

void swAddYamlFields(swYamlMapping* mapping, const swFields* fields, size_t offset, const char* section)
{
    for (int i = 0; i < fields->count; ++i)
    {
        const swField* field = &fields->fields[i];
        const char* own = swGetFieldSection(fields, field);
        if (field->type == SW_FIELD_DEF)
        {
            swAddYamlFields(mapping, field->fields, offset + field->offset, section);
        }
        else if (field->type < SW_FIELD_DEF && field->key != NULL && own != NULL && strcmp(own, section) == 0)
        {
            addKey(mapping, &(swYamlKey){.key = field->key, .fields = fields, .field = field, .offset = offset});
        }
    }
}

swYamlKey* swFindYamlKey(swYamlMapping* mapping, const char* key)
{
    for (int i = 0; i < mapping->count; ++i)
    {
        if (strcmp(mapping->keys[i].key, key) == 0)
        {
            return &mapping->keys[i];
        }
    }
    return NULL;
}

static const swYamlKey* findKey(const swYamlMapping* mapping, const char* key)
{
    const swYamlKey* found = swFindYamlKey((swYamlMapping*)mapping, key);
    SW_ASSERT(found != NULL);
    return found;
}

yaml_node_t* swGetYamlNode(const swYamlMapping* mapping, const char* key)
{
    const swYamlKey* found = findKey(mapping, key);
    return found != NULL ? found->node : NULL;
}

bool swIsYamlWrong(const swYamlMapping* mapping, const char* key)
{
    const swYamlKey* found = findKey(mapping, key);
    return found != NULL && found->isWrong;
}

// ---- collections ----

static swYamlKey* matchKey(swYamlMapping* mapping, const char* text, int size)
{
    for (int i = 0; i < mapping->count && text != NULL; ++i)
    {
        if (isWord(text, size, mapping->keys[i].key))
        {
            return &mapping->keys[i];
        }
    }
    return NULL;
}

static swResult failKey(swYaml* yaml, const yaml_node_t* key, const swYamlMapping* mapping)
{
    int size = 0;
    const char* text = getScalar(key, &size);
    char known[700] = "";
    for (int i = 0; i < mapping->count; ++i)
    {
        listWord(known, sizeof(known), mapping->keys[i].key);
    }
    return swFailYaml(yaml, key, SW_MISTAKE_UNKNOWN_KEY, "'%.*s' is no key of %s; it has: %s.", size < 60 ? size : 60,
                      text != NULL ? text : "", mapping->what, known);
}

swResult swReadYamlMapping(swYaml* yaml, yaml_node_t* node, swYamlMapping* mapping, void* target)
{
    if (node->type != YAML_MAPPING_NODE)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_WRONG_FORM, "%s must hold lines of the form 'key: value', indented.",
                          mapping->what);
    }
    swResult result = SW_SUCCESS;
    yaml_node_pair_t* pair = node->data.mapping.pairs.start;
    for (; pair < node->data.mapping.pairs.top && !swIsYamlOver(yaml, result); ++pair)
    {
        yaml_node_t* key = yaml_document_get_node(&yaml->document, pair->key);
        yaml_node_t* value = yaml_document_get_node(&yaml->document, pair->value);
        int size = 0;
        const char* text = getScalar(key, &size);
        swYamlKey* known = matchKey(mapping, text, size);
        swResult own = SW_SUCCESS;
        if (known == NULL)
        {
            own = failKey(yaml, key, mapping);
        }
        else if (known->node != NULL)
        {
            own = swFailYaml(yaml, key, SW_MISTAKE_REPEATED, "%s stands twice in %s, first on line %d; remove one.",
                             known->key, mapping->what, (int)known->node->start_mark.line + 1);
        }
        else
        {
            known->node = value;
            own = readValue(yaml, value, known, target);
            known->isWrong = own != SW_SUCCESS;
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
