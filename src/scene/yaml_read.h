// SPDX-License-Identifier: MIT
#pragma once

// Mappings of a YAML document into structs by tables of fields. Every complaint is one sentence with file and line,
// says what would be right, and ends with its code in brackets. Reading goes on after a mistake, so that all are told
// at once: functions return the first failure of what they read, and what could not be read keeps its value.

#include <stdbool.h>
#include <stddef.h>
#include <yaml.h>

#include "core/base/host.h"

typedef enum swMistake
{
#define SW_MISTAKE(name, code) SW_MISTAKE_##name,
#include "scene/mistakes.inl"
#undef SW_MISTAKE
} swMistake;

// Mistakes that are told; a file with more is no scene.
#define SW_YAML_MAX_MISTAKES 64

// What a document may have, or it is refused before it is read: the parser's time grows with the square of the depth,
// of the anchors and of the directives.
#define SW_YAML_MAX_DEPTH 16
#define SW_YAML_MAX_NODES 100000
#define SW_YAML_MAX_ANCHORS 1000

typedef struct swYaml
{
    const swHost* host;
    const char* name; // of the file, for messages
    yaml_document_t document;
    void* context; // what custom fields are read into
    int mistakeCount;
} swYaml;

typedef enum swYamlType
{
    SW_YAML_FLOAT,
    SW_YAML_DOUBLE,
    SW_YAML_INT,
    SW_YAML_UINT,
    SW_YAML_BOOL,
    SW_YAML_TEXT,     // char[size]
    SW_YAML_DEGREES,  // float, stored in radians
    SW_YAML_BEARING,  // float: degrees clockwise from north that waves come from, stored as the direction they go
    SW_YAML_COLOR,    // swVec3 from a list of three numbers
    SW_YAML_POSITION, // swPos from a list of three numbers
    SW_YAML_CHOICE,   // int: index into the words
    SW_YAML_CUSTOM    // `read`
} swYamlType;

typedef struct swYamlField
{
    const char* key;
    swYamlType type;
    size_t offset;
    double low, high;         // numbers: both inclusive, in the file's unit
    size_t size;              // TEXT
    const char* const* words; // CHOICE: ends with NULL
    swResult (*read)(swYaml* yaml, yaml_node_t* node, void* target);
} swYamlField;

#define SW_YAML_MAX_FIELDS 64

// How many fields a table has. A table with more than there is room for does not compile.
#define SW_YAML_COUNT(fields)                                                                                          \
    ((int)(sizeof(fields) / sizeof((fields)[0])) +                                                                     \
     0 * (int)sizeof(char[sizeof(fields) / sizeof((fields)[0]) <= SW_YAML_MAX_FIELDS ? 1 : -1]))

// Which node set each field, NULL where the file says nothing, and whether it holds a mistake, which has been told.
typedef struct swYamlNodes
{
    yaml_node_t* nodes[SW_YAML_MAX_FIELDS];
    bool isWrong[SW_YAML_MAX_FIELDS];
} swYamlNodes;

// Parse a text. Needs swCloseYaml() if it succeeds. `root` is NULL for an empty document.
swResult swOpenYaml(const swHost* host, const char* text, size_t size, const char* name, swYaml* yaml,
                    yaml_node_t** root);
void swCloseYaml(swYaml* yaml);

// Read a mapping into `target`; `what` names it in messages. Unknown and repeated keys are refused. `nodes` may be
// NULL.
swResult swReadYamlMapping(swYaml* yaml, yaml_node_t* node, const char* what, const swYamlField* fields, int fieldCount,
                           void* target, swYamlNodes* nodes);

// The items of a list, at most `limit`; the first ones also if there are more, which fails.
swResult swReadYamlList(swYaml* yaml, yaml_node_t* node, const char* what, int limit, int* count);
yaml_node_t* swGetYamlItem(swYaml* yaml, yaml_node_t* node, int index);

// A text of at most field->size bytes, its zero included.
swResult swReadYamlText(swYaml* yaml, yaml_node_t* node, const swYamlField* field, char* target);

// Log "file:line: sentence [code]" and return SW_ERROR_FORMAT.
swResult swFailYaml(swYaml* yaml, const yaml_node_t* node, swMistake mistake, const char* format, ...) SW_PRINTF(4, 5);

// The first failure of two, but want of memory before all.
swResult swKeepFailure(swResult first, swResult next);

// Nothing more is to be read: there is no memory, or there are too many mistakes.
bool swIsYamlOver(const swYaml* yaml, swResult result);
