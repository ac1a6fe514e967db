// SPDX-License-Identifier: MIT
// Tides of a scene file: constituents by their name, such as M2, or by their speed.

#include "core/base/field.h"
#include "scene/scene_lists.h"

static swResult readName(swYaml* yaml, yaml_node_t* node, swTideConstituent* constituent)
{
    char name[16] = "";
    swResult result = swReadYamlText(yaml, node, "constituent", name, sizeof(name));
    constituent->speed = result == SW_SUCCESS ? swGetTideSpeed(name) : 0.0f;
    return result == SW_SUCCESS && !(constituent->speed > 0.0f)
               ? swFailYaml(yaml, node, SW_MISTAKE_UNKNOWN_WORD,
                            "there is no constituent named '%s' here; take one such as M2, or give its speed_rad_s.",
                            name)
               : result;
}

static swResult readConstituent(swYaml* yaml, yaml_node_t* node, bool isFlow, swTideConstituent* constituent)
{
    static const char* const across[] = {"amplitude_across_m_s", "phase_across_deg"};
    swYamlMapping mapping;
    swFillDef(swGetTideFields(), constituent);
    swBeginYamlMapping(&mapping, "a constituent");
    swAddYamlKey(&mapping, "constituent", swKeepYamlNode);
    swAddYamlFields(&mapping, swGetTideFields(), 0, "tide");
    swResult result = swReadYamlMapping(yaml, node, &mapping, constituent);
    if (node->type != YAML_MAPPING_NODE || swIsYamlOver(yaml, result))
    {
        return result;
    }
    yaml_node_t *name = swGetYamlNode(&mapping, "constituent"), *speed = swGetYamlNode(&mapping, "speed_rad_s");
    if (name != NULL && speed != NULL)
    {
        return swFailYaml(yaml, speed, SW_MISTAKE_CONFLICT,
                          "speed_rad_s stands beside constituent, which has a speed; remove one.");
    }
    if (name == NULL && speed == NULL)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY,
                          "the constituent has no speed; name it, such as constituent: M2, or give its speed_rad_s.");
    }
    for (int i = 0; i < 2 && !isFlow; ++i)
    {
        const yaml_node_t* key = swGetYamlNode(&mapping, across[i]);
        result = key == NULL ? result
                             : swKeepFailure(result, swFailYaml(yaml, key, SW_MISTAKE_NO_EFFECT,
                                                                "%s has no effect on a level; remove it.", across[i]));
    }
    return name != NULL ? swKeepFailure(result, readName(yaml, name, constituent)) : result;
}

swResult swReadTide(swYaml* yaml, yaml_node_t* node, bool isFlow, swTideConstituent tide[SW_MAX_TIDE])
{
    int count = 0;
    swResult result = swReadYamlList(yaml, node, "tide", SW_MAX_TIDE, &count);
    for (int i = 0; i < count && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readConstituent(yaml, swGetYamlItem(yaml, node, i), isFlow, &tide[i]));
    }
    return result;
}
