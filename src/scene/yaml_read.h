// SPDX-License-Identifier: MIT
#pragma once

// Mappings of a YAML document into structs by the tables of their defs (seaway/field.h). Every complaint is one
// sentence with file and line, says what would be right, and ends with its code in brackets. Reading goes on after a
// mistake, so that all are told at once: functions return the first failure of what they read, and what could not be
// read keeps its value.

#include <stdbool.h>
#include <stddef.h>
#include <yaml.h>

#include "core/base/host.h"
#include "seaway/field.h"

typedef enum swMistake
{
#define SW_MISTAKE(name, code, meaning, remedy) SW_MISTAKE_##name,
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
    void* context; // what custom keys are read into
    int mistakeCount;
} swYaml;

// A key of a mapping: a field of a def that begins at `offset` of the target, or what `read` makes of it.
typedef struct swYamlKey swYamlKey;
typedef swResult (*swReadYamlFcn)(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* target);
struct swYamlKey
{
    const char* key;
    const swFields* fields; // that the field is of
    const swField* field;
    size_t offset;
    swReadYamlFcn read; // NULL: by the field
    yaml_node_t* node;  // that set it; NULL where the file says nothing
    bool isWrong;       // it holds a mistake, which has been told
};

#define SW_YAML_MAX_KEYS 96

// The keys that a mapping may have.
typedef struct swYamlMapping
{
    const char* what; // names it in messages
    int count;
    swYamlKey keys[SW_YAML_MAX_KEYS];
} swYamlMapping;

// No keys yet.
void swBeginYamlMapping(swYamlMapping* mapping, const char* what);

// A key that is read by a function.
void swAddYamlKey(swYamlMapping* mapping, const char* key, swReadYamlFcn read);

// The fields of a table that scene files have in a section, those of defs within it as well. Keys that are there
// already stay what they are. Lists of defs are left to swAddYamlKey().
void swAddYamlFields(swYamlMapping* mapping, const swFields* fields, size_t offset, const char* section);

// A key of the mapping; NULL if it has none of that name.
swYamlKey* swFindYamlKey(swYamlMapping* mapping, const char* key);

// What the file says there; NULL if nothing.
yaml_node_t* swGetYamlNode(const swYamlMapping* mapping, const char* key);
bool swIsYamlWrong(const swYamlMapping* mapping, const char* key);

// The section that a field stands in, and whether a part is one whose fields stand in it.
const char* swGetFieldSection(const swFields* fields, const swField* field);

// Parse a text. Needs swCloseYaml() if it succeeds. `root` is NULL for an empty document.
swResult swOpenYaml(const swHost* host, const char* text, size_t size, const char* name, swYaml* yaml,
                    yaml_node_t** root);
void swCloseYaml(swYaml* yaml);

// Read a mapping into `target`. Unknown and repeated keys are refused.
swResult swReadYamlMapping(swYaml* yaml, yaml_node_t* node, swYamlMapping* mapping, void* target);

// The items of a list, at most `limit`; the first ones also if there are more, which fails.
swResult swReadYamlList(swYaml* yaml, yaml_node_t* node, const char* what, int limit, int* count);
yaml_node_t* swGetYamlItem(swYaml* yaml, yaml_node_t* node, int index);

// A text of at most `size` bytes, its zero included.
swResult swReadYamlText(swYaml* yaml, yaml_node_t* node, const char* key, char* target, size_t size);

// Log "file:line: sentence [code]" and return SW_ERROR_FORMAT.
swResult swFailYaml(swYaml* yaml, const yaml_node_t* node, swMistake mistake, const char* format, ...) SW_PRINTF(4, 5);

// The first failure of two, but want of memory before all.
swResult swKeepFailure(swResult first, swResult next);

// Nothing more is to be read: there is no memory, or there are too many mistakes.
bool swIsYamlOver(const swYaml* yaml, swResult result);
