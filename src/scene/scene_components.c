// SPDX-License-Identifier: MIT
// Waves given by hand: a list of lengths, heights, directions and phases.

#include "scene/scene_components.h"

#include <string.h>

enum
{
    WAVELENGTH,
    AMPLITUDE,
    DIRECTION,
    PHASE
};

static const swYamlField componentFields[] = {
    [WAVELENGTH] = {.key = "wavelength_m",
                    .type = SW_YAML_FLOAT,
                    .offset = offsetof(swWaveComponent, wavelength),
                    .low = 0.0625,
                    .high = 4096.0},
    [AMPLITUDE] = {.key = "amplitude_m",
                   .type = SW_YAML_FLOAT,
                   .offset = offsetof(swWaveComponent, amplitude),
                   .low = 0.0,
                   .high = 40.0},
    [DIRECTION] = {.key = "direction_from_deg",
                   .type = SW_YAML_BEARING,
                   .offset = offsetof(swWaveComponent, direction),
                   .low = -360.0,
                   .high = 360.0},
    [PHASE] = {.key = "phase_deg",
               .type = SW_YAML_DEGREES,
               .offset = offsetof(swWaveComponent, phase),
               .low = -360.0,
               .high = 360.0},
};

static swResult readComponent(swYaml* yaml, yaml_node_t* node, swWaveComponent* component)
{
    swYamlNodes nodes;
    swResult result = swReadYamlMapping(yaml, node, "a component", componentFields, SW_YAML_COUNT(componentFields),
                                        component, &nodes);
    for (int i = WAVELENGTH; i <= DIRECTION && node->type == YAML_MAPPING_NODE; ++i)
    {
        if (nodes.nodes[i] == NULL)
        {
            result = swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY,
                                "the component has no %s; it needs wavelength_m, amplitude_m and direction_from_deg.",
                                componentFields[i].key);
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
