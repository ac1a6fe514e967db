// SPDX-License-Identifier: MIT
// `seaway devices`: every Vulkan device in Vulkan's order, which is what --device INDEX counts, and what each lacks.

#include "seaway/stage.h"

#include "args.h"
#include "verbs.h"

#define MAX_DEVICES 64

static void PrintDevice(Json* json, int index, const swStageDevice* device)
{
    char version[32];
    snprintf(version, sizeof(version), "%u.%u.%u", VK_API_VERSION_MAJOR(device->version),
             VK_API_VERSION_MINOR(device->version), VK_API_VERSION_PATCH(device->version));
    if (json == NULL)
    {
        printf("%d  %s, %s, Vulkan %s: %s%s\n", index, device->name, device->type, version,
               device->isUsable ? "usable" : "lacks ", device->missing);
        return;
    }
    JsonOpenObject(json, NULL);
    JsonInteger(json, "index", index);
    JsonText(json, "name", device->name);
    JsonText(json, "type", device->type);
    JsonText(json, "vulkan", version);
    JsonFlag(json, "usable", device->isUsable);
    JsonText(json, "missing", device->isUsable ? NULL : device->missing);
    JsonCloseObject(json);
}

int RunDevices(int argumentCount, char** arguments)
{
    bool asJson = false;
    const Option options[] = {{.name = "json", .kind = OPTION_FLAG, .value = &asJson, .help = "print JSON"}};
    const Verb verb = {.name = "devices",
                       .synopsis = "[--json]",
                       .text = "List the Vulkan devices of this machine in Vulkan's order, the one that --device INDEX "
                               "counts,\nand what each of them lacks. Exit code 1 if none is usable.",
                       .options = options,
                       .optionCount = 1};
    ParseResult parsed = ParseArguments(&verb, argumentCount, arguments);
    if (parsed != PARSE_FINE)
    {
        return GetParseExit(parsed);
    }
    swStageDevice devices[MAX_DEVICES];
    int count = 0;
    swHost host = MakeHost();
    swResult result = swListStageDevices(&host, MAX_DEVICES, devices, &count);
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, "the devices cannot be listed");
        return EXIT_PROBLEM;
    }
    count = count < MAX_DEVICES ? count : MAX_DEVICES;
    Json json = OpenJson(stdout);
    if (asJson)
    {
        JsonOpenObject(&json, NULL);
        JsonOpenArray(&json, "devices");
    }
    int usableCount = 0;
    for (int i = 0; i < count; ++i)
    {
        PrintDevice(asJson ? &json : NULL, i, &devices[i]);
        usableCount += devices[i].isUsable;
    }
    if (asJson)
    {
        JsonCloseArray(&json);
        JsonCloseObject(&json);
    }
    if (usableCount == 0)
    {
        Complain("no Vulkan device here is usable");
    }
    return FinishOutput() && usableCount > 0 ? EXIT_FINE : EXIT_PROBLEM;
}
