// SPDX-License-Identifier: MIT

#include "scene/field_tree.h"

#include <math.h>
#include <string.h>

#include "scene/yaml_read.h"

static bool isFloat(const swField* field)
{
    return field->type == SW_FIELD_FLOAT || field->type == SW_FIELD_FLOATS;
}

static bool isReadAs(const swField* field, const char* text, double value)
{
    double shown = 0.0;
    if (!swParseExactNumber(text, (int)strlen(text), &shown))
    {
        return false;
    }
    double read = swField_Read(field, shown);
    return isFloat(field) ? (float)read == (float)value : read == value;
}

static bool printShown(const swField* field, double shown, double value, char text[SW_NUMBER_TEXT])
{
    for (int digits = 1; digits <= 17; ++digits)
    {
        swPrintDigits(shown, digits, text);
        if (isReadAs(field, text, value))
        {
            return true;
        }
    }
    return false;
}

void swPrintFieldNumber(const swField* field, double value, char text[SW_NUMBER_TEXT])
{
    double read = swField_Read(field, swField_Show(field, value));
    if (field->form != SW_FORM_PLAIN &&
        (printShown(field, 360.0, value, text) || printShown(field, -360.0, value, text)))
    {
        return; // a turn, which as a float is a little more than one
    }
    if (fabs(read - value) > 1.0 && field->form != SW_FORM_PLAIN && field->form != SW_FORM_COLOR)
    {
        value = isFloat(field) ? (double)(float)read : read;
    }
    double shown = swField_Show(field, value);
    bool isWrapped = field->form == SW_FORM_BEARING && shown < 0.0;
    if ((isWrapped && printShown(field, shown + 360.0, value, text)) || printShown(field, shown, value, text))
    {
        return;
    }
    swPrintDigits(shown, 17, text);
}

static bool isDefaultNumber(const swField* field, const void* def, const void* usual, int index)
{
    double value = swField_GetNumber(field, def, index);
    double other = usual != NULL ? swField_GetNumber(field, usual, index) : field->defaults[index];
    return isFloat(field) ? (float)value == (float)other : value == other;
}

int swAddField(swTree* tree, int parent, const swField* field, const void* def, const void* usual)
{
    char text[SW_NUMBER_TEXT] = "";
    bool isNumbers = field->type == SW_FIELD_FLOATS || field->type == SW_FIELD_DOUBLES;
    if (field->type == SW_FIELD_TEXT)
    {
        const char* value = (const char*)def + field->offset;
        return value[0] != '\0' ? swAddTreeText(tree, parent, field->key, value, false) : -1;
    }
    if (field->type == SW_FIELD_BOOL || field->type == SW_FIELD_CHOICE)
    {
        int value = (int)swField_GetNumber(field, def, 0);
        const char* word = field->type == SW_FIELD_CHOICE ? field->words[value] : value != 0 ? "true" : "false";
        return swAddTreeText(tree, parent, field->key, word, isDefaultNumber(field, def, usual, 0));
    }
    int list = isNumbers ? swAddTreeNode(tree, parent, SW_TREE_LIST, field->key) : -1;
    bool isDefault = true;
    for (int i = 0; i < field->count; ++i)
    {
        double value = swField_GetNumber(field, def, i);
        bool isUsual = isDefaultNumber(field, def, usual, i);
        isDefault = isDefault && isUsual;
        if (!(fabs(value) <= 1e300))
        {
            return -1;
        }
        swPrintFieldNumber(field, value, text);
        int node = swAddTreeText(tree, isNumbers ? list : parent, isNumbers ? NULL : field->key, text, isUsual);
        if (!isNumbers || node < 0)
        {
            return node;
        }
        swSetTreeItem(tree, node, i, false);
    }
    swSetTreeItem(tree, list, -1, true);
    swSetTreeDefault(tree, list, isDefault);
    return list;
}

void swAddFields(swTree* tree, int parent, const swFields* fields, const void* def, const char* section)
{
    for (int i = 0; i < fields->count; ++i)
    {
        const swField* field = &fields->fields[i];
        const char* own = swGetFieldSection(fields, field);
        if (field->type == SW_FIELD_DEF)
        {
            swAddFields(tree, parent, field->fields, (const char*)def + field->offset, section);
        }
        else if (field->type < SW_FIELD_DEF && field->key != NULL && own != NULL && strcmp(own, section) == 0)
        {
            swAddField(tree, parent, field, def, NULL);
        }
    }
}
