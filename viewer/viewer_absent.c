// SPDX-License-Identifier: MIT
// Stands in for the viewer in builds without GLFW or Dear ImGui.

#include "viewer.h"

#include <stdio.h>

ViewerOptions DefaultViewerOptions(void)
{
    return (ViewerOptions){0};
}

int RunViewer(const ViewerOptions* options)
{
    (void)options;
    fprintf(stderr, "seaway: this build has no viewer, because GLFW, Dear ImGui, libpng or a C++ compiler was missing "
                    "when it was configured; `seaway render` makes pictures without them\n");
    return 1;
}
