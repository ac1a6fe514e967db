// SPDX-License-Identifier: MIT
// Waves given by hand: a list of lengths, heights, directions and phases.

#include "scene/scene_components.h"

#include <string.h>

static swResult readComponent(swYaml* yaml, yaml_node_t* node, swWaveComponent* component)
{
    static const char* const needed[] = {"wavelength_m", "amplitude_m", "direction_from_deg"};
    swYamlMapping mapping;
    swBeginYamlMapping(&mapping, "a component");
    swAddYamlFields(&mapping, swGetWaveComponentFields(), 0, "components");
    swResult result = swReadYamlMapping(yaml, node, &mapping, component);
    for (int i = 0; i < 3 && node->type == YAML_MAPPING_NODE; ++i)
    {
        if (swGetYamlNode(&mapping, needed[i]) == NULL)
        {
            result = swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY,
                                "the component has no %s; it needs wavelength_m, amplitude_m and direction_from_deg.",
                                needed[i]);
        }
    }
    return result;
}

swResult swReadComponents(swYaml* yaml, yaml_node_t* node, swSceneWaves* waves)
{
    int count = 0;
    swResult result = swReadYamlList(yaml, node, "components", SW_MAX_FREE_WAVES, &count);
    if (result == SW_SUCCESS && count == 0)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY, "components is empty; give it a wave, or remove it.");
    }
    if (count == 0)
    {
        return result;
    }
    waves->components = swAllocateZero(yaml->host, (size_t)count * sizeof(swWaveComponent));
    if (waves->components == NULL)
    {
        return swFail(yaml->host, SW_ERROR_NO_MEMORY, "No memory for %d waves of %s.", count, yaml->name);
    }
    waves->componentCount = count;
    for (int i = 0; i < count && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readComponent(yaml, swGetYamlItem(yaml, node, i), &waves->components[i]));
    }
    return result;
}

void swFreeComponents(const swHost* host, swSceneWaves* waves)
{
    swFree(host, waves->components, (size_t)waves->componentCount * sizeof(swWaveComponent));
    waves->components = NULL;
}
