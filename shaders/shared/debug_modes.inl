// SPDX-License-Identifier: MIT
// What a picture may show instead of the water: SW_DEBUG_MODE(enumerator of swDebugMode, its number, its word on the
// command line). The program's words and the shader's numbers come from this list.
SW_DEBUG_MODE(SW_DEBUG_NONE, 0, none)
SW_DEBUG_MODE(SW_DEBUG_SLICES, 1, slices)
SW_DEBUG_MODE(SW_DEBUG_WIREFRAME, 2, wireframe)
SW_DEBUG_MODE(SW_DEBUG_NORMALS, 3, normals)
SW_DEBUG_MODE(SW_DEBUG_HEIGHT, 4, height)
SW_DEBUG_MODE(SW_DEBUG_JACOBIAN, 5, jacobian)
SW_DEBUG_MODE(SW_DEBUG_FOAM, 6, foam)
SW_DEBUG_MODE(SW_DEBUG_ROUGHNESS, 7, roughness)
